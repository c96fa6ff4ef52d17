/* sequence.c - see sequence.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/sequence.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "builder/emit.h"
#include "common/file.h"
#include "image/mips.h"
#include "scene/motion.h"
#include "tool/json.h"
#include "tool/levels.h"
#include "tool/pictures.h"
#include "tool/print.h"
#include "tool/progress.h"
#include "trial/met.h"

void tool_frames_parse(const struct argp_state *state, const char *arg,
                       struct tool_frames *frames) {
    const char *dots = strstr(arg, "..");
    char first[16] = "";
    if (!dots || dots - arg >= (int)sizeof first)
        argp_error(state, "--frames: '%s' is no range of frames such as 0..9", arg);
    memcpy(first, arg, (size_t)(dots - arg));
    frames->first = (uint32_t)tool_number(state, "--frames", first, 0, SPH_MAX_FRAME);
    frames->last = (uint32_t)tool_number(state, "--frames", dots + 2, 0, SPH_MAX_FRAME);
    if (frames->first > frames->last)
        argp_error(state, "--frames: '%s': the first is after the last", arg);
    frames->on = 1;
}

/* path with a word before its ending; malloc, NULL if memory is out. */
static char *tailed(const char *path, const char *word) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    if (!dot || (slash && dot < slash)) dot = path + strlen(path);
    size_t size = strlen(path) + strlen(word) + 2;
    char *name = malloc(size);
    if (name) snprintf(name, size, "%.*s-%s%s", (int)(dot - path), path, word, dot);
    return name;
}

char *tool_numbered(const char *path, uint32_t frame) {
    char number[16];
    snprintf(number, sizeof number, "%04" PRIu32, frame);
    return path ? tailed(path, number) : NULL;
}

/* ---- a pair of eyes ---- */

void tool_stereo_check(const struct argp_state *state, const struct tool_outputs *outputs) {
    for (int i = 0; i < outputs->n; i++)
        if (!strcmp(outputs->path[i], "-"))
            argp_error(state, "--stereo writes two files of each kind, not standard output");
}

int tool_stereo(double apart, struct tool_source *source, const char **names[], int n,
                tool_draw *draw, void *user) {
    static const char *const sides[] = {"left", "right"};
    const struct tool_source both = *source;
    int rc = TOOL_GOOD;
    for (int eye = 0; eye < 2 && rc == TOOL_GOOD; eye++) {
        struct tool_outputs *o = &source->outputs;
        const char *was[TOOL_OUTPUTS];
        char *is[TOOL_OUTPUTS] = {NULL};
        int named = 0;
        for (int i = 0; i < n; i++)
            was[i] = *names[i];
        *source = both;
        source->aim.eye[0] += (eye - 0.5) * apart;
        for (int k = 0; k < o->n && rc == TOOL_GOOD; k++) {
            if (!(is[named] = tailed(o->path[k], sides[eye]))) rc = TOOL_FAILED;
            for (int i = 0; i < n; i++)
                if (*names[i] == o->path[k]) *names[i] = is[named];
            o->path[k] = is[named++];
        }
        if (rc == TOOL_GOOD) rc = draw(user);
        for (int i = 0; i < n; i++)
            *names[i] = was[i];
        while (named)
            free(is[--named]);
    }
    *source = both;
    return rc;
}

void report_bases(json_t *report, const struct sph_build_report *build) {
    json_t *json = report_flops(&build->bases_flops);
    report_count(json, "computed", build->bases_computed);
    report_count(json, "kept", build->bases_kept);
    json_object_set_new(report, "bases", json);
}

/* What a frame costs before it is drawn. */
static void report_time(json_t *report, const struct tool_built *built) {
    const struct sph_build_report *b = &built->report;
    report_number(report, "build_seconds", b->build_seconds);
    report_number(report, "cpu_seconds", b->cpu_seconds);
    report_number(report, "tree_seconds", b->tree_seconds);
    report_add(report, "refitted", json_boolean(b->refitted));
    report_number(report, "tree_cost", b->tree_cost);
    report_count(report, "memory_bytes", (uint64_t)built->machine.lines * SPH_LINE_WORDS * 4);
}

/* What all frames share. */
struct run {
    struct sph_scene rest;
    struct sph_mip *mips;
    struct sph_texture_bases bases;
    struct sph_kept_tree kept;
    struct sph_census met; /* by the rays of all frames */
    struct sph_build_options options;
    const struct sph_aim *aim;
    char profile_why[640]; /* empty if the profile was asked for */
};

/* The scene at a frame, seen as options want it. -1 with nothing to free. */
static int frame_of(const struct run *run, uint32_t frame, struct sph_scene *moved,
                    struct sph_error *err) {
    if (sph_scene_at(&run->rest, frame, moved, err)) return -1;
    if (!sph_camera_aim(run->aim, &moved->camera, moved->path, err)) return 0;
    sph_scene_at_free(moved);
    return -1;
}

static int build_frame(struct run *run, uint32_t frame, struct tool_built *built,
                       struct sph_error *err) {
    struct sph_scene moved;
    memset(built, 0, sizeof *built);
    if (frame_of(run, frame, &moved, err)) return -1;
    built->from_scene = 1;
    int rc = sph_build(&moved, &run->options, &built->machine, &built->report, err);
    if (!rc && run->options.numbers) { /* what it is built for is to find out what is met */
        rc = sph_census_add(&run->met, &moved, &run->options, &built->machine, &built->report, err);
        if (rc) sph_machine_free(&built->machine);
    }
    sph_scene_at_free(&moved);
    return rc;
}

/* Finds out what the rays of all frames do not meet, up to one that cannot be built: those before
 * it are written all the same. */
static int census(struct run *run, const struct tool_frames *frames, struct sph_error *err) {
    const struct sph_build_options options = run->options;
    size_t n = (size_t)run->rest.n_spheres + run->rest.n_facets + 1;
    run->options.numbers = calloc(n, sizeof *run->options.numbers);
    if (!run->options.numbers) return sph_fail(err, "%s: no memory", run->rest.path);
    for (uint32_t frame = frames->first; frame <= frames->last && !run->met.kept; frame++) {
        struct tool_built built;
        if (build_frame(run, frame, &built, err)) break;
        sph_machine_free(&built.machine);
        run->options.later = 1;
    }
    free(run->options.numbers);
    run->options = options;
    if (sph_error_memory(err)) return -1;
    err->text[0] = 0;
    if (run->met.prims) run->options.unmet = sph_census_unmet(&run->met, &run->rest, &run->options);
    return 0;
}

/* The finest of the profiles that the first frame, the last and one between ask for: one core draws
 * them all. */
static int choose(struct run *run, const struct tool_source *source,
                  const struct tool_frames *frames, struct sph_error *err) {
    const uint32_t at[] = {frames->first, frames->first + (frames->last - frames->first) / 2,
                           frames->last};
    enum { FRAMES = sizeof at / sizeof *at };
    int most = -1;
    for (int i = 0; i < FRAMES && source->profile_auto; i++) {
        struct sph_scene moved;
        struct sph_profile_choice choice;
        if (i && at[i] == at[i - 1]) continue;
        if (frame_of(run, at[i], &moved, NULL)) continue; /* told when it is built */
        int rc = tool_profile(source, &moved, &run->options, &choice, err);
        sph_scene_at_free(&moved);
        if (rc) return rc;
        if (choice.taken <= most) continue;
        most = choice.taken;
        sph_choose_why(&choice, &source->bound, run->profile_why, sizeof run->profile_why);
        sph_note(run->profile_why, sizeof run->profile_why,
                 "; so frame %" PRIu32 ", which asks for most of %" PRIu32 ", %" PRIu32
                 " and %" PRIu32,
                 at[i], at[0], at[1], at[2]);
    }
    if (most >= 0) run->options.profile = most;
    return 0;
}

/* No numbered output may be the scene's file or an image of it. */
static int spares(const char *path, const struct sph_scene *scene, const struct tool_source *source,
                  const struct tool_frames *frames, struct sph_error *err) {
    int rc = 0;
    for (int i = 0; i < source->outputs.n; i++)
        for (uint32_t frame = frames->first; !rc && frame <= frames->last; frame++) {
            char *name = tool_numbered(source->outputs.path[i], frame);
            struct tool_outputs one = {{name}, 1, {0}};
            if (!name) return sph_fail(err, "no memory for the name of a file");
            rc = tool_spares(&one, path, err) ? -1 : tool_spares_images(&one, scene, err);
            free(name);
        }
    return rc;
}

int tool_each_frame(const char *path, const struct tool_source *source,
                    const struct tool_frames *frames, FILE *to, json_t *list, tool_take *take,
                    void *user, struct sph_error *err) {
    struct run run = {.options = source->build,
                      .aim = &source->aim,
                      .kept = {.how = source->refit, .loss = source->loss}};
    struct progress line;
    struct sph_progress reading = progress_of(&line, "reading", frames->progress), all, part;
    struct tool_source from = *source;
    if (tool_is_machine(path))
        return sph_fail(err, "%s: --frames is for scenes, this is a machine file", path);
    from.read.progress = &reading;
    from.aim = (struct sph_aim){0}; /* of each frame, where the camera is then */
    int bad = tool_scene_read(path, &from, &run.rest, err);
    progress_end(&line);
    if (bad) return -1;
    all = progress_of(&line, "building", frames->progress);
    run.options.progress = &part;
    if (spares(path, &run.rest, source, frames, err)) return sph_scene_free(&run.rest), -1;
    int rc = run.options.texture == SPH_OFF ? 0 : sph_mips_load(&run.rest, &run.mips, err);
    if (!rc) rc = tool_frame_size(source, &run.rest, &run.options, err);
    run.options.mips = run.mips;
    if (!rc) rc = choose(&run, source, frames, err);
    if (!rc && source->effects == TOOL_EFFECTS_MET) {
        rc = census(&run, frames, err);
        if (!rc && run.options.unmet && run.options.unmet->lights)
            rc = choose(&run, source, frames, err); /* the grid may be finer without them */
    }
    if (!rc) rc = sph_bases_start(&run.bases, &run.rest, err);
    run.options.kept = &run.kept;
    run.options.bases = &run.bases;
    for (uint32_t frame = frames->first; !rc && frame <= frames->last; frame++) {
        struct tool_built built;
        double n = frames->last - frames->first + 1, done = frame - frames->first;
        part = sph_progress_part(&all, done / n, (done + 1) / n);
        rc = build_frame(&run, frame, &built, err);
        progress_end(&line);
        if (rc) break;
        json_t *entry = json_object();
        report_count(entry, "at", frame);
        report_bases(entry, &built.report);
        report_time(entry, &built);
        run.options.later = 1;
        if (run.profile_why[0]) report_text(entry, "profile_why", run.profile_why);
        if (frame == frames->first) {
            if (to && run.profile_why[0]) fprintf(to, "profile  %s\n", run.profile_why);
            print_build(NULL, &built); /* warnings alone */
            if (run.met.kept)
                sph_note(built.report.left_out, sizeof built.report.left_out, "nothing: %s\n",
                         run.met.kept);
            print_left_out(to, &built.report);
        }
        if (to)
            fprintf(to,
                    "frame %-5" PRIu32 " bases %" PRIu64 " made, %" PRIu64
                    " kept; built in %.4f s, "
                    "tree %s, cost %.3f; %u bytes\n",
                    frame, built.report.bases_computed, built.report.bases_kept,
                    built.report.build_seconds, built.report.refitted ? "refitted" : "built",
                    built.report.tree_cost, built.machine.lines * SPH_LINE_WORDS * 4);
        rc = take(user, frame, &built, entry, err);
        json_array_append_new(list, entry);
        sph_machine_free(&built.machine);
    }
    sph_census_free(&run.met);
    sph_bases_end(&run.bases);
    sph_kept_free(&run.kept);
    sph_mips_free(run.mips, run.rest.n_textures);
    sph_scene_free(&run.rest);
    return rc;
}

int tool_movie_of(const char *movie, const char **picture, const char *path,
                  const struct tool_source *source, const struct tool_frames *frames, FILE *to,
                  json_t *list, tool_take *take, void *user, struct sph_error *err) {
    char folder[4096], name[4128];
    uint32_t n = frames->last - frames->first + 1;
    if (snprintf(folder, sizeof folder, "%s.XXXXXX", movie) >= (int)sizeof folder)
        return sph_fail(err, "%s: the name is too long", movie);
    char **shots = calloc(n, sizeof *shots);
    if (!shots) return sph_fail(err, "%s: no memory for %u names", movie, n);
    int rc = movie_check(movie, err), made = !rc && mkdtemp(folder);
    if (!rc && !made) rc = sph_fail(err, "%s: %s", movie, strerror(errno));
    if (made) sph_output_note(folder);
    snprintf(name, sizeof name, "%s/frame.png", folder);
    *picture = name;
    for (uint32_t i = 0; i < n && !rc; i++)
        if (!(shots[i] = tool_numbered(name, frames->first + i)))
            rc = sph_fail(err, "%s: no memory for %u names", movie, n);
    if (!rc) rc = tool_each_frame(path, source, frames, to, list, take, user, err);
    if (!rc) rc = movie_write(movie, (const char *const *)shots, (int)n, MOVIE_RATE, err);
    for (uint32_t i = 0; i < n; i++) {
        if (shots[i]) unlink(shots[i]);
        free(shots[i]);
    }
    if (made) {
        rmdir(folder);
        sph_output_forget(folder);
    }
    free(shots);
    *picture = NULL;
    return rc;
}

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
    print_ledger(&scene.ledger);
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
