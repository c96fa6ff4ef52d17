/* test_meet.c - where rays meet primitives: the bounds of the double reference hold, and nothing
 * leaks
 * SPDX-License-Identifier: Apache-2.0
 *
 * The bounds are held against the same equations in long double. SEED=N: other rays.
 */
#include "made_scene.h"
#include "number.h"

#include <math.h>

#include "reference/facet.h"
#include "reference/meet.h"
#include "reference/tree.h"
#include "scene/rng.h"

enum { ROUNDS = SANITIZED ? 20000 : 400000, FAN = 3 };

static void lessw(struct sph_vec a, const double b[3], wide out[3]) {
    out[0] = (wide)a.x - b[0], out[1] = (wide)a.y - b[1], out[2] = (wide)a.z - b[2];
}

/* The t nearest to `t` of the two at which the line meets a sphere; NAN: none. */
static wide sphere_t(const struct sph_sphere *s, const struct sph_ref_ray *ray, double t) {
    wide oc[3], d[3] = {ray->dir[0], ray->dir[1], ray->dir[2]}, off2 = 0;
    lessw(s->ctr, ray->org, oc);
    wide a = dotw(d, d), b = dotw(oc, d);
    for (int i = 0; i < 3; i++) {
        wide v = oc[i] - b / a * d[i];
        off2 += v * v;
    }
    wide half2 = (wide)s->rad * s->rad - off2;
    if (half2 < 0) return NAN;
    wide half = sqrtl(half2 / a), near = b / a - half, far = b / a + half;
    return fabsl(near - t) < fabsl(far - t) ? near : far;
}

static wide facet_t(const struct sph_facet *f, const struct sph_ref_ray *ray) {
    wide a0[3], e1[3], e2[3], n[3], d[3] = {ray->dir[0], ray->dir[1], ray->dir[2]};
    const double v0[3] = {f->v[0].x, f->v[0].y, f->v[0].z};
    lessw(f->v[0], ray->org, a0);
    lessw(f->v[1], v0, e1);
    lessw(f->v[2], v0, e2);
    crossw(e1, e2, n);
    if (f->kind == SPH_PLANE) n[0] = f->v[1].x, n[1] = f->v[1].y, n[2] = f->v[1].z;
    return dotw(n, a0) / dotw(n, d);
}

static double spread(struct sph_rng *rng, double low, double high) {
    return exp(sph_rng_range(rng, log(low), log(high)));
}

static void any(struct sph_rng *rng, double size, double v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = sph_rng_range(rng, -size, size);
}

/* A ray from `far` away past a point so near that it barely meets what lies there. */
static struct sph_ref_ray past(struct sph_rng *rng, const double at[3], double far) {
    struct sph_ref_ray ray = {.skip = SPH_ID_NONE};
    double away[3];
    any(rng, 1, away);
    for (int i = 0; i < 3; i++) {
        ray.org[i] = at[i] + far * away[i];
        ray.dir[i] = at[i] - ray.org[i];
    }
    return ray;
}

/* Aims a ray at the rim of a sphere, just inside. */
static void graze(struct sph_rng *rng, const double ctr[3], double rad, struct sph_ref_ray *ray) {
    double way[3], side[3], across[3], length = 0;
    any(rng, 1, side);
    for (int i = 0; i < 3; i++)
        way[i] = ctr[i] - ray->org[i];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = way[j] * side[k] - way[k] * side[j];
        length += across[i] * across[i];
    }
    double most = rad * (1 - spread(rng, 1e-15, 1e-3)) / sqrt(length);
    for (int i = 0; i < 3; i++)
        ray->dir[i] = way[i] + most * across[i];
}

static void bounds_hold(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    struct sph_material matt = {.kd = 1};
    struct sph_sphere ball = {.rad = 1};
    struct sph_facet facet = {.kind = SPH_TRIANGLE};
    struct sph_scene s = {.n_spheres = 1,
                          .n_facets = 1,
                          .spheres = &ball,
                          .facets = &facet,
                          .n_materials = 1,
                          .materials = &matt};
    int met[3] = {0};
    double most[3] = {0};
    for (int i = 0; i < ROUNDS; i++) {
        int kind = i % 3; /* sphere, triangle, plane */
        double at[3], ctr[3], size = spread(&rng, 1e-3, 10), far = spread(&rng, 0.1, 1e6);
        any(&rng, spread(&rng, 1, 1e3), ctr);
        any(&rng, 1, at);
        double length = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        ball = (struct sph_sphere){.ctr = vec(ctr), .rad = size};
        facet.kind = kind == 2 ? SPH_PLANE : SPH_TRIANGLE;
        for (int k = 0; k < 3; k++) { /* corners about one point; of a sliver in a line */
            double to[3], thin = i % 7 ? 1 : 1e-4;
            any(&rng, size, to);
            for (int j = 0; j < 3; j++)
                to[j] = ctr[j] + (k == 2 ? thin : 1) * to[j];
            facet.v[k] = vec(to);
        }
        if (kind == 2) any(&rng, 1, at), facet.v[1] = vec(at);
        double part = sph_rng_range(&rng, 0, 1) * (kind == 0 ? size / length : 0.3);
        for (int j = 0; j < 3; j++) /* to a point in it */
            at[j] = kind == 0 ? ctr[j] + part * at[j] : ctr[j] + part * size * at[j];
        struct sph_ref_ray ray = past(&rng, at, far);
        if (kind == 0 && i % 2) graze(&rng, ctr, size, &ray);
        struct sph_ref_cast cast = sph_ref_cast(&ray);
        struct sph_ref_meet m;
        if (!sph_ref_meet_ahead(&s, kind != 0, &cast, &m) || !m.met) continue;
        wide t = kind == 0 ? sphere_t(&ball, &ray, m.t) : facet_t(&facet, &ray);
        if (isnan((double)t)) {
            assert_true(m.doubt);
            continue;
        }
        double part_off = (double)(fabsl(t - m.t) / m.slack);
        most[kind] = fmax(most[kind], part_off);
        met[kind]++;
        if (part_off > 1)
            fail_msg("round %d: t %.17g for %.21Lg, more than %.3g off", i, m.t, t, m.slack);
    }
    for (int kind = 0; kind < 3; kind++) {
        printf("# %s: %d hits, off by at most %.3f of the bound\n",
               (const char *[]){"spheres", "triangles", "planes"}[kind], met[kind], most[kind]);
        assert_true(met[kind] > ROUNDS / 40);
        assert_true(most[kind] > 1e-3); /* nor is it far too wide */
    }
}

/* Signs that doubles get wrong, known from whole numbers. */
static void sides_are_exact(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    int wrong = 0, zero = 0;
    for (int i = 0; i < ROUNDS / 10; i++) {
        int64_t n[4][3]; /* org, dir, p, q: 20 bits, so that the volume has 65 */
        double v[4][3], u = 0, scale = ldexp(1, i % 400 - 200);
        for (int k = 0; k < 12; k++)
            n[k / 3][k % 3] = (int64_t)(sph_rng_range(&rng, -1, 1) * (k < 3 ? 9 : 1 << 20));
        for (int j = 0; j < 3; j++) { /* q is nearly in the plane of org, p and org + dir */
            n[3][j] = n[2][j] - n[1][j] * (i % 9);
            if (i % 2 && j == 0) n[3][j] += i % 3 - 1;
        }
        for (int k = 0; k < 12; k++)
            v[k / 3][k % 3] = (double)n[k / 3][k % 3] * scale;
        __int128 sum = 0;
        for (int j = 0; j < 3; j++) {
            int a = (j + 1) % 3, b = (j + 2) % 3;
            __int128 c = (__int128)(n[2][a] - n[0][a]) * (n[3][b] - n[0][b]) -
                         (__int128)(n[2][b] - n[0][b]) * (n[3][a] - n[0][a]);
            sum += n[1][j] * c;
            u += v[1][j] * ((v[2][a] - v[0][a]) * (v[3][b] - v[0][b]) -
                            (v[2][b] - v[0][b]) * (v[3][a] - v[0][a]));
        }
        int sign = (sum > 0) - (sum < 0);
        assert_int_equal(sph_ref_exact_side(v[0], v[1], v[2], v[3]), sign);
        assert_int_equal(sph_ref_exact_side(v[0], v[1], v[3], v[2]), -sign);
        wrong += (u > 0) - (u < 0) != sign;
        zero += !sign;
    }
    printf("# %d of %d signs are 0, doubles get %d wrong\n", zero, ROUNDS / 10, wrong);
    assert_true(zero > 10);
}

/* What lies at the light's place, or at the start, does not stand between, wherever roundings put
 * it; what lies a little before the light does. */
static void ends_of_a_shadow_ray(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    for (int i = 0; i < 400; i++) {
        struct sph_scene *s = bare();
        double from[3], to[3], dir[3], n[3], m[3];
        any(&rng, 10, from), any(&rng, 10, to), any(&rng, 1, n), any(&rng, 1, m);
        for (int k = 0; k < 3; k++)
            dir[k] = to[k] - from[k];
        for (uint32_t k = 0; k < 2; k++) { /* planes through both, by another point of theirs */
            const double *normal = k ? m : n, *place = k ? from : to;
            double beside[3];
            for (int j = 0; j < 3; j++)
                beside[j] = place[j] + 3 * (normal[(j + 1) % 3] * dir[(j + 2) % 3] -
                                            normal[(j + 2) % 3] * dir[(j + 1) % 3]);
            add(s, SPH_PLANE, k, (double[3][3]){{0}, {0}, {1, 0, 0}});
            s->facets[k].v[0] = vec(beside);
            s->facets[k].v[1] = vec(normal);
        }
        struct sph_ref_tree *tree = sph_ref_tree_new(s);
        assert_non_null(tree);
        struct sph_ref_ray ray = {.skip = SPH_ID_NONE, .light = 1, .lift = 1e-13};
        memcpy(ray.org, from, sizeof from), memcpy(ray.dir, dir, sizeof dir);
        assert_true(isinf(sph_ref_trace(tree, &ray, 1, 1).t));
        for (int k = 0; k < 3; k++)
            ray.dir[k] *= 1 + 1e-9;
        assert_int_equal(sph_ref_trace(tree, &ray, 1, 1).id, 0);
        sph_ref_tree_free(tree);
    }
}

/* A fan of triangles around a corner, and rays at points of its edges and at the corner: whichever
 * way a double rounds them, they meet one. */
static void fans_are_closed(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    int doubts = 0, rays = 0;
    for (int round = 0; round < ROUNDS / 4000; round++) {
        struct sph_scene *s = bare();
        double rim[FAN][3], hub[3], org[3];
        any(&rng, 1, hub);
        for (int k = 0; k < FAN; k++) {
            double turn = 2 * acos(-1.0) / FAN * k, away = sph_rng_range(&rng, 1, 3);
            rim[k][0] = hub[0] + away * cos(turn);
            rim[k][1] = hub[1] + away * sin(turn);
            rim[k][2] = hub[2] + sph_rng_range(&rng, -0.1, 0.1);
        }
        for (int k = 0; k < FAN; k++) {
            double v[3][3];
            for (int c = 0; c < 3; c++) /* corners in any order */
                memcpy(v[(c + k) % 3], c == 0 ? hub : rim[(k + c - 1) % FAN], sizeof v[0]);
            add(s, SPH_TRIANGLE, (uint32_t)k, (const double(*)[3])v);
        }
        struct sph_ref_tree *tree = sph_ref_tree_new(s);
        assert_non_null(tree);
        any(&rng, 1, org), org[2] = 9;
        for (int i = 0; i < 300; i++) {
            struct sph_ref_ray ray = {.skip = SPH_ID_NONE};
            double along = i % 5 ? sph_rng_range(&rng, 0, 0.9) : 0;
            for (int j = 0; j < 3; j++) {
                ray.org[j] = org[j];
                ray.dir[j] = hub[j] + along * (rim[i % FAN][j] - hub[j]) - org[j];
            }
            struct sph_ref_hit hit = sph_ref_trace(tree, &ray, INFINITY, 0);
            if (hit.id == SPH_ID_NONE) fail_msg("round %d: ray %d slips through", round, i);
            doubts += hit.doubt, rays++;
        }
        sph_ref_tree_free(tree);
    }
    printf("# %d rays at edges and corners, %d of them in doubt\n", rays, doubts);
    assert_int_equal(doubts, rays);
}

/* A ray past the rim of a sphere is in doubt only where it touches, and so is one through it. */
static void doubt_of_a_rim(void **state) {
    (void)state;
    struct sph_scene *s = bare();
    s->spheres[0] = (struct sph_sphere){.ctr = {3, 0, 0}, .rad = 1};
    s->n_spheres = 1;
    struct sph_ref_tree *tree = sph_ref_tree_new(s);
    assert_non_null(tree);
    for (int k = -2; k <= 2; k++) {
        struct sph_ref_ray ray = {
            .org = {0, 1 + 1e-12 * k, 0}, .dir = {1, 0, 0}, .skip = SPH_ID_NONE};
        struct sph_ref_hit hit = sph_ref_trace(tree, &ray, INFINITY, 0);
        assert_int_equal(hit.id, k < 0 ? 0 : SPH_ID_NONE);
        assert_int_equal(hit.doubt, k == 0);
        ray.off = 3e-12; /* of a ray that is so far off all are */
        assert_int_equal(sph_ref_trace(tree, &ray, INFINITY, 0).doubt, 1);
    }
    sph_ref_tree_free(tree);
}

/* A ray from a point of a sphere meets its other side, if it looks inwards. */
static void start_on_a_sphere(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    struct sph_scene *s = bare();
    s->n_spheres = 1;
    for (int i = 0; i < 400; i++) {
        double ctr[3], at[3], to[3], inwards = 0, square = 0;
        any(&rng, 10, ctr), any(&rng, 1, at), any(&rng, 1, to);
        s->spheres[0] = (struct sph_sphere){
            .ctr = vec(ctr), .rad = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2])};
        struct sph_ref_ray ray = {.skip = SPH_ID_NONE};
        for (int k = 0; k < 3; k++) {
            ray.org[k] = ctr[k] + at[k], ray.dir[k] = to[k];
            inwards -= at[k] * to[k], square += to[k] * to[k];
        }
        struct sph_ref_tree *tree = sph_ref_tree_new(s);
        assert_non_null(tree);
        struct sph_ref_hit hit = sph_ref_trace(tree, &ray, INFINITY, 0);
        assert_int_equal(hit.id, inwards > 0 ? 0 : SPH_ID_NONE);
        if (inwards > 0) assert_true(hit.far && fabs(hit.t - 2 * inwards / square) < 1e-9);
        sph_ref_tree_free(tree);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_hold),     cmocka_unit_test(sides_are_exact),
        cmocka_unit_test(fans_are_closed), cmocka_unit_test(ends_of_a_shadow_ray),
        cmocka_unit_test(doubt_of_a_rim),  cmocka_unit_test(start_on_a_sphere),
    };
    return cmocka_run_group_tests_name("meet", tests, NULL, NULL);
}
