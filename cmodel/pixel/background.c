/* background.c - see background.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "pixel/background.h"

#include <stddef.h>

#include "math/fx.h"

int sph_background_missing(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    int64_t lines = 0;
    if (r[SPH_REG_BG_MODE] == 2)
        lines = (r[SPH_REG_WIN_Y1] + SPH_LINE_WORDS - 1) / SPH_LINE_WORDS;
    else if (r[SPH_REG_BG_MODE] == 3)
        lines = (int64_t)SPH_CONE_LINES * r[SPH_REG_BG_COUNT];
    else
        return 0;
    return (int64_t)(uint32_t)r[SPH_REG_BG_BASE] + lines > (uint32_t)r[SPH_REG_MEM_LINES];
}

static int outside_rect(const int32_t *r, int x, int y) {
    return x < r[SPH_REG_RECT_X0] || x >= r[SPH_REG_RECT_X1] || y < r[SPH_REG_RECT_Y0] ||
           y >= r[SPH_REG_RECT_Y1];
}

static int outside_span(const struct sph_machine *m, int x, int y) {
    size_t line = (uint32_t)m->regs[SPH_REG_BG_BASE] + (size_t)(y / SPH_LINE_WORDS);
    const uint32_t *word = sph_line(m, line) + y % SPH_LINE_WORDS;
    return (uint32_t)x < sph_field(word, SPH_SPAN_X0_LSB, SPH_SPAN_X0_BITS) ||
           (uint32_t)x >= sph_field(word, SPH_SPAN_X1_LSB, SPH_SPAN_X1_BITS);
}

/* The low 128 bits of a field that starts a word. */
static sph_u128 wide(const uint32_t *cone, int lsb) {
    const uint32_t *w = cone + lsb / 32;
    return (sph_u128)w[3] << 96 | (sph_u128)w[2] << 64 | (uint64_t)w[1] << 32 | w[0];
}

static uint64_t narrow(const uint32_t *cone, int lsb) {
    const uint32_t *w = cone + lsb / 32;
    return (uint64_t)w[1] << 32 | w[0];
}

/* 1 if the sphere of a cone record may be seen at pixel x, y. Sums wrap as in the RTL, which keeps
 * f in s(2W+2WD+4) and b in s(W+WD+4): the width is cut at the end, which is the same. */
static int inside_cone(const struct sph_profile *p, const uint32_t *cone, int x, int y) {
    int f_bits = 2 * p->w + 2 * p->wd + 4, b_bits = p->w + p->wd + 4;
    sph_u128 ux = (sph_u128)x, uy = (sph_u128)y;
    sph_u128 f =
        wide(cone, SPH_CONE_F_LSB) + ux * wide(cone, SPH_CONE_FX_LSB) +
        ux * (ux - 1) / 2 * wide(cone, SPH_CONE_FXX_LSB) + uy * wide(cone, SPH_CONE_FY_LSB) +
        uy * (uy - 1) / 2 * wide(cone, SPH_CONE_FYY_LSB) + ux * uy * wide(cone, SPH_CONE_FXY_LSB);
    uint64_t b = narrow(cone, SPH_CONE_B_LSB) + (uint64_t)x * narrow(cone, SPH_CONE_BX_LSB) +
                 (uint64_t)y * narrow(cone, SPH_CONE_BY_LSB);
    uint32_t inside = sph_field(cone, SPH_CONE_INSIDE_LSB, SPH_CONE_INSIDE_BITS);
    return (sph_i128)(f << (128 - f_bits)) > 0 && (inside || (int64_t)(b << (64 - b_bits)) > 0);
}

static int outside_cones(const struct sph_machine *m, int x, int y) {
    for (int i = 0; i < m->regs[SPH_REG_BG_COUNT]; i++) {
        size_t line = (uint32_t)m->regs[SPH_REG_BG_BASE] + (size_t)i * SPH_CONE_LINES;
        if (inside_cone(sph_machine_profile(m), sph_line(m, line), x, y)) return 0;
    }
    return 1;
}

int sph_is_background(const struct sph_machine *m, int x, int y) {
    switch (sph_background_missing(m) ? 0 : m->regs[SPH_REG_BG_MODE]) {
    case 1:
        return outside_rect(m->regs, x, y);
    case 2:
        return outside_span(m, x, y);
    case 3:
        return outside_cones(m, x, y);
    default:
        return 0;
    }
}
