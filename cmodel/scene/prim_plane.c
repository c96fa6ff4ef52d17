/* prim_plane.c - a plane in a scene file: `plane`; see scene.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "scene/prim.h"
#include "scene/polygon.h"
#include "scene/vector.h"

/* plane x y z nx ny nz [sx sy sz] */
static int take_plane(struct sph_reader *r, struct sph_error *err) {
    static const char *const normal[] = {"nx", "ny", "nz"}, *const along[] = {"sx", "sy", "sz"};
    struct sph_facet facet = {.kind = SPH_PLANE, .group = r->n_groups};
    double n[3], s[3];
    facet.line = r->lex.token_line;
    if (sph_nff_material(r, "plane", "plane", &facet.material, err) ||
        sph_nff_vec(r, "plane", &facet.v[0], err) || sph_nff_numbers(r, "plane", normal, 3, n, err))
        return -1;
    facet.v[1] = sph_vec_of(n[0], n[1], n[2]);
    facet.v[2] = sph_plane_axis(facet.v[1]);
    if (!(fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2]))) > 0))
        return sph_fail(err, "%s:%u: `plane`: the normal is zero", r->lex.path, facet.line);
    int got = sph_nff_more(r, "plane", along, 3, s, err);
    if (got < 0) return -1;
    if (got) facet.v[2] = sph_vec_of(s[0], s[1], s[2]);
    if (sph_parallel(facet.v[1], facet.v[2]))
        return sph_fail(err, "%s:%u: `plane`: the direction of s is along the normal, or zero",
                        r->lex.path, facet.line);
    facet.texture = r->texture;
    for (int i = 0; i < 2 && r->texture; i++) {
        facet.st[0][i] = r->scene->textures[r->texture - 1].repeat[i];
        facet.st[1][i] = r->scene->textures[r->texture - 1].offset[i];
    }
    r->n_groups++;
    return sph_scene_add_facet(r->scene, &facet, err);
}

static uint32_t write(struct sph_nff_writer *w, uint32_t i) {
    const struct sph_facet *f = &w->scene->facets[i];
    sph_nff_put_motion(w, f->motion);
    sph_nff_put_material(w, f->material);
    sph_nff_put_texture(w, f->texture);
    sph_nff_put(w, "plane",
                (double[]){f->v[0].x, f->v[0].y, f->v[0].z, f->v[1].x, f->v[1].y, f->v[1].z,
                           f->v[2].x, f->v[2].y, f->v[2].z},
                9);
    return 1;
}

/* The repeats of its texture. */
static void grow(struct sph_facet *facet, double by) {
    for (int k = 0; k < 2; k++)
        facet->st[0][k] *= by;
}

static const struct sph_nff_word words[] = {{"plane", take_plane, SPH_READ_PLANE}, {0}};
const struct sph_prim_scene sph_prim_scene_plane = {.words = words,
                                                    .write = write,
                                                    .points = 1,
                                                    .wants = "a finite point and normal",
                                                    .grow = grow};
