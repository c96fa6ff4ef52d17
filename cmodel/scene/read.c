/* read.c - a scene file or text of a scene, by its kind; see scene.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include "common/packed.h"
#include "scene/aff.h"
#include "scene/import.h"
#include "scene/nff_reader.h"

const char *sph_scene_section(const char *path, char file[SPH_SCENE_FILE]) {
    const char *colon = strrchr(path, ':');
    snprintf(file, SPH_SCENE_FILE, "%s", path);
    if (!colon || colon - path >= SPH_SCENE_FILE || !access(path, F_OK)) return NULL;
    file[colon - path] = 0;
    if (!access(file, F_OK)) return colon + 1;
    file[colon - path] = ':';
    return NULL;
}

int sph_scene_read(const char *text, const struct sph_read_options *options,
                   struct sph_scene *scene, struct sph_error *err) {
    char path[SPH_SCENE_FILE];
    const char *looks, *section = sph_scene_section(text, path);
    memset(scene, 0, sizeof *scene);
    FILE *file = sph_input_text(path, err);
    if (!file) return -1;
    enum sph_file_kind kind = sph_aff_is(path) ? SPH_FILE_AFF : sph_file_kind(path, &looks);
    if (options && options->camera && !sph_importable(kind)) {
        fclose(file);
        return sph_fail(err, "%s: --camera %.80s: only glTF has cameras to choose from", path,
                        options->camera);
    }
    if (kind == SPH_FILE_NFF) return sph_nff_read(file, path, section, options, scene, err);
    fclose(file);
    if (section)
        return sph_fail(err, "%s: only NFF files have several scenes; there is no `%.100s`", path,
                        section);
    if (kind == SPH_FILE_AFF) return sph_aff_read(path, options, scene, err);
    if (sph_importable(kind)) {
        struct sph_import_options o = {0};
        if (options)
            o = (struct sph_import_options){.strict = options->strict,
                                            .skip = options->skip_unsupported,
                                            .allow_paths = options->allow_paths,
                                            .camera = options->camera,
                                            .radius = options->radius,
                                            .up = options->up};
        return sph_import(path, kind, &o, scene, err);
    }
    return sph_fail(err, "%s: is %s, no scene", path, looks);
}

int sph_scene_parse(const char *text, size_t length, const char *path,
                    const struct sph_read_options *options, struct sph_scene *scene,
                    struct sph_error *err) {
    memset(scene, 0, sizeof *scene);
    if (!length) return sph_fail(err, "%s: the text is empty", path);
    /* read only: "r" never writes to the text */
    FILE *file = fmemopen((void *)(uintptr_t)text, length, "r");
    if (!file) return sph_fail(err, "%s: no memory to read %zu bytes", path, length);
    return sph_nff_read(file, path, NULL, options, scene, err);
}
