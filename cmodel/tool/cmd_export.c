/* cmd_export.c - `sphaera export`: a scene for another renderer, a machine for a core or a host
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "common/file.h"
#include "image/mips.h"
#include "machine/export.h"
#include "scene/pov_write.h"
#include "tool/tool.h"

struct arguments {
    struct tool_source source;
    const char *input, *output, *hex, *c_array;
    char regs[4096], mem[4096]; /* files of --hex */
};

enum { KEY_HEX = 512, KEY_C_ARRAY };

static const struct argp_option options[] = {
    {"output", 'o', "FILE.pov", 0, "scene to write (default: standard output)", 0},
    {"hex", KEY_HEX, "STEM", 0,
     "of a machine file: STEM.regs.hex and STEM.mem.hex, registers and lines of memory for "
     "$readmemh",
     0},
    {"c-array", KEY_C_ARRAY, "FILE.h", 0,
     "of a machine file: both as arrays of C (- : on standard output)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case 'o':
        a->output = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_HEX:
        a->hex = arg;
        snprintf(a->regs, sizeof a->regs, "%.4080s.regs.hex", arg);
        snprintf(a->mem, sizeof a->mem, "%.4080s.mem.hex", arg);
        tool_output(&a->source.outputs, key, a->regs);
        tool_output(&a->source.outputs, -key, a->mem);
        return 0;
    case KEY_C_ARRAY:
        a->c_array = tool_output(&a->source.outputs, key, arg);
        return 0;
    case ARGP_KEY_END:
        if (a->output && (a->hex || a->c_array))
            argp_error(state, "-o is of a scene, --hex and --c-array are of a machine file");
        break;
    default:
        break;
    }
    return tool_one_scene(state, key, arg, &a->input, "no scene given");
}

/* Writes the scene where the user wants it, and says so. */
static int finish(const struct arguments *a, const struct sph_scene *scene, struct sph_error *err) {
    const char *path = a->output ? a->output : "-";
    struct sph_pov_options how = {a->source.build.width, a->source.build.height,
                                  a->source.build.max_depth};
    struct sph_output out;
    if (sph_output_open(&out, path, err)) return -1;
    int failed = sph_scene_write_pov(scene, &how, out.file, err);
    if (sph_output_close(&out, failed, err)) return -1;
    if (strcmp(path, "-"))
        printf("%s: %u spheres, %u facets, %d lights, %u materials\n", path, scene->n_spheres,
               scene->n_facets, scene->n_lights, scene->n_materials);
    return 0;
}

/* Looks into the images how they stand for light, since POV-Ray is told. */
static int name_colours(struct sph_scene *scene, struct sph_error *err) {
    struct sph_mip *mips;
    if (sph_mips_load(scene, &mips, err)) return -1;
    for (uint32_t i = 0; i < scene->n_textures; i++)
        scene->textures[i].colours = mips[i].decoded ? SPH_COLOURS_SRGB : SPH_COLOURS_LINEAR;
    sph_mips_free(mips, scene->n_textures);
    return 0;
}

/* A machine file as text. */
static int export_machine(const struct arguments *a, struct sph_error *err) {
    struct tool_built built;
    if (tool_wants_machine(a->input, err) || tool_load(a->input, &a->source, &built, err))
        return -1;
    int rc = a->hex ? sph_machine_write_hex(&built.machine, a->hex, err) : 0;
    if (!rc && a->c_array) rc = sph_machine_write_c(&built.machine, a->c_array, err);
    sph_machine_free(&built.machine);
    return rc;
}

int tool_export(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_scene_argp, 0, "The scene:", 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE|MACHINE.sph",
        "Writes a scene for POV-Ray 3.7, or a machine file for simulators and C compilers.\v"
        "Lights, surfaces, shadows, mirrors and glass are those of the scene, in linear light; "
        "of images the nearest texel is seen, as with --filter nearest. The first lines of the "
        "file say how it is rendered.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default};
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (a.hex || a.c_array) return export_machine(&a, &err) ? tool_failed(&err) : TOOL_GOOD;
    if (tool_wants_scene(a.input, &err) || tool_scene_read(a.input, &a.source, &scene, &err))
        return tool_failed(&err);
    int rc = name_colours(&scene, &err) || finish(&a, &scene, &err);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
