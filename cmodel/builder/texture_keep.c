/* texture_keep.c - see texture_keep.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/texture_keep.h"

#include <stdlib.h>
#include <string.h>

int sph_bases_start(struct sph_texture_bases *bases, const struct sph_scene *scene,
                    struct sph_error *err) {
    *bases = (struct sph_texture_bases){.n = scene->n_spheres + scene->n_facets};
    bases->base = malloc(((size_t)bases->n + 1) * sizeof *bases->base);
    if (!bases->base) return sph_fail(err, "%s: out of memory for %u bases", scene->path, bases->n);
    for (uint32_t i = 0; i < bases->n; i++)
        bases->base[i] = SPH_NO_BASE;
    return 0;
}

void sph_bases_end(struct sph_texture_bases *bases) {
    free(bases->base);
    bases->base = NULL;
    bases->n = 0;
}

void sph_bases_frame(struct sph_texture_bases *bases, const struct sph_scene *scene,
                     const struct sph_texture_view *view) {
    const struct sph_texture_view *old = &bases->view;
    int same = old->distance == view->distance && old->pixels == view->pixels &&
               old->step == view->step && old->literal == view->literal;
    for (uint32_t i = 0; i < bases->n; i++) {
        uint32_t motion = i < scene->n_spheres ? scene->spheres[i].motion
                                               : scene->facets[i - scene->n_spheres].motion;
        if (motion || !same) bases->base[i] = SPH_NO_BASE;
    }
    bases->view = *view;
    bases->computed = bases->kept = 0;
    memset(&bases->flops, 0, sizeof bases->flops);
}

int sph_bases_of(struct sph_texture_bases *bases, uint32_t id,
                 const struct sph_texture_shape *shape, double texels) {
    if (id < bases->n && bases->base[id] != SPH_NO_BASE) {
        bases->kept++;
        return bases->base[id];
    }
    struct sph_texture_area area = sph_texture_area_of(shape, texels, &bases->flops);
    int base = sph_texture_base(&area, &bases->view, &bases->flops);
    bases->computed++;
    if (id < bases->n) bases->base[id] = base;
    return base;
}
