/* validate.c - is a machine in memory one that the hardware may run? See validate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "validate/validate.h"

#include "validate/prims.h"
#include "validate/check.h"
#include "math/fx.h"
#include "machine/camera.h"
#include "machine/parts.h"

#define RANGE(name, lo, hi)                                                                        \
    if (sph_validate_register(m, SPH_REG_##name, #name, lo, hi, err)) return -1

/* Frame, window, background and colours. */
static int check_frame(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    if (sph_validate_effects(m, err) || sph_validate_optics(m, err)) return -1;
    RANGE(MAX_DEPTH, 0, SPH_MAX_DEPTH);
    RANGE(LEAST_WEIGHT, 0,
          sph_machine_effect(m, SPH_EFFECT_REFLECT) || sph_machine_effect(m, SPH_EFFECT_REFRACT)
              ? SPH_LEAST_WEIGHT_MAX
              : 0);
    RANGE(N_LIGHTS, 0, SPH_MAX_LIGHTS);
    RANGE(FRAME_W, 1, SPH_MAX_SIDE);
    RANGE(FRAME_H, 1, SPH_MAX_SIDE);
    RANGE(WIN_X1, 0, r[SPH_REG_FRAME_W]);
    RANGE(WIN_Y1, 0, r[SPH_REG_FRAME_H]);
    RANGE(WIN_X0, 0, r[SPH_REG_WIN_X1]);
    RANGE(WIN_Y0, 0, r[SPH_REG_WIN_Y1]);
    RANGE(BG_MODE, 0, 3);
    RANGE(RECT_X1, 0, r[SPH_REG_FRAME_W]);
    RANGE(RECT_Y1, 0, r[SPH_REG_FRAME_H]);
    RANGE(RECT_X0, 0, r[SPH_REG_RECT_X1]);
    RANGE(RECT_Y0, 0, r[SPH_REG_RECT_Y1]);
    RANGE(BG_COLOUR, 0, 0xffffff);
    RANGE(AMBIENT_R, 0, 65535);
    RANGE(AMBIENT_G, 0, 65535);
    RANGE(AMBIENT_B, 0, 65535);
    return 0;
}

/* The widths are those of the register, and such as model and RTL can hold. */
static int check_profile(const struct sph_machine *m, struct sph_error *err) {
    struct sph_error why = {{0}};
    int32_t packed = (int32_t)sph_profile_pack(&m->profile);
    RANGE(PROFILE, packed, packed);
    if (!sph_profile_check(&m->profile, &why)) return 0;
    return sph_fail(err, "register PROFILE is %d: %.300s", packed, why.text);
}

/* Directions of a grid that is turned: of 32 bits, the top ones in the width of the profile. The
 * screen is a plane; its distance in doubles, which is rounded far below the unit that it is more
 * than what is asked. */
static int check_turned(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int32_t *r = m->regs, *across = r + SPH_REG_ACROSS_X, *down = r + SPH_REG_DOWN_X;
    int64_t unit = 1ll << (32 - p->wd), most = (1ll << 31) - 1, least = unit - (1ll << 31);
    double square = 0, along = 0;
    RANGE(BG_MODE, 0, 0);
    RANGE(PITCH, 0, 0);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        for (int corner = 0; corner < 4; corner++) {
            int64_t at = r[SPH_REG_DIR_X0 + i] +
                         (corner & 1 ? (r[SPH_REG_FRAME_W] - 1ll) * across[i] : 0) +
                         (corner & 2 ? (r[SPH_REG_FRAME_H] - 1ll) * down[i] : 0);
            if (at < least || at > most)
                return sph_fail(err, "register DIR_%c: a corner of the frame leaves %d bits",
                                "XYZ"[i], p -> wd);
        }
        double normal = (double)across[j] * down[k] - (double)across[k] * down[j];
        square += normal * normal;
        along += normal * r[SPH_REG_DIR_X0 + i];
    }
    double screen = fabs(along) / sqrt(square) / (double)unit;
    if (!(screen >= (double)sph_min_screen(p) + 1))
        return sph_fail(err, "registers ACROSS_X to DOWN_Z: the screen is too near");
    return 0;
}

/* Directions of rows and columns. */
static int check_raster(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int32_t *r = m->regs;
    int64_t wd = (1ll << (p->wd - 1)) - 1;
    RANGE(ACROSS_X, 0, 0);
    RANGE(ACROSS_Y, 0, 0);
    RANGE(ACROSS_Z, 0, 0);
    RANGE(DOWN_X, 0, 0);
    RANGE(DOWN_Y, 0, 0);
    RANGE(DOWN_Z, 0, 0);
    RANGE(DIR_X0, -wd, wd);
    RANGE(DIR_Y0, -wd, wd);
    RANGE(DIR_Z, -wd, -sph_min_screen(p));
    RANGE(PITCH, 1, 2 * wd);
    if (r[SPH_REG_DIR_X0] + (r[SPH_REG_FRAME_W] - 1ll) * r[SPH_REG_PITCH] > wd)
        return sph_fail(err, "register PITCH is %d: the last column leaves %d bits",
                        r[SPH_REG_PITCH], p->wd);
    if (r[SPH_REG_DIR_Y0] - (r[SPH_REG_FRAME_H] - 1ll) * r[SPH_REG_PITCH] < -wd)
        return sph_fail(err, "register PITCH is %d: the last row leaves %d bits", r[SPH_REG_PITCH],
                        p->wd);
    return 0;
}

/* Eye, directions and lights, in the widths of the profile. */
static int check_geometry(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int32_t *r = m->regs;
    int64_t w = 1ll << (p->w - 1);
    RANGE(EYE_X, -w, w - 1);
    RANGE(EYE_Y, -w, w - 1);
    RANGE(EYE_Z, -w, w - 1);
    if (sph_machine_effect(m, SPH_EFFECT_TURNED) ? check_turned(m, err) : check_raster(m, err))
        return -1;
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        static const char *const names[6] = {"X", "Y", "Z", "R", "G", "B"};
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l;
        int shift = lamp[3] >> SPH_LIGHT_SHIFT_LSB;
        if (shift < 0 || shift >= 1 << SPH_LIGHT_SHIFT_BITS) shift = 0;
        for (int i = 0; i < 6; i++) {
            int32_t v = i == 3 ? lamp[i] - shift * (1 << SPH_LIGHT_SHIFT_LSB) : lamp[i];
            int64_t most = shift ? 2 * w - 1 - sph_round(w, shift) : w - 1;
            if (i < 3 ? v < -most - !shift || v > most : v < 0 || v > 65535)
                return sph_fail(err, "register LIGHT%d_%s is %d, out of range", l, names[i], v);
        }
    }
    return 0;
}

/* Sizes and addresses of memory. */
static int check_memory(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    int facets = sph_machine_effect(m, SPH_EFFECT_FACETS);
    if (m->lines < 1 || m->lines >= 1u << SPH_NODE_BASE_BITS)
        return sph_fail(err, "memory has %u lines, not 1..%u", m->lines,
                        (1u << SPH_NODE_BASE_BITS) - 1);
    RANGE(MEM_LINES, m->lines, m->lines);
    RANGE(N_PRIMS, 0, facets ? SPH_ID_NONE : SPH_MAX_SPHERES);
    RANGE(PRIM_BASE, 1, (int64_t)m->lines - r[SPH_REG_N_PRIMS]);
    RANGE(N_SPHERES, facets ? (int64_t)r[SPH_REG_N_PRIMS] - SPH_MAX_FACETS : 0,
          facets ? r[SPH_REG_N_PRIMS] : 0);
    RANGE(N_SPHERES, 0, SPH_MAX_SPHERES);
    RANGE(FACET_BASE, facets ? (int64_t)r[SPH_REG_PRIM_BASE] + r[SPH_REG_N_PRIMS] : 0,
          facets ? m->lines - sph_machine_facets(m) : 0);
    RANGE(SMOOTH_BASE, 0, sph_machine_effect(m, SPH_EFFECT_SMOOTH) ? m->lines : 0);
    RANGE(TEX_FILTER, 0, sph_machine_effect(m, SPH_EFFECT_TEXTURE) ? 3 : 0);
    RANGE(COARSE, 0, sph_machine_effect(m, SPH_EFFECT_TEXTURE) ? SPH_LOD_BITS : 0);
    int64_t prims = r[SPH_REG_PRIM_BASE], behind = prims + r[SPH_REG_N_PRIMS];
    int built = r[SPH_REG_ROOT] >= behind; /* by rt_top, which has a place there */
    RANGE(ROOT, built ? behind : 0, built ? m->lines - 1 : prims - 1);
    RANGE(VISIT_LIMIT, 1, 0xffffff);
    RANGE(TREE, 1, SPH_TREE_LAST);
    if (!sph_machine_effect(m, SPH_EFFECT_CAMERA)) RANGE(ONE_CAMERA, 0, 0);
    if (sph_camera_strayed(m))
        return sph_fail(err,
                        "register ONE_CAMERA is %d, the camera's sum is %d: what is left out "
                        "holds for another one",
                        r[SPH_REG_ONE_CAMERA], sph_camera_sum(m));
    return 0;
}

/* Spans of background separation: every row within the frame. */
static int check_spans(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    uint32_t base = (uint32_t)r[SPH_REG_BG_BASE], width = (uint32_t)r[SPH_REG_FRAME_W];
    for (uint32_t y = 0; y < (uint32_t)r[SPH_REG_FRAME_H]; y++) {
        const uint32_t *word = sph_line(m, base + y / SPH_LINE_WORDS) + y % SPH_LINE_WORDS;
        uint32_t x0 = sph_field(word, SPH_SPAN_X0_LSB, SPH_SPAN_X0_BITS);
        uint32_t x1 = sph_field(word, SPH_SPAN_X1_LSB, SPH_SPAN_X1_BITS);
        if (x0 > x1 || x1 > width)
            return sph_fail(err, "line %u: span of row %u is %u..%u, the frame has %u columns",
                            base + y / SPH_LINE_WORDS, y, x0, x1, width);
    }
    return 0;
}

/* 1 if n words are a number of `bits` bits, sign extended. */
static int extended(const uint32_t *word, int n, int bits) {
    int top = (bits - 1) / 32;
    int32_t sign = (int32_t)(word[top] << (31 - (bits - 1) % 32)) >> 31;
    if ((int32_t)word[top] >> (bits - 1) % 32 != sign) return 0;
    while (++top < n)
        if (word[top] != (uint32_t)sign) return 0;
    return 1;
}

/* Cone records: every number in the width that the hardware keeps. */
static int check_cones(const struct sph_machine *m, struct sph_error *err) {
    const struct sph_profile *p = sph_machine_profile(m);
    int f_bits = 2 * p->w + 2 * p->wd + 4, b_bits = p->w + p->wd + 4;
    for (int i = 0; i < m->regs[SPH_REG_BG_COUNT]; i++) {
        uint32_t base = (uint32_t)(m->regs[SPH_REG_BG_BASE] + SPH_CONE_LINES * i);
        const uint32_t *cone = sph_line(m, base);
        int good = 1, tail = SPH_CONE_INSIDE_LSB / 32;
        for (int lsb = SPH_CONE_F_LSB; lsb <= SPH_CONE_FYY_LSB; lsb += SPH_CONE_F_BITS)
            good &= extended(cone + lsb / 32, SPH_CONE_F_BITS / 32, f_bits);
        for (int lsb = SPH_CONE_B_LSB; lsb <= SPH_CONE_BY_LSB; lsb += SPH_CONE_B_BITS)
            good &= extended(cone + lsb / 32, SPH_CONE_B_BITS / 32, b_bits);
        if (!good || cone[tail] > 1 || cone[tail + 1])
            return sph_fail(err, "line %u: cone %d does not fit %d and %d bits", base, i, f_bits,
                            b_bits);
    }
    return 0;
}

/* Background separation: its table behind the primitive records, and what stands in it. */
static int check_background(const struct sph_machine *m, struct sph_error *err) {
    const int32_t *r = m->regs;
    int mode = r[SPH_REG_BG_MODE], rows = (r[SPH_REG_FRAME_H] + SPH_LINE_WORDS - 1);
    RANGE(BG_COUNT, 0, mode == 3 ? SPH_MAX_CONES : 0);
    int lines = mode == 2   ? rows / SPH_LINE_WORDS
                : mode == 3 ? SPH_CONE_LINES * r[SPH_REG_BG_COUNT]
                            : 0;
    if (mode < 2) {
        RANGE(BG_BASE, 0, 0);
        return 0;
    }
    int64_t first = sph_machine_effect(m, SPH_EFFECT_FACETS)
                        ? r[SPH_REG_FACET_BASE] + sph_machine_facets(m)
                        : (int64_t)r[SPH_REG_PRIM_BASE] + r[SPH_REG_N_PRIMS];
    RANGE(BG_BASE, first, (int64_t)m->lines - lines);
    return mode == 2 ? check_spans(m, err) : check_cones(m, err);
}

int sph_machine_validate(const struct sph_machine *m, struct sph_error *err) {
    if (check_profile(m, err) || check_frame(m, err) || check_geometry(m, err) ||
        check_memory(m, err) || check_background(m, err))
        return -1;
    if (sph_machine_effect(m, SPH_EFFECT_FACETS) && sph_validate_facets(m, err)) return -1;
    if (sph_machine_effect(m, SPH_EFFECT_TEXTURE) && sph_validate_textures(m, err)) return -1;
    if (sph_validate_materials(m, err)) return -1;
    return sph_machine_bih(m) ? sph_validate_bih(m, err) : sph_validate_tree(m, err);
}

int sph_machine_read(const char *path, struct sph_machine *m, struct sph_error *err) {
    struct sph_error why = {{0}};
    if (sph_machine_load(path, m, err)) return -1;
    if (!sph_machine_validate(m, &why)) return 0;
    sph_machine_free(m);
    return sph_fail(err, "%s: %.400s", path, why.text);
}
