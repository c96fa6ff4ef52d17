/* cmd_view.c - `sphaera view`: the golden model in a window
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/mips.h"
#include "tool/pixel_rays.h"
#include "tool/tool.h"
#include "view/keys.h"
#include "view/view.h"

struct arguments {
    struct tool_source source;
    const char *input, *script, *record;
    int threads, keys;
};

enum { KEY_SCRIPT = 512, KEY_RECORD, KEY_KEYS };

static const struct argp_option options[] = {
    {"script", KEY_SCRIPT, "FILE", 0, "inputs from a file, with its end the view ends", 0},
    {"record", KEY_RECORD, "FILE", 0,
     "what is seen as a video, by ffmpeg; without it, or for FILE.png, as pictures FILE-0000.png",
     0},
    {"keys", KEY_KEYS, NULL, 0, "print what keys and mouse do, and end", 0},
    {"threads", 't', "N", 0, "0: one for every processor (default)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case KEY_SCRIPT:
        a->script = arg;
        return 0;
    case KEY_RECORD:
        a->record = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_KEYS:
        a->keys = 1;
        return 0;
    case 't':
        a->threads = (int)tool_number(state, "--threads", arg, 0, 1024);
        return 0;
    case ARGP_KEY_END:
        if (a->source.samples > 1) argp_error(state, "--samples is not for the live view");
        return 0;
    default:
        if (key == ARGP_KEY_NO_ARGS && a->keys) return 0;
        return tool_one_scene(state, key, arg, &a->input, "no scene given");
    }
}

/* Chooses what the scene leaves open, and goes. *left: as view_run(). */
static int view(const struct arguments *a, const struct sph_scene *scene, int *left,
                struct sph_error *err) {
    struct view_options o = {.scene = scene,
                             .build = a->source.build,
                             .threads = a->threads,
                             .script = a->script,
                             .record = a->record,
                             .print_rays = print_rays};
    struct sph_profile_choice choice;
    struct sph_mip *mips = NULL;
    if (o.build.texture != SPH_OFF && sph_mips_load(scene, &mips, err)) return -1;
    o.build.mips = mips;
    int rc = tool_profile(&a->source, scene, &o.build, &choice, err);
    if (!rc) rc = view_run(&o, left, err);
    if (!*left) sph_mips_free(mips, scene->n_textures);
    return rc;
}

int tool_view(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "Shows the golden model's picture in a window, in which one moves through the scene.\v"
        "Coarse pictures come first. While the camera moves, rays are turned in the machine that "
        "is there; when it stands, the machine for it is built and gives the picture that `sphaera "
        "render` writes. A profile `auto` is chosen once, for the camera of the scene. --keys "
        "lists keys, mouse and fingers. The window needs SDL2.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default};
    struct sph_scene scene;
    struct sph_error err = {""};
    int left = 0;
    tool_parse(&argp, argc, argv, 0, &a);

    if (a.keys) {
        view_keys_print(stdout);
        return TOOL_GOOD;
    }
    if (tool_wants_scene(a.input, &err) || tool_scene_read(a.input, &a.source, &scene, &err))
        return tool_failed(&err);
    int rc = view(&a, &scene, &left, &err);
    if (!left) sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
