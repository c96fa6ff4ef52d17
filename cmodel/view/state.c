/* state.c - see state.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/state.h"

#include <math.h>
#include <stdio.h>

#include "view/camera.h"

enum { CLICK = 3 }; /* pixels that a button may move and still be a click */
static const double half_turn = 3.14159265358979323846;
static const char *const backgrounds[] = {"none", "rect", "spans", "exact"};

void view_state_start(struct view_state *s, const struct sph_camera *camera,
                      const struct sph_build_options *build) {
    *s = (struct view_state){.home = *camera, .camera = *camera, .build = *build};
    s->width = build->width ? build->width : camera->width;
    s->height = build->height ? build->height : camera->height;
    s->layer = SPH_FRAMES - 1;
    s->camera_changes = s->build_changes = 1;
    for (int i = 0; i < VIEW_ONCE; i++)
        s->since[i] = -1;
}

/* A key's motion for so many seconds: half the scene's own distance a second, or a radian. */
static void move(struct view_state *s, int does, double seconds) {
    double far = view_distance(&s->home) / 2 * seconds, wider = exp2(seconds);
    switch (does) {
    case VIEW_DO_FORWARD:
    case VIEW_DO_BACK:
        view_walk(&s->camera, 0, 0, does == VIEW_DO_FORWARD ? far : -far);
        break;
    case VIEW_DO_LEFT:
    case VIEW_DO_RIGHT:
        view_walk(&s->camera, does == VIEW_DO_RIGHT ? far : -far, 0, 0);
        break;
    case VIEW_DO_UP:
    case VIEW_DO_DOWN:
        view_walk(&s->camera, 0, does == VIEW_DO_UP ? far : -far, 0);
        break;
    case VIEW_DO_LOOK_LEFT:
    case VIEW_DO_LOOK_RIGHT:
        view_look(&s->camera, does == VIEW_DO_LOOK_RIGHT ? seconds : -seconds, 0);
        break;
    case VIEW_DO_LOOK_UP:
    case VIEW_DO_LOOK_DOWN:
        view_look(&s->camera, 0, does == VIEW_DO_LOOK_UP ? seconds : -seconds);
        break;
    default:
        view_angle(&s->camera, does == VIEW_DO_WIDER ? wider : 1 / wider);
        break;
    }
    s->camera_changes++;
}

int view_state_hold(struct view_state *s, double now) {
    int any = 0;
    for (int i = 0; i < VIEW_ONCE; i++) {
        double from = fmax(s->since[i] + VIEW_HOLD, s->moved);
        if (s->since[i] < 0) continue;
        any = 1;
        if (now > from) move(s, i, now - from);
    }
    s->moved = now;
    return any;
}

/* The next profile; after widths of the user's own the first. */
static void next_profile(struct sph_build_options *build) {
    int is = build->widths ? sph_profile_find(build->widths->name) : build->profile;
    build->profile = (is + 1) % SPH_PROFILES;
    build->widths = NULL;
}

/* What is not a motion. */
static void act(struct view_state *s, int does) {
    struct sph_build_options *b = &s->build;
    switch (does) {
    case VIEW_DO_TREE:
        b->tree = b->tree < SPH_TREE_LAST ? b->tree + 1 : SPH_TREE_PAPER;
        break;
    case VIEW_DO_BACKGROUND:
        b->background = b->background < SPH_BG_EXACT ? b->background + 1 : SPH_BG_NONE;
        break;
    case VIEW_DO_DEPTH:
        b->max_depth = b->max_depth < SPH_MAX_DEPTH ? b->max_depth + 1 : 0;
        break;
    case VIEW_DO_PROFILE:
        next_profile(b);
        break;
    case VIEW_DO_HOME:
        s->camera = s->home;
        s->head[0] = s->head[1] = 0;
        s->camera_changes++;
        break;
    case VIEW_DO_HEAD:
        s->headed = !s->headed;
        if (!s->headed) view_head(&s->camera, s->head, 0, 0);
        s->camera_changes += !s->headed;
        break;
    case VIEW_DO_PRICE:
        s->price = !s->price;
        break;
    case VIEW_DO_CAMERA:
        s->print = 1;
        break;
    case VIEW_DO_CLEAR:
        s->clear = 1;
        break;
    case VIEW_DO_HELP:
        s->help = 1;
        break;
    case VIEW_DO_QUIT:
        s->quit = 1;
        break;
    default:
        if (does < VIEW_DO_NOTHING) s->layer = does - VIEW_DO_LAYER;
        break;
    }
    s->build_changes += does >= VIEW_DO_TREE && does <= VIEW_DO_PROFILE;
}

static int key(struct view_state *s, const struct view_event *event, double now) {
    int does = view_key_does(event->key), down = event->kind == VIEW_KEY_DOWN;
    if (does < VIEW_ONCE) {
        if (down && s->since[does] < 0) move(s, does, VIEW_TAP);
        s->since[does] = down ? now : -1;
        return down;
    }
    if (down) act(s, does);
    return down && does != VIEW_DO_NOTHING;
}

/* The mouse is at x, y: what it drags follows it. */
static int drag(struct view_state *s, double x, double y) {
    double right = (x - s->at[0]) / s->height, down = (y - s->at[1]) / s->height;
    s->at[0] = x, s->at[1] = y;
    if (!s->button && s->headed) {
        view_head(&s->camera, s->head, (x - s->width / 2.0) / s->height,
                  (s->height / 2.0 - y) / s->height);
        s->camera_changes++;
        return 1;
    }
    if (!s->button) return 0;
    s->dragged |= hypot(x - s->from[0], y - s->from[1]) > CLICK;
    if (!s->dragged) return 0;
    if (s->button == VIEW_BUTTON_LEFT)
        view_orbit(&s->camera, -right * half_turn, down * half_turn);
    else
        view_pan(&s->camera, right, down);
    s->camera_changes++;
    return 1;
}

static int press(struct view_state *s, const struct view_event *event) {
    if (event->kind == VIEW_BUTTON_DOWN) {
        if (s->button) return 0; /* one after the other */
        s->button = event->button;
        s->dragged = 0;
        s->at[0] = s->from[0] = event->x, s->at[1] = s->from[1] = event->y;
        return 0;
    }
    if (event->button != s->button) return 0;
    int moved = drag(s, event->x, event->y);
    s->button = 0;
    s->x = (int)event->x, s->y = (int)event->y;
    s->clicked = event->button == VIEW_BUTTON_LEFT && !s->dragged && s->x >= 0 && s->y >= 0 &&
                 s->x < s->width && s->y < s->height;
    return moved || s->clicked;
}

int view_state_input(struct view_state *s, const struct view_event *event, double now) {
    switch (event->kind) {
    case VIEW_KEY_DOWN:
    case VIEW_KEY_UP:
        return key(s, event, now);
    case VIEW_BUTTON_DOWN:
    case VIEW_BUTTON_UP:
        return press(s, event);
    case VIEW_MOVE:
        return drag(s, event->x, event->y);
    case VIEW_WHEEL:
        view_near(&s->camera, pow(0.9, event->y));
        break;
    case VIEW_FINGER:
        view_pan(&s->camera, event->x * s->width / s->height, event->y);
        break;
    case VIEW_PINCH:
        view_walk(&s->camera, 0, 0, event->y * view_distance(&s->home));
        break;
    case VIEW_CLOSED:
        s->quit = 1;
        return 0;
    default:
        return 0;
    }
    s->camera_changes++;
    return 1;
}

void view_state_words(const struct sph_build_options *b, char *text, size_t size) {
    snprintf(text, size, "%s, background %s, depth %d, %s",
             b->tree == SPH_TREE_AUTO ? "auto" : sph_tree_name(b->tree), backgrounds[b->background],
             b->max_depth, sph_build_profile(b)->name);
}
