/* load.c - a machine from a machine file or a scene file
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "common/input.h"
#include "tool/textures.h"
#include "tool/tool.h"

int tool_is_machine(const char *path) {
    size_t length = strlen(path);
    if (length > 4 && !strcmp(path + length - 4, ".sph")) return 1;
    return sph_input_starts(path, "SPHAERA", 7);
}

int tool_scene_read(const char *path, const struct tool_source *source, struct sph_scene *scene,
                    struct sph_error *err) {
    if (tool_spares(&source->outputs, path, err) || sph_scene_read(path, &source->read, scene, err))
        return -1;
    if (!tool_spares_images(&source->outputs, scene, err)) return 0;
    sph_scene_free(scene);
    return -1;
}

int tool_load(const char *path, const struct tool_source *source, struct tool_built *built,
              struct sph_error *err) {
    memset(built, 0, sizeof *built);
    if (tool_is_machine(path)) {
        if (source->option)
            return sph_fail(err, "%s: --%s is for scenes, this is a machine file", path,
                            source->option);
        if (tool_spares(&source->outputs, path, err)) return -1;
        return sph_machine_read(path, &built->machine, err);
    }
    struct sph_scene scene;
    if (tool_scene_read(path, source, &scene, err)) return -1;
    built->from_scene = 1;
    built->skipped = scene.n_skipped;
    struct sph_build_options options = source->build;
    struct sph_mip *mips = NULL;
    int rc = options.texture == SPH_OFF ? 0 : tool_mips_load(&scene, &mips, err);
    options.mips = mips;
    if (!rc) rc = sph_build(&scene, &options, &built->machine, &built->report, err);
    tool_mips_free(mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc;
}
