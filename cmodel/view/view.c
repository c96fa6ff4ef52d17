/* view.c - see view.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <stdlib.h>

#include "view/live.h"

/* s that the loop waits for an input: while something is drawn, moved or played; else. */
#define BRISK 0.003
#define IDLE 0.02

static void print_camera(const struct sph_camera *c) {
    const struct sph_vec *at[] = {&c->from, &c->at, &c->up};
    static const char *const names[] = {"from", "at", "up"};
    puts("v");
    for (int i = 0; i < 3; i++)
        printf("%s %.17g %.17g %.17g\n", names[i], at[i]->x, at[i]->y, at[i]->z);
    printf("angle %.17g\n", c->angle);
    if (c->shift[0] != 0 || c->shift[1] != 0)
        printf("shift %.17g %.17g\n", c->shift[0], c->shift[1]);
    fflush(stdout);
}

/* What was asked for and is done here. */
static void serve(struct view *v) {
    struct view_state *s = &v->state;
    if (s->help) view_keys_print(stdout);
    if (s->help) fflush(stdout);
    if (s->print) print_camera(&s->camera);
    if (s->clear) view_rays_free(&v->rays);
    if (s->clicked) view_click(v);
    v->redraw |= s->clear;
    s->help = s->print = s->clear = s->clicked = 0;
}

static void take_inputs(struct view *v) {
    struct view_state *s = &v->state;
    struct view_event event;
    int busy = v->o->script || v->shown < VIEW_PASSES || view_state_hold(s, view_now());
    for (double wait = busy ? BRISK : IDLE; v->calls->next(v->screen, wait, &event); wait = 0) {
        int layer = s->layer, price = s->price;
        uint64_t build = s->build_changes;
        int answer = view_state_input(s, &event, view_now());
        if (answer)
            view_meter_input(&v->meter, v->o->script ? v->input : view_now(), s->camera_changes);
        if (s->layer != layer) v->keep_under = 0; /* its colours are of the other layer */
        v->redraw |= s->layer != layer || s->build_changes != build || s->price != price ||
                     event.kind == VIEW_EXPOSED || (answer && s->camera_changes == v->job_camera);
        serve(v);
    }
    if (view_state_hold(s, view_now())) v->meter.last_input = view_now(); /* it still moves */
}

static int make_room(struct view *v) {
    size_t n = (size_t)v->state.width * (size_t)v->state.height;
    v->picture = calloc(n, sizeof *v->picture);
    v->over = calloc(n, sizeof *v->over);
    v->under = calloc(n, sizeof *v->under);
    v->builder = view_maker_new(v->o->scene, view_make_machine);
    v->truths = view_maker_new(v->o->scene, view_make_truth);
    v->prices = view_maker_new(v->o->scene, view_make_price);
    if (!v->picture || !v->over || !v->under || !v->builder || !v->truths || !v->prices)
        return sph_fail(v->err, "no memory for a picture of %dx%d", v->state.width,
                        v->state.height);
    v->workers = view_workers_new(v->state.width, v->state.height, v->o->threads, v->err);
    v->srgb = view_paint_table(v->err);
    return v->workers && v->srgb ? 0 : -1;
}

static int open_all(struct view *v) {
    const struct view_options *o = v->o;
    if (o->script && view_script_read(o->script, &v->script, v->err)) return -1;
    v->calls = view_screen_load(v->err);
    if (!v->calls || make_room(v)) return -1;
    if (o->record) {
        v->record = view_record_open(o->record, v->state.width, v->state.height, v->err);
        if (!v->record) return -1;
    }
    v->screen = v->calls->open(v->state.width, v->state.height, v->err);
    return v->screen ? 0 : -1;
}

static void close_all(struct view *v, int *left) {
    if (v->screen) v->calls->close(v->screen);
    view_workers_free(v->workers);
    *left = view_maker_free(v->builder) | view_maker_free(v->truths) | view_maker_free(v->prices);
    for (struct view_made *made = v->made, *before; made; made = before) {
        before = made->before;
        view_made_free(made);
    }
    view_made_free(v->truth);
    view_made_free(v->price);
    view_rays_free(&v->rays);
    view_script_free(&v->script);
    free(v->srgb);
    free(v->picture);
    free(v->over);
    free(v->under);
}

int view_run(const struct view_options *o, int *left, struct sph_error *err) {
    struct view v = {.o = o, .scene = *o->scene, .err = err};
    view_state_start(&v.state, &o->scene->camera, &o->build);
    int rc = open_all(&v);
    v.due = view_now();
    while (!rc && !v.state.quit && !v.failed) {
        view_play(&v, view_now());
        take_inputs(&v);
        view_work(&v, view_now());
        view_show(&v, view_now());
    }
    if (v.failed) rc = -1;
    if (v.record && view_record_close(v.record, rc, err)) rc = -1;
    close_all(&v, left);
    return rc;
}
