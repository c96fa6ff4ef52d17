/* cmd_gen.c - `sphaera gen` and `sphaera import`: scenes by formula, of molecules, of AFF
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "common/file.h"
#include "scene/generate.h"
#include "scene/aff.h"
#include "scene/frustum.h"
#include "scene/motion.h"
#include "scene/import.h"
#include "tool/print.h"
#include "tool/sequence.h"

struct arguments {
    const char *what, *output;
    char kind[32]; /* of KIND:N */
    struct sph_generate_options generate;
    struct sph_import_options import;
    struct tool_import_aff aff;
    const char *import_option, *aff_option; /* the last one that is for such files alone */
    const char *scenario_option;            /* the last one that is for scenarios alone */
    struct tool_outputs outputs;
};

enum {
    KEY_SIZE = 512,
    KEY_SEED,
    KEY_WATER,
    KEY_RESOLUTION,
    KEY_ELEMENTS,
    KEY_RADIUS,
    KEY_PLAIN,
    KEY_DRIFT,
    KEY_ORBIT,
    KEY_AT,
    KEY_TIME,
    KEY_FRAMES,
    KEY_SKIP,
    KEY_ROUND,
    KEY_STRICT,
    KEY_ALLOW,
    KEY_STYLE,
    KEY_COLOR,
    KEY_CAMERA,
    KEY_UP
};

static const struct argp_option gen_options[] = {
    {"output", 'o', "FILE.nff", 0, "scene to write (default: standard output)", 0},
    {"size", KEY_SIZE, "N", 0,
     "sphereflake: levels, icosphere: cuts, jacks and so on: how many, 1 to 5 (2)", 0},
    {"spheres", 'n', "N", 0, "random, swarm, scenarios: number of spheres (1000, 4096, 64)", 0},
    {"radius", KEY_RADIUS, "R", 0, "scenarios: of every sphere (1)", 0},
    {"plain", KEY_PLAIN, NULL, 0,
     "scenarios: materials without highlights, ambient share and Whitted's sum", 0},
    {"seed", KEY_SEED, "N", 0, "another choice of spheres (0)", 0},
    {"drift", KEY_DRIFT, "D", 0,
     "every sphere, polygon and cone moves by D a frame, in a direction of its own", 0},
    {"orbit", KEY_ORBIT, "DEGREES", 0, "the camera goes round what it looks at, so far a frame", 0},
    {"resolution", KEY_RESOLUTION, "WxH", 0, "frame in pixels (320x180, scenarios 640x1088)", 0},
    {0},
};

static const struct argp_option import_options[] = {
    {"output", 'o', "FILE.nff", 0, "scene to write (default: standard output)", 0},
    {"resolution", KEY_RESOLUTION, "WxH", 0, "frame in pixels (320x180; AFF: the scene's)", 0},
    {"allow-paths", KEY_ALLOW, NULL, 0,
     "files that the scene names may lie anywhere, not only in its folder and below", 0},
    {"strict", KEY_STRICT, NULL, 0, "what is not used as it stands is an error", 0},
    {NULL, 0, NULL, 0, "Molecules, points and meshes:", 1},
    {"radius", KEY_RADIUS, "R", 0,
     "of points without one (tables 1; meshes without faces: by their number)", 1},
    {"camera", KEY_CAMERA, "NAME|N", 0, "of glTF: the camera of that name or number (the first)",
     1},
    {"up", KEY_UP, "x|y|z", 0, "of meshes without a camera: the axis that is up (y, of STL z)", 1},
    {"water", KEY_WATER, NULL, 0, "keep water molecules", 1},
    {"style", KEY_STYLE, "STYLE", 0,
     "of atoms: spacefill (default), or ball-and-stick, with a cylinder for every bond", 1},
    {"color", KEY_COLOR, "BY", 0, "of atoms: by element (default), residue or chain", 1},
    {"elements", KEY_ELEMENTS, "FILE", 0, "radii and colours (" SPH_ELEMENTS_PATH ")", 1},
    {"skip-unsupported", KEY_SKIP, NULL, 0,
     "leave out what is not supported, and materials and images of a mesh that are not there", 0},
    {NULL, 0, NULL, 0, "AFF:", 2},
    {"at", KEY_AT, "N", 0, "frame of the animation, 0 (default) to 65535", 2},
    {"time", KEY_TIME, "T", 0, "time of the animation, in its own unit, not a frame", 2},
    {"frames", KEY_FRAMES, "A..B", 0, "these frames; their numbers go before .nff", 2},
    {"round", KEY_ROUND, "E", 0, "of cones, as of build", 2},
    {0},
};

/* A number above 0. */
static double real(const struct argp_state *state, const char *option, const char *arg) {
    double value = 0;
    if (sph_parse_number(arg, &value) || !(value > 0))
        argp_error(state, "%s: '%s' is no number above 0", option, arg);
    return value;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case 'o':
        a->output = tool_output(&a->outputs, key, arg);
        return 0;
    case 'n':
        a->generate.n = (uint32_t)tool_number(state, "--spheres", arg, 1, SPH_MAX_SPHERES);
        return 0;
    case KEY_SIZE:
        a->generate.size = (int)tool_number(state, "--size", arg, 1, 5);
        return 0;
    case KEY_SEED:
        a->generate.seed = tool_number(state, "--seed", arg, 0, UINT64_MAX);
        return 0;
    case KEY_RADIUS:
        a->generate.radius = real(state, "--radius", arg);
        a->scenario_option = "radius";
        return 0;
    case KEY_DRIFT:
        a->generate.drift = real(state, "--drift", arg);
        return 0;
    case KEY_ORBIT:
        a->generate.orbit = tool_real(state, "--orbit", arg, 1e-3, 360);
        return 0;
    case KEY_PLAIN:
        a->generate.plain = 1;
        a->scenario_option = "plain";
        return 0;
    case KEY_WATER:
        a->import.keep_water = 1;
        a->import_option = "water";
        return 0;
    case KEY_ELEMENTS:
        a->import.elements_path = arg;
        a->import_option = "elements";
        return 0;
    case KEY_RESOLUTION:
        tool_size(state, "--resolution", arg, &a->generate.width, &a->generate.height);
        a->import.width = a->generate.width;
        a->import.height = a->generate.height;
        return 0;
    case ARGP_KEY_ARG:
        if (a->what) argp_error(state, "'%s' is one argument too many", arg);
        a->what = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->what) argp_error(state, "nothing given to make a scene of");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* Options of import: those of AFF, and the others. */
static error_t parse_import(int key, char *arg, struct argp_state *state) {
    static const char *const styles[] = {"spacefill", "ball-and-stick", NULL}, *const colours[] = {
                                                                                   "element",
                                                                                   "residue",
                                                                                   "chain", NULL};
    struct arguments *a = state->input;
    switch (key) {
    case KEY_STRICT:
        a->aff.read.strict = a->import.strict = 1;
        return 0;
    case KEY_ALLOW:
        a->aff.read.allow_paths = a->import.allow_paths = 1;
        return 0;
    case KEY_RADIUS:
        a->import.radius = real(state, "--radius", arg);
        a->import_option = "radius";
        return 0;
    case KEY_STYLE:
        a->import.sticks = tool_choice(state, "--style", arg, styles);
        a->import_option = "style";
        return 0;
    case KEY_COLOR:
        a->import.colour = (enum sph_atom_colour)tool_choice(state, "--color", arg, colours);
        a->import_option = "color";
        return 0;
    case KEY_CAMERA:
        a->import.camera = arg;
        a->import_option = "camera";
        return 0;
    case KEY_UP:
        if (strlen(arg) != 1 || !strchr("xyz", *arg))
            argp_error(state, "--up: '%s' is none of x, y, z", arg);
        a->import.up = *arg;
        a->import_option = "up";
        return 0;
    case KEY_AT:
        a->aff.read.at = (uint32_t)tool_number(state, "--at", arg, 0, SPH_MAX_FRAME);
        break;
    case KEY_TIME:
        a->aff.read.time = tool_real(state, "--time", arg, -1e9, 1e9);
        a->aff.read.timed = 1;
        break;
    case KEY_FRAMES:
        tool_frames_parse(state, arg, &a->aff.frames);
        break;
    case KEY_SKIP:
        a->aff.read.skip_unsupported = a->import.skip = 1;
        return 0;
    case KEY_ROUND:
        a->aff.read.round =
            tool_real(state, "--round", arg, SPH_FRUSTUM_ROUND_MIN, SPH_FRUSTUM_ROUND_MAX);
        break;
    default:
        return parse(key, arg, state);
    }
    for (int i = 0; import_options[i].key || import_options[i].doc; i++)
        if (import_options[i].key == key) a->aff_option = import_options[i].name;
    return 0;
}

/* What the kind does not take. Every one takes a seed: those that move do so by it. */
static void check_kind(const struct argp_state *state, const struct arguments *a) {
    int takes = sph_generate_takes(a->what);
    const char *wrong = NULL;
    if (takes == SPH_TAKES_UNKNOWN) return;
    if (a->scenario_option && strncmp(a->what, "scenario", 8) != 0) wrong = a->scenario_option;
    if (a->generate.size && takes != SPH_TAKES_SIZE) wrong = "size";
    if (a->generate.n && takes != SPH_TAKES_N) wrong = "spheres";
    if (wrong) argp_error(state, "--%s is not for %s", wrong, a->what);
}

/* The same with KIND:N, the number that a kind is mostly asked for with. */
static error_t parse_gen(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    struct sph_error err = {""};
    char *colon = key == ARGP_KEY_ARG ? strchr(arg, ':') : NULL;
    if (!colon) {
        error_t rc = parse(key, arg, state);
        if (key == ARGP_KEY_END) check_kind(state, a);
        return rc;
    }
    int made = sph_generate_parse(arg, a->kind, &a->generate, &err);
    if (made <= 0) {
        if (made) argp_error(state, "%s", err.text);
        argp_error(state, "'%s' is no kind of scene that takes a number", arg);
        return EINVAL;
    }
    return parse(key, a->kind, state);
}

/* The kinds of scenes stand in the library; argp's help takes them from here. */
static char *gen_help(int key, const char *text, void *input) {
    (void)input;
    return key == ARGP_KEY_HELP_POST_DOC ? strdup(sph_generate_help) : (char *)text;
}

int tool_gen(int argc, char **argv) {
    static const struct argp argp = {gen_options,
                                     parse_gen,
                                     "KIND[:N]",
                                     "Makes a scene by formula. N: size, spheres or seed, the "
                                     "first that the kind takes.\vKinds:",
                                     NULL,
                                     gen_help,
                                     NULL};
    struct arguments a = {0};
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);
    if (sph_generate(a.what, &a.generate, &scene, &err) || tool_write_scene(a.output, &scene, &err))
        return tool_failed(&err);
    return TOOL_GOOD;
}

int tool_import(int argc, char **argv) {
    static const struct argp argp = {
        import_options,
        parse_import,
        "FILE",
        "Makes a scene of a molecule (PDB, mmCIF, XYZ); of a table of points (CSV: columns x, y, z "
        "and r); of a mesh (OBJ, PLY, STL, glTF, GLB); or of an AFF scene as it stands at a frame "
        "or "
        "a time. Texts but meshes may be packed by gzip.",
        NULL,
        NULL,
        NULL};
    /* sticks are written as cones: what triangles of these are made is asked later */
    struct arguments a = {.import = {.round = SPH_FRUSTUM_ROUND_MAX}};
    struct sph_scene scene;
    struct sph_error err = {""};
    const char *looks;
    tool_parse(&argp, argc, argv, 0, &a);
    int aff = sph_aff_is(a.what);
    const char *wrong = aff ? a.import_option : a.aff_option;
    if (wrong) {
        sph_fail(&err, "%s: --%s is for %s", a.what, wrong,
                 aff ? "molecules, points and meshes" : "AFF scenes");
        return tool_failed(&err);
    }
    if (aff) {
        a.aff.width = a.import.width, a.aff.height = a.import.height;
        a.aff.output = a.output, a.aff.outputs = &a.outputs;
        return tool_import_aff(a.what, &a.aff, &err) ? tool_failed(&err) : TOOL_GOOD;
    }
    const char *elements = a.import.elements_path ? a.import.elements_path : SPH_ELEMENTS_PATH;
    if (tool_spares(&a.outputs, a.what, &err) || tool_spares(&a.outputs, elements, &err))
        return tool_failed(&err);
    FILE *probe = sph_input_open(a.what, SPH_INPUT_ANY, &err);
    if (!probe) return tool_failed(&err);
    fclose(probe);
    enum sph_file_kind kind = sph_file_kind(a.what, &looks);
    if (!sph_importable(kind)) {
        sph_fail(&err, "%s: is %s, no molecule, table of points, mesh or AFF scene%s", a.what,
                 looks, kind == SPH_FILE_NFF ? " (`build` and `render` take NFF)" : "");
        return tool_failed(&err);
    }
    if (sph_import(a.what, kind, &a.import, &scene, &err)) return tool_failed(&err);
    print_ledger(&scene.ledger);
    return tool_write_scene(a.output, &scene, &err) ? tool_failed(&err) : TOOL_GOOD;
}
