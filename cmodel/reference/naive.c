/* naive.c - a pixel from ray to colours, see naive.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. V (background), VI.A (hit point), VI.B (mirror), VI.C (light, shadow).
 */
#include "reference/naive.h"

#include "reference/naive_math.h"

struct prim {
    struct sph_leaf sphere; /* of a facet: ctr is the normal */
    int facet;
    uint32_t rgb[3], kr;
};

struct found {
    struct sph_naive_leaf how;
    struct prim prim;
};

struct point { /* where a ray ends */
    int64_t at[3], normal[3], unit[3];
};

static int64_t min(int64_t a, int64_t b) {
    return a < b ? a : b;
}

static int on(const struct sph_machine *m, int effect) {
    return m->regs[SPH_REG_EFFECTS] & 1 << effect ? 1 : 0;
}

static struct prim prim_read(const struct sph_machine *m, int32_t index) {
    const uint32_t *line = m->mem + (int64_t)SPH_LINE_WORDS * (m->regs[SPH_REG_PRIM_BASE] + index);
    struct prim p;
    for (int i = 0; i < 3; i++) {
        p.sphere.ctr[i] = sph_field_signed(line, 24 * i, 24);
        p.rgb[i] = sph_field(line, SPH_PRIM_RED_LSB + 8 * i, 8);
    }
    p.sphere.rad = sph_field(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
    p.sphere.id = sph_field(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    p.kr = sph_field(line, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS);
    p.facet = on(m, SPH_EFFECT_FACETS) && index >= m->regs[SPH_REG_N_SPHERES];
    return p;
}

/* Meets facet `index`. */
static struct sph_naive_leaf facet(const struct sph_machine *m, const struct sph_ray *ray,
                                   int32_t index) {
    int32_t line = m->regs[SPH_REG_FACET_BASE] + index - m->regs[SPH_REG_N_SPHERES];
    struct sph_facet_leaf f = sph_naive_facet_read(m->mem + (int64_t)SPH_LINE_WORDS * line);
    return sph_naive_facet(ray, &f, sph_machine_profile(m)->w);
}

/* Tests primitive `index`; a hit with a smaller key, or the same and a smaller id, replaces *best.
 */
static void consider(const struct sph_machine *m, const struct sph_ray *ray, int32_t index,
                     struct found *best) {
    struct prim prim = prim_read(m, index);
    struct sph_naive_leaf how =
        prim.facet ? facet(m, ray, index)
                   : sph_naive_leaf_bits(ray, &prim.sphere, sph_machine_profile(m)->pr);
    if (!how.hit) return;
    if (!best->how.hit || how.key < best->how.key ||
        (how.key == best->how.key && prim.sphere.id < best->prim.sphere.id))
        *best = (struct found){how, prim};
}

/* The first hit in the order of keys, then ids; any hit of a shadow ray. */
static struct found trace(const struct sph_machine *m, const struct sph_ray *ray) {
    struct found best = {0};
    for (int32_t i = 0; i < m->regs[SPH_REG_N_PRIMS]; i++)
        consider(m, ray, i, &best);
    return best;
}

/* Of the nodes from `line` down, each before its children, the first with a leaf that is hit. */
static struct found first_node(const struct sph_machine *m, const struct sph_ray *ray,
                               uint32_t line) {
    const uint32_t *node = m->mem + (size_t)SPH_LINE_WORDS * line;
    uint32_t below = node[7] & 0x3ffffff, inner = node[7] >> 26 & 7, leaves = node[7] >> 29;
    struct found best = {0};
    for (uint32_t i = 0; i < leaves; i++) {
        const uint32_t *leaf = m->mem + (size_t)SPH_LINE_WORDS * (below + inner) + (size_t)4 * i;
        consider(m, ray, (int32_t)(leaf[3] & 0xffffff), &best);
    }
    for (uint32_t i = 0; i < inner && !best.how.hit; i++)
        best = first_node(m, ray, below + i);
    return best;
}

/* Sets vec to direction - 2 * (direction . normal) / (normal . normal) * normal, free of division.
 */
static void mirror(const int64_t d[3], const int64_t n[3], int wd, int64_t out[3]) {
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

/* org + t*dir with guard bits; the normal points to the side that the ray came from. */
static struct point point_of(const struct sph_profile *p, const struct sph_ray *ray,
                             const struct found *f) {
    struct point s;
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
    sph_naive_unit(s.normal, p->wd, s.unit);
    mpz_clears(n[0], n[1], n[2], x, NULL);
    return s;
}

/* Ambient light and all lights that the point faces and sees, u2.15. */
static void light(const struct sph_machine *m, const struct found *f, const struct point *s,
                  int64_t sum[3]) {
    const struct sph_profile *p = sph_machine_profile(m);
    for (int i = 0; i < 3; i++)
        sum[i] = m->regs[SPH_REG_AMBIENT_R + i];
    for (int l = 0; l < m->regs[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = &m->regs[SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l];
        struct sph_ray ray = {.kind = SPH_SHADOW,
                              .skip = {f->prim.sphere.id, f->how.far},
                              .inside = on(m, SPH_EFFECT_INSIDE)};
        int64_t to[3], cosine = 0;
        for (int i = 0; i < 3; i++) {
            ray.org[i] = s->at[i];
            ray.dir[i] = lamp[i] - s->at[i];
        }
        sph_naive_unit(ray.dir, p->wd, to);
        for (int i = 0; i < 3; i++)
            cosine += to[i] * s->unit[i];
        cosine = min(sph_naive_round64(cosine, 17), 32768);
        if (cosine <= 0) continue;
        if (on(m, SPH_EFFECT_SHADOW) && trace(m, &ray).how.hit) continue;
        for (int i = 0; i < 3; i++)
            sum[i] = min(sum[i] + sph_naive_round64(cosine * lamp[3 + i], 15), 131071);
    }
}

/* The ray that leaves a point in the mirror direction of the ray that came. */
static struct sph_ray mirror_ray(const struct sph_machine *m, const struct sph_ray *ray,
                                 const struct found *f, const struct point *s) {
    struct sph_ray next = {.kind = SPH_REFLECTED,
                           .skip = {f->prim.sphere.id, f->how.far},
                           .inside = on(m, SPH_EFFECT_INSIDE)};
    for (int i = 0; i < 3; i++)
        next.org[i] = s->at[i];
    mirror(ray->dir, s->normal, sph_machine_profile(m)->wd, next.dir);
    return next;
}

/* 1 if the point that the tree's first hit shows is known to lie in another sphere. */
static int buried(const struct sph_machine *m, const struct sph_ray *ray) {
    struct found f = first_node(m, ray, (uint32_t)m->regs[SPH_REG_ROOT]);
    if (!f.how.hit) return 0;
    struct point s = point_of(sph_machine_profile(m), ray, &f);
    struct sph_ray next = mirror_ray(m, ray, &f, &s);
    struct found around = trace(m, &next);
    return around.how.hit && around.how.far && around.prim.sphere.id != f.prim.sphere.id;
}

struct sph_pixel sph_naive_pixel(const struct sph_machine *m, int x, int y) {
    const int32_t *r = m->regs;
    const struct sph_profile *p = sph_machine_profile(m);
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    int background = sph_naive_background(m, x, y);
    int64_t weight = 65536, sum[3] = {0};
    struct sph_ray ray = {.org = {r[SPH_REG_EYE_X], r[SPH_REG_EYE_Y], r[SPH_REG_EYE_Z]},
                          .dir = {(int64_t)r[SPH_REG_DIR_X0] + (int64_t)x * r[SPH_REG_PITCH],
                                  (int64_t)r[SPH_REG_DIR_Y0] - (int64_t)y * r[SPH_REG_PITCH],
                                  r[SPH_REG_DIR_Z]},
                          .kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = on(m, SPH_EFFECT_INSIDE)};
    int first = on(m, SPH_EFFECT_FIRST) && !(on(m, SPH_EFFECT_INTERPENETRATE) && buried(m, &ray));
    int last = 0;
    for (int depth = 0; !last; depth++) {
        struct found f = {0};
        struct point s = {0};
        int64_t colour[3], lit[3];
        if (!background)
            f = first && depth == 0 ? first_node(m, &ray, (uint32_t)r[SPH_REG_ROOT])
                                    : trace(m, &ray);
        if (depth == 0 && f.how.hit) pixel.id = f.prim.sphere.id, pixel.key = f.how.key;
        if (f.how.hit) {
            s = point_of(p, &ray, &f);
            light(m, &f, &s, lit);
        }
        for (int i = 0; i < 3; i++)
            colour[i] = f.how.hit ? min(sph_naive_round64(f.prim.rgb[i] * lit[i], 7), 255 * 256)
                                  : 256 * (int64_t)(r[SPH_REG_BG_COLOUR] >> (8 * i) & 255);
        last =
            !f.how.hit || !f.prim.kr || !on(m, SPH_EFFECT_REFLECT) || depth == r[SPH_REG_MAX_DEPTH];

        uint32_t seen = 0; /* as if nothing came behind */
        int64_t front = sph_naive_round64(weight * (256 - f.prim.kr), 8);
        for (int i = 0; i < 3; i++) {
            int64_t all = sum[i] + sph_naive_round64(weight * colour[i], 16);
            seen |= (uint32_t)min(sph_naive_round64(all, 8), 255) << (8 * i);
            sum[i] += sph_naive_round64(front * colour[i], 16);
        }
        weight = sph_naive_round64(weight * f.prim.kr, 8);
        for (int i = 0; i < SPH_FRAMES; i++)
            if (depth <= i || i == SPH_FRAMES - 1) pixel.colour[i] = seen;

        if (last) break;
        ray = mirror_ray(m, &ray, &f, &s);
    }
    return pixel;
}
