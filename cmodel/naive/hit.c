/* hit.c - the naive model: what a ray hits, where, and what leaves there; see hit.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. VI.A (hit point), VI.B (mirror).
 */
#include "naive/hit.h"

#include "naive/math.h"

static int on(const struct sph_machine *m, int effect) {
    return m->regs[SPH_REG_EFFECTS] & 1 << effect ? 1 : 0;
}

static uint32_t share(const uint32_t *line, int lsb, int bits) {
    uint32_t s = sph_field(line, lsb, bits);
    return s > 256 ? 256 : s;
}

static struct sph_naive_prim prim_read(const struct sph_machine *m, int32_t index) {
    const uint32_t *line = m->mem + (int64_t)SPH_LINE_WORDS * (m->regs[SPH_REG_PRIM_BASE] + index);
    struct sph_naive_prim p;
    for (int i = 0; i < 3; i++) {
        p.sphere.ctr[i] = sph_field_signed(line, 24 * i, 24);
        p.rgb[i] = sph_field(line, SPH_PRIM_RED_LSB + 8 * i, 8);
    }
    p.sphere.rad = sph_field(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
    p.sphere.id = sph_field(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    p.kr = share(line, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS);
    p.kt = share(line, SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS);
    p.sum = (int)sph_field(line, SPH_PRIM_SUM_LSB, SPH_PRIM_SUM_BITS);
    p.ka = share(line, SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS);
    p.kd = share(line, SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS);
    p.ks = sph_field(line, SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS);
    p.power = sph_field(line, SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS);
    p.index = sph_field(line, SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS);
    p.tex = sph_field(line, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
    p.bend = on(m, SPH_EFFECT_SPREAD) ? sph_field(line, SPH_PRIM_BEND_LSB, SPH_PRIM_BEND_BITS) : 0;
    p.facet = on(m, SPH_EFFECT_FACETS) && index >= m->regs[SPH_REG_N_SPHERES];
    p.smooth = p.facet && on(m, SPH_EFFECT_SMOOTH) ? (uint32_t)p.sphere.rad : 0;
    return p;
}

/* Meets facet `index`. */
static struct sph_naive_leaf facet(const struct sph_machine *m, const struct sph_ray *ray,
                                   int32_t index) {
    int32_t line = m->regs[SPH_REG_FACET_BASE] + index - m->regs[SPH_REG_N_SPHERES];
    struct sph_facet_leaf f = sph_naive_facet_read(m->mem + (int64_t)SPH_LINE_WORDS * line);
    return sph_naive_facet(sph_machine_profile(m), ray, &f);
}

/* Whether rays to lights go through primitive `index` as if it were not there. */
static int is_clear(const struct sph_machine *m, int32_t index) {
    int facet = on(m, SPH_EFFECT_FACETS) && index >= m->regs[SPH_REG_N_SPHERES];
    int64_t line = facet ? (int64_t)m->regs[SPH_REG_FACET_BASE] + index - m->regs[SPH_REG_N_SPHERES]
                         : (int64_t)m->regs[SPH_REG_PRIM_BASE] + index;
    const uint32_t *words = m->mem + SPH_LINE_WORDS * line;
    return on(m, SPH_EFFECT_CLEAR) && (facet ? words[7] >> 22 & 1 : words[3] >> 31);
}

/* Tests primitive `index`; a hit with a smaller key, or the same and a smaller id, replaces *best.
 */
static void consider(const struct sph_machine *m, const struct sph_ray *ray, int32_t index,
                     struct sph_naive_found *best) {
    if (ray->kind == SPH_SHADOW && is_clear(m, index)) return;
    struct sph_naive_prim prim = prim_read(m, index);
    struct sph_naive_leaf how =
        prim.facet ? facet(m, ray, index)
                   : sph_naive_leaf_bits(ray, &prim.sphere, sph_machine_profile(m)->pr);
    if (!how.hit) return;
    if (!best->how.hit || how.key < best->how.key ||
        (how.key == best->how.key && prim.sphere.id < best->prim.sphere.id))
        *best = (struct sph_naive_found){how, prim};
}

struct sph_naive_found sph_naive_trace(const struct sph_machine *m, const struct sph_ray *ray) {
    struct sph_naive_found best = {0};
    for (int32_t i = 0; i < m->regs[SPH_REG_N_PRIMS]; i++)
        consider(m, ray, i, &best);
    return best;
}

int sph_naive_within(const struct sph_machine *m, const struct sph_ray *ray, uint32_t own) {
    int within = 0;
    for (int32_t i = 0; i < m->regs[SPH_REG_N_PRIMS]; i++) {
        struct sph_naive_found one = {0};
        consider(m, ray, i, &one);
        within |= one.how.hit && one.how.far && one.prim.sphere.id != own;
    }
    return within;
}

struct sph_naive_found sph_naive_first(const struct sph_machine *m, const struct sph_ray *ray,
                                       uint32_t line) {
    const uint32_t *node = m->mem + (size_t)SPH_LINE_WORDS * line;
    uint32_t below = node[7] & 0x3ffffff, inner = node[7] >> 26 & 7, leaves = node[7] >> 29;
    struct sph_naive_found best = {0};
    for (uint32_t i = 0; i < leaves; i++) {
        const uint32_t *leaf = m->mem + (size_t)SPH_LINE_WORDS * (below + inner) + (size_t)4 * i;
        consider(m, ray, (int32_t)(leaf[3] & 0xffffff), &best);
    }
    for (uint32_t i = 0; i < inner && !best.how.hit; i++)
        best = sph_naive_first(m, ray, below + i);
    return best;
}

void sph_naive_mirror(const int64_t d[3], const int64_t n[3], int wd, int64_t out[3]) {
    mpz_t v[3], dn, nn, x;
    mpz_inits(v[0], v[1], v[2], dn, nn, x, NULL);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(x, n[i]);
        mpz_addmul(nn, x, x);
        mpz_mul_si(x, x, d[i]);
        mpz_add(dn, dn, x);
    }
    for (int i = 0; i < 3; i++) {
        mpz_mul_si(v[i], nn, d[i]);
        mpz_mul_si(x, dn, 2 * n[i]);
        mpz_sub(v[i], v[i], x);
    }
    sph_naive_normalise(v, wd, out);
    mpz_clears(v[0], v[1], v[2], dn, nn, x, NULL);
}

/* A coordinate x of a facet's point, with ng guard bits, to the grid: the number next to it on the
 * side that the normal's component n looks to; to nearest if n is 0. */
static void beyond(mpz_t x, int64_t n, int ng) {
    if (!n) {
        sph_naive_round(x, ng);
    } else if (n > 0) {
        mpz_fdiv_q_2exp(x, x, (mp_bitcnt_t)ng);
        mpz_add_ui(x, x, 1);
    } else {
        mpz_cdiv_q_2exp(x, x, (mp_bitcnt_t)ng);
        mpz_sub_ui(x, x, 1);
    }
}

/* A field of a record of normals, as it is drawn in machine.def. */
static int64_t word(const uint32_t *record, int lsb, int bits) {
    return sph_field_signed(record, lsb, bits);
}

/* v = n + m (g - b) / 2^e, rounded half up, both limited; 0 if nothing is left. */
static int interpolate(const struct sph_machine *m, uint32_t number, const int64_t g[3], int far,
                       mpz_t v[3]) {
    const struct sph_profile *p = sph_machine_profile(m);
    const uint32_t *r =
        m->mem + (int64_t)SPH_LINE_WORDS * (m->regs[SPH_REG_SMOOTH_BASE] + (int64_t)number - 1);
    mpz_t d;
    mpz_init(d);
    int any = 0;
    for (int i = 0; i < 3; i++) {
        mpz_set_ui(v[i], 0);
        for (int k = 0; k < 3; k++) {
            mpz_set_si(d, g[k] - word(r, 24 * k, 24) * (1 << p->ng));
            mpz_set_si(d, sph_naive_limit(d, p->w + p->ng));
            mpz_mul_si(d, d, word(r, 72 + 14 * (3 * i + k), 14));
            mpz_add(v[i], v[i], d);
        }
        sph_naive_round(v[i], (int)sph_field(r, 198, 6));
        mpz_set_si(d, word(r, 204 + 17 * i, 17));
        mpz_add(v[i], v[i], d);
        mpz_set_si(v[i], sph_naive_limit(v[i], 20));
        if (far) mpz_neg(v[i], v[i]);
        any |= mpz_sgn(v[i]) != 0;
    }
    mpz_clear(d);
    return any;
}

struct sph_naive_point sph_naive_point_of(const struct sph_machine *m, const struct sph_ray *ray,
                                          const struct sph_naive_found *f) {
    const struct sph_profile *p = sph_machine_profile(m);
    int64_t guarded[3];
    struct sph_naive_point s;
    uint64_t mant, a = 0;
    mpz_t n[3], x;
    mpz_inits(n[0], n[1], n[2], x, NULL);
    for (int i = 0; i < 3; i++)
        a += (uint64_t)(ray->dir[i] * ray->dir[i]);
    long exp = sph_naive_quotient(f->how.key, a, p->pq, &mant);
    for (int i = 0; i < 3; i++) {
        mpz_set_ui(n[i], mant);
        mpz_mul_si(n[i], n[i], ray->dir[i]);
        sph_naive_round(n[i], exp - p->ng);
        mpz_set_si(x, ray->org[i]);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)p->ng);
        mpz_add(n[i], n[i], x);
        mpz_set_si(n[i], sph_naive_limit(n[i], p->w + p->ng));
        mpz_set(x, n[i]);
        guarded[i] = s.guarded[i] = mpz_get_si(x);
        if (f->prim.facet)
            beyond(x, f->prim.sphere.ctr[i] * (f->how.far ? -1 : 1), p->ng);
        else
            sph_naive_round(x, p->ng);
        s.at[i] = sph_naive_limit(x, p->w);
        mpz_set_si(x, f->prim.sphere.ctr[i]);
        mpz_mul_2exp(x, x, (mp_bitcnt_t)p->ng);
        mpz_sub(n[i], n[i], x);
        if (f->prim.facet) mpz_set_si(n[i], f->prim.sphere.ctr[i]);
        if (f->how.far) mpz_neg(n[i], n[i]);
    }
    if (!mpz_sgn(n[0]) && !mpz_sgn(n[1]) && !mpz_sgn(n[2]))
        for (int i = 0; i < 3; i++)
            mpz_set_si(n[i], -ray->dir[i]);
    sph_naive_normalise(n, p->wd, s.normal);
    for (int i = 0; i < 3; i++) {
        int side = f->prim.facet ? (s.normal[i] > 0) - (s.normal[i] < 0) : 0;
        mpz_set_si(x, s.at[i] - side * (2 + (4ll << p->w >> p->pq)));
        s.behind[i] = sph_naive_limit(x, p->w);
        s.side[i] = s.normal[i];
    }
    s.bent = f->prim.smooth && interpolate(m, f->prim.smooth, guarded, f->how.far, n);
    if (s.bent) sph_naive_normalise(n, p->wd, s.normal);
    sph_naive_unit(s.normal, p->wd, s.unit);
    mpz_clears(n[0], n[1], n[2], x, NULL);
    return s;
}
