/* facets_scene.h - scenes of triangles and planes made in code, for the tests of build and machine
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_FACETS_SCENE_H
#define SPH_TEST_FACETS_SCENE_H

#include "build_scene.h"

#include <math.h>
#include <string.h>

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
