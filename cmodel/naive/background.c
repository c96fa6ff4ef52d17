/* background.c - background separation by definition; see naive.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <gmp.h>

#include "naive/naive.h"

/* x as the two's complement number that `bits` bits hold of it. */
static void wrap(mpz_t x, unsigned bits) {
    mpz_fdiv_r_2exp(x, x, bits);
    if (mpz_tstbit(x, bits - 1)) {
        mpz_t all;
        mpz_init(all);
        mpz_setbit(all, bits);
        mpz_sub(x, x, all);
        mpz_clear(all);
    }
}

/* x += factor * (the number in `bits` bits of line `from`, lowest bit lsb). */
static void add(mpz_t x, int64_t factor, const uint32_t *from, int lsb, int bits) {
    mpz_t term;
    mpz_init(term);
    mpz_import(term, (size_t)bits / 32, -1, sizeof *from, 0, 0, from + lsb / 32);
    wrap(term, (unsigned)bits);
    mpz_mul_si(term, term, factor);
    mpz_add(x, x, term);
    mpz_clear(term);
}

static int in_cone(const struct sph_machine *m, const uint32_t *cone, int64_t x, int64_t y) {
    const struct sph_profile *p = sph_machine_profile(m);
    mpz_t f, b;
    mpz_inits(f, b, NULL);
    add(f, 1, cone, SPH_CONE_F_LSB, SPH_CONE_F_BITS);
    add(f, x, cone, SPH_CONE_FX_LSB, SPH_CONE_FX_BITS);
    add(f, y, cone, SPH_CONE_FY_LSB, SPH_CONE_FY_BITS);
    add(f, x * (x - 1) / 2, cone, SPH_CONE_FXX_LSB, SPH_CONE_FXX_BITS);
    add(f, y * (y - 1) / 2, cone, SPH_CONE_FYY_LSB, SPH_CONE_FYY_BITS);
    add(f, x * y, cone, SPH_CONE_FXY_LSB, SPH_CONE_FXY_BITS);
    add(b, 1, cone, SPH_CONE_B_LSB, SPH_CONE_B_BITS);
    add(b, x, cone, SPH_CONE_BX_LSB, SPH_CONE_BX_BITS);
    add(b, y, cone, SPH_CONE_BY_LSB, SPH_CONE_BY_BITS);
    wrap(f, (unsigned)(2 * p->w + 2 * p->wd + 4));
    wrap(b, (unsigned)(p->w + p->wd + 4));
    int inside = cone[SPH_CONE_INSIDE_LSB / 32] & 1;
    int in = mpz_sgn(f) > 0 && (inside || mpz_sgn(b) > 0);
    mpz_clears(f, b, NULL);
    return in;
}

int sph_naive_background(const struct sph_machine *m, int x, int y) {
    const int32_t *r = m->regs;
    size_t base = (uint32_t)r[SPH_REG_BG_BASE], lines = (uint32_t)r[SPH_REG_MEM_LINES];
    size_t rows = (size_t)r[SPH_REG_WIN_Y1], cones = (size_t)r[SPH_REG_BG_COUNT];
    if (r[SPH_REG_BG_MODE] == 1) {
        int across = r[SPH_REG_RECT_X0] <= x && x < r[SPH_REG_RECT_X1];
        return !(across && r[SPH_REG_RECT_Y0] <= y && y < r[SPH_REG_RECT_Y1]);
    }
    if (r[SPH_REG_BG_MODE] == 2 && base + rows / 8 + (rows % 8 > 0) <= lines) {
        uint32_t span = m->mem[base * SPH_LINE_WORDS + (size_t)y];
        return x < (int)(span & 0xffff) || x >= (int)(span >> 16);
    }
    if (r[SPH_REG_BG_MODE] == 3 && base + 4 * cones <= lines) {
        for (size_t i = 0; i < cones; i++)
            if (in_cone(m, m->mem + (base + 4 * i) * SPH_LINE_WORDS, x, y)) return 0;
        return 1;
    }
    return 0;
}
