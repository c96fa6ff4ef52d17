/* play.c - a script's inputs at their times; see live.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "core/frame.h"
#include "image/image.h"
#include "view/live.h"

#define PACE 0.016    /* s between inputs, as of a mouse that tells its place 60 times a second */
#define PATIENCE 120. /* s that `wait refined` waits */

static void push(struct view *v, int kind, double x, double y) {
    const struct view_say *say = &v->script.list[v->at];
    struct view_event event = {.kind = kind, .button = say->button, .x = x, .y = y};
    if (say->what == VIEW_SAY_CLICK) event.button = VIEW_BUTTON_LEFT;
    memcpy(event.key, say->text, sizeof event.key - 1);
    v->calls->push(v->screen, &event);
    if (kind == VIEW_MOVE) v->mouse[0] = x, v->mouse[1] = y;
}

/* What the window shows, into a file; of as many pixels as the two arrays. */
static int shoot(struct view *v, const char *path, struct sph_frame *frame, uint32_t *pixels) {
    size_t n = (size_t)frame->width * (size_t)frame->height;
    if (v->calls->read(v->screen, pixels, v->err)) return -1;
    for (size_t i = 0; i < n; i++)
        frame->pixels[i].colour[0] = pixels[i] & 0xffffff;
    return sph_image_write(path, frame, 0, v->err);
}

static int screenshot(struct view *v, const char *path) {
    size_t n = (size_t)v->state.width * (size_t)v->state.height;
    struct sph_frame frame = {v->state.width, v->state.height, calloc(n, sizeof *frame.pixels)};
    uint32_t *pixels = calloc(n, sizeof *pixels);
    int rc = frame.pixels && pixels ? shoot(v, path, &frame, pixels)
                                    : sph_fail(v->err, "%s: no memory for the picture", path);
    free(pixels);
    sph_frame_free(&frame);
    return rc;
}

static int write_scene(struct view *v, const char *path) {
    struct sph_output out;
    v->scene.camera = v->state.camera;
    v->scene.camera.width = v->state.width, v->scene.camera.height = v->state.height;
    if (sph_output_open(&out, path, v->err)) return -1;
    return sph_output_close(&out, sph_scene_write(&v->scene, out.file, v->err), v->err);
}

/* A mouse on its way; 0 when it is there. */
static int glide(struct view *v, const struct view_say *say, double now) {
    double length = say->number[2] / 1000;
    if (v->began <= 0) {
        v->began = v->due;
        memcpy(v->glide, v->mouse, sizeof v->glide);
    }
    double part = length > 0 ? (now - v->began) / length : 1;
    if (part > 1) part = 1;
    push(v, VIEW_MOVE, v->glide[0] + part * (say->number[0] - v->glide[0]),
         v->glide[1] + part * (say->number[1] - v->glide[1]));
    if (part < 1) return 1;
    v->began = 0;
    return 0;
}

/* Waits for a fine picture; 0 when it is there. */
static int refine(struct view *v, const struct view_say *say, double now) {
    int done = view_refined(v), bad = v->bad_camera == v->state.camera_changes;
    if (v->began <= 0) v->began = now;
    if (!done && (bad || now - v->began > PATIENCE))
        v->failed = sph_fail(v->err, "%s:%d: there is no fine picture within %g s", v->o->script,
                             say->line, PATIENCE);
    if (done) v->began = 0;
    return !done;
}

/* Events of an input that is made at once. */
static void input(struct view *v, const struct view_say *say) {
    double x = say->number[0], y = say->number[1];
    switch (say->what) {
    case VIEW_SAY_KEY:
        push(v, VIEW_KEY_DOWN, 0, 0);
        push(v, VIEW_KEY_UP, 0, 0);
        break;
    case VIEW_SAY_DOWN:
    case VIEW_SAY_UP:
        push(v, say->what == VIEW_SAY_DOWN ? VIEW_KEY_DOWN : VIEW_KEY_UP, 0, 0);
        break;
    case VIEW_SAY_PRESS:
    case VIEW_SAY_RELEASE:
        push(v, say->what == VIEW_SAY_PRESS ? VIEW_BUTTON_DOWN : VIEW_BUTTON_UP, v->mouse[0],
             v->mouse[1]);
        break;
    case VIEW_SAY_CLICK:
        push(v, VIEW_MOVE, x, y);
        push(v, VIEW_BUTTON_DOWN, x, y);
        push(v, VIEW_BUTTON_UP, x, y);
        break;
    case VIEW_SAY_WHEEL:
        push(v, VIEW_WHEEL, 0, x);
        break;
    case VIEW_SAY_FINGER:
        push(v, VIEW_FINGER, x, y);
        break;
    default:
        push(v, VIEW_PINCH, 0, x);
        break;
    }
}

/* Does a command; 1 if it is not done with it. */
static int say(struct view *v, double now) {
    const struct view_say *s = &v->script.list[v->at];
    switch (s->what) {
    case VIEW_SAY_MOVE:
        return glide(v, s, now);
    case VIEW_SAY_WAIT:
        v->due += s->number[0] / 1000 - PACE;
        return 0;
    case VIEW_SAY_REFINED:
        return refine(v, s, now);
    case VIEW_SAY_SCREENSHOT:
        v->failed |= screenshot(v, s->text) != 0;
        return 0;
    case VIEW_SAY_SCENE:
        v->failed |= write_scene(v, s->text) != 0;
        return 0;
    case VIEW_SAY_REPORT:
        view_meter_print(&v->meter, stdout);
        return 0;
    case VIEW_SAY_QUIT:
        v->state.quit = 1;
        return 0;
    default:
        input(v, s);
        return 0;
    }
}

void view_play(struct view *v, double now) {
    v->input = now;
    if (!v->o->script || now < v->due) return;
    if (v->at == v->script.n) {
        v->state.quit = 1;
        return;
    }
    v->input = v->due;
    int what = v->script.list[v->at].what, more = say(v, now);
    if (!more) v->at++;
    v->due += PACE;
    if (what >= VIEW_SAY_WAIT && v->due < now) v->due = now; /* these may take their time */
}
