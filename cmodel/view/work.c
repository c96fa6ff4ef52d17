/* work.c - which machine is built and what is drawn with it; see live.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <string.h>

#include "view/camera.h"
#include "view/live.h"

/* A build that takes no longer is made for every picture; others when the camera stands. */
#define QUICK 0.02
#define PAUSE 0.15

/* Says once why no machine is built, and goes back to what could be. */
static void refuse(struct view *v, const struct view_made *made) {
    struct view_state *s = &v->state;
    if (!v->made) {
        v->failed = sph_fail(v->err, "%s", made->err.text);
        return;
    }
    fprintf(stderr, "sphaera: %s\n", made->err.text);
    if (made->build_changes != v->made->build_changes && made->build_changes == s->build_changes) {
        s->build = v->made->build;
        s->build_changes++;
        v->redraw = 1;
    } else {
        v->bad_camera = made->camera_changes;
    }
}

/* Draws the newest machine's picture of the camera, as the hardware does or by turned rays. */
static void start(struct view *v, double now) {
    const struct view_state *s = &v->state;
    struct view_job job = {.machine = &v->made->machine, .fast = v->made->fast};
    int same = v->job_camera == s->camera_changes;
    int exact = v->made->camera_changes == s->camera_changes;
    if (exact)
        job.aim = view_aim_own(job.machine);
    else if (view_aim_at(job.machine, &s->camera, &job.aim))
        return; /* what is drawn stays until there is a machine */
    v->keep_under = same && v->shown;
    if (v->keep_under)
        memcpy(v->under, v->picture, (size_t)s->width * (size_t)s->height * sizeof *v->under);
    if (view_workers_start(v->workers, &job)) return;
    v->job = job;
    v->exact = exact;
    v->seen = s->camera;
    v->job_camera = s->camera_changes;
    v->job_build = v->made->build_changes;
    v->shown = 0;
    v->started = now;
}

static void take_machine(struct view *v, double now) {
    struct view_made *made = view_maker_take(v->builder);
    if (!made) return;
    if (made->failed) {
        refuse(v, made);
        view_made_free(made);
        return;
    }
    made->before = v->made;
    v->made = made;
    start(v, now);
}

/* Frees machines before the newest that nobody needs any more. */
static void free_machines(struct view *v) {
    for (struct view_made **at = v->made ? &v->made->before : NULL; at && *at;) {
        struct view_made *old = *at;
        if (view_workers_need(v->workers, &old->machine)) {
            at = &old->before;
            continue;
        }
        *at = old->before;
        view_made_free(old);
    }
}

static void ask_machine(struct view *v, double now) {
    const struct view_state *s = &v->state;
    struct view_made want = {.camera = s->camera,
                             .build = s->build,
                             .camera_changes = s->camera_changes,
                             .build_changes = s->build_changes};
    int other = !v->made || v->made->build_changes != s->build_changes;
    struct view_aim aim;
    if (!other &&
        (v->made->camera_changes == s->camera_changes || v->bad_camera == s->camera_changes))
        return;
    if (view_maker_busy(v->builder)) return;
    if (!other && now - v->meter.last_input < PAUSE && v->made->seconds > QUICK &&
        !view_aim_at(&v->made->machine, &s->camera, &aim))
        return;
    view_maker_ask(v->builder, &want);
}

static int truth_known(const struct view *v) {
    return v->truth && v->truth->camera_changes == v->state.camera_changes &&
           v->truth->build_changes == v->state.build_changes;
}

static void work_truth(struct view *v) {
    const struct view_state *s = &v->state;
    struct view_made *made = view_maker_take(v->truths);
    if (made && made->failed) {
        fprintf(stderr, "sphaera: %s\n", made->err.text);
        v->bad_truth = made->camera_changes;
        view_made_free(made);
    } else if (made) {
        view_made_free(v->truth);
        v->truth = made;
        v->redraw = 1;
    }
    if (s->layer != VIEW_DIFFERENCE || truth_known(v) || v->bad_truth == s->camera_changes ||
        !v->exact || v->shown < VIEW_PASSES || view_maker_busy(v->truths))
        return;
    struct view_made want = {.camera = s->camera,
                             .build = s->build,
                             .camera_changes = s->camera_changes,
                             .build_changes = s->build_changes};
    want.build.width = s->width, want.build.height = s->height;
    view_maker_ask(v->truths, &want);
}

int view_refined(const struct view *v) {
    return v->job_camera == v->state.camera_changes && v->job_build == v->state.build_changes &&
           v->exact && v->shown == VIEW_PASSES && !v->redraw &&
           (v->state.layer != VIEW_DIFFERENCE || truth_known(v));
}

void view_work(struct view *v, double now) {
    /* What is begun is shown before anything else is drawn: an input that comes meanwhile waits
     * for one picture, not for ever. */
    if (!v->job_camera || v->shown) {
        take_machine(v, now);
        if (!v->failed && v->made && (!v->job_camera || v->shown) &&
            v->job_camera != v->state.camera_changes)
            start(v, now);
    }
    free_machines(v);
    if (!v->failed) ask_machine(v, now);
    work_truth(v);
}
