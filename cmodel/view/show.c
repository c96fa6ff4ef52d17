/* show.c - pictures on the screen; see live.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "view/camera.h"
#include "view/live.h"

#define FIRST 0.016 /* s that a job gets before its first picture */
#define NEXT 0.1    /* between pictures that get finer */

static void put_title(struct view *v, int passes) {
    char text[640], how[128], words[256], price[64] = "";
    view_state_words(&v->state.build, words, sizeof words);
    if (passes < VIEW_PASSES)
        snprintf(how, sizeof how, "every %d pixels", passes ? VIEW_COARSEST >> (passes - 1) : 0);
    else
        snprintf(how, sizeof how, v->exact ? "as the hardware draws it" : "turned rays");
    if (v->state.price && view_stands(v, v->price))
        snprintf(price, sizeof price, " - %.1f dB, %.2f cycles a pixel", v->price->price.psnr,
                 v->price->price.cycles);
    else if (v->state.price)
        snprintf(price, sizeof price, " - to be measured");
    snprintf(text, sizeof text, "%s - %s - %s - %s%s%s", v->scene.name,
             view_layer_names[v->state.layer], words, how,
             view_maker_busy(v->builder) ? ", building" : "", price);
    v->calls->title(v->screen, text);
}

void view_show(struct view *v, double now) {
    const struct view_state *s = &v->state;
    int passes = v->job_camera ? view_workers_passes(v->workers) : 0;
    int whole = passes == VIEW_PASSES;
    int due = v->redraw || (passes && !v->shown && (whole || now - v->started >= FIRST)) ||
              (v->shown && passes > v->shown && (whole || now - v->last >= NEXT));
    if (!due) return;
    struct view_paint how = {
        .layer = s->layer, .distance = view_distance(&v->state.home), .srgb = v->srgb};
    if (v->truth && v->truth->camera_changes == v->job_camera &&
        v->truth->build_changes == v->job_build)
        how.truth = v->truth->truth;
    size_t n = (size_t)s->width * (size_t)s->height;
    if (v->job_camera)
        view_workers_paint(v->workers, &how, v->keep_under ? v->under : NULL, v->picture);
    memcpy(v->over, v->picture, n * sizeof *v->over);
    view_rays_draw(&v->rays, &v->seen, s->width, s->height, v->over);
    v->calls->show(v->screen, v->over);
    put_title(v, passes);
    v->redraw = 0;
    if (passes) v->shown = passes;
    v->last = view_now();
    view_meter_shown(&v->meter, v->last, v->shown ? v->job_camera : 0);
    if (v->record && view_record_add(v->record, v->over, v->last, v->err)) v->failed = 1;
}

void view_click(struct view *v) {
    int x = v->state.x, y = v->state.y;
    struct sph_ray_log log;
    struct sph_pixel pixel;
    view_rays_free(&v->rays);
    v->redraw = 1;
    if (!v->job_camera) return;
    double far = view_distance(&v->state.home);
    if (!view_pick(&v->job, x, y, far, &pixel, &log, &v->rays)) {
        printf("pixel    %d,%d: id %" PRIu32 ", key %" PRIu64 ", %" PRIu32 " visits\n", x, y,
               pixel.id, pixel.key, pixel.visits);
        v->o->print_rays(stdout, &log);
        fflush(stdout);
    }
    sph_ray_log_free(&log);
}
