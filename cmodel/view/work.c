/* work.c - which machine is built and what is drawn with it; see live.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
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

int view_stands(const struct view *v, const struct view_made *made) {
    return made && made->camera_changes == v->state.camera_changes &&
           made->build_changes == v->state.build_changes;
}

/* Takes what a maker beside the picture has made; asks it for more if that is wanted and the
 * picture is drawn. 1 if there is something new. */
static int work_beside(struct view *v, struct view_maker *maker, struct view_made **kept,
                       uint64_t *bad, int wanted) {
    const struct view_state *s = &v->state;
    struct view_made *made = view_maker_take(maker);
    int taken = made && !made->failed;
    if (made && made->failed) {
        fprintf(stderr, "sphaera: %s\n", made->err.text);
        *bad = made->camera_changes;
        view_made_free(made);
    } else if (made) {
        view_made_free(*kept);
        *kept = made;
        v->redraw = 1;
    }
    if (!wanted || view_stands(v, *kept) || *bad == s->camera_changes || !v->exact ||
        v->shown < VIEW_PASSES || view_maker_busy(maker))
        return taken;
    struct view_made want = {.camera = s->camera,
                             .build = s->build,
                             .camera_changes = s->camera_changes,
                             .build_changes = s->build_changes};
    want.build.width = s->width, want.build.height = s->height;
    view_maker_ask(maker, &want);
    return taken;
}

int view_refined(const struct view *v) {
    return v->job_camera == v->state.camera_changes && v->job_build == v->state.build_changes &&
           v->exact && v->shown == VIEW_PASSES && !v->redraw &&
           (v->state.layer != VIEW_DIFFERENCE || view_stands(v, v->truth)) &&
           (!v->state.price || view_stands(v, v->price));
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
    work_beside(v, v->truths, &v->truth, &v->bad_truth, v->state.layer == VIEW_DIFFERENCE);
    if (work_beside(v, v->prices, &v->price, &v->bad_price, v->state.price)) {
        const struct view_price *p = &v->price->price;
        printf("price    %s: %.2f dB, %" PRIu64 " wrong, %.2f cycles a pixel, most for %s\n",
               sph_build_profile(&v->price->build)->name, p->psnr, p->wrong, p->cycles, p->limit);
        fflush(stdout);
    }
}
