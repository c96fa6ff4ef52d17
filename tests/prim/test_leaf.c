/* test_leaf.c - the exact ray and sphere test against two oracles
 * SPDX-License-Identifier: Apache-2.0
 *
 * Both oracles use Lagrange's discriminant rad^2*a - |oc x dir|^2 and know no hit rule: they look
 * for the smallest root. Every operand of three bits is tried, then hard cases of every profile.
 */
#include "vectors.h"

#include "naive/naive.h"

enum { OWN = 7 }; /* id of every tested sphere */

/* Widths of everything the leaf test makes: what the RTL's registers must hold. */
static void check_widths(const struct sph_leaf_result *r, uint64_t key, int w, int wd) {
    sph_i128 disc = (sph_i128)1 << (2 * w + 2 * wd + 1);
    int64_t b = 1ll << (w + wd + 1), k = 1ll << (2 * w + 2);
    assert_true(r->disc >= -disc && r->disc < disc);
    assert_true(r->b >= -b && r->b < b && r->k >= -k && r->k < k);
    assert_true(key >> (w + wd + 2) == 0);
}

static void mismatch(const struct sph_ray *ray, const struct sph_leaf *s,
                     const struct sph_leaf_result *r, uint64_t key, int hit, int far, int exit_,
                     uint64_t expected) {
    fail_msg("kind %d skip %u inside %d org (%ld, %ld, %ld) dir (%ld, %ld, %ld) ctr (%ld, %ld, "
             "%ld) rad %ld: hit %d far %d exit %d key %lu, expected %d %d %d %lu",
             ray->kind, ray->skip.id, ray->skip.inside, ray->org[0], ray->org[1], ray->org[2],
             ray->dir[0], ray->dir[1], ray->dir[2], s->ctr[0], s->ctr[1], s->ctr[2], s->rad, r->hit,
             r->far, r->exit, key, hit, far, exit_, expected);
}

/* Golden model against GMP. */
static struct sph_naive_leaf check(const struct sph_profile *p, struct sph_ray *ray,
                                   const struct sph_leaf *s) {
    uint64_t roots = 0, key = 0;
    ray->a = (uint64_t)(ray->dir[0] * ray->dir[0] + ray->dir[1] * ray->dir[1] +
                        ray->dir[2] * ray->dir[2]);
    struct sph_leaf_result r = sph_leaf_test(ray, s);
    if (r.hit && ray->kind != SPH_SHADOW) key = sph_leaf_key(&r, &roots);
    struct sph_naive_leaf n = sph_naive_leaf(ray, s);
    if (r.hit != n.hit || (r.hit && (r.far != n.far || r.exit != n.exit)) || key != n.key)
        mismatch(ray, s, &r, key, n.hit, n.far, n.exit, n.key);
    check_widths(&r, key, p->w, p->wd);
    return n;
}

/* Golden model against small integers: tau = b -+ sqrt(disc), found by trying every key. */
static void check_small(struct sph_ray *ray, const struct sph_leaf *s, int64_t disc, int64_t b) {
    int64_t a = (int64_t)ray->a, key = 0, bb = b * b;
    int own = ray->skip.id == s->id, shadow = ray->kind == SPH_SHADOW;
    int near = !own && disc > 0 && b > 0 && bb > disc;
    int far = ray->inside && disc > 0 && (b >= 0 || disc > bb);
    int hit = near || far;
    if (shadow && hit) { /* tau < a */
        int64_t x = a - b;
        hit = near ? x >= 0 || x * x < disc : x > 0 && x * x > disc;
    } else if (hit) {
        for (key = 1;; key++) {
            int64_t x = key - b;
            if (near ? x >= 0 || x * x <= disc : x >= 0 && x * x >= disc) break;
        }
    }
    int exit_ = own && !hit && !shadow;
    if (exit_) hit = 1, key = 1;
    if (own && shadow) { /* the light lies outside */
        hit = 0;
        for (int i = 0; i < 3; i++)
            hit += (int)((ray->org[i] + ray->dir[i] - s->ctr[i]) *
                         (ray->org[i] + ray->dir[i] - s->ctr[i]));
        hit = hit > s->rad * s->rad;
    }
    uint64_t roots = 0, got = 0;
    struct sph_leaf_result r = sph_leaf_test(ray, s);
    if (r.hit && !shadow) got = sph_leaf_key(&r, &roots);
    int is_far = own || !near; /* of a hit */
    if (r.hit != hit || (hit && (r.far != is_far || r.exit != exit_)) || got != (uint64_t)key)
        mismatch(ray, s, &r, got, hit, is_far, exit_, (uint64_t)key);
}

/* Every oc, dir and rad of w bits, every kind of ray. gmp: one in so many goes to GMP as well. */
static void exhaustive_bits(int w, uint64_t gmp) {
    const struct sph_profile tiny = {"tiny", w, w, w, 0, w, 0};
    int64_t most = (1 << w) - 1, low = -(1 << (w - 1));
    uint64_t n = 0, hits = 0;
    for (int64_t i = 0; i < (2 * most + 1) * (2 * most + 1) * (2 * most + 1); i++) {
        struct sph_leaf s = {.id = OWN};
        struct sph_ray ray = {0};
        int64_t oc[3] = {i % (2 * most + 1) - most, i / (2 * most + 1) % (2 * most + 1) - most,
                         i / (2 * most + 1) / (2 * most + 1) - most};
        for (int j = 0; j < 3; j++) {
            ray.org[j] = oc[j] >= 0 ? low : -low - 1;
            s.ctr[j] = ray.org[j] + oc[j];
        }
        for (int64_t d = 0; d < 1 << 3 * w; d++) {
            int64_t b = 0, cross2 = 0;
            ray.a = 0;
            for (int j = 0; j < 3; j++) {
                ray.dir[j] = (d >> (w * j) & most) + low;
                ray.a += (uint64_t)(ray.dir[j] * ray.dir[j]);
                b += ray.dir[j] * oc[j];
            }
            for (int j = 0; j < 3; j++) {
                int k = (j + 1) % 3;
                int64_t c = oc[j] * ray.dir[k] - oc[k] * ray.dir[j];
                cross2 += c * c;
            }
            for (s.rad = 0; s.rad <= most; s.rad++, n++) {
                if (w > 2 && n % VEC_SHARE) continue;
                int64_t disc = s.rad * s.rad * (int64_t)ray.a - cross2;
                for (int kind = 0; kind < 6; kind++) {
                    ray.kind = kind & 1 ? SPH_SHADOW : SPH_REFLECTED;
                    ray.skip = (struct sph_skip){kind & 2 ? OWN : SPH_ID_NONE, 1};
                    ray.inside = kind < 4;
                    check_small(&ray, &s, disc, b);
                    if (n % gmp == 0) hits += (uint64_t)check(&tiny, &ray, &s).hit;
                }
            }
        }
    }
    printf("# %d bits: %lu cases of every kind of ray\n", w, n);
    assert_true(n > 0 && hits > 0);
}

static void exhaustive_2(void **state) {
    (void)state;
    exhaustive_bits(2, VEC_SHARE);
}

static void exhaustive_3(void **state) {
    (void)state;
    exhaustive_bits(3, 211 * VEC_SHARE);
}

/* Spheres that touch the ray exactly, from an integer frame of columns of length `norm`. */
static int tangent(struct sph_rng *rng, const struct sph_profile *p, struct sph_ray *ray,
                   struct sph_leaf *s) {
    int64_t q[4], most = 1 << ((p->w - 2) / 4), limit = 1ll << (p->w - 1);
    for (int i = 0; i < 4; i++)
        q[i] = vec_pick(rng, -most, most);
    int64_t norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    int64_t u[3] = {q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3],
                    2 * (q[1] * q[2] + q[0] * q[3]), 2 * (q[1] * q[3] - q[0] * q[2])};
    int64_t v[3] = {2 * (q[1] * q[2] - q[0] * q[3]),
                    q[0] * q[0] - q[1] * q[1] + q[2] * q[2] - q[3] * q[3],
                    2 * (q[2] * q[3] + q[0] * q[1])};
    int64_t along = vec_pick(rng, 1, 4), aside = vec_pick(rng, 1, 2), scale = vec_pick(rng, 1, 2);
    s->rad = norm * aside;
    s->id = OWN;
    for (int i = 0; i < 3; i++) {
        ray->dir[i] = scale * u[i];
        s->ctr[i] = ray->org[i] + along * u[i] + aside * v[i];
        if (s->ctr[i] >= limit || s->ctr[i] < -limit) return 0;
        if (ray->dir[i] >= limit || ray->dir[i] < -limit) return 0;
    }
    return norm > 0 && s->rad < 2 * limit - 1;
}

static void touching(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("touching");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        uint64_t count = 0;
        for (int i = 0; i < 20000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            struct sph_leaf s;
            vec_ray(&rng, p, &ray);
            for (int j = 0; j < 3; j++)
                ray.org[j] /= 2;
            if (!tangent(&rng, p, &ray, &s)) continue;
            assert_int_equal(check(p, &ray, &s).hit, 0); /* a tangent misses */
            s.rad++;
            check(p, &ray, &s);
            s.rad -= 2;
            assert_int_equal(check(p, &ray, &s).hit, 0);
            s.rad++;
            ray.dir[i % 3] += ray.dir[i % 3] < 0 ? 1 : -1;
            check(p, &ray, &s);
            count++;
        }
        printf("# %s: %lu exact tangents\n", p->name, count);
        assert_true(count > 100 / VEC_SHARE);
    }
}

static void hard(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("hard");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        uint64_t hits[2] = {0, 0}, entries[2] = {0, 0}, exits = 0;
        for (int i = 0; i < 60000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            struct sph_leaf s = {.id = OWN};
            vec_ray(&rng, p, &ray);
            if (i % 3 || !vec_grazed(&rng, p, &ray, sph_rng_range(&rng, 0.99, 1.01), &s)) {
                for (int j = 0; j < 3; j++)
                    s.ctr[j] = i % 5 ? vec_signed(&rng, p->w) : ray.org[j]; /* origin at centre */
                s.rad = (int64_t)vec_unsigned(&rng, p->w);
            }
            if (i % 4 == 0) /* origin on an axis end of the sphere */
                for (int j = 0; j < 3; j++) {
                    int64_t at = s.ctr[j] + (j == i % 3 ? s.rad : 0);
                    if (at < 1ll << (p->w - 1)) ray.org[j] = at;
                }
            hits[0] += (uint64_t)check(p, &ray, &s).hit;
            ray.skip = (struct sph_skip){OWN, 1};
            exits += (uint64_t)check(p, &ray, &s).exit;
            ray.skip.inside = 0;
            assert_int_equal(check(p, &ray, &s).hit, 0);
            ray.skip.id = SPH_ID_NONE;
            ray.inside = 0; /* only the entry counts */
            entries[0] += (uint64_t)check(p, &ray, &s).hit;
            ray.kind = SPH_SHADOW;
            for (int j = 0; j < 3; j++) {
                int64_t light = i % 4 == 1 ? s.ctr[j] : vec_signed(&rng, p->w);
                if (i % 8 == 2) light = s.ctr[j] + (j == i % 3 ? s.rad : 0); /* on the surface */
                ray.dir[j] = light - ray.org[j];
                if (ray.dir[j] >= 1ll << (p->wd - 1)) ray.dir[j] = 1;
            }
            ray.skip = (struct sph_skip){SPH_ID_NONE, 0};
            entries[1] += (uint64_t)check(p, &ray, &s).hit;
            ray.inside = 1;
            hits[1] += (uint64_t)check(p, &ray, &s).hit;
            ray.skip = (struct sph_skip){OWN, 1};
            check(p, &ray, &s);
        }
        printf("# %s: %lu hits and %lu occluders, %lu and %lu from outside, %lu exits\n", p->name,
               hits[0], hits[1], entries[0], entries[1], exits);
        assert_true(entries[0] && entries[1] && exits);
        assert_true(entries[0] < hits[0] && entries[1] < hits[1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exhaustive_2),
        cmocka_unit_test(exhaustive_3),
        cmocka_unit_test(touching),
        cmocka_unit_test(hard),
    };
    return cmocka_run_group_tests_name("leaf", tests, NULL, NULL);
}
