/* test_front.c - where rays leave a facet: in front of its plane, behind it, and never in a speck
 * SPDX-License-Identifier: Apache-2.0
 *
 * In exact integers: a mirror ray, or one to a light, starts strictly in front of the plane of the
 * facet that was hit, a refracted ray strictly behind it. So nothing of a convex mesh shades what
 * faces the light.
 */
#include "build_scene.h"

#include <gmp.h>

#include "render/render.h"
#include "math/arith.h"
#include "pixel/background.h"
#include "prim/facet.h"
#include "prim/prim.h"
#include "scene/generate.h"
#include "trace/traverse.h"
#include "trace/setup.h"

static int64_t whole(int64_t lo, int64_t hi) {
    return lo + (int64_t)(uniform() * (double)(hi - lo + 1));
}

/* N.(p - v0) of a triangle's exact normal. */
static sph_i128 height(const int64_t v[3][3], const int64_t p[3]) {
    sph_i128 sum = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        int64_t n =
            (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) - (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]);
        sum += (sph_i128)n * (p[i] - v[0][i]);
    }
    return sum;
}

/* A triangle of any size within the grid, flat or steep, and a ray at it from anywhere. */
static struct sph_ray aim(const struct sph_profile *p, struct sph_facet_leaf *f) {
    int64_t half = (1ll << (p->w - 1)) - 4, size = 1 + (int64_t)exp(uniform() * p->w * log(2)) / 2;
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    int still = (int)whole(0, 5); /* the plane is that of an axis, or nearly */
    *f = (struct sph_facet_leaf){.kind = SPH_TRIANGLE};
    double at[3] = {0, 0, 0}, most = 1;
    for (int i = 0; i < 3; i++) {
        int64_t base = whole(-half, half);
        for (int k = 0; k < 3; k++) {
            int64_t to =
                base + whole(-size, size) * (still != i) + whole(0, still == i && size > 9);
            f->v[k][i] = to > half ? half : to < -half ? -half : to;
        }
        ray.org[i] = whole(0, 3) ? whole(-half, half) : f->v[0][i] + whole(-9, 9);
        if (ray.org[i] > half) ray.org[i] = half;
        if (ray.org[i] < -half) ray.org[i] = -half;
    }
    double a = uniform(), b = uniform() * (1 - a);
    for (int i = 0; i < 3; i++) {
        at[i] = (double)f->v[0][i] + a * (double)(f->v[1][i] - f->v[0][i]) +
                b * (double)(f->v[2][i] - f->v[0][i]) - (double)ray.org[i];
        most = fmax(most, fabs(at[i]));
    }
    double reach = whole(0, 3) ? ldexp(between(0.5, 0.99), p->wd - 1)
                               : (double)sph_min_screen(p) * between(1, 4);
    for (int i = 0; i < 3; i++)
        ray.dir[i] = (int64_t)(at[i] * reach / most);
    sph_ray_setup(p, &ray);
    return ray;
}

static void test_sides(void **unused) {
    (void)unused;
    long hits = 0, behind = 0, near = 0;
    for (int run = 0; run < 400000 / (SANITIZED ? 10 : 1); run++) {
        struct sph_profile p = sph_profiles[run % SPH_PROFILES];
        if (run % 12 >= 8) p.ng = run % 12 == 8 ? 0 : run % 12 == 9 ? 1 : 4;
        if (p.ng == 4 && p.pq < p.w + 2) p.pq = p.w + 4;
        struct sph_facet_leaf f;
        struct sph_ray ray = aim(&p, &f);
        if (ray.a < (uint64_t)(sph_min_screen(&p) * sph_min_screen(&p))) continue;
        struct sph_facet_result r = sph_facet_test(&p, &ray, &f);
        int32_t v[3][3], normal[3];
        int64_t n[3], start[3];
        uint64_t divisions = 0;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                v[k][i] = (int32_t)f.v[k][i];
        if (!r.hit || !sph_triangle_normal((const int32_t(*)[3])v, normal)) continue;
        struct sph_hit hit = {sph_facet_key(&ray, &r, &divisions), 0, r.far != 0, 0};
        struct sph_surface s;
        for (int i = 0; i < 3; i++)
            n[i] = normal[i];
        if (sph_surface_facet(&p, &ray, &hit, n, &s)) continue;
        int side = r.far ? -1 : 1;
        assert_true(side * height(f.v, s.point) > 0);
        sph_surface_behind(&p, &s, start);
        assert_true(side * height(f.v, start) < 0);
        hits++;
        sph_surface_nearest(&p, &s);
        behind += side * height(f.v, s.point) < 0;
        near += side * height(f.v, s.point) == 0;
    }
    printf("# %ld hits; the nearest point would lie behind the plane for %ld, on it for %ld\n",
           hits, behind, near);
    assert_true(hits > 20000 / (SANITIZED ? 10 : 1) && behind > hits / 4);
}

/* Sign of N.(v0 2^e - org 2^e - mant dir) of a triangle, what is seen being org + mant dir / 2^e.
 */
static int side_of(const int64_t v[3][3], const struct sph_ray *eye, const mpz_t mant,
                   const mpz_t unit) {
    mpz_t sum, x;
    mpz_inits(sum, x, NULL);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        int64_t n =
            (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) - (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]);
        mpz_mul_si(x, unit, v[0][i] - eye->org[i]);
        mpz_mul_si(x, x, n);
        mpz_add(sum, sum, x);
        mpz_mul_si(x, mant, eye->dir[i]);
        mpz_mul_si(x, x, n);
        mpz_sub(sum, sum, x);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, x, NULL);
    return sign;
}

/* t of what the eye sees, mant / unit: the quotient, or that of the exact hit if it is less. */
static void seen_at(const struct sph_profile *p, const struct sph_ray *ray,
                    const struct sph_facet_result *r, uint64_t key, mpz_t mant, mpz_t unit) {
    struct sph_quotient t = sph_quotient(key, p->w + p->wd + 2, ray->a, 2 * p->wd, p->pq);
    mpz_t num, det, x;
    mpz_inits(num, det, x, NULL);
    mpz_import(num, 1, -1, sizeof r->num, 0, 0, &r->num);
    mpz_import(det, 1, -1, sizeof r->det, 0, 0, &r->det);
    mpz_set_ui(mant, t.mant);
    mpz_set_ui(unit, 1);
    mpz_mul_2exp(unit, unit, (mp_bitcnt_t)t.exp);
    mpz_mul(x, mant, det);
    mpz_submul(x, num, unit);
    if (mpz_sgn(x) > 0) mpz_set(mant, num), mpz_set(unit, det);
    mpz_clears(num, det, x, NULL);
}

/* Neighbours that share an edge or a corner with a facet that is seen, folded either way: none of
 * them keeps a light from it that is on the same side of its plane, or in it, as what is seen. */
static void test_neighbours(void **unused) {
    (void)unused;
    long hits = 0, same = 0, saved = 0, shades = 0;
    mpz_t mant, unit;
    mpz_inits(mant, unit, NULL);
    for (int run = 0; run < 400000 / (SANITIZED ? 10 : 1); run++) {
        struct sph_profile p = sph_profiles[run % SPH_PROFILES];
        if (run % 12 >= 8) p.ng = run % 12 == 8 ? 0 : run % 12 == 9 ? 1 : 4;
        if (p.ng == 4 && p.pq < p.w + 2) p.pq = p.w + 4;
        struct sph_facet_leaf f, g;
        struct sph_ray ray = aim(&p, &f), to = {.kind = SPH_SHADOW, .inside = 1}, free;
        if (ray.a < (uint64_t)(sph_min_screen(&p) * sph_min_screen(&p))) continue;
        struct sph_facet_result r = sph_facet_test(&p, &ray, &f);
        uint64_t divisions = 0;
        int64_t n[3], size = 2 << whole(0, p.w - 4), half = (1ll << (p.w - 1)) - 1;
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            int64_t(*v)[3] = f.v;
            n[i] = (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) -
                   (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]);
        }
        if (!r.hit) continue;
        struct sph_hit hit = {sph_facet_key(&ray, &r, &divisions), 0, r.far != 0, 0};
        struct sph_surface s;
        if (sph_surface_point(&p, &ray, hit.key, &s) | sph_surface_outwards(&p, r.far, n, &s))
            continue;
        hits++;
        seen_at(&p, &ray, &r, hit.key, mant, unit);
        sph_surface_spawn(&p, &s, &to);
        to.skip = (struct sph_skip){SPH_ID_NONE, 0};
        for (int other = 0; other < 8; other++) {
            g = f;
            for (int k = 0; k < 1 + other % 2; k++) /* an edge or a corner in common */
                for (int i = 0; i < 3; i++) {
                    int64_t at = (other & 2 ? s.point[i] : f.v[k][i]) + whole(-size, size);
                    g.v[(other / 4 + k) % 3][i] = at > half ? half : at < -half ? -half : at;
                }
            for (int i = 0; i < 3; i++)
                to.dir[i] = (other & 2 ? whole(-half, half) : g.v[other % 3][i]) - s.point[i];
            free = to;
            for (int i = 0; i < 3; i++)
                free.lift[i] = to.dir[i] * (1ll << (p.w + 12)); /* all is ahead of it */
            struct sph_facet_result by = sph_facet_test(&p, &to, &g);
            int met = sph_facet_test(&p, &free, &g).hit;
            int ahead = side_of((const int64_t(*)[3])g.v, &ray, mant, unit) * (by.far ? 1 : -1);
            shades += by.hit;
            if (ahead > 0 || !by.det) continue;
            same++;
            saved += met;
            assert_false(by.hit);
        }
    }
    printf(
        "# %ld hits, %ld neighbours with light and point on one side, %ld would have shaded; %ld "
        "shade\n",
        hits, same, saved, shades);
    assert_true(same > hits && saved > hits / 200 && shades > hits / 20);
    mpz_clears(mant, unit, NULL);
}

/* The point of a hit of the eye's ray; 0: none, or on the plane below the mesh. */
static int seen(const struct sph_machine *m, int x, int y, struct sph_hit *hit,
                struct sph_surface *s, int64_t v[3][3]) {
    const struct sph_profile *p = sph_machine_profile(m);
    static const int lsb[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB, SPH_TRIANGLE_V2_X_LSB};
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    struct sph_counters c = {0};
    uint32_t visits = 0, errors = 0;
    int64_t n[3];
    for (int i = 0; i < 3; i++)
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_ray_setup(p, &ray);
    *hit = sph_traverse(m, &ray, SPH_TRAVERSE_TREE, &c, &visits, &errors);
    if (!hit->key) return 0;
    const uint32_t *line = machine_line(m, (uint32_t)m->regs[SPH_REG_FACET_BASE] + hit->id);
    const uint32_t *prim = machine_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + hit->id);
    if (sph_record_kind(1, line) != SPH_TRIANGLE) return 0;
    for (int k = 0; k < 3; k++)
        sph_vector_read(line, lsb[k], p->w, v[k]);
    sph_stored_normal(p, prim, NULL, n);
    sph_surface_facet(p, &ray, hit, n, s);
    return 1;
}

/* A ball of triangles: what faces the light is lit, whatever the profile. */
static void test_convex(void **unused) {
    (void)unused;
    struct sph_generate_options how = {.size = 4, .width = 320, .height = 180};
    struct sph_scene scene;
    struct sph_error err = {{0}};
    if (sph_generate("icosphere", &how, &scene, &err)) fail_msg("%s", err.text);
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        struct sph_build_options o = standard;
        struct sph_build_report report;
        o.profile = profile;
        struct sph_machine m = built(&scene, o, &report);
        const struct sph_profile *p = sph_machine_profile(&m);
        const int32_t *lamp = m.regs + SPH_REG_LIGHT0_X;
        long lit = 0, dark = 0, acne = 0;
        for (int i = 0; i < 320 * 180; i += SANITIZED ? 16 : 1) {
            struct sph_hit hit;
            struct sph_surface s;
            int64_t v[3][3], light[3] = {lamp[0], lamp[1], lamp[2]};
            if (!seen(&m, i % 320, i / 320, &hit, &s, v)) continue;
            if (height(v, light) <= 0) continue;
            for (int nearest = 0; nearest < 2; nearest++) {
                struct sph_ray to = {.kind = SPH_SHADOW, .skip = {hit.id, hit.far}, .inside = 1};
                struct sph_counters c = {0};
                uint32_t visits = 0, errors = 0;
                if (nearest) sph_surface_nearest(p, &s);
                for (int k = 0; k < 3; k++) {
                    to.org[k] = s.point[k];
                    to.dir[k] = lamp[k] - s.point[k];
                }
                sph_ray_setup(p, &to);
                struct sph_hit by = sph_traverse(&m, &to, SPH_TRAVERSE_TREE, &c, &visits, &errors);
                *(nearest ? &acne : &dark) += by.key != 0;
            }
            lit++;
        }
        printf("# %s: %ld pixels face the light, dark %ld; from the nearest points %ld\n", p->name,
               lit, dark, acne);
        assert_int_equal(dark, 0);
        assert_true(lit > 500 && (acne > 0 || SANITIZED || profile > SPH_STANDARD));
        sph_machine_free(&m);
    }
    sph_scene_free(&scene);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sides),
                                       cmocka_unit_test(test_neighbours),
                                       cmocka_unit_test(test_convex)};
    seed(argc, argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
