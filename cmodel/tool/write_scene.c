/* write_scene.c - see tool.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <string.h>

#include "common/output.h"
#include "tool/tool.h"

int tool_write_scene(const char *output, struct sph_scene *scene, struct sph_error *err) {
    struct sph_output out;
    const char *path = output ? output : "-";
    int rc = sph_output_open(&out, path, err);
    if (!rc) {
        int failed = sph_scene_write(scene, out.file, err);
        rc = sph_output_close(&out, failed, err);
    }
    if (!rc && strcmp(path, "-")) {
        printf("%s: %u spheres, ", path, scene->n_spheres);
        if (scene->n_facets) printf("%u facets, ", scene->n_facets);
        printf("%d lights, %u materials\n", scene->n_lights, scene->n_materials);
    }
    sph_scene_free(scene);
    return rc;
}
