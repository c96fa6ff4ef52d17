/* options.c - the options of build
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "builder/background/background.h"
#include "builder/background/spans.h"
#include "texture/lookup.h"
#include "common/number.h"
#include "tool/tool.h"

enum {
    KEY_PROFILE = 256,
    KEY_TREE,
    KEY_REFIT,
    KEY_BACKGROUND,
    KEY_BG_POINTS,
    KEY_BG_BORDER,
    KEY_BG_LEVELS,
    KEY_TRAVERSE,
    KEY_FILTER,
    KEY_LOD,
    KEY_LOD_BITS,
    KEY_SAMPLES,
    KEY_ERROR,
    KEY_EFFECTS
};

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "From scene to machine:", 1},
    {"profile", KEY_PROFILE, "NAME[:KEY=N,...]", 0,
     "auto (default), the cheapest that keeps --error; draft, standard, fine or reference, each "
     "with widths of its own: w, wd, pr, pq, ng, fw",
     1},
    {"error", KEY_ERROR, "PIXELS[,DB]", 0,
     "how far what the eye sees may be off, at most, and the picture: 0.125,45", 1},
    {"tree", KEY_TREE, "NAME", 0,
     "bvh4: reinserted (default), balanced or paper; paper-grown is that without its rule that no "
     "node is larger than the sphere around all; hw, as hardware builds it, of spheres; hw1, hw2 "
     "with rounds of joining that follow the first",
     1},
    {"refit", KEY_REFIT, "HOW", 0,
     "--frames: every tree is built (off, default), or refitted from that of the frame before "
     "(on); "
     "auto, auto:PERCENT: while it is expected to make at most so many more visits than when it "
     "was "
     "built (10)",
     1},
    {"background", KEY_BACKGROUND, "NAME", 0,
     "pixels not traced: none (default), those outside a rectangle (rect), outside the outline of "
     "the scene (spans), or whose ray misses it (exact)",
     1},
    {"bg-points", KEY_BG_POINTS, "N", 0, "spans: meridians and parallels, 4 to 4096 (16)", 1},
    {"bg-border", KEY_BG_BORDER, "N", 0, "spans: pixels around the outline, 0 to 64 (1)", 1},
    {"bg-levels", KEY_BG_LEVELS, "N", 0,
     "exact: 0 the root sphere (default), 1 its children, 2 theirs", 1},
    {"samples", KEY_SAMPLES, "N", 0,
     "N x N rays a pixel, 1 to 16: the frame is N times as wide and high, and pictures have the "
     "mean "
     "of its light (1)",
     1},
    {"effects", KEY_EFFECTS, "WHICH", 0,
     "those that rays of the frame meet, which is drawn once to find out (met: `build` and `price` "
     "do so "
     "by default), or all that the scene names (all: the other commands)",
     1},
    {"traverse", KEY_TRAVERSE, "HOW", 0,
     "primary rays find the nearest hit (default), or end at the first one, as in the paper", 1},
    {"lod-bits", KEY_LOD_BITS, "N", 0, "bits of the fraction of a level, 0 to 8 (8)", 1},
    {"filter", KEY_FILTER, "NAME", 0,
     "texels: nearest or bilinear of the whole image, bilinear of one level of its MIP chain "
     "(level), or of two (between, default)",
     1},
    {"lod", KEY_LOD, "NAME", 0,
     "how far away a pixel is as large as a texel: mended (default), or as the paper prints it", 1},
    {0},
};

const struct tool_source tool_source_default = {
    .samples = 1,
    .loss = 0.1,
    .profile_auto = 1,
    .bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR},
    .build = SPH_BUILD_DEFAULT,
};

const char *const tool_filter_names[] = {"nearest", "bilinear", "level", "between", NULL};

/* PIXELS or PIXELS,DB */
static void parse_error_bound(const struct argp_state *state, const char *arg,
                              struct sph_error_bound *to) {
    size_t n = strcspn(arg, ",");
    double off = 0, psnr = to->psnr;
    char pixels[32] = "";
    if (n < sizeof pixels) memcpy(pixels, arg, n);
    if (sph_parse_number(pixels, &off) || !(off >= 1e-9 && off <= 1e9) ||
        (arg[n] && (sph_parse_number(arg + n + 1, &psnr) || !(psnr >= 0 && psnr <= 99))))
        argp_error(state,
                   "--error: '%s' is no error such as 0.125 or 0.125,45: pixels from 1e-9 to "
                   "1e9, and dB up to 99",
                   arg);
    *to = (struct sph_error_bound){off, psnr};
}

/* off, on, auto or auto:PERCENT */
static void refit(const struct argp_state *state, const char *arg, struct tool_source *s) {
    static const char *const hows[] = {"off", "on", "auto", NULL};
    int bounded = !strncmp(arg, "auto:", 5);
    s->refit = bounded ? SPH_REFIT_AUTO : tool_choice(state, "--refit", arg, hows);
    if (bounded) s->loss = tool_real(state, "--refit", arg + 5, 0, 1e6) / 100;
}

static const char *const backgrounds[] = {"none", "rect", "spans", "exact", NULL};

/* What is of no use beside the other options that are given. */
static void check(const struct argp_state *state, const struct tool_source *s) {
    const char *why = sph_build_contradiction(&s->build);
    const char *background = backgrounds[s->build.background - SPH_BG_NONE];
    if (why) argp_error(state, "%s", why);
    if (s->every_background) return;
    if (s->spans_option && s->build.background != SPH_BG_SPANS)
        argp_error(state, "--%s is for --background spans, this is %s", s->spans_option,
                   background);
    if (s->levels_given && s->build.background != SPH_BG_EXACT)
        argp_error(state, "--bg-levels is for --background exact, this is %s", background);
}

static error_t parse(int key, char *arg, struct argp_state *state) {
    static const char *const hows[] = {"nearest", "first", NULL};
    struct tool_source *s = state->input;
    struct sph_error err = {{0}};
    static const char *const lods[] = {"mended", "paper", NULL};
    static const char *const whiches[] = {"all", "met", NULL};
    switch (key) {
    case ARGP_KEY_INIT:
        for (int i = 0; i < 3; i++)
            state->child_inputs[i] = s;
        return 0;
    case KEY_PROFILE:
        s->profile_auto = !strcmp(arg, "auto");
        s->build.widths = NULL;
        if (s->profile_auto) break;
        if (sph_profile_parse(arg, &s->profile, &err)) argp_error(state, "--profile: %s", err.text);
        s->build.widths = &s->profile;
        break;
    case KEY_ERROR:
        parse_error_bound(state, arg, &s->bound);
        break;
    case KEY_TREE:
        sph_build_set_tree(&s->build, tool_choice(state, "--tree", arg, sph_build_trees));
        s->tree_given = 1;
        break;
    case KEY_REFIT:
        refit(state, arg, s);
        break;
    case KEY_BACKGROUND:
        s->build.background = SPH_BG_NONE + tool_choice(state, "--background", arg, backgrounds);
        break;
    case KEY_BG_POINTS:
        s->spans_option = "bg-points";
        s->build.bg_points =
            (int)tool_number(state, "--bg-points", arg, SPH_POINTS_MIN, SPH_POINTS_MAX);
        break;
    case KEY_BG_BORDER:
        s->spans_option = "bg-border";
        s->build.bg_border = (int)tool_number(state, "--bg-border", arg, 0, SPH_BORDER_MAX);
        break;
    case KEY_BG_LEVELS:
        s->levels_given = 1;
        s->build.bg_levels = (int)tool_number(state, "--bg-levels", arg, 0, SPH_BG_LEVELS);
        break;
    case KEY_SAMPLES:
        s->samples = (int)tool_number(state, "--samples", arg, 1, TOOL_SAMPLES);
        return 0; /* for machines too */
    case KEY_EFFECTS:
        s->effects = tool_choice(state, "--effects", arg, whiches);
        break;
    case KEY_TRAVERSE:
        s->build.traverse = SPH_BUILD_NEAREST + tool_choice(state, "--traverse", arg, hows);
        break;
    case KEY_FILTER:
        s->build.tex_filter = tool_choice(state, "--filter", arg, tool_filter_names);
        break;
    case KEY_LOD:
        s->build.lod_literal = tool_choice(state, "--lod", arg, lods);
        break;
    case KEY_LOD_BITS:
        s->build.coarse =
            SPH_LOD_BITS - (int)tool_number(state, "--lod-bits", arg, 0, SPH_LOD_BITS);
        break;
    case ARGP_KEY_END:
        check(state, s);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    for (int i = 0; options[i].key || options[i].doc; i++)
        if (options[i].key == key) s->option = options[i].name;
    return 0;
}

static const struct argp_child children[] = {{&tool_scene_argp, 0, NULL, 1},
                                             {&tool_accel_argp, 0, NULL, 1},
                                             {&tool_effects_argp, 0, NULL, 1},
                                             {0}};

const struct argp tool_source_argp = {options, parse, NULL, NULL, children, NULL, NULL};
