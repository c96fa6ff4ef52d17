/* options_accel.c - options of build: what rays go through
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "tool/tool.h"

enum { KEY_ACCEL = 384, KEY_MAX_PRIMS, KEY_MAX_TREE_DEPTH, KEY_BIH, KEY_BIH_FIT, KEY_AXES };

static const struct argp_option options[] = {
    {"accel", KEY_ACCEL, "NAME", 0,
     "bvh4 (spheres around four children), box4 (boxes around them), bih (bounding interval "
     "hierarchy), brute (every primitive), or auto (default: box4 if there are triangles, and at "
     "least as many as spheres, else bvh4)",
     1},
    {"axes", KEY_AXES, "NAME", 0,
     "of the grid: camera, scene, or auto (default: scene if boxes are much smaller along its "
     "axes, "
     "with box4 and bih and without --background)",
     1},
    {"max-prims", KEY_MAX_PRIMS, "N", 0,
     "bih: a leaf of no more primitives is not cut (4); or infinity", 1},
    {"max-tree-depth", KEY_MAX_TREE_DEPTH, "N", 0,
     "bih: levels, the root's is 1; infinity (default) means 65, as the stack has it", 1},
    {"bih", KEY_BIH, "HOW", 0,
     "bih: full (default: with the one-child nodes and empty leaves that the thesis counts), or as "
     "its listing says",
     1},
    {"bih-fit", KEY_BIH_FIT, "F", 0,
     "bih: a node whose box is more than F times as long as what is in it says so, 1 to 100 (1.3); "
     "or infinity: none does",
     1},
    {0},
};

/* A number, or 0 for infinity. */
static uint32_t number(const struct argp_state *state, const char *option, const char *arg,
                       uint32_t max) {
    return strcmp(arg, "infinity") ? (uint32_t)tool_number(state, option, arg, 1, max) : 0;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
    static const char *const accels[] = {"auto", "bvh4", "bih", "brute", "box4", NULL};
    static const char *const ways[] = {"full", "listing", NULL};
    static const char *const axes[] = {"auto", "camera", "scene", NULL};
    struct tool_source *s = state->input;
    switch (key) {
    case KEY_ACCEL:
        s->accel = tool_choice(state, "--accel", arg, accels);
        break;
    case KEY_AXES:
        s->build.axes = SPH_AXES_AUTO + tool_choice(state, "--axes", arg, axes);
        break;
    case KEY_MAX_PRIMS:
        s->build.max_prims = number(state, "--max-prims", arg, SPH_ID_NONE);
        if (!s->build.max_prims) s->build.max_prims = UINT32_MAX;
        s->bih_option = "max-prims";
        break;
    case KEY_MAX_TREE_DEPTH:
        s->build.max_tree_depth = number(state, "--max-tree-depth", arg, SPH_BIH_STACK + 1);
        s->bih_option = "max-tree-depth";
        break;
    case KEY_BIH:
        s->build.bih = SPH_BIH_FULL + tool_choice(state, "--bih", arg, ways);
        s->bih_option = "bih";
        break;
    case KEY_BIH_FIT:
        s->build.bih_fit = !strcmp(arg, "infinity")
                               ? UINT32_MAX
                               : (uint32_t)lround(100 * tool_real(state, "--bih-fit", arg, 1, 100));
        s->bih_option = "bih-fit";
        break;
    case ARGP_KEY_END:
        if (s->bih_option && s->accel != TOOL_BIH)
            argp_error(state, "--%s is for --accel bih, this is %s", s->bih_option,
                       accels[s->accel]);
        if (s->tree_given && s->accel == TOOL_AUTO) s->accel = TOOL_BVH4;
        if (s->tree_given && s->accel != TOOL_BVH4)
            argp_error(state, "--tree is for --accel bvh4, this is %s", accels[s->accel]);
        if (s->accel == TOOL_AUTO) s->build.tree = SPH_TREE_AUTO;
        if (s->accel == TOOL_BIH) s->build.tree = SPH_TREE_BIH;
        if (s->accel == TOOL_BOX4) s->build.tree = SPH_TREE_BOX4;
        if (s->accel == TOOL_BRUTE) s->build.tree = SPH_TREE_BRUTE;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    for (int i = 0; options[i].key; i++)
        if (options[i].key == key) s->option = options[i].name;
    return 0;
}

const struct argp tool_accel_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};
