/* prim_sphere.c - a sphere in a scene file: `s`; see scene.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "scene/prim.h"
#include "scene/nesting.h"

/* s x y z radius; negative: the inner surface of hollow glass */
static int take_sphere(struct sph_reader *r, struct sph_error *err) {
    struct sph_vec ctr;
    double rad;
    uint32_t line = r->lex.token_line, material;
    if (sph_nff_material(r, "s", "sphere", &material, err)) return -1;
    if (sph_nff_vec(r, "s", &ctr, err) || sph_lex_number(&r->lex, "s", "radius", &rad, err))
        return -1;
    if (rad == 0) return sph_fail(err, "%s:%u: `s`: radius is 0", r->lex.path, r->lex.token_line);
    if (rad < 0 && sph_material_clear(&r->scene->materials[material]) &&
        sph_scene_hollow(r->scene, &material, err))
        return -1;
    if (sph_scene_add_sphere(r->scene, ctr, fabs(rad), material, line, err)) return -1;
    r->scene->spheres[r->scene->n_spheres - 1].texture = r->texture;
    return 0;
}

static uint32_t write(struct sph_nff_writer *w, uint32_t i) {
    const struct sph_sphere *s = &w->scene->spheres[i];
    sph_nff_put_motion(w, s->motion);
    sph_nff_put_material(w, s->material);
    sph_nff_put_texture(w, s->texture);
    double sign = w->scene->materials[s->material].sum.hollow ? -1 : 1;
    sph_nff_put(w, "s", (double[]){s->ctr.x, s->ctr.y, s->ctr.z, sign * s->rad}, 4);
    return 1;
}

static const struct sph_nff_word words[] = {{"s", take_sphere, SPH_READ_SPHERE}, {0}};
const struct sph_prim_scene sph_prim_scene_sphere = {.words = words, .write = write};
