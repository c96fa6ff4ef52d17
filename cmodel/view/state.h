/* state.h - what the user of the live view has set, and what inputs make of it
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_STATE_H
#define SPH_VIEW_STATE_H

#include "builder/build.h"
#include "view/keys.h"
#include "view/screen.h"

/* Of a second and more a key is held before it goes on, and what a touch of it is worth. */
#define VIEW_HOLD 0.15
#define VIEW_TAP 0.1

struct view_state {
    struct sph_camera home;         /* of the scene */
    struct sph_camera camera;       /* now */
    struct sph_build_options build; /* what the machine is asked to be */
    int width, height;
    int layer;      /* VIEW_* of keys.h */
    int price;      /* 1: frames at rest are measured */
    int headed;     /* 1: the eye is in front of the mouse */
    double head[2]; /* where it is then, in heights of the screen from where it was */
    uint64_t camera_changes, build_changes; /* counted */
    int quit, help, print, clear, clicked;  /* asked for; whoever does it sets it back */
    int x, y;                               /* pixel that was clicked */
    int button, dragged;                    /* VIEW_BUTTON_* that is down, 0: none; it moved */
    double at[2], from[2];                  /* of the mouse: now, where the button went down */
    double since[VIEW_ONCE];                /* when a key went down; below 0: it is up */
    double moved; /* until when keys that are down have moved the camera */
};

/* Starts with a scene's camera and what it is to be built like. */
void view_state_start(struct view_state *s, const struct sph_camera *camera,
                      const struct sph_build_options *build);

/* Takes an input at a time in seconds. Returns 1 if the picture may change by it. */
int view_state_input(struct view_state *s, const struct view_event *event, double now);

/* Moves the camera for keys that are down; 1 if there is one. */
int view_state_hold(struct view_state *s, double now);

/* tree, background, depth and profile in words. */
void view_state_words(const struct sph_build_options *build, char *text, size_t size);

#endif
