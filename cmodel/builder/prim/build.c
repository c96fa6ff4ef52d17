/* build.c - see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/prim/build.h"

#include "prim/prim.h"

#define EXTERN(name) extern const struct sph_prim_build sph_prim_build_##name;
SPH_EACH_KIND(EXTERN)
#define KIND(name) &sph_prim_build_##name,
static const struct sph_prim_build *const kinds[SPH_KINDS] = {SPH_EACH_KIND(KIND)};

const struct sph_prim_build *sph_prim_build_of(uint32_t kind) {
    return kinds[kind];
}

struct sph_grid_prim sph_grid_prim_of(const struct sph_ball *balls, uint32_t n_spheres,
                                      const struct sph_facets *facets, uint32_t id) {
    if (id < n_spheres) return (struct sph_grid_prim){SPH_SPHERE, id, &balls[id], NULL, id};
    const struct sph_grid_facet *f = &facets->list[id - n_spheres];
    return (struct sph_grid_prim){(uint32_t)f->kind, id, &balls[id], f, f->scene};
}

struct sph_grid_appearance sph_grid_appearance(const struct sph_scene *scene,
                                               const struct sph_grid_prim *prim) {
    if (prim->facet) {
        const struct sph_facet *f = &scene->facets[prim->index];
        return (struct sph_grid_appearance){f->material, f->texture, f->line};
    }
    const struct sph_sphere *s = &scene->spheres[prim->index];
    return (struct sph_grid_appearance){s->material, s->texture, s->line};
}

static uint32_t passes(const struct sph_scene *scene, const struct sph_grid_prim *prim) {
    return (uint32_t)scene->materials[sph_grid_appearance(scene, prim).material].passes;
}

void sph_put_record(const struct sph_scene *scene, const struct sph_grid_prim *prim,
                    uint32_t *words) {
    sph_prim_build_of(prim->kind)->record(prim, words);
    sph_field_set(words, sph_record_clear_lsb(prim->kind), SPH_LEAF_CLEAR_BITS,
                  passes(scene, prim));
}

/* That of a sphere begins with its leaf record. */
void sph_put_prim(const struct sph_scene *scene, const struct sph_grid_prim *prim, uint32_t *line) {
    sph_prim_build_of(prim->kind)->prim(prim, line);
    if (prim->kind == SPH_SPHERE)
        sph_field_set(line, SPH_LEAF_CLEAR_LSB, SPH_LEAF_CLEAR_BITS, passes(scene, prim));
}
