/* test_meet.c - the bounds of the double reference hold; no ray slips through; the lower number
 * wins SPDX-License-Identifier: Apache-2.0
 *
 * The bounds are held against the same equations in long double, whose digits are 2048 times finer.
 * SEED=N: other rays.
 */
#include "model_scene.h"
#include "number.h"

#include <float.h>
#include <math.h>

#include "reference/exact.h"
#include "reference/meet.h"
#include "reference/reference.h"
#include "reference/tree.h"
#include "scene/rng.h"

typedef long double wide;

enum { ROUNDS = SANITIZED ? 20000 : 400000 };

static struct sph_vec vec(const double v[3]) {
    return (struct sph_vec){v[0], v[1], v[2]};
}

static wide dotw(const wide a[3], const wide b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void crossw(const wide a[3], const wide b[3], wide out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void lessw(struct sph_vec a, const double b[3], wide out[3]) {
    out[0] = (wide)a.x - b[0], out[1] = (wide)a.y - b[1], out[2] = (wide)a.z - b[2];
}

/* ---- what doubles lose stays within the bounds ---- */

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

/* ---- scenes in which surfaces lie in one place ---- */

enum { SIDE = 33, MOST = 64 };

static struct {
    struct sph_scene scene;
    struct sph_sphere spheres[4];
    struct sph_facet facets[MOST];
    struct sph_material materials[MOST];
} made;

/* Nothing but a light and the eye, which looks along -z from 10. */
static struct sph_scene *bare(void) {
    memset(&made, 0, sizeof made);
    struct sph_scene *s = &made.scene;
    *s = (struct sph_scene){.path = "made here", .n_lights = 1, .n_materials = MOST};
    s->camera = (struct sph_camera){{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, 0, SIDE, SIDE};
    s->lights[0] = (struct sph_light){{3, 4, 20}, {0.75, 0.75, 0.75}, 0};
    s->ambient[0] = s->ambient[1] = 0.25;
    s->spheres = made.spheres, s->facets = made.facets, s->materials = made.materials;
    for (int i = 0; i < MOST; i++)
        made.materials[i] =
            (struct sph_material){.rgb = {1.0 / (1 + i), i * 0.01, 0.5}, .kd = 0.7, .ks = 0.3};
    return s;
}

static void add(struct sph_scene *s, int kind, uint32_t group, const double v[3][3]) {
    uint32_t i = s->n_facets++;
    s->facets[i] = (struct sph_facet){.kind = kind, .group = group, .material = i % MOST};
    for (int k = 0; k < 3; k++)
        s->facets[i].v[k] = vec(v[k]);
}

static struct sph_reference render(const struct sph_scene *s, int width, int height) {
    struct sph_reference_options o = {.width = width,
                                      .height = height,
                                      .max_depth = 4,
                                      .shadow = 1,
                                      .reflect = 1,
                                      .refract = 1,
                                      .specular = 1};
    struct sph_reference r;
    struct sph_error err = {{0}};
    if (sph_reference_render(s, &o, &r, &err)) fail_msg("%s", err.text);
    return r;
}

/* A point of a plane askew, from where it is along its two sides. */
static void askew(double x, double y, double out[3]) {
    const double u[3] = {0.96, 0.1, -0.2613}, v[3] = {-0.07, 0.98, 0.183};
    for (int i = 0; i < 3; i++)
        out[i] = 0.1 * (i + 1) + x * u[i] + y * v[i];
}

/* Triangles across one another in a plane that no double holds: of those around a point the first
 * is seen, and none of them shades another or shows in its mirror. */
static void first_of_a_plane(void **state) {
    (void)state;
    struct sph_rng rng = {test_seed()};
    struct sph_scene *s = bare();
    double at[MOST][3][2];
    for (int k = 0; k < 40; k++) {
        double v[3][3];
        for (int c = 0; c < 3; c++) {
            at[k][c][0] = sph_rng_range(&rng, -2.5, 2.5);
            at[k][c][1] = sph_rng_range(&rng, -2.5, 2.5);
            askew(at[k][c][0], at[k][c][1], v[c]);
        }
        add(s, SPH_TRIANGLE, (uint32_t)k, v);
    }
    struct sph_reference r = render(s, SIDE, SIDE);
    double o[3], p[3][3], screen = SIDE / 2.0 / tan(acos(-1.0) / 12);
    int seen = 0, several = 0;
    askew(0, 0, p[0]), askew(1, 0, p[1]), askew(0, 1, p[2]);
    for (int i = 0; i < SIDE * SIDE; i++) {
        /* where the pixel's ray meets the plane: o + x (p1 - p0) + y (p2 - p0) */
        wide d[3] = {i % SIDE - (SIDE - 1) / 2, (SIDE - 1) / 2 - i / SIDE, -screen}, n[3], e[2][3],
             c[3];
        for (int j = 0; j < 3; j++) {
            e[0][j] = (wide)p[1][j] - p[0][j], e[1][j] = (wide)p[2][j] - p[0][j];
            o[j] = (j == 2 ? 10 : 0) - p[0][j];
        }
        crossw(e[0], e[1], n);
        wide from[3] = {o[0], o[1], o[2]}, t = -dotw(n, from) / dotw(n, d), x, y;
        for (int j = 0; j < 3; j++)
            from[j] += t * d[j];
        crossw(from, e[1], c), x = dotw(c, n) / dotw(n, n);
        crossw(e[0], from, c), y = dotw(c, n) / dotw(n, n);
        uint32_t first = SPH_ID_NONE;
        int around = 0, edge = 0;
        for (int k = 0; k < 40; k++) {
            int signs[2] = {0};
            for (int q = 0; q < 3; q++) {
                const double *a = at[k][q], *b = at[k][(q + 1) % 3];
                wide side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
                signs[side > 0]++;
                edge |= fabsl(side) < 1e-6;
            }
            if (signs[0] && signs[1]) continue;
            around++;
            if (first == SPH_ID_NONE) first = (uint32_t)k;
        }
        if (edge) continue;
        assert_int_equal(r.pixels[i].id, first);
        assert_int_equal(r.pixels[i].doubt, 0);
        if (first == SPH_ID_NONE) continue;
        assert_int_equal(r.pixels[i].shadow, 0);
        assert_int_equal(r.pixels[i].reflected_id, SPH_ID_NONE);
        seen++, several += around > 1;
    }
    printf("# %d pixels see the plane, %d of them several triangles\n", seen, several);
    assert_true(several > 100);
    sph_reference_free(&r);
}

/* A sphere and another one, which differs from it in the last bit of its radius, draw what one
 * draws. */
static void sphere_twice(void **state) {
    (void)state;
    for (int glass = 0; glass < 2; glass++) {
        struct sph_scene *s = bare();
        for (int i = 0; i < MOST && glass; i++)
            made.materials[i] = (struct sph_material){.rgb = {1, 0.5, 0.2},
                                                      .kd = 0.1,
                                                      .ks = 0.2,
                                                      .shine = 40,
                                                      .trans = 0.8,
                                                      .ior = 1.5,
                                                      .sum = {.on = 1, .ka = 0.1, .kr = 0.1}};
        s->spheres[0] = (struct sph_sphere){.ctr = {0.1, 0.2, 0.3}, .rad = sqrt(3)};
        s->spheres[1] = (struct sph_sphere){
            .ctr = {0.1, 0.2, 0.3}, .rad = nextafter(sqrt(3), 4), .material = 1};
        s->spheres[2] = (struct sph_sphere){.ctr = {0.7, -0.4, 5}, .rad = 0.6, .material = 2};
        made.materials[1] = made.materials[0];
        s->n_spheres = 3;
        struct sph_reference twice = render(s, SIDE, SIDE);
        s->spheres[1] = s->spheres[2];
        s->n_spheres = 2;
        struct sph_reference once = render(s, SIDE, SIDE);
        for (int i = 0; i < SIDE * SIDE; i++) {
            uint32_t id = once.pixels[i].id == 1 ? 2 : once.pixels[i].id;
            assert_int_equal(twice.pixels[i].id, id);
            assert_int_equal(twice.pixels[i].colour[2], once.pixels[i].colour[2]);
            assert_int_equal(twice.pixels[i].shadow, once.pixels[i].shadow);
        }
        sph_reference_free(&twice);
        sph_reference_free(&once);
    }
}

/* A sphere, a triangle and a plane that touch where the middle pixel looks: in each order of
 * triangle and plane, with and without the sphere. */
static void tie_of_three(void **state) {
    (void)state;
    const double corner[3][3] = {{-2, -1, 2}, {2, -1, 2}, {0, 3, 2}};
    const double plane[3][3] = {{7, 7, 2}, {0, 0, 1}, {1, 0, 0}};
    for (int how = 0; how < 4; how++) {
        struct sph_scene *s = bare();
        s->spheres[0] = (struct sph_sphere){.rad = 2};
        s->n_spheres = how & 1;
        add(s, how & 2 ? SPH_PLANE : SPH_TRIANGLE, 0, how & 2 ? plane : corner);
        add(s, how & 2 ? SPH_TRIANGLE : SPH_PLANE, 1, how & 2 ? corner : plane);
        struct sph_reference r = render(s, SIDE, SIDE);
        const struct sph_reference_pixel *middle = &r.pixels[SIDE / 2 * SIDE + SIDE / 2];
        assert_int_equal(middle->id, 0);
        assert_int_equal(middle->doubt != 0,
                         s->n_spheres); /* it is one point of the sphere alone */
        assert_int_equal(middle->shadow, 0);
        assert_int_equal(middle[2].id, s->n_spheres);
        assert_int_equal(middle[2].doubt, 0);
        assert_true(fabs(middle->distance - 8) < 1e-12);
        sph_reference_free(&r);
    }
}

/* What lies at the light's place, or at the start, does not stand between. */
static void ends_of_a_shadow_ray(void **state) {
    (void)state;
    struct sph_scene *s = bare();
    for (int k = 0; k < 3; k++) { /* planes through (1, 1, 1) k / 3 */
        double z = k / 3.0;
        add(s, SPH_PLANE, (uint32_t)k, (double[3][3]){{z, z, z}, {3, 1, 2}, {1, 0, 0}});
    }
    s->spheres[0] = (struct sph_sphere){.ctr = {2, 1, 1}, .rad = 1}; /* (1, 1, 1) is on it */
    s->n_spheres = 1;
    for (int k = 0; k < 3; k++) {
        double p = k / 3.0, q = (k + 1) / 3.0;
        struct sph_ref_ray ray = {
            .org = {p, p, p}, .dir = {q - p, q - p, q - p}, .skip = 1, .light = 1, .lift = 1e-14};
        struct sph_ref_tree *tree = sph_ref_tree_new(s);
        assert_non_null(tree);
        struct sph_ref_hit hit = sph_ref_trace(tree, &ray, 1, 1);
        assert_true(isinf(hit.t));
        for (int i = 0; i < 3; i++) /* a little on, and there is one between */
            ray.dir[i] *= 1 + 1e-9;
        assert_true(isfinite(sph_ref_trace(tree, &ray, 1, 1).t));
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
        double rim[12][3], hub[3], org[3];
        any(&rng, 1, hub);
        for (int k = 0; k < 12; k++) {
            double turn = acos(-1.0) / 6 * k, away = sph_rng_range(&rng, 1, 3);
            rim[k][0] = hub[0] + away * cos(turn);
            rim[k][1] = hub[1] + away * sin(turn);
            rim[k][2] = hub[2] + sph_rng_range(&rng, -0.1, 0.1);
        }
        for (int k = 0; k < 12; k++) {
            double v[3][3];
            for (int c = 0; c < 3; c++) /* corners in any order */
                memcpy(v[(c + k) % 3], c == 0 ? hub : rim[(k + c - 1) % 12], sizeof v[0]);
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
                ray.dir[j] = hub[j] + along * (rim[i % 12][j] - hub[j]) - org[j];
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

/* ---- scenes of files, and the model ---- */

struct file {
    const char *name;
    int least; /* pixels in doubt, at least */
    double floor[SPH_PROFILES];
};

static void model_is_judged(void **state) {
    (void)state;
    static const struct file files[] = {{"squares", 0, {42, 60, 60, 60}},
                                        {"bricks", 0, {20, 34, 53, 55}},
                                        {"wall", 5000, {70, 70, 70, 70}}};
    for (unsigned n = 0; n < sizeof files / sizeof *files; n++) {
        char path[128];
        snprintf(path, sizeof path, "tests/scenes/coincident/%s.nff", files[n].name);
        struct sph_scene scene = read_scene(path);
        struct sph_reference r = render(&scene, 320, 180);
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct sph_build_options o = SPH_BUILD_DEFAULT;
            struct sph_build_report report;
            struct sph_machine m;
            struct sph_counters c;
            struct sph_error err = {{0}};
            int errors;
            o.profile = profile, o.width = 320, o.height = 180, o.max_depth = 4;
            o.axes = SPH_AXES_SCENE; /* so that planes stay planes on the grid */
            if (sph_build(&scene, &o, &m, &report, &err)) fail_msg("%s", err.text);
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            struct sph_image_error e = sph_reference_compare(&f, &r);
            printf("# %-8s %-9s %6.2f dB, %lu silhouette, %lu other, %lu undecidable\n",
                   files[n].name, sph_profiles[profile].name, e.psnr[2], e.silhouette, e.wrong_id,
                   e.undecidable);
            assert_true(e.psnr[2] >= files[n].floor[profile]);
            assert_true((int)e.undecidable >= files[n].least);
            if (!files[n].least) assert_int_equal(e.undecidable, 0);
            if (profile == SPH_REFERENCE) assert_int_equal(e.silhouette + e.wrong_id, 0);
            sph_frame_free(&f);
            sph_machine_free(&m);
        }
        sph_reference_free(&r);
        sph_scene_free(&scene);
    }
}

/* What is in doubt is neither right nor wrong. */
static void doubt_is_apart(void **state) {
    (void)state;
    struct sph_pixel p[3] = {
        {.colour = {9, 9, 9}, .id = 1}, {.colour = {0, 0, 90}, .id = 1}, {.id = SPH_ID_NONE}};
    struct sph_reference_pixel q[3] = {{.colour = {9, 9, 9}, .id = 2, .doubt = SPH_DOUBT_SEEN},
                                       {.id = 2, .doubt = SPH_DOUBT_LATER},
                                       {.id = SPH_ID_NONE}};
    struct sph_frame f = {3, 1, p};
    struct sph_reference r = {.width = 3, .height = 1, .pixels = q};
    struct sph_image_error e = sph_reference_compare(&f, &r);
    assert_int_equal(e.pixels, 3);
    assert_int_equal(e.undecidable, 2);
    assert_int_equal(e.wrong_id, 1); /* the shadow or mirror is in doubt, what is seen is not */
    assert_int_equal(e.far_off + (uint64_t)e.worst, 0);
    assert_true(isinf(e.psnr[2]));
    q[2].colour[2] = 9;
    assert_true(fabs(sph_reference_compare(&f, &r).psnr[2] - 10 * log10(65025.0 * 3 / 81)) < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_hold),      cmocka_unit_test(sides_are_exact),
        cmocka_unit_test(first_of_a_plane), cmocka_unit_test(sphere_twice),
        cmocka_unit_test(tie_of_three),     cmocka_unit_test(ends_of_a_shadow_ray),
        cmocka_unit_test(fans_are_closed),  cmocka_unit_test(doubt_of_a_rim),
        cmocka_unit_test(model_is_judged),  cmocka_unit_test(doubt_is_apart),
    };
    return cmocka_run_group_tests_name("meet", tests, NULL, NULL);
}
