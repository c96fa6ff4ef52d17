/* gen_tie.c - families where surfaces of several kinds lie in one place, or the eye lies in them
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "gen.h"

static void cross(const int64_t a[3], const int64_t b[3], int64_t out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* at + x a + y b */
static void step(const int64_t at[3], int64_t x, const int64_t a[3], int64_t y, const int64_t b[3],
                 int64_t out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = at[i] + x * a[i] + y * b[i];
}

static void small(struct sph_rng *rng, int64_t most, int64_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = vec_pick(rng, -most, most);
}

/* The size of the longest component, at least 1. */
static int64_t longest(const int64_t v[3]) {
    int64_t most = 1;
    for (int i = 0; i < 3; i++)
        most = v[i] > most ? v[i] : -v[i] > most ? -v[i] : most;
    return most;
}

/* A normal of up to 24 bits along n, either way. */
static void normal_along(struct sph_rng *rng, const int64_t n[3], int64_t out[3]) {
    int64_t scale = gen_sign(rng) * vec_pick(rng, 1, ((1 << 23) - 1) / longest(n));
    for (int i = 0; i < 3; i++)
        out[i] = n[i] * scale;
}

/* A triangle or plane of the case that passes through a point of the grid: inside it, on an edge or
 * at a corner; along, if it is not NULL, gets a direction in its plane. */
static void facet_through(struct sph_rng *rng, const struct sph_profile *p, const int64_t at[3],
                          struct sph_facet_leaf *f, int64_t along[3]) {
    int64_t v[3][3], e1[3], e2[3], n[3];
    int id = (int)f->id;
    int64_t most = 1ll << vec_pick(rng, 1, p->w - 3);
    *f = (struct sph_facet_leaf){.kind = gen_one_in(rng, 3) ? SPH_PLANE : SPH_TRIANGLE,
                                 .id = (uint32_t)id};
    if (f->kind == SPH_PLANE && most > 1000) most = 1000; /* its normal has 24 bits */
    do {
        small(rng, most, e1);
        small(rng, most, e2);
        int64_t inside = vec_pick(rng, 0, 2); /* 0: a corner, 1: an edge, 2: the middle */
        step(at, inside ? -1 : 0, e1, inside > 1 ? -1 : 0, e2, v[0]);
        step(at, 1, e1, 0, e2, v[1]);
        step(at, 0, e1, 1, e2, v[2]);
        cross(e1, e2, n);
    } while (!gen_on_grid(p, v[0]) || !gen_on_grid(p, v[1]) || !gen_on_grid(p, v[2]) ||
             (!n[0] && !n[1] && !n[2]));
    gen_corners(f, v[0], v[1], v[2]);
    if (f->kind == SPH_PLANE) {
        normal_along(rng, n, f->v[1]);
        memset(f->v[2], 0, sizeof f->v[2]);
    }
    if (along) memcpy(along, gen_one_in(rng, 2) ? e1 : e2, 3 * sizeof *along);
}

void gen_coplane(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t s[2][3], n[3], v[5][3], at[3], base[3], room = gen_half(p) / 64;
    int of = (int)vec_pick(rng, 0, 1), i = (int)vec_pick(rng, 0, 2), placed;
    do { /* three corners in steps of four, a point of the plane, one of the triangle */
        gen_point(rng, p, base);
        small(rng, 4, s[0]);
        small(rng, 4, s[1]);
        cross(s[0], s[1], n);
        placed = n[0] || n[1] || n[2];
        for (int k = 0; k < 5; k++) {
            step(base, 4 * vec_pick(rng, -room, room), s[0], 4 * vec_pick(rng, -room, room), s[1],
                 v[k]);
            placed &= gen_on_grid(p, v[k]);
        }
    } while (!placed);
    int64_t weight = vec_pick(rng, 0, 4), rest = 4 - weight, second = vec_pick(rng, 0, rest);
    for (int k = 0; k < 3; k++)
        at[k] = v[0][k] + (weight * (v[1][k] - v[0][k]) + second * (v[2][k] - v[0][k])) / 4;
    gen_facets(c, SPH_TRIANGLE, 2);
    gen_corners(&c->facet[of], v[0], v[1], v[2]);
    c->facet[1 - of].kind = SPH_PLANE;
    memcpy(c->facet[1 - of].v[0], v[3], sizeof v[3]);
    normal_along(rng, n, c->facet[1 - of].v[1]);
    gen_point(rng, p, c->ray.org);
    gen_towards(rng, p, at, c);
    if (!gen_one_in(rng, 3)) return;
    int64_t *moved = &c->facet[1 - of].v[0][i];
    *moved = gen_clamp(p, *moved + gen_sign(rng));
    c->through = 0;
}

/* Directions of pixels as a camera has them: a distance along one axis, whole pitches along the
 * others. The edge runs from the ray of one pixel to that of another. */
void gen_pixel(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t most = 1ll << vec_pick(rng, 3, 7), a[3], b[3], g[3], mid[3], v[4][3], n;
    int64_t pitch = vec_pick(rng, 1, 3), far = gen_half(p) / (2 * most);
    int axis = (int)vec_pick(rng, 0, 2), i = (int)vec_pick(rng, 0, 2);
    do {
        n = vec_pick(rng, 2, 8);
        small(rng, most, a);
        small(rng, 2, g);
        a[axis] = gen_sign(rng) * vec_pick(rng, 1, 4 * most);
        g[axis] = 0;
        step(a, n * pitch, g, 0, g, b);
        step(a, vec_pick(rng, 0, n) * pitch, g, 0, g, mid);
        gen_point(rng, p, c->ray.org);
        step(c->ray.org, vec_pick(rng, 1, far), a, 0, a, v[0]);
        step(c->ray.org, vec_pick(rng, 1, far), b, 0, b, v[1]);
    } while (!gen_on_grid(p, v[0]) || !gen_on_grid(p, v[1]));
    gen_point(rng, p, v[2]);
    gen_point(rng, p, v[3]);
    gen_facets(c, SPH_TRIANGLE, 2);
    gen_corners(&c->facet[0], v[0], v[1], v[2]);
    gen_corners(&c->facet[1], v[1], v[0], v[3]);
    int64_t scale = vec_pick(rng, 1, ((1ll << (p->wd - 1)) - 2) / longest(mid));
    for (int k = 0; k < 3; k++)
        c->ray.dir[k] = mid[k] * scale;
    c->through = !gen_one_in(rng, 3);
    if (!c->through) c->ray.dir[i] += gen_sign(rng);
}

/* Two slopes beside an edge along u. Head-on the ray comes along w, which is at right angles to the
 * edge and halves what lies between them; else it lies in the plane of the first, beyond the edge.
 */
void gen_ridge(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t u[3], v[3], w[3], at[3], slope[2][3], base[3], end[3], tip[2][3], steps, tall;
    const int64_t zero[3] = {0};
    int alike = gen_one_in(rng, 2), in_plane = gen_one_in(rng, 4);
    do {
        gen_frame(rng, 1ll << vec_pick(rng, 0, (p->w - 6) / 2), u, v, w);
        gen_point(rng, p, base);
        steps = vec_pick(rng, 1, 8);
        int64_t wide = gen_log(rng, 4), high = vec_pick(rng, -8, 8);
        step(zero, wide, v, high, w, slope[0]);
        step(zero, alike ? -wide : -gen_log(rng, 4), v, alike ? high : vec_pick(rng, -8, 8), w,
             slope[1]);
        step(base, steps, u, 0, u, end);
        for (int k = 0; k < 2; k++)
            step(base, vec_pick(rng, 0, steps), u, 1, slope[k], tip[k]);
        step(base, vec_pick(rng, 0, steps), u, 0, u, at);
        tall = gen_sign(rng) * gen_log(rng, 6);
        if (in_plane)
            step(at, tall < 0 ? tall : -tall, slope[0], 0, u, c->ray.org);
        else
            step(at, tall, w, 0, u, c->ray.org);
    } while (!gen_on_grid(p, end) || !gen_on_grid(p, tip[0]) || !gen_on_grid(p, tip[1]) ||
             !gen_on_grid(p, c->ray.org));
    gen_facets(c, SPH_TRIANGLE, 2);
    gen_corners(&c->facet[0], base, end, tip[0]);
    gen_corners(&c->facet[1], end, base, tip[1]);
    gen_towards(rng, p, at, c);
    if (in_plane) c->through = 0; /* it is not met by the first */
}

/* Makes a case of one sphere and one facet. */
static void start(struct hard_case *c) {
    c->n = 1;
    c->facet[0].id = HARD_OTHER;
}

/* One of both by a unit; 0: none is. */
static int moved(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int i = (int)vec_pick(rng, 0, 2), which = (int)vec_pick(rng, 0, 3);
    int64_t *s = &c->sphere[0].rad, *f = &c->facet[0].v[0][i];
    if (which == 0 && *s > 1 && *s < 2 * gen_half(p) - 1) *s += gen_sign(rng);
    if (which == 1) *f = gen_clamp(p, *f + gen_sign(rng));
    return which < 2;
}

void gen_meet(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t at[3];
    start(c);
    gen_point(rng, p, at);
    gen_through(rng, p, at, &c->sphere[0]);
    c->sphere[0].id = HARD_ID;
    facet_through(rng, p, at, &c->facet[0], NULL);
    gen_point(rng, p, c->ray.org);
    gen_towards(rng, p, at, c);
    if (moved(rng, p, c)) c->through = 0;
}

void gen_eye(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t at[3], along[3], light[3], *eye = c->ray.org, n;
    int on = (int)vec_pick(rng, 0, 2), whither = (int)vec_pick(rng, 0, 3); /* on: both, or one */
    double to[3];
    start(c);
    gen_point(rng, p, eye);
    gen_point(rng, p, at);
    gen_through(rng, p, on == 1 ? at : eye, &c->sphere[0]);
    c->sphere[0].id = HARD_ID;
    facet_through(rng, p, on == 2 ? at : eye, &c->facet[0], along);
    if (gen_one_in(rng, 3)) eye[vec_pick(rng, 0, 2)] += eye[0] < 0 ? 1 : -1;
    for (int i = 0; i < 3; i++) {
        int64_t aim[] = {eye[i] + along[i], c->sphere[0].ctr[i], at[i],
                         2 * eye[i] - c->sphere[0].ctr[i]};
        eye[i] = gen_clamp(p, eye[i]);
        to[i] = (double)aim[whither];
        light[i] = gen_clamp(p, aim[whither]);
    }
    gen_aim(rng, p, to, 3, c);
    n = vec_pick(rng, 0, 7); /* mostly an eye; else a surface that is left, or a light */
    if (n < 2) {
        c->ray.kind = n ? SPH_REFLECTED : SPH_REFRACTED;
        c->ray.skip =
            (struct sph_skip){gen_one_in(rng, 2) ? HARD_ID : HARD_OTHER, (int)vec_pick(rng, 0, 1)};
    }
    if (n == 2) gen_shadow(p, light, c);
}

/* The ray touches the second sphere, and starts on the inner side of the first, which is its own:
 * anyhow, or nearly along it. */
void gen_glass(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *own = &c->sphere[0];
    double n[3], along, size;
    do {
        gen_start(c);
        if (gen_one_in(rng, 2))
            gen_graze0(rng, p, c);
        else
            gen_graze1(rng, p, c);
        size = along = 0;
        gen_unit(rng, n);
        for (int i = 0; i < 3; i++) {
            along += n[i] * (double)c->ray.dir[i];
            size += (double)c->ray.dir[i] * (double)c->ray.dir[i];
        }
    } while (!(size > 0));
    double part = gen_one_in(rng, 3) ? along / size : along > 0 ? 2 * along / size : 0;
    c->sphere[1] = *own;
    c->sphere[1].id = HARD_OTHER;
    own->id = HARD_ID;
    own->rad = gen_log(rng, p->w - 1);
    for (int i = 0; i < 3; i++) { /* against the ray, or across it */
        double out = n[i] - part * (double)c->ray.dir[i];
        own->ctr[i] = gen_clamp(p, c->ray.org[i] - (int64_t)rint(out * (double)own->rad));
    }
    c->n = 2;
    c->ray.kind = gen_one_in(rng, 2) ? SPH_REFRACTED : SPH_REFLECTED;
    c->ray.skip = (struct sph_skip){HARD_ID, 1};
}
