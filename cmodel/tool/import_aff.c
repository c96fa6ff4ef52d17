/* import_aff.c - see import_aff.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/import_aff.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Gives the images whole paths, since the scene is written into any folder: for the writer it has
 * none itself, so that none is left away from theirs. */
static int find_images(struct sph_scene *scene, struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_textures; i++) {
        struct sph_texture *t = &scene->textures[i];
        char *all = realpath(t->path, NULL);
        size_t length = all ? strlen(all) : 0;
        int bad = !all || length >= sizeof t->path;
        if (!bad) memcpy(t->path, all, length + 1);
        free(all);
        if (bad)
            return sph_fail(err, "%s:%u: %s: %s", scene->path, t->line, t->path,
                            length ? "the path is too long" : "cannot find this image");
    }
    return 0;
}

static int import_one(const char *path, const struct tool_import_aff *how,
                      const struct tool_outputs *outputs, uint32_t frame, const char *output,
                      struct sph_error *err) {
    struct sph_read_options read = how->read;
    struct sph_scene scene;
    read.at = frame;
    if (tool_spares(outputs, path, err) || sph_scene_read(path, &read, &scene, err)) return -1;
    if (how->width) scene.camera.width = how->width, scene.camera.height = how->height;
    if (find_images(&scene, err) || tool_spares_images(outputs, &scene, err)) {
        sph_scene_free(&scene);
        return -1;
    }
    if (scene.n_skipped)
        fprintf(stderr, "sphaera: warning: %s: %u unsupported primitives left out\n", path,
                scene.n_skipped);
    const char *slash = strrchr(scene.path, '/');
    if (slash) memmove(scene.path, slash + 1, strlen(slash));
    return tool_write_scene(output, &scene, err);
}

int tool_import_aff(const char *path, const struct tool_import_aff *how, struct sph_error *err) {
    if (!how->frames.on) return import_one(path, how, how->outputs, how->read.at, how->output, err);
    if (!how->output || !strcmp(how->output, "-"))
        return sph_fail(err, "%s: --frames needs --output", path);
    for (uint32_t frame = how->frames.first; frame <= how->frames.last; frame++) {
        char *name = tool_numbered(how->output, frame);
        struct tool_outputs one = {{name}, 1, {0}};
        if (!name) return sph_fail(err, "no memory for the name of a file");
        int bad = import_one(path, how, &one, frame, name, err);
        free(name);
        if (bad) return -1;
    }
    return 0;
}
