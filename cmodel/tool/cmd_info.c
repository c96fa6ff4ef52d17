/* cmd_info.c - `sphaera info`: what a file holds, and what became of each of its records
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/file.h"
#include "common/kind.h"
#include "builder/warn.h"
#include "image/image.h"
#include "image/texture.h"
#include "image/mips.h"
#include "validate/describe.h"
#include "common/number.h"
#include "tool/pixel_rays.h"
#include "tool/print.h"
#include "tool/report.h"
#include "tool/tool.h"
#include "validate/validate.h"

struct arguments {
    const char *input, *json;
    int pixel[2]; /* x, y; -1: none asked for */
    int stages, strict, allow_paths;
    struct tool_outputs outputs;
};

enum { KEY_JSON = 512, KEY_PIXEL, KEY_STAGES, KEY_STRICT, KEY_ALLOW };

static const struct argp_option options[] = {
    {"pixel", KEY_PIXEL, "X,Y", 0, "the rays of this pixel as a tree, with what each finds", 0},
    {"stages", KEY_STAGES, NULL, 0,
     "... and each stage of each of these rays, with its numbers bit for bit", 0},
    {"strict", KEY_STRICT, NULL, 0, "what is not used as it stands is an error", 0},
    {"allow-paths", KEY_ALLOW, NULL, 0,
     "files that a scene names may lie anywhere, not only in its folder and below", 0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    const char *at = arg;
    uint64_t x = 0, y = 0;
    switch (key) {
    case KEY_JSON:
        a->json = tool_output(&a->outputs, key, arg);
        return 0;
    case KEY_PIXEL:
        if (sph_take_count(&at, 0, SPH_MAX_SIDE - 1, &x) || sph_take_char(&at, ',') ||
            sph_parse_count(at, 0, SPH_MAX_SIDE - 1, &y))
            argp_error(state, "--pixel: '%s' is no pixel such as 21,9", arg);
        a->pixel[0] = (int)x, a->pixel[1] = (int)y;
        return 0;
    case KEY_STRICT:
        a->strict = 1;
        return 0;
    case KEY_ALLOW:
        a->allow_paths = 1;
        return 0;
    case KEY_STAGES:
        a->stages = 1;
        return 0;
    case ARGP_KEY_ARG:
        if (a->input) argp_error(state, "one file at a time: '%s' is one too many", arg);
        a->input = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->input) argp_error(state, "no file given");
        if (a->stages && a->pixel[0] < 0) argp_error(state, "--stages wants --pixel X,Y");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* Reads what is no machine; the ledger of its records. */
static int read_other(const struct arguments *a, enum sph_file_kind kind, struct sph_ledger *ledger,
                      struct sph_error *err) {
    if (kind == SPH_FILE_IMAGE) {
        struct sph_mip mip = {0};
        struct sph_image picture = {0}; /* of one that is too large to be a texture */
        struct sph_error why = {""};
        if (sph_mip_load(a->input, SPH_COLOURS_OF_FILE, &mip, &why) &&
            sph_image_read(a->input, &picture, NULL))
            return sph_fail(err, "%s", why.text);
        sph_image_free(&picture);
        sph_mip_free(&mip);
        return sph_ledger_note(ledger, mip.decoded ? SPH_READ_SRGB : SPH_READ_IMAGE, a->input, 0,
                               err);
    }
    struct sph_scene scene;
    const struct sph_read_options how = {.strict = a->strict, .allow_paths = a->allow_paths};
    if (sph_scene_read(a->input, &how, &scene, err)) return -1;
    struct sph_mip *mips = NULL;
    *ledger = scene.ledger;
    int rc =
        sph_mips_load(&scene, &mips, err) || sph_note_images(&scene, mips, ledger, err) ? -1 : 0;
    sph_mips_free(mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc;
}

/* `info` of what is no machine. */
static int describe_other(const struct arguments *a) {
    struct sph_ledger ledger = {0};
    struct sph_error err = {""};
    const char *looks;
    char path[SPH_SCENE_FILE];
    sph_scene_section(a->input, path);
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, &err);
    if (!file) return tool_failed(&err);
    fclose(file);
    enum sph_file_kind kind = sph_file_kind(path, &looks);
    if (a->pixel[0] >= 0) {
        sph_fail(&err, "%s: is %s: --pixel is for machine files; `sphaera build` makes one",
                 a->input, looks);
        return tool_failed(&err);
    }
    if (read_other(a, kind, &ledger, &err)) return tool_failed(&err);
    FILE *to = print_stream(a->json);
    if (to) {
        fprintf(to, "%s: %s\n", a->input, looks);
        sph_ledger_print(&ledger, SPH_USED, "", to);
    }
    json_t *report = report_new("info");
    report_text(report, "input", a->input);
    report_text(report, "looks", looks);
    report_ledger(report, &ledger);
    return report_write(report, a->json, &err) ? tool_failed(&err) : TOOL_GOOD;
}

int tool_info(int argc, char **argv) {
    static const struct argp argp = {options,
                                     parse,
                                     "FILE",
                                     "Checks a machine file and describes it; of a scene, molecule "
                                     "or image, what became of each "
                                     "of its records.",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.pixel = {-1, -1}};
    struct sph_machine machine;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_spares(&a.outputs, a.input, &err)) return tool_failed(&err);
    if (!tool_is_machine(a.input)) return describe_other(&a);
    if (sph_machine_read(a.input, &machine, &err)) return tool_failed(&err);
    struct sph_ray_log log = {0};
    struct sph_stages stages = {0};
    const int32_t *size = machine.regs + SPH_REG_FRAME_W; /* and height behind it */
    if (a.pixel[0] >= size[0] || a.pixel[1] >= size[1])
        sph_fail(&err, "--pixel: %d,%d lies outside of the frame, %dx%d", a.pixel[0], a.pixel[1],
                 size[0], size[1]);
    else if (a.pixel[0] >= 0)
        pixel_rays(&machine, a.pixel[0], a.pixel[1], &log, a.stages ? &stages : NULL, &err);
    if (err.text[0]) {
        sph_machine_free(&machine);
        sph_ray_log_free(&log);
        sph_stages_free(&stages);
        return tool_failed(&err);
    }
    FILE *to = print_stream(a.json);
    struct sph_ledger ledger = {0};
    sph_machine_note(&machine, a.input, &ledger);
    if (to) {
        sph_machine_describe(&machine, to);
        sph_ledger_print(&ledger, SPH_USED, "", to);
    }
    struct sph_bih_stats stats;
    if (sph_machine_bih(&machine))
        sph_bih_measure(&machine, &stats), print_bih(to, &machine, &stats);
    if (a.pixel[0] >= 0) print_rays(to, &log);
    print_stages(to, &machine, &stages);
    json_t *report = report_new("info");
    report_text(report, "input", a.input);
    report_machine(report, &machine);
    report_ledger(report, &ledger);
    if (sph_machine_bih(&machine)) report_bih(report, &machine, &stats);
    if (a.pixel[0] >= 0) report_rays(report, &log);
    if (a.stages) report_stages(report, &machine, &stages);
    sph_stages_free(&stages);
    sph_ray_log_free(&log);
    int rc = report_write(report, a.json, &err);
    sph_machine_free(&machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
