/* keep.c - see keep.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/texture/keep.h"

#include <stdlib.h>
#include <string.h>

int sph_bases_start(struct sph_texture_bases *bases, const struct sph_scene *scene,
                    struct sph_error *err) {
    *bases = (struct sph_texture_bases){.n = scene->n_spheres + scene->n_facets};
    bases->last = calloc((size_t)bases->n + 1, sizeof *bases->last);
    if (!bases->last) return sph_fail(err, "%s: out of memory for %u bases", scene->path, bases->n);
    for (uint32_t i = 0; i < bases->n; i++)
        bases->last[i].base = SPH_NO_BASE;
    return 0;
}

void sph_bases_end(struct sph_texture_bases *bases) {
    free(bases->last);
    bases->last = NULL;
    bases->n = 0;
}

void sph_bases_frame(struct sph_texture_bases *bases, const struct sph_scene *scene,
                     const struct sph_texture_view *view) {
    const struct sph_texture_view *old = &bases->view;
    int same = old->distance == view->distance && old->pixels == view->pixels &&
               old->step == view->step && old->literal == view->literal;
    const uint32_t spheres = scene->n_spheres, all = spheres + scene->n_facets;
    for (uint32_t i = 0; i < bases->n; i++) {
        uint32_t motion = i >= all      ? 0
                          : i < spheres ? scene->spheres[i].motion
                                        : scene->facets[i - spheres].motion;
        if (motion || !same) bases->last[i].base = SPH_NO_BASE;
    }
    bases->view = *view;
    bases->computed = bases->kept = 0;
    memset(&bases->flops, 0, sizeof bases->flops);
}

/* 1 if both have the same coordinates. */
static int alike(const struct sph_texture_shape *a, const struct sph_texture_shape *b) {
    if (a->kind != b->kind || a->rad != b->rad) return 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            if (a->corner[i][k] != b->corner[i][k]) return 0;
        for (int k = 0; k < 2; k++)
            if (a->st[i][k] != b->st[i][k]) return 0;
    }
    return 1;
}

int sph_bases_of(struct sph_texture_bases *bases, uint32_t id,
                 const struct sph_texture_shape *shape, double texels) {
    struct sph_kept_base *last = id < bases->n ? &bases->last[id] : NULL;
    if (last && last->base != SPH_NO_BASE && alike(&last->shape, shape) &&
        !(last->texels < texels || last->texels > texels)) {
        bases->kept++;
        return last->base;
    }
    struct sph_texture_area area = sph_texture_area_of(shape, texels, &bases->flops);
    int base = sph_texture_base(&area, &bases->view, &bases->flops);
    bases->computed++;
    if (last) *last = (struct sph_kept_base){*shape, texels, base};
    return base;
}
