/* read.c - a scene file or text of a scene, by its kind; see scene.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdint.h>
#include <string.h>

#include "common/file.h"
#include "scene/aff.h"
#include "scene/import.h"
#include "scene/nff_reader.h"

int sph_scene_read(const char *path, const struct sph_read_options *options,
                   struct sph_scene *scene, struct sph_error *err) {
    const char *looks;
    memset(scene, 0, sizeof *scene);
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file) return -1;
    enum sph_file_kind kind = sph_aff_is(path) ? SPH_FILE_AFF : sph_file_kind(path, &looks);
    if (options && options->camera && !sph_importable(kind)) {
        fclose(file);
        return sph_fail(err, "%s: --camera %.80s: only glTF has cameras to choose from", path,
                        options->camera);
    }
    if (kind == SPH_FILE_NFF) return sph_nff_read(file, path, options, scene, err);
    fclose(file);
    if (kind == SPH_FILE_AFF) return sph_aff_read(path, options, scene, err);
    if (sph_importable(kind)) {
        struct sph_import_options o = {0};
        if (options)
            o = (struct sph_import_options){.strict = options->strict,
                                            .skip = options->skip_unsupported,
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
    return sph_nff_read(file, path, options, scene, err);
}
