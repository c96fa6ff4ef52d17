/* cmd_reference.c - `sphaera reference`: a scene as it is written, in double precision
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "core/frame.h"
#include "image/image.h"
#include "reference/reference.h"
#include "tool/levels.h"
#include "tool/pictures.h"
#include "image/mips.h"
#include "tool/tool.h"

struct arguments {
    struct tool_source source;
    const char *input, *frame;
    struct light_pictures light;
    int levels, threads, unlimited, total;
};

enum { KEY_FRAME = 512, KEY_FILTER, KEY_LEVELS, KEY_UNLIMITED, KEY_TOTAL };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, TOOL_OUTPUT_TEXT, 0},
    {"exr", TOOL_KEY_EXR, "FILE.exr", 0, "picture in linear light with ids, OpenEXR", 0},
    {"transfer", TOOL_KEY_TRANSFER, "NAME", 0,
     "how the bytes of the picture stand for light: srgb (default), as people see it; linear", 0},
    {"frame", KEY_FRAME, "FILE", 0, "frame file: colours and ids; keys, visits, counters are 0", 0},
    {"layer", TOOL_KEY_LAYER, "N", 0,
     "colours of pictures: 0 without reflections, 1 one reflection, 2 all (default)", 0},
    {"filter", KEY_FILTER, "NAME", 0,
     "texels: nearest or bilinear of the whole image, bilinear of one level of its MIP chain "
     "(level), or of two (between, default)",
     0},
    {"levels", KEY_LEVELS, "NAME", 0,
     "how levels of textures are chosen: mended (default, as the machine), paper, bmrt, or by ray "
     "differentials (rays)",
     0},
    {"unlimited", KEY_UNLIMITED, NULL, 0,
     "a surface may be brighter than 1 in a mirror or through glass, as in POV-Ray", 0},
    {"total", KEY_TOTAL, NULL, 0,
     "what is totally reflected keeps all its light, not Kr + T of it, as in POV-Ray", 0},
    {"threads", 't', "N", 0, "0: one for every processor (default)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    if (!light_option(&a->light, &a->source.outputs, key, arg, state)) return 0;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case KEY_FRAME:
        a->frame = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_FILTER:
        a->source.build.tex_filter = tool_choice(state, "--filter", arg, tool_filter_names);
        return 0;
    case KEY_LEVELS:
        a->levels = tool_choice(state, "--levels", arg, tool_level_names);
        return 0;
    case KEY_UNLIMITED:
        a->unlimited = 1;
        return 0;
    case KEY_TOTAL:
        a->total = 1;
        return 0;
    case 't':
        a->threads = (int)tool_number(state, "--threads", arg, 0, 1024);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->input, "no scene given");
    }
}

/* The frame of a reference: colours and ids. */
static int frame_of(const struct sph_reference *r, struct sph_frame *frame) {
    size_t n = (size_t)r->width * (size_t)r->height;
    *frame = (struct sph_frame){r->width, r->height, calloc(n, sizeof *frame->pixels)};
    if (!frame->pixels) return -1;
    for (size_t i = 0; i < n; i++) {
        frame->pixels[i].id = r->pixels[i].id;
        frame->pixels[i].texture = SPH_NO_TEXTURE;
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            frame->pixels[i].colour[layer] = r->pixels[i].colour[layer];
    }
    return 0;
}

static int write(const struct arguments *a, const struct sph_reference *r, struct sph_error *err) {
    struct sph_shot shot = {0};
    if (frame_of(r, &shot.frame)) return sph_fail(err, "%s: no memory for the frame", a->input);
    int rc = light_picture(&a->light, 1, NULL, &shot.frame, NULL, err) ||
             (a->frame && sph_shot_write(&shot, a->frame, err));
    if (!rc)
        fprintf(tool_text(), "picture %016lx\n",
                (unsigned long)sph_frame_picture_hash(&shot.frame));
    sph_frame_free(&shot.frame);
    return rc ? -1 : 0;
}

static int draw(const struct arguments *a, const struct sph_scene *scene, struct sph_error *err) {
    struct sph_mip *mips = NULL;
    struct sph_reference r = {0};
    if (sph_mips_load(scene, &mips, err)) return -1;
    struct sph_reference_options how = {.width = a->source.build.width,
                                        .height = a->source.build.height,
                                        .max_depth = a->source.build.max_depth,
                                        .shadow = 1,
                                        .reflect = 1,
                                        .refract = 1,
                                        .specular = 1,
                                        .unlimited = a->unlimited,
                                        .total = a->total,
                                        .threads = a->threads,
                                        .mips = mips,
                                        .filter = a->source.build.tex_filter,
                                        .lod = a->levels,
                                        .spread = a->source.build.spread != SPH_OFF};
    int rc = sph_reference_render(scene, &how, &r, err) || write(a, &r, err) ? -1 : 0;
    sph_reference_free(&r);
    sph_mips_free(mips, scene->n_textures);
    return rc;
}

int tool_reference(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_scene_argp, 0, "The scene:", 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "Draws a scene as it is written, in double precision.\v"
        "Shading rules are those of the machine, but nothing of it is used: no grid, no tree of "
        "its own, no fixed point. Planes have no end. The hash is that of colours and ids.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default,
                          .light = {.layer = SPH_FRAMES - 1, .transfer = SPH_TRANSFER_SRGB}};
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_wants_scene(a.input, &err) || tool_scene_read(a.input, &a.source, &scene, &err))
        return tool_failed(&err);
    int rc = draw(&a, &scene, &err);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
