/* test_facet_naive.c - the exact test of ray and facet against equations in rational numbers
 * SPDX-License-Identifier: Apache-2.0
 *
 * Random and aimed rays of every profile, ends of ranges, groups; and that every number fits the
 * width that docs/design/primitives.md gives it.
 */
#include "vectors.h"

#include "naive/naive.h"
#include "prim/facet.h"

enum { OWN = 300 }; /* id of every tested facet */

static sph_u128 bit(int n) {
    return (sph_u128)1 << n;
}

static void check_widths(const struct sph_profile *p, const struct sph_ray *ray,
                         const struct sph_facet_result *r, uint64_t key) {
    int w = p->w, wd = p->wd;
    sph_i128 num = (sph_i128)bit(3 * w + 1);
    assert_true(r->det < bit(2 * w + wd + 1));
    assert_true(r->num >= -num && r->num < num);
    if (r->num > 0)
        assert_true((sph_u128)r->num <= (bit(3 * w + 2 * wd + 1) - 1) / (ray->a + !ray->a));
    assert_true(key <= ((3ull << w) + 1) << (wd - 1));
    assert_true(r->add < bit(wd - 1));
}

/* Counts of what was met. */
struct tally {
    uint64_t cases, hits, far, shadows, largest_num, largest_key;
};

/* Golden model against GMP, as a ray of its kind; returns whether it hits. */
static int check(const struct sph_profile *p, struct sph_ray *ray, const struct sph_facet_leaf *f,
                 struct tally *t) {
    uint64_t divisions = 0, key = 0;
    ray->a = (uint64_t)(ray->dir[0] * ray->dir[0] + ray->dir[1] * ray->dir[1] +
                        ray->dir[2] * ray->dir[2]);
    struct sph_facet_result r = sph_facet_test(p, ray, f);
    if (r.hit && ray->kind != SPH_SHADOW) key = sph_facet_key(ray, &r, &divisions);
    struct sph_naive_leaf n = sph_naive_facet(p, ray, f);
    if (r.hit != n.hit || (r.hit && r.far != n.far) || key != n.key)
        fail_msg("%s: ray kind %d org (%ld, %ld, %ld) dir (%ld, %ld, %ld) skip %u, facet kind %d "
                 "(%ld, %ld, %ld) (%ld, %ld, %ld) (%ld, %ld, %ld): hit %d far %d key %lu, "
                 "expected %d %d %lu",
                 p->name, ray->kind, ray->org[0], ray->org[1], ray->org[2], ray->dir[0],
                 ray->dir[1], ray->dir[2], ray->skip.id, f->kind, f->v[0][0], f->v[0][1],
                 f->v[0][2], f->v[1][0], f->v[1][1], f->v[1][2], f->v[2][0], f->v[2][1], f->v[2][2],
                 r.hit, r.far, key, n.hit, n.far, n.key);
    check_widths(p, ray, &r, key);
    assert_true(divisions == (key != 0));
    t->cases++;
    t->hits += (uint64_t)r.hit;
    t->far += (uint64_t)(r.hit && r.far);
    t->shadows += (uint64_t)(r.hit && ray->kind == SPH_SHADOW);
    uint64_t bits = (uint64_t)sph_bit_length128((sph_u128)(r.num > 0 ? r.num : 0) * ray->a);
    if (r.hit && bits > t->largest_num) t->largest_num = bits;
    if (key > t->largest_key) t->largest_key = key;
    return r.hit;
}

/* A triangle: any corners, small ones around one, ends of the range, or one in a plane of the axes;
 * or a plane with any normal. */
static struct sph_facet_leaf make(struct sph_rng *rng, const struct sph_profile *p, int family) {
    struct sph_facet_leaf f = {.kind = SPH_TRIANGLE, .id = OWN};
    int64_t half = 1ll << (p->w - 1);
    int axis = (int)vec_pick(rng, 0, 2), near = (int)vec_pick(rng, 1, p->w - 1);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int64_t x = vec_signed(rng, p->w);
            if (family == 1 && i) x = f.v[0][j] + vec_pick(rng, -(1 << near), 1 << near);
            if (family == 2) x = vec_pick(rng, 0, 1) ? half - 1 : -half;
            if (family == 3 && j == axis && i) x = f.v[0][j];
            f.v[i][j] = x < -half ? -half : x >= half ? half - 1 : x;
        }
    if (family == 4) {
        f.kind = SPH_PLANE;
        for (int j = 0; j < 3; j++)
            f.v[1][j] = axis == j || vec_pick(rng, 0, 2) ? vec_signed(rng, 24) : 0;
    }
    return f;
}

/* A point of the facet: a corner, on an edge, inside; not always whole. */
static void aim(struct sph_rng *rng, const struct sph_profile *p, const struct sph_facet_leaf *f,
                int64_t at[3]) {
    int64_t share[3] = {vec_pick(rng, 0, 4), vec_pick(rng, 0, 4), vec_pick(rng, 0, 4)};
    int64_t all = share[0] + share[1] + share[2];
    for (int j = 0; j < 3; j++) {
        at[j] = f->v[0][j];
        if (f->kind == SPH_TRIANGLE && all)
            at[j] = (share[0] * f->v[0][j] + share[1] * f->v[1][j] + share[2] * f->v[2][j]) / all;
    }
    if (f->kind == SPH_PLANE && vec_pick(rng, 0, 1)) { /* a face of the world, near the plane */
        int64_t half = 1ll << (p->w - 1);
        at[vec_pick(rng, 0, 2)] = vec_pick(rng, 0, 1) ? half - 1 : -half;
    }
}

static void random_rays(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("facets");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        struct tally t = {0};
        for (int i = 0; i < 20000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            int64_t at[3], most = 1ll << (p->wd - 1), reach = 0;
            vec_ray(&rng, p, &ray);
            struct sph_facet_leaf f = make(&rng, p, i % 5);
            aim(&rng, p, &f, at);
            if (i % 4 == 3)
                for (int j = 0; j < 3; j++) /* from a corner of the world */
                    ray.org[j] = vec_pick(&rng, 0, 1) ? most / 2 - 1 : -most / 2;
            for (int j = 0; j < 3; j++) {
                if (ray.org[j] < -(1 << (p->w - 1))) ray.org[j] = -(1 << (p->w - 1));
                if (ray.org[j] >= 1 << (p->w - 1)) ray.org[j] = (1 << (p->w - 1)) - 1;
                if (i % 6) ray.dir[j] = at[j] - ray.org[j];
                if (labs(ray.dir[j]) > reach) reach = labs(ray.dir[j]);
            }
            while (i % 3 && reach && 2 * reach < most) { /* as long as the word allows */
                reach *= 2;
                for (int j = 0; j < 3; j++)
                    ray.dir[j] *= 2;
            }
            if (i % 7 == 0) ray.dir[i % 3] += ray.dir[i % 3] > 0 ? -1 : 1;
            check(p, &ray, &f, &t);
            ray.kind = SPH_SHADOW; /* ends on the facet, before it or behind it */
            for (int j = 0; j < 3; j++) {
                ray.dir[j] = at[j] - ray.org[j];
                ray.lift[j] = vec_pick(&rng, -(1 << p->ng), 1 << p->ng);
            }
            check(p, &ray, &f, &t);
            ray.dir[i % 3] += vec_pick(&rng, -1, 1);
            if (labs(ray.dir[i % 3]) >= most) ray.dir[i % 3] = 0;
            check(p, &ray, &f, &t);
        }
        printf("# %s: %lu cases, %lu hits, %lu of them far, %lu of lights, a*num of %lu bits, keys "
               "up to %.3f of the bound\n",
               p->name, t.cases, t.hits, t.far, t.shadows, t.largest_num,
               (double)t.largest_key / (double)(3 * ((1ull << p->w) - 1) << (p->wd - 1)));
        assert_true(t.hits > t.cases / 10 && t.far > t.hits / 4 && t.far < t.hits * 3 / 4);
        assert_true(t.shadows > t.cases / 50);
    }
}

/* The ids that a group has, and those beside it. */
static void groups(void **state) {
    (void)state;
    const struct sph_profile *p = &sph_profiles[0];
    struct tally t = {0};
    for (uint32_t before = 0; before < SPH_MAX_GROUP; before += SPH_MAX_GROUP - 1)
        for (uint32_t after = 0; after < SPH_MAX_GROUP; after += SPH_MAX_GROUP - 1)
            for (uint32_t skip = OWN - 130; skip < OWN + 130; skip++) {
                struct sph_facet_leaf f = {
                    SPH_TRIANGLE, {{5, 0, 0}, {5, 9, 0}, {5, 0, 9}}, OWN, before, after};
                struct sph_ray ray = {.dir = {1, 0, 0}, .org = {0, 1, 1}, .skip = {skip, 1}};
                int own = skip >= OWN - before && skip <= OWN + after;
                assert_int_equal(check(p, &ray, &f, &t), !own);
                f = (struct sph_facet_leaf){SPH_PLANE, {{5, 0, 0}, {1, 0, 0}}, OWN, before, after};
                assert_int_equal(check(p, &ray, &f, &t), !own);
            }
    struct sph_facet_leaf f = {SPH_PLANE, {{5, 0, 0}, {1, 0, 0}}, 3, 3, 127};
    struct sph_ray ray = {.dir = {1, 0, 0}, .skip = {SPH_ID_NONE, 0}};
    assert_int_equal(check(p, &ray, &f, &t), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_rays),
        cmocka_unit_test(groups),
    };
    return cmocka_run_group_tests_name("facet_naive", tests, NULL, NULL);
}
