/* spans.c - see spans.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/background/spans.h"

#include <stdlib.h>

#include "builder/background/cones.h"

int sph_spans_draw(struct sph_span *rows, const struct sph_projection *p, int width, int height,
                   int border, struct sph_work *work, struct sph_error *err) {
    struct sph_outline o;
    if (sph_outline_start(&o, width, height, border + 1, err)) return -1;
    int result = sph_outline_rows(&o, p, err) || sph_outline_columns(&o, err) ||
                 (border && sph_outline_border(&o, border, err));
    for (int y = 0; y < height && !result; y++)
        rows[y] = sph_outline_row(&o, y);
    *work = o.work;
    free(o.rows);
    return result ? -1 : 0;
}

static int holds(const struct sph_span *span, const struct sph_span *exact) {
    return exact->x1 <= exact->x0 || (span->x0 <= exact->x0 && span->x1 >= exact->x1);
}

static void widen(struct sph_span *span, const struct sph_span *exact) {
    if (holds(span, exact)) return;
    int empty = span->x1 <= span->x0;
    if (empty || exact->x0 < span->x0) span->x0 = exact->x0;
    if (empty || exact->x1 > span->x1) span->x1 = exact->x1;
}

/* Doubles the points until no row leaves out a pixel of `exact`. */
static int cover(struct sph_spans *spans, struct sph_projection *p, const struct sph_span *exact,
                 int width, int height, int border, struct sph_error *err) {
    for (;; p->n *= 2) {
        struct sph_work work;
        if (sph_spans_draw(spans->rows, p, width, height, border, &work, err)) return -1;
        sph_work_add(&spans->work, &work);
        spans->points = p->n;
        int y = 0;
        while (y < height && holds(&spans->rows[y], &exact[y]))
            y++;
        spans->check.compare += 2 * (unsigned)y;
        if (y == height) return 0;
        if (2 * p->n > SPH_POINTS_MAX) break;
    }
    spans->how = SPH_SPANS_WIDENED;
    for (int y = 0; y < height; y++)
        widen(&spans->rows[y], &exact[y]);
    return 0;
}

int sph_spans_make(struct sph_spans *spans, const struct sph_ball *root, const int32_t eye[3],
                   const struct sph_rays *rays, int width, int height, int points, int border,
                   struct sph_error *err) {
    *spans = (struct sph_spans){.how = SPH_SPANS_OUTLINE};
    struct sph_span *exact = calloc((size_t)height, sizeof *exact);
    spans->rows = calloc((size_t)height, sizeof *spans->rows);
    int result = 0;
    if (!exact || !spans->rows) {
        result = sph_fail(err, "out of memory for %d rows", height);
    } else if ((int64_t)eye[2] - root->c[2] <= -(int64_t)root->r) {
        spans->how = SPH_SPANS_BEHIND;
    } else if (!sph_in_front(root, eye)) {
        spans->how = SPH_SPANS_WHOLE;
        for (int y = 0; y < height; y++)
            spans->rows[y].x1 = width;
    } else {
        struct sph_cone cone = sph_cone_make(root, eye, rays, &spans->check);
        struct sph_projection p = {root, eye, rays, points};
        for (int y = 0; y < height; y++)
            sph_cone_row(&cone, width, y, &exact[y].x0, &exact[y].x1, &spans->check);
        result = cover(spans, &p, exact, width, height, border, err);
    }
    free(exact);
    if (result) {
        free(spans->rows);
        spans->rows = NULL;
    }
    return result;
}
