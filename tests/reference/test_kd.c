/* test_kd.c - the kd-tree, the tree of boxes and every primitive in turn find the same hits
 * SPDX-License-Identifier: Apache-2.0
 */
#include "model_scene.h"

#include <math.h>

#include "reference/tree.h"
#include "scene/rng.h"

enum { PRIMS = SANITIZED ? 60 : 300, RAYS = SANITIZED ? 100 : 600 };

static struct sph_vec point(struct sph_rng *rng, double far) {
    struct sph_vec v;
    v.x = sph_rng_range(rng, -far, far);
    v.y = sph_rng_range(rng, -far, far);
    v.z = sph_rng_range(rng, -far, far);
    return v;
}

/* A coordinate of a lattice: many boxes begin and end where others do. */
static void snap(struct sph_vec *v) {
    v->x = round(v->x), v->y = round(v->y), v->z = round(v->z);
}

/* n spheres of radius up to `large`, n triangles as wide, and a plane, in a cube of 20. */
static struct sph_scene make(struct sph_rng *rng, uint32_t n, double large, int snapped) {
    struct sph_scene s = {.n_spheres = n, .n_facets = n + 1};
    s.spheres = calloc(n + 1, sizeof *s.spheres);
    s.facets = calloc(n + 1, sizeof *s.facets);
    assert_non_null(s.spheres);
    assert_non_null(s.facets);
    for (uint32_t i = 0; i < n; i++) {
        s.spheres[i].ctr = point(rng, 10);
        s.spheres[i].rad = sph_rng_range(rng, 0.01, large);
        struct sph_facet *f = &s.facets[i];
        *f = (struct sph_facet){.kind = SPH_TRIANGLE, .group = i};
        struct sph_vec at = point(rng, 10);
        for (int k = 0; k < 3; k++) {
            struct sph_vec to = point(rng, large);
            f->v[k] = (struct sph_vec){at.x + to.x, at.y + to.y, at.z + to.z};
            if (snapped) snap(&f->v[k]);
        }
        if (snapped) snap(&s.spheres[i].ctr), s.spheres[i].rad = ceil(s.spheres[i].rad);
    }
    s.facets[n] =
        (struct sph_facet){.kind = SPH_PLANE, .v = {{0, -8, 0}, {0, 1, 0}, {1, 0, 0}}, .group = n};
    return s;
}

/* From inside and outside; along axes too, from where boxes end. */
static struct sph_ref_ray aim(struct sph_rng *rng, int number) {
    struct sph_vec org = point(rng, number % 2 ? 40 : 10), dir = point(rng, 1);
    if (number % 5 == 0) {
        snap(&org);
        dir = (struct sph_vec){number % 3 == 0, number % 3 == 1, -(number % 3 == 2)};
    }
    return (struct sph_ref_ray){
        .org = {org.x, org.y, org.z}, .dir = {dir.x, dir.y, dir.z}, .skip = SPH_ID_NONE};
}

static struct sph_ref_hit brute(const struct sph_ref_tree *tree, const struct sph_scene *s,
                                const struct sph_ref_ray *ray) {
    struct sph_ref_hit best = {.t = INFINITY, .id = SPH_ID_NONE};
    for (uint32_t id = 0; id < s->n_spheres + s->n_facets; id++) {
        double t = sph_ref_meet(tree, id, ray);
        if (t < best.t) best.t = t, best.id = id;
    }
    return best;
}

static void all_find_the_same(void **state) {
    (void)state;
    struct sph_rng rng = {20};
    int hits = 0, halves = 0;
    for (int round = 0; round < 10; round++) {
        uint32_t n = round < 2 ? (uint32_t)round : PRIMS; /* none at all, one of each */
        struct sph_scene scene = make(&rng, n, round % 3 ? 0.7 : 4, round % 2);
        struct sph_ref_work work;
        struct sph_ref_tree *boxes = sph_ref_tree_new(&scene);
        struct sph_ref_tree *kd = sph_ref_tree_counted(&scene, 1, &work);
        assert_non_null(boxes);
        assert_non_null(kd);
        for (int i = 0; i < RAYS; i++) {
            struct sph_ref_ray ray = aim(&rng, i);
            struct sph_ref_hit truth = brute(boxes, &scene, &ray);
            struct sph_ref_hit a = sph_ref_trace(boxes, &ray, INFINITY, 0);
            struct sph_ref_hit b = sph_ref_trace(kd, &ray, INFINITY, 0);
            assert_int_equal(a.id, truth.id);
            assert_int_equal(b.id, truth.id);
            assert_true(a.t == truth.t && b.t == truth.t && a.far == b.far);
            double half = i % 3 * truth.t / 1.5; /* 0, two thirds, four thirds of the way */
            int blocked = truth.t < half;
            assert_int_equal(sph_ref_trace(boxes, &ray, half, 1).t < half, blocked);
            assert_int_equal(sph_ref_trace(kd, &ray, half, 1).t < half, blocked);
            hits += truth.id < 2 * n, halves += blocked;
        }
        assert_int_equal(work.rays, 2 * RAYS);
        if (n == PRIMS && round % 3) { /* small ones: few are tested */
            assert_true(work.nodes > n && work.steps < work.rays * 40);
            assert_true(work.tests < work.rays * n / 20);
        }
        sph_ref_tree_free(boxes);
        sph_ref_tree_free(kd);
        free(scene.spheres);
        free(scene.facets);
    }
    assert_true(hits > RAYS && halves > RAYS / 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_find_the_same)};
    return cmocka_run_group_tests_name("kd", tests, NULL, NULL);
}
