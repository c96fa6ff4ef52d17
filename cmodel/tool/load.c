/* load.c - a machine from a machine file or a scene file
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "common/file.h"
#include "image/mips.h"
#include "scene/aff.h"
#include "scene/generate.h"
#include "scene/window.h"
#include "tool/tool.h"
#include "trial/choose.h"
#include "trial/met.h"
#include "validate/validate.h"

int tool_is_machine(const char *path) {
    size_t length = strlen(path);
    if (length > 4 && !strcasecmp(path + length - 4, ".sph")) return 1;
    return sph_input_starts(path, "SPHAERA", 7);
}

int tool_wants_scene(const char *path, struct sph_error *err) {
    if (!tool_is_machine(path)) return 0;
    return sph_fail(err, "%s: is a machine file, a scene is needed", path);
}

int tool_wants_machine(const char *path, struct sph_error *err) {
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file) return -1;
    fclose(file);
    if (tool_is_machine(path)) return 0;
    return sph_fail(err, "%s: is no machine file; `sphaera build` makes one of a scene", path);
}

int tool_scene_read(const char *path, const struct tool_source *source, struct sph_scene *scene,
                    struct sph_error *err) {
    if (source->read.timed && !sph_aff_is(path))
        return sph_fail(err, "%s: --time is for AFF scenes; frames of others are --at", path);
    if (tool_spares(&source->outputs, path, err) || sph_scene_find(path, &source->read, scene, err))
        return -1;
    int still = !scene->aff && !scene->n_motions && !scene->n_flights && source->read.at;
    if (!still && !tool_spares_images(&source->outputs, scene, err) &&
        !sph_camera_aim(&source->aim, &scene->camera, scene->path, err))
        return 0;
    sph_scene_free(scene);
    return still ? sph_fail(err, "%s: --at %u: nothing in the scene moves", path, source->read.at)
                 : -1;
}

int tool_frame_size(const struct tool_source *source, const struct sph_scene *scene,
                    struct sph_build_options *build, struct sph_error *err) {
    int width = build->width ? build->width : scene->camera.width;
    int height = build->height ? build->height : scene->camera.height, n = source->samples;
    if (n == 1) return 0;
    if (width > SPH_MAX_SIDE / n || height > SPH_MAX_SIDE / n)
        return sph_fail(err, "%s: %d x %d samples of %dx%d pixels: sides of a frame are 1..%d",
                        scene->path, n, n, width, height, SPH_MAX_SIDE);
    build->width = n * width;
    build->height = n * height;
    return 0;
}

int tool_profile(const struct tool_source *source, const struct sph_scene *scene,
                 struct sph_build_options *build, struct sph_profile_choice *choice,
                 struct sph_error *err) {
    *choice = (struct sph_profile_choice){.taken = SPH_PROFILES};
    return source->profile_auto ? sph_choose(scene, build, &source->bound, choice, err) : 0;
}

int tool_build_scene(const struct tool_source *source, const struct sph_scene *scene,
                     const struct sph_mip *mips, struct tool_built *built, struct sph_error *err) {
    struct sph_build_options o = source->build;
    struct sph_profile_choice choice;
    struct sph_build_report *report = &built->report;
    built->from_scene = 1;
    o.mips = mips;
    if (tool_frame_size(source, scene, &o, err)) return -1;
    char tree_why[SPH_TREE_WHY];
    if (sph_measure_trees(scene, &o, tree_why, sizeof tree_why, err)) return -1;
    int (*build)(const struct sph_scene *, struct sph_build_options *, int,
                 const struct sph_error_bound *, struct sph_profile_choice *, struct sph_machine *,
                 struct sph_build_report *, struct sph_error *) =
        source->effects == TOOL_EFFECTS_MET ? sph_build_met : sph_build_kept;
    if (build(scene, &o, source->profile_auto, &source->bound, &choice, &built->machine, report,
              err))
        return -1;
    if (tree_why[0]) memcpy(report->tree_why, tree_why, sizeof tree_why);
    built->picture = choice.of[choice.taken];
    if (source->profile_auto)
        sph_choose_why(&choice, &source->bound, built->profile_why, sizeof built->profile_why);
    return 0;
}

int tool_load(const char *path, const struct tool_source *source, struct tool_built *built,
              struct sph_error *err) {
    memset(built, 0, sizeof *built);
    if (tool_is_machine(path)) {
        if (source->option)
            return sph_fail(err, "%s: --%s is for scenes, this is a machine file", path,
                            source->option);
        if (tool_spares(&source->outputs, path, err) ||
            sph_machine_read(path, &built->machine, err))
            return -1;
        const int32_t *r = built->machine.regs;
        int width = r[SPH_REG_FRAME_W], height = r[SPH_REG_FRAME_H], n = source->samples;
        if (width % n == 0 && height % n == 0) return 0;
        sph_machine_free(&built->machine);
        return sph_fail(err, "%s: a frame of %dx%d has no whole pixels of %d x %d samples", path,
                        width, height, n, n);
    }
    if (source->refit) return sph_fail(err, "%s: --refit is for several frames: --frames", path);
    struct sph_scene scene;
    if (tool_scene_read(path, source, &scene, err)) return -1;
    struct sph_mip *mips = NULL;
    int rc = source->build.texture == SPH_OFF ? 0 : sph_mips_load(&scene, &mips, err);
    if (!rc) rc = tool_build_scene(source, &scene, mips, built, err);
    sph_mips_free(mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc;
}

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
        uint32_t facets, cones;
        sph_scene_count(scene, &facets, &cones);
        if (facets) printf("%u facets, ", facets);
        if (cones) printf("%u cones, ", cones);
        printf("%d lights, %u materials\n", scene->n_lights, scene->n_materials);
    }
    sph_scene_free(scene);
    return rc;
}
