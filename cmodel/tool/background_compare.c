/* background_compare.c - see background_compare.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/background_compare.h"

#include <stdlib.h>
#include <string.h>

#include "builder/background/cones.h"
#include "builder/background/outline.h"
#include "builder/background/spans.h"
#include "pixel/background.h"
#include "render/render.h"

const char *const way_names[WAYS] = {"none",          "rect",          "rect literal",
                                     "spans",         "spans 16x16",   "spans 16x16, no border",
                                     "exact level 0", "exact level 1", "exact level 2"};

static size_t pixels(const struct ways *w) {
    return (size_t)w->width * (size_t)w->height;
}

/* What the walk of the hardware does for the pixels of a frame: columns of 8 pixels, row by row.
 * docs/design/overview.md. */
static void count_walk(struct way *way, int mode, int cones, const struct ways *w) {
    uint64_t columns = ((uint64_t)w->width + 7) / 8, rows = (uint64_t)w->height, n = pixels(w);
    if (mode == SPH_BG_RECT) way->compare = 4 * n;
    if (mode == SPH_BG_SPANS) {
        way->compare = 2 * n;
        way->words = columns * ((rows + SPH_LINE_WORDS - 1) / SPH_LINE_WORDS * SPH_LINE_WORDS);
    }
    if (mode == SPH_BG_EXACT) {
        uint64_t spheres = (uint64_t)cones;
        way->add = 4 * spheres * n; /* down to a row's first pixel, or one to the right */
        way->compare = 2 * spheres * n;
        way->words = spheres * SPH_CONE_LINES * SPH_LINE_WORDS;
    }
}

/* Truth: the primary rays of a machine without light or reflections. */
static int find_truth(struct sph_machine *m, struct ways *w, struct sph_error *err) {
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST};
    struct sph_frame frame;
    struct sph_counters counters = {{0}};
    m->regs[SPH_REG_N_LIGHTS] = m->regs[SPH_REG_EFFECTS] = m->regs[SPH_REG_MAX_DEPTH] = 0;
    int bits = sph_render(m, &how, &frame, &counters, err);
    if (bits < 0) return -1;
    w->hit = malloc(pixels(w));
    for (size_t i = 0; w->hit && i < pixels(w); i++) {
        w->hit[i] = frame.pixels[i].id != SPH_ID_NONE;
        w->background += !w->hit[i];
    }
    sph_frame_free(&frame);
    if (!w->hit) return sph_fail(err, "out of memory");
    return bits ? sph_fail(err, "%s: the walk of the tree failed", w->name) : 0;
}

/* What every way shares, from the machine of WAY_NONE. */
static int start(struct sph_machine *m, const struct sph_build_report *report, struct ways *w,
                 struct sph_error *err) {
    const int32_t *r = m->regs;
    w->width = r[SPH_REG_FRAME_W], w->height = r[SPH_REG_FRAME_H];
    memcpy(w->name, m->name, sizeof w->name);
    memcpy(w->eye, r + SPH_REG_EYE_X, sizeof w->eye);
    w->rays = (struct sph_rays){.x0 = r[SPH_REG_DIR_X0],
                                .y0 = r[SPH_REG_DIR_Y0],
                                .z = r[SPH_REG_DIR_Z],
                                .pitch = r[SPH_REG_PITCH]};
    w->ball = report->root;
    w->in_front = r[SPH_REG_N_PRIMS] && sph_in_front(&w->ball, w->eye);
    w->root = calloc(pixels(w), 1);
    if (!w->root) return sph_fail(err, "out of memory");
    struct sph_work work = {0};
    struct sph_cone cone = sph_cone_make(&w->ball, w->eye, &w->rays, &work);
    for (int y = 0; y < w->height && r[SPH_REG_N_PRIMS]; y++) {
        int32_t x0, x1;
        sph_cone_row(&cone, w->width, y, &x0, &x1, &work);
        memset(w->root + (size_t)y * (size_t)w->width + x0, 1, (size_t)(x1 - x0));
    }
    return find_truth(m, w, err);
}

/* Pixels traced, and how they compare with the truth. */
static void judge(struct way *way, const struct ways *w) {
    for (size_t i = 0; i < pixels(w); i++) {
        way->rays += way->traced[i];
        way->found += !way->traced[i] && !w->hit[i];
        way->wrong += !way->traced[i] && w->hit[i];
    }
}

/* Asks the model for every pixel. */
static int trace_all(const struct sph_machine *m, struct way *way, const struct ways *w,
                     struct sph_error *err) {
    way->traced = calloc(pixels(w), 1);
    if (!way->traced) return sph_fail(err, "out of memory");
    uint8_t *traced = way->traced;
    for (int y = 0; y < w->height; y++)
        for (int x = 0; x < w->width; x++)
            *traced++ = !sph_is_background(m, x, y);
    count_walk(way, m->regs[SPH_REG_BG_MODE], m->regs[SPH_REG_BG_COUNT], w);
    judge(way, w);
    return 0;
}

/* One of the machine's ways. */
static int measure_built(const struct sph_scene *scene, struct sph_build_options o, int index,
                         struct ways *w, struct sph_error *err) {
    struct way *way = &w->way[index];
    struct sph_machine m;
    struct sph_build_report report;
    if (index >= WAY_EXACT0) o.bg_levels = index - WAY_EXACT0;
    o.axes = SPH_AXES_CAMERA;
    o.background = index >= WAY_EXACT0  ? SPH_BG_EXACT
                   : index == WAY_SPANS ? SPH_BG_SPANS
                   : index == WAY_RECT  ? SPH_BG_RECT
                                        : SPH_BG_NONE;
    if (sph_build(scene, &o, &m, &report, err)) return -1;
    int rc = index == WAY_NONE ? start(&m, &report, w, err) : 0;
    if (!rc) rc = trace_all(&m, way, w, err);
    memcpy(way->background, report.background, sizeof way->background);
    way->work = report.bg_work;
    way->check = report.bg_check;
    sph_machine_free(&m);
    return rc;
}

static void fill(uint8_t *traced, const struct sph_span *rows, const struct ways *w) {
    for (int y = 0; y < w->height; y++)
        for (int x = 0; x < w->width; x++)
            *traced++ = x >= rows[y].x0 && x < rows[y].x1;
}

/* A method of the paper at its word; for the spans an outline of 16 x 16 points. */
static int measure_literal(int index, struct ways *w, struct sph_span *rows,
                           struct sph_error *err) {
    struct way *way = &w->way[index];
    struct sph_projection p = {&w->ball, w->eye, &w->rays, SPH_POINTS_DEFAULT};
    double point[4][2];
    way->traced = malloc(pixels(w));
    if (!way->traced) return sph_fail(err, "out of memory");
    if (index == WAY_RECT_LITERAL) {
        way->no_answer = !sph_rect_paper(&w->ball, w->eye, &w->rays, w->width, w->height, rows,
                                         point, &way->work);
    } else if (!w->in_front) {
        way->no_answer = 1;
        for (int y = 0; y < w->height; y++)
            rows[y] = (struct sph_span){0, w->width};
    } else if (sph_spans_draw(rows, &p, w->width, w->height, index == WAY_SPANS_LITERAL, &way->work,
                              err)) {
        return -1;
    }
    fill(way->traced, rows, w);
    count_walk(way, index == WAY_RECT_LITERAL ? SPH_BG_RECT : SPH_BG_SPANS, 0, w);
    judge(way, w);
    return 0;
}

/* Outlines of 4 x 4 to 64 x 64 points, with and without a border. */
static int measure_series(struct ways *w, struct sph_span *rows, uint8_t *traced,
                          struct sph_error *err) {
    for (int i = 0; i < SERIES; i++) {
        struct series *s = &w->series[i];
        struct sph_work work;
        uint64_t rays[2] = {0};
        s->points = 4 << i;
        struct sph_projection p = {&w->ball, w->eye, &w->rays, s->points};
        for (int border = 0; border <= 1; border++) {
            if (sph_spans_draw(rows, &p, w->width, w->height, border, &work, err)) return -1;
            fill(traced, rows, w);
            for (size_t at = 0; at < pixels(w); at++) {
                rays[border] += traced[at];
                s->missed[border] += w->root[at] && !traced[at];
                s->wrong[border] += w->hit[at] && !traced[at];
            }
        }
        s->border = rays[1] - rays[0];
    }
    return 0;
}

int ways_measure(const struct sph_scene *scene, const struct sph_build_options *options,
                 struct ways *w, struct sph_error *err) {
    memset(w, 0, sizeof *w);
    int rc = 0;
    for (int i = 0; i < WAYS && !rc; i++)
        if (i != WAY_RECT_LITERAL && i != WAY_SPANS_LITERAL && i != WAY_SPANS_BARE)
            rc = measure_built(scene, *options, i, w, err);
    if (rc) return -1;
    struct sph_span *rows = calloc((size_t)w->height, sizeof *rows);
    uint8_t *traced = malloc(pixels(w));
    rc = rows && traced ? 0 : sph_fail(err, "out of memory");
    if (!rc) rc = measure_literal(WAY_RECT_LITERAL, w, rows, err);
    if (!rc) rc = measure_literal(WAY_SPANS_LITERAL, w, rows, err);
    if (!rc) rc = measure_literal(WAY_SPANS_BARE, w, rows, err);
    if (!rc && w->in_front) rc = measure_series(w, rows, traced, err);
    free(rows);
    free(traced);
    return rc;
}

void ways_free(struct ways *w) {
    for (int i = 0; i < WAYS; i++)
        free(w->way[i].traced);
    free(w->hit);
    free(w->root);
    memset(w, 0, sizeof *w);
}
