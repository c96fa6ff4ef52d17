/* at.c - a scene at another frame; see motion.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "scene/motion.h"

int sph_scene_at(const struct sph_scene *rest, uint32_t frame, struct sph_scene *moved_scene,
                 struct sph_error *err) {
    struct sph_scene *m = moved_scene;
    if (rest->aff) {
        struct sph_read_options options = rest->read;
        options.at = frame;
        return sph_scene_read(rest->path, &options, m, err);
    }
    size_t spheres = rest->n_spheres * sizeof *m->spheres;
    size_t facets = rest->n_facets * sizeof *m->facets;
    *m = *rest;
    m->spheres = calloc((size_t)rest->n_spheres + 1, sizeof *m->spheres);
    m->facets = calloc((size_t)rest->n_facets + 1, sizeof *m->facets);
    if (!m->spheres || !m->facets) {
        sph_scene_at_free(m);
        return sph_fail(err, "%s: no memory for frame %u", rest->path, frame);
    }
    if (spheres) memcpy(m->spheres, rest->spheres, spheres);
    if (facets) memcpy(m->facets, rest->facets, facets);
    int rc = sph_scene_move(m, frame, err);
    if (rc) sph_scene_at_free(m);
    return rc;
}

void sph_scene_at_free(struct sph_scene *m) {
    if (m->aff) {
        sph_scene_free(m);
        return;
    }
    free(m->spheres);
    free(m->facets);
    m->spheres = NULL;
    m->facets = NULL;
}
