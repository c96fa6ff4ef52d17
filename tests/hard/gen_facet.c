/* gen_facet.c - families of triangles and planes
 * SPDX-License-Identifier: Apache-2.0
 *
 * Targets are points of the grid that divide an edge in whole steps, so that a ray meets them
 * exactly.
 */
#include <string.h>

#include "gen.h"

void gen_facets(struct hard_case *c, int kind, int n) {
    c->n = n;
    for (int i = 0; i < n; i++)
        c->facet[i] = (struct sph_facet_leaf){.kind = kind, .id = i ? HARD_OTHER : HARD_ID};
}

void gen_towards(struct sph_rng *rng, const struct sph_profile *p, const int64_t at[3],
                 struct hard_case *c) {
    int64_t longest = 1, end = (1ll << (p->wd - 1)) - 1;
    for (int i = 0; i < 3; i++) {
        int64_t d = c->ray.dir[i] = at[i] - c->ray.org[i];
        if (d > longest || -d > longest) longest = d < 0 ? -d : d;
    }
    int64_t scale = vec_pick(rng, 1, end / longest);
    c->through = 1;
    if (gen_one_in(rng, 8)) {
        c->ray.kind = SPH_SHADOW;
        scale = scale > 2 ? vec_pick(rng, 1, 2) : 1; /* t = 1: no shadow; t = 1/2 */
    }
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] *= scale;
    int i = (int)vec_pick(rng, 0, 2);
    if (gen_one_in(rng, 3) || c->ray.dir[i] < -end) {
        c->ray.dir[i] += c->ray.dir[i] > 0 ? -1 : 1;
        c->through = 0;
    }
}

/* An edge of n whole steps between two points of the grid; the steps. */
static int64_t edge(struct sph_rng *rng, const struct sph_profile *p, int64_t a[3], int64_t b[3]) {
    int64_t n = 1ll << vec_pick(rng, 0, 4), room = 2 * gen_half(p) / n - 1;
    int bits = (int)vec_pick(rng, 1, p->w - 5);
    do {
        gen_point(rng, p, a);
        for (int i = 0; i < 3; i++) {
            int64_t most = gen_one_in(rng, 4) ? room : 1ll << bits;
            b[i] = a[i] + n * vec_pick(rng, -most, most);
        }
    } while (!gen_on_grid(p, b));
    return n;
}

static void between(struct sph_rng *rng, const int64_t a[3], const int64_t b[3], int64_t n,
                    int64_t out[3]) {
    int64_t step = vec_pick(rng, 0, n);
    for (int i = 0; i < 3; i++)
        out[i] = a[i] + (b[i] - a[i]) / n * step;
}

void gen_corners(struct sph_facet_leaf *f, const int64_t a[3], const int64_t b[3],
                 const int64_t c[3]) {
    memcpy(f->v[0], a, sizeof f->v[0]);
    memcpy(f->v[1], b, sizeof f->v[1]);
    memcpy(f->v[2], c, sizeof f->v[2]);
}

/* A point anywhere, or a few units from `near`. */
static void some_point(struct sph_rng *rng, const struct sph_profile *p, const int64_t near[3],
                       int64_t out[3]) {
    int close = gen_one_in(rng, 3);
    gen_point(rng, p, out);
    for (int i = 0; i < 3 && close; i++)
        out[i] = gen_clamp(p, near[i] + vec_pick(rng, -4, 4));
}

void gen_edge(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t a[3], b[3], left[3], right[3], at[3], n = edge(rng, p, a, b);
    gen_facets(c, SPH_TRIANGLE, 2);
    some_point(rng, p, a, left);
    some_point(rng, p, b, right);
    gen_corners(&c->facet[0], a, b, left);
    gen_corners(&c->facet[1], b, a, right);
    between(rng, a, b, n, at);
    some_point(rng, p, at, c->ray.org);
    gen_towards(rng, p, at, c);
}

void gen_vertex(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t at[3], rim[3][3];
    gen_facets(c, SPH_TRIANGLE, 2);
    gen_point(rng, p, at);
    for (int i = 0; i < 3; i++)
        some_point(rng, p, at, rim[i]);
    gen_corners(&c->facet[0], at, rim[0], rim[1]);
    gen_corners(&c->facet[1], rim[2], at, rim[1]);
    some_point(rng, p, at, c->ray.org);
    gen_towards(rng, p, at, c);
    if (!gen_one_in(rng, 4)) return;
    c->ray.skip.id = HARD_OTHER + (uint32_t)vec_pick(rng, 0, 3); /* a group's ends, and beside */
    c->facet[0].after = (uint32_t)vec_pick(rng, 0, 4);
    c->facet[1].after = (uint32_t)vec_pick(rng, 0, 2);
}

void gen_sliver(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t a[3], b[3], tip[2][3], at[3], n = edge(rng, p, a, b);
    gen_facets(c, SPH_TRIANGLE, 2);
    for (int k = 0; k < 2; k++) { /* a unit or two from the edge; none: without area */
        between(rng, a, b, n, tip[k]);
        for (int i = 0; i < 3; i++)
            tip[k][i] = gen_clamp(p, tip[k][i] + vec_pick(rng, -1 - k, 1 + k));
    }
    gen_corners(&c->facet[0], a, b, tip[0]);
    gen_corners(&c->facet[1], b, a, tip[1]);
    between(rng, a, b, n, at);
    gen_point(rng, p, c->ray.org);
    gen_towards(rng, p, at, c);
}

/* Two triangles in one plane, which may lie over one another. */
void gen_flat(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t v[7][3], s[2][3], base[3], room = gen_half(p) / 8;
    do {
        gen_point(rng, p, base);
        for (int i = 0; i < 3; i++) {
            s[0][i] = vec_pick(rng, -4, 4);
            s[1][i] = vec_pick(rng, -4, 4);
        }
        for (int k = 0; k < 7; k++) {
            int64_t x = vec_pick(rng, -room, room), y = vec_pick(rng, -room, room);
            if (gen_one_in(rng, 3)) x = y = vec_pick(rng, -2, 2);
            for (int i = 0; i < 3; i++)
                v[k][i] = base[i] + x * s[0][i] + y * s[1][i];
        }
    } while (!gen_on_grid(p, v[0]) || !gen_on_grid(p, v[1]) || !gen_on_grid(p, v[2]) ||
             !gen_on_grid(p, v[3]) || !gen_on_grid(p, v[4]) || !gen_on_grid(p, v[5]) ||
             !gen_on_grid(p, v[6]));
    gen_facets(c, SPH_TRIANGLE, 2);
    gen_corners(&c->facet[0], v[0], v[1], v[2]);
    gen_corners(&c->facet[1], v[3], v[4], v[5]);
    gen_point(rng, p, c->ray.org);
    if (gen_one_in(rng, 4)) /* from their plane, or a unit beside it */
        for (int i = 0; i < 3; i++)
            c->ray.org[i] = gen_clamp(p, v[2][i] + (gen_one_in(rng, 3) ? 1 : 0));
    gen_towards(rng, p, gen_one_in(rng, 2) ? v[3] : v[6], c);
    c->through = 0;
}

/* To a light, from a point of a surface that was rounded. */
static void leave(struct sph_rng *rng, const struct sph_profile *p, struct sph_ray *ray) {
    ray->kind = SPH_SHADOW;
    for (int i = 0; i < 3; i++)
        ray->lift[i] = vec_pick(rng, -(1 << p->ng), 1 << p->ng);
}

/* Nearly along the plane of a triangle, from a unit beside it. */
void gen_skim(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t a[3], b[3], tip[3], end = (1ll << (p->wd - 1)) - 1, n = edge(rng, p, a, b);
    gen_facets(c, SPH_TRIANGLE, 1);
    some_point(rng, p, a, tip);
    gen_corners(&c->facet[0], a, b, tip);
    between(rng, a, b, n, c->ray.org);
    for (int i = 0; i < 3; i++) {
        c->ray.org[i] =
            gen_clamp(p, c->ray.org[i] + (gen_one_in(rng, 2) ? vec_pick(rng, -1, 1) : 0));
        int64_t d = tip[i] - c->ray.org[i] + vec_pick(rng, -1, 1);
        c->ray.dir[i] = d > end ? end : d < -end ? -end : d;
    }
    if (gen_one_in(rng, 2)) leave(rng, p, &c->ray);
}

/* A normal of 24 bits that is nearly at right angles to the ray. */
static void beside(struct sph_rng *rng, const struct sph_profile *p, const int64_t dir[3],
                   int64_t normal[3]) {
    int64_t u[3], most = 0;
    (void)p;
    for (int i = 0; i < 3; i++)
        u[i] = vec_pick(rng, -1000, 1000);
    for (int i = 0; i < 3; i++) {
        normal[i] = dir[(i + 1) % 3] * u[(i + 2) % 3] - dir[(i + 2) % 3] * u[(i + 1) % 3];
        if (normal[i] > most || -normal[i] > most) most = normal[i] < 0 ? -normal[i] : normal[i];
    }
    for (int i = 0; i < 3; i++)
        normal[i] =
            (most >= 1 << 23 ? normal[i] * 0x7ffff0 / most : normal[i]) + vec_pick(rng, -2, 2);
}

void gen_plane(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t end = (1ll << (p->wd - 1)) - 1;
    gen_facets(c, SPH_PLANE, 1);
    gen_point(rng, p, c->ray.org);
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] = gen_one_in(rng, 4) ? gen_sign(rng) * gen_log(rng, p->wd - 1)
                                           : vec_pick(rng, -end - 1, end);
    some_point(rng, p, c->ray.org, c->facet[0].v[0]);
    beside(rng, p, c->ray.dir, c->facet[0].v[1]);
    if (gen_one_in(rng, 4)) /* a face of the world */
        for (int i = 0, axis = (int)vec_pick(rng, 0, 2); i < 3; i++) {
            c->facet[0].v[1][i] = i == axis ? gen_sign(rng) * gen_log(rng, 23) : 0;
            if (i == axis)
                c->facet[0].v[0][i] = gen_one_in(rng, 2) ? -gen_half(p) : gen_half(p) - 1;
        }
}

/* Two planes through one point of the ray; one of them a unit away. */
void gen_planes(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t at[3];
    gen_facets(c, SPH_PLANE, 2);
    gen_point(rng, p, at);
    some_point(rng, p, at, c->ray.org);
    gen_towards(rng, p, at, c);
    for (int k = 0; k < 2; k++) {
        memcpy(c->facet[k].v[0], at, sizeof at);
        if (gen_one_in(rng, 3))
            beside(rng, p, c->ray.dir, c->facet[k].v[1]);
        else
            for (int i = 0; i < 3; i++)
                c->facet[k].v[1][i] = gen_sign(rng) * gen_log(rng, gen_one_in(rng, 2) ? 23 : 3);
    }
    int i = (int)vec_pick(rng, 0, 2);
    if (gen_one_in(rng, 3)) c->facet[1].v[0][i] = gen_clamp(p, c->facet[1].v[0][i] + gen_sign(rng));
}
