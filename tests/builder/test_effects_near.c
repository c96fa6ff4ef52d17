/* test_effects_near.c - spheres of a few grid units about as near as can matter, and lights about
 * where they begin to: the machine that build finds shows what one with every effect shows
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_effects_near [seed] [scenes]
 */
#include "effects_scene.h"

enum { MOST = 6, WIDTH = 16, HEIGHT = 12 };
static int scenes = 2000 / SLOW;

static struct sph_material materials[3] = {{{0.9, 0.5, 0.3}, 1, 0, 1, 0, 1, 1, {0}, 0},
                                           {{0.3, 0.9, 0.5}, 0.5, 0.5, 1, 0, 1, 2, {0}, 0},
                                           {{0.5, 0.3, 0.9}, 0.1, 0.9, 1, 0, 1, 3, {0}, 0}};
static struct sph_sphere spheres[MOST];

static int whole(int lo, int hi) {
    return lo + (int)((hi - lo + 1) * uniform());
}

static struct sph_vec direction(void) {
    for (;;) {
        struct sph_vec v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
        if (length > 0.05 && length < 1)
            return (struct sph_vec){v.x / length, v.y / length, v.z / length};
    }
}

/* A grid point at a distance from a point in a direction. */
static struct sph_vec step(struct sph_vec from, struct sph_vec u, double far) {
    return (struct sph_vec){round(from.x + far * u.x), round(from.y + far * u.y),
                            round(from.z + far * u.z)};
}

/* An eye at the origin looks along -z; a black light makes the scene so large that a grid unit is
 * one unit of the scene: what is whole there is exact. */
static struct sph_scene empty(struct sph_build_options *o) {
    struct sph_scene s = {.name = "near", .path = "near.nff", .n_materials = 3};
    s.camera =
        (struct sph_camera){{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40, .width = WIDTH, .height = HEIGHT};
    s.ambient[0] = s.ambient[1] = s.ambient[2] = 0.2;
    s.background[2] = 1;
    s.materials = materials;
    s.spheres = spheres;
    *o = standard;
    o->profile = whole(0, SPH_PROFILES - 1);
    o->tree = whole(SPH_TREE_PAPER, SPH_TREE_BALANCED);
    o->background = SPH_BG_NONE;
    o->traverse = whole(SPH_BUILD_NEAREST, SPH_BUILD_FIRST);
    o->max_depth = 3;
    s.lights[s.n_lights++].pos.x = ldexp(0.75, sph_profiles[o->profile].w);
    return s;
}

static void add_sphere(struct sph_scene *s, struct sph_vec ctr, double rad) {
    spheres[s->n_spheres] =
        (struct sph_sphere){ctr, rad, (uint32_t)whole(0, 2), s->n_spheres + 10, 0, 0};
    s->n_spheres++;
}

static void add_light(struct sph_scene *s, struct sph_vec pos) {
    s->lights[s->n_lights++] = (struct sph_light){pos, {0.9, 0.7, 0.8}, 0};
}

static int radius(void) {
    int most = uniform() < 0.4 ? 4 : uniform() < 0.6 ? 20 : 60;
    return whole(1, most);
}

/* The first sphere, before the eye or around it. */
static void begin(struct sph_scene *s, const struct sph_build_options *o, int around) {
    double far = ldexp(0.7, sph_profiles[o->profile].w), z;
    int rad = radius();
    if (around)
        z = rad * between(0, 0.7);
    else
        z = rad + 2 + exp(between(0, log(uniform() < 0.5 ? far : 200)));
    add_sphere(s, (struct sph_vec){0, 0, -round(z)}, rad);
}

/* The next sphere, at a gap to one of those before. */
static void attach(struct sph_scene *s, double gap) {
    const struct sph_sphere *to = &spheres[whole(0, (int)s->n_spheres - 1)];
    int rad = radius();
    add_sphere(s, step(to->ctr, direction(), to->rad + rad + gap), rad);
}

/* An angle that shows the spheres, or some of them. */
static void aim(struct sph_scene *s) {
    double most = 0;
    for (uint32_t i = 0; i < s->n_spheres; i++) {
        const struct sph_vec *c = &spheres[i].ctr;
        double wide = sqrt(c->x * c->x + c->y * c->y) + spheres[i].rad;
        if (c->z < 0 && -wide / c->z > most) most = -wide / c->z;
    }
    s->camera.angle = fmin(atan(most * between(0.3, 1.2)) * 360 / M_PI, 120);
}

static struct sph_vec somewhere(const struct sph_scene *s, const struct sph_build_options *o) {
    const struct sph_sphere *at = &spheres[whole(0, (int)s->n_spheres - 1)];
    double pick = uniform();
    if (pick < 0.3) return step(at->ctr, direction(), at->rad * between(0, 1.2));
    if (pick < 0.7) return step(at->ctr, direction(), at->rad * between(1, 8));
    return step(at->ctr, direction(), ldexp(between(0, 0.2), sph_profiles[o->profile].w));
}

/* Anything, with all its gaps near the error of hit points. */
static void test_random(void **unused) {
    struct tally t = {0};
    (void)unused;
    for (int run = 0; run < scenes; run++) {
        struct sph_build_options o;
        struct sph_scene s = empty(&o);
        begin(&s, &o, uniform() < 0.1);
        for (int n = whole(1, MOST - 1); n; n--)
            attach(&s, uniform() < 0.1 ? between(-9, 0) : between(0, 8));
        for (int n = whole(0, 3); n; n--)
            add_light(&s, somewhere(&s, &o));
        aim(&s);
        compare(&s, o, &t);
    }
    print_tally(&t);
    assert_true(t.frames > scenes / 2 && t.seen > 20 * t.frames);
    assert_true(t.off[SPH_REPORT_INSIDE] * 20 > scenes && t.off[SPH_REPORT_SHADOW] * 300 > scenes);
}

/* One number of a scene between a value with which an effect is called for and one without. */
typedef void (*setter)(struct sph_scene *s, double value);

static int called(struct sph_scene *s, const struct sph_build_options *o, int effect, setter set,
                  double value) {
    static struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err;
    set(s, value);
    if (sph_build(s, o, &m, &report, &err)) return -1;
    sph_machine_free(&m);
    return report.effects[effect].called;
}

/* Sets the value next to the limit with which the effect is called for less, and compares. */
static void at_limit(struct sph_scene *s, const struct sph_build_options *o, int effect, setter set,
                     double on, double off, struct tally *t) {
    int most = called(s, o, effect, set, on), least = called(s, o, effect, set, off);
    if (most <= least || least < 0) return;
    while (fabs(on - off) > 0.3) {
        double middle = (on + off) / 2;
        if (called(s, o, effect, set, middle) > least)
            on = middle;
        else
            off = middle;
    }
    set(s, off);
    compare(s, *o, t);
}

static struct sph_vec way, from; /* of what the setters move */

static void set_gap(struct sph_scene *s, double gap) {
    (void)s;
    spheres[1].ctr = step(spheres[0].ctr, way, spheres[0].rad + spheres[1].rad + gap);
}

static void set_light(struct sph_scene *s, double far) {
    s->lights[1].pos = step(from, way, far);
}

static void set_inner(struct sph_scene *s, double far) {
    (void)s;
    spheres[1].ctr = step(spheres[0].ctr, way, far);
}

/* The smallest gap with which INSIDE is off. */
static void test_gap(void **unused) {
    struct tally t = {0};
    (void)unused;
    for (int run = 0; run < scenes; run++) {
        struct sph_build_options o;
        struct sph_scene s = empty(&o);
        begin(&s, &o, 0);
        attach(&s, 1);
        way = direction();
        if (uniform() < 0.7) add_light(&s, somewhere(&s, &o));
        aim(&s);
        at_limit(&s, &o, SPH_REPORT_INSIDE, set_gap, 0, 20, &t);
    }
    print_tally(&t);
    assert_true(t.frames > scenes / 3 && t.off[SPH_REPORT_INSIDE] == t.frames);
}

/* The nearest a light comes to where a sphere can shade another. */
static void test_shadow(void **unused) {
    struct tally t = {0};
    (void)unused;
    for (int run = 0; run < 2 * scenes; run++) {
        struct sph_build_options o;
        struct sph_scene s = empty(&o);
        begin(&s, &o, 0);
        attach(&s, between(6, 30));
        from = spheres[0].ctr, way = direction();
        add_light(&s, from);
        aim(&s);
        from = step(from, direction(), between(1, 300));
        at_limit(&s, &o, SPH_REPORT_SHADOW, set_light, between(-400, 400), between(-400, 400), &t);
    }
    print_tally(&t);
    assert_true(t.frames > scenes / 10 && t.off[SPH_REPORT_SHADOW] > t.frames * 4 / 5);
}

/* A light as far out in a sphere as is still shut in, and a sphere as far out as is buried. */
static void test_shut_in(void **unused) {
    struct tally t = {0}, buried = {0};
    (void)unused;
    for (int run = 0; run < scenes; run++) {
        struct sph_build_options o;
        struct sph_scene s = empty(&o);
        begin(&s, &o, 0);
        way = direction(), from = spheres[0].ctr;
        double rad = spheres[0].rad;
        add_light(&s, from);
        if (run & 1) {
            attach(&s, between(6, 30));
            aim(&s);
            at_limit(&s, &o, SPH_REPORT_LIGHTS, set_light, rad, 0, &t);
            continue;
        }
        add_sphere(&s, from, whole(1, 1 + (int)(rad / 2)));
        aim(&s);
        s.lights[1].pos = step(from, direction(), rad * between(1.1, 30));
        at_limit(&s, &o, SPH_REPORT_SHADOW, set_inner, rad, 0, &buried);
    }
    print_tally(&t);
    print_tally(&buried);
    assert_true(t.frames > scenes / 20 && t.off[SPH_REPORT_LIGHTS] == t.frames);
    assert_true(buried.frames > scenes / 20 && buried.off[SPH_REPORT_SHADOW] == buried.frames);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_gap),
        cmocka_unit_test(test_shadow),
        cmocka_unit_test(test_shut_in),
    };
    seed(argc, argv);
    if (argc > 2) scenes = (int)test_number(argv[2], "scenes", 0);
    return cmocka_run_group_tests_name("effects near their limits", tests, NULL, NULL);
}
