/* options_scene.c - the options of every command that draws or builds a scene
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "scene/frustum.h"
#include "scene/motion.h"
#include "scene/window.h"
#include "common/number.h"
#include "tool/tool.h"

enum {
    KEY_SIZE = 640,
    KEY_DEPTH,
    KEY_LEAST,
    KEY_AT,
    KEY_SKIP,
    KEY_ROUND,
    KEY_TIME,
    KEY_STRICT,
    KEY_SHIFT,
    KEY_EYE,
    KEY_WALL,
    KEY_CAMERA,
    KEY_RADIUS,
    KEY_UP,
    KEY_ALLOW
};

static const struct argp_option options[] = {
    {"size", KEY_SIZE, "WxH", 0, "frame in pixels; as the scene says if not given", 1},
    {"shift", KEY_SHIFT, "X,Y", 0,
     "the picture's middle lies so many of its heights to the right of the view and above it; as "
     "the scene says if not given",
     1},
    {"eye-shift", KEY_EYE, "X,Y[,Z]", 0,
     "the eye moves to the right, up and back by units of the scene, before a screen that stays: "
     "the one through `at`",
     1},
    {"wall", KEY_WALL, "NxM:X,Y", 0,
     "the frame is number X,Y, from 0,0 at the top left, of N x M of its size that lie side by "
     "side and show together what the camera sees",
     1},
    {"depth", KEY_DEPTH, "N", 0, "reflections and refractions one after another, 0 to 10 (2)", 1},
    {"least-weight", KEY_LEAST, "S", 0,
     "a mirrored or refracted ray of less than this share of its pixel, 0 (default) to 1 in steps "
     "of 1/256, is not followed: each changes a channel by less than that share of 255",
     1},
    {"at", KEY_AT, "N", 0, "frame that moving primitives are moved to, 0 (default) to 65535", 1},
    {"time", KEY_TIME, "T", 0, "of AFF: the scene at this time of its own, not at a frame", 1},
    {"skip-unsupported", KEY_SKIP, NULL, 0,
     "leave out what is neither sphere, polygon, cone nor plane (patches), and materials and "
     "images "
     "of a mesh that are not there, instead of refusing the scene",
     1},
    {"camera", KEY_CAMERA, "NAME|N", 0, "of glTF: the camera of that name or number (the first)",
     1},
    {"radius", KEY_RADIUS, "R", 0,
     "of points without one (tables 1; meshes without faces: by their number)", 1},
    {"up", KEY_UP, "x|y|z", 0, "of meshes without a camera: the axis that is up (y, of STL z)", 1},
    {"allow-paths", KEY_ALLOW, NULL, 0,
     "files that the scene names may lie anywhere, not only in its folder and below", 1},
    {"strict", KEY_STRICT, NULL, 0,
     "whatever of the scene is not used as it stands is an error, which names file and line", 1},
    {"round", KEY_ROUND, "E", 0,
     "cones and cylinders become triangles: no point of these is farther off than this part of the "
     "larger radius, 1e-6 to 0.5 (0.005)",
     1},
    {0},
};

/* NxM:X,Y */
static struct sph_wall parse_wall(const struct argp_state *state, const char *arg) {
    const char *at = arg;
    uint64_t n[4];
    if (sph_take_count(&at, 1, SPH_MAX_SIDE, &n[0]) || sph_take_char(&at, 'x') ||
        sph_take_count(&at, 1, SPH_MAX_SIDE, &n[1]) || sph_take_char(&at, ':') ||
        sph_take_count(&at, 0, n[0] - 1, &n[2]) || sph_take_char(&at, ',') ||
        sph_parse_count(at, 0, n[1] - 1, &n[3]))
        argp_error(state, "--wall: '%s' is no place in a wall such as 3x2:0,1", arg);
    return (struct sph_wall){(int)n[0], (int)n[1], (int)n[2], (int)n[3]};
}

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct tool_source *s = state->input;
    switch (key) {
    case KEY_SIZE:
        tool_size(state, "--size", arg, &s->build.width, &s->build.height);
        break;
    case KEY_SHIFT:
        s->aim.shifted = 1;
        tool_reals(state, "--shift", arg, SPH_SHIFT_MAX, 2, 2, s->aim.shift);
        break;
    case KEY_EYE:
        tool_reals(state, "--eye-shift", arg, SPH_NUMBER_MAX, 2, 3, s->aim.eye);
        break;
    case KEY_WALL:
        s->aim.wall = parse_wall(state, arg);
        break;
    case KEY_DEPTH:
        s->build.max_depth = (int)tool_number(state, "--depth", arg, 0, SPH_MAX_DEPTH);
        break;
    case KEY_LEAST:
        s->build.least_weight =
            (int)(SPH_LEAST_WEIGHT_MAX * tool_real(state, "--least-weight", arg, 0, 1));
        break;
    case KEY_AT:
        s->read.at = (uint32_t)tool_number(state, "--at", arg, 0, SPH_MAX_FRAME);
        break;
    case KEY_TIME:
        s->read.time = tool_real(state, "--time", arg, -1e9, 1e9);
        s->read.timed = 1;
        break;
    case KEY_ROUND:
        s->read.round =
            tool_real(state, "--round", arg, SPH_FRUSTUM_ROUND_MIN, SPH_FRUSTUM_ROUND_MAX);
        break;
    case KEY_STRICT:
        s->read.strict = 1;
        break;
    case KEY_ALLOW:
        s->read.allow_paths = 1;
        break;
    case KEY_CAMERA:
        s->read.camera = arg;
        break;
    case KEY_RADIUS:
        s->read.radius = tool_real(state, "--radius", arg, 1e-9, 1e9);
        break;
    case KEY_UP:
        if (strlen(arg) != 1 || !strchr("xyz", *arg))
            argp_error(state, "--up: '%s' is none of x, y, z", arg);
        s->read.up = *arg;
        break;
    case KEY_SKIP:
        s->read.skip_unsupported = 1;
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    for (int i = 0; options[i].key; i++)
        if (options[i].key == key) s->option = options[i].name;
    return 0;
}

const struct argp tool_scene_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};
