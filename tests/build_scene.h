/* build_scene.h - scenes made in code for the tests of build and machine
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_BUILD_SCENE_H
#define SPH_TEST_BUILD_SCENE_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "builder/build.h"
#include "number.h"
#include "validate/validate.h"

static uint64_t state = 1; /* of the generator: argument 1 of a test program */

/* Uniform in [0, 1) (xorshift64*). */
static inline double uniform(void) {
    state ^= state >> 12, state ^= state << 25, state ^= state >> 27;
    return (double)(state * 0x2545f4914f6cdd1du >> 11) * 0x1p-53;
}

static inline double between(double lo, double hi) {
    return lo + (hi - lo) * uniform();
}

static struct sph_material mirror = {{0.8, 0.6, 0.4}, 0.5, 0.5, 10, 0, 1, 7, {0}, 0};

/* A scene of n spheres of the same radius range in the unit cube, seen from outside. */
static inline struct sph_scene cloud(uint32_t n, double rad) {
    struct sph_scene s = {.name = "cloud", .path = "cloud.nff", .n_lights = 2, .n_materials = 1};
    s.camera =
        (struct sph_camera){{2, 3, 1.5}, {0.5, 0.5, 0.5}, {0, 0, 1}, 40, .width = 64, .height = 48};
    for (int l = 0; l < 2; l++)
        s.lights[l] = (struct sph_light){{3, 4.0 * l - 2, 3}, {0.7, 0.7, 2.5}, 3 + (uint32_t)l};
    s.materials = &mirror;
    s.n_spheres = n;
    s.spheres = calloc(n + 1u, sizeof *s.spheres);
    for (uint32_t i = 0; i < n; i++) {
        double x = uniform(), y = uniform(), z = uniform();
        s.spheres[i] = (struct sph_sphere){{x, y, z}, rad * between(0.5, 1), 0, i + 10, 0, 0};
    }
    return s;
}

static const struct sph_build_options standard = {.profile = SPH_STANDARD,
                                                  .tree = SPH_TREE_BALANCED,
                                                  .background = SPH_BG_RECT,
                                                  .bg_border = 1,
                                                  .max_depth = 2,
                                                  .shadow = SPH_AUTO,
                                                  .reflect = SPH_AUTO,
                                                  .lights = SPH_AUTO,
                                                  .inside = SPH_AUTO,
                                                  .interpenetrate = SPH_AUTO};

static inline struct sph_machine built(const struct sph_scene *scene,
                                       struct sph_build_options options,
                                       struct sph_build_report *report) {
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (sph_build(scene, &options, &m, report, &err)) fail_msg("%s", err.text);
    if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
    return m;
}

/* Takes the seed from the command line and tells how to repeat the run. */
static inline void seed(int argc, char **argv) {
    if (argc > 1) state = test_number(argv[1], "seed", 1) | 1;
    printf("# repeat with: %s %llu\n", argv[0], (unsigned long long)state);
}

/* ---- scenes of triangles and planes made in code, for the tests of build and machine ---- */

enum { MOST_FACETS = 1200 };
static struct sph_facet facet_list[MOST_FACETS]; /* of the one scene at a time */

/* No facet, no sphere, two lights; lines of facets start at 100. */
static inline struct sph_scene bare(void) {
    static struct sph_sphere spheres[16];
    struct sph_scene s = cloud(0, 0.1);
    free(s.spheres);
    s.spheres = spheres;
    s.facets = facet_list;
    return s;
}

static inline struct sph_facet *add_facet(struct sph_scene *s, int kind, uint32_t group) {
    struct sph_facet *f = &facet_list[s->n_facets];
    *f = (struct sph_facet){.kind = kind, .group = group, .line = 100 + s->n_facets++};
    return f;
}

static inline void add_triangle(struct sph_scene *s, struct sph_vec a, struct sph_vec b,
                                struct sph_vec c, uint32_t group) {
    struct sph_facet *f = add_facet(s, SPH_TRIANGLE, group);
    f->v[0] = a, f->v[1] = b, f->v[2] = c;
}

static inline void add_plane(struct sph_scene *s, struct sph_vec p, struct sph_vec n) {
    struct sph_facet *f = add_facet(s, SPH_PLANE, s->n_facets);
    f->v[0] = p, f->v[1] = n, f->v[2] = (struct sph_vec){1, 0, 0};
}

static inline void add_ball(struct sph_scene *s, struct sph_vec ctr, double rad) {
    s->spheres[s->n_spheres] = (struct sph_sphere){ctr, rad, 0, 10 + s->n_spheres, 0, 0};
    s->n_spheres++;
}

static inline struct sph_vec at(double x, double y, double z) {
    return (struct sph_vec){x, y, z};
}

static inline struct sph_vec near_to(struct sph_vec p, double far) {
    return at(p.x + between(-far, far), p.y + between(-far, far), p.z + between(-far, far));
}

/* n triangles of about one size in the unit cube. */
static inline void soup(struct sph_scene *s, uint32_t n, double size) {
    while (n--) {
        struct sph_vec p = at(uniform(), uniform(), uniform());
        add_triangle(s, p, near_to(p, size), near_to(p, size), s->n_facets);
    }
}

static inline const uint32_t *machine_line(const struct sph_machine *m, uint32_t line) {
    return m->mem + (size_t)line * SPH_LINE_WORDS;
}

/* Three numbers in fields of 24 bits. */
static inline void get_vector(const uint32_t *line, int lsb, int32_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = sph_field_signed(line, lsb + 24 * i, 24);
}

#endif
