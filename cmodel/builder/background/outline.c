/* outline.c - see outline.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/background/outline.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

int sph_in_front(const struct sph_ball *ball, const int32_t eye[3]) {
    return (int64_t)eye[2] - ball->c[2] > ball->r;
}

int sph_outline_start(struct sph_outline *o, int width, int height, int margin,
                      struct sph_error *err) {
    *o = (struct sph_outline){.width = width, .height = height, .margin = margin};
    o->rows = calloc((size_t)height + 2 * (size_t)margin, sizeof *o->rows);
    return o->rows ? 0 : sph_fail(err, "out of memory for %d rows", height);
}

/* The paper's matrix, with V the eye and D such that the screen lies -z direction units before the
 * eye: x = (X (Zv + D) - Xv (Z + D)) / (Zv - Z), in grid units on the screen. */
void sph_project_parallel(const struct sph_projection *p, int i, double (*pixel)[2],
                          struct sph_work *work) {
    const double xv = p->eye[0], yv = p->eye[1], zv = p->eye[2], r = p->ball->r;
    const double screen = -(double)p->rays->z, d = screen - zv, pitch = 1 / (double)p->rays->pitch;
    const double alpha = pi * i / (p->n - 1), ring = r * sin(alpha);
    const double z = p->ball->c[2] + r * cos(alpha), depth = 1 / (zv - z);
    const double xs = xv * (z + d), ys = yv * (z + d);
    for (int j = 0; j < p->n; j++) {
        double beta = 2 * pi * j / p->n;
        double x = p->ball->c[0] + ring * cos(beta), y = p->ball->c[1] + ring * sin(beta);
        double sx = (x * screen - xs) * depth, sy = (y * screen - ys) * depth;
        pixel[j][0] = floor((sx - xv - p->rays->x0) * pitch + 0.5);
        pixel[j][1] = floor((p->rays->y0 - (sy - yv)) * pitch + 0.5);
    }
    unsigned n = (unsigned)p->n;
    sph_work_add(work, &(struct sph_work){
                           .add = 5 + 10 * n, .mul = 5 + 9 * n, .div = 3 + n, .trig = 2 + 2 * n});
}

/* The whole number nearest to v in lo .. hi. */
static int32_t limit(double v, int32_t lo, int32_t hi) {
    return v < lo ? lo : v > hi ? hi : (int32_t)v;
}

static void mark(struct sph_outline *o, int32_t x, int32_t y) {
    struct sph_span *row = &o->rows[y + o->margin];
    int first = o->x1 <= o->x0;
    if (first || x < o->x0) o->x0 = x;
    if (first || x >= o->x1) o->x1 = x + 1;
    if (first || y < o->y0) o->y0 = y;
    if (first || y >= o->y1) o->y1 = y + 1;
    first = row->x1 <= row->x0;
    if (first || x < row->x0) row->x0 = x;
    if (first || x >= row->x1) row->x1 = x + 1;
    o->work.compare += 6;
}

int sph_outline_rows(struct sph_outline *o, const struct sph_projection *p, struct sph_error *err) {
    double(*pixel)[2] = malloc((size_t)p->n * sizeof *pixel);
    if (!pixel) return sph_fail(err, "out of memory for %d points", p->n);
    for (int i = 0; i < p->n; i++) {
        sph_project_parallel(p, i, pixel, &o->work);
        for (int j = 0; j < p->n; j++)
            mark(o, limit(pixel[j][0], -o->margin, o->width - 1 + o->margin),
                 limit(pixel[j][1], -o->margin, o->height - 1 + o->margin));
    }
    free(pixel);
    return 0;
}

int sph_outline_columns(struct sph_outline *o, struct sph_error *err) {
    if (o->x1 <= o->x0) return 0;
    struct sph_span *column = calloc((size_t)(o->x1 - o->x0), sizeof *column); /* rows y0.. */
    if (!column) return sph_fail(err, "out of memory for %d columns", o->width);
    for (int y = o->y0; y < o->y1; y++) {
        const struct sph_span *row = &o->rows[y + o->margin];
        for (int x = row->x0; x < row->x1; x++) {
            struct sph_span *c = &column[x - o->x0];
            if (!c->x1) c->x0 = y - o->y0;
            c->x1 = y - o->y0 + 1;
        }
        o->work.compare += (unsigned)(row->x1 - row->x0) + 1;
    }
    for (int x = o->x0; x < o->x1; x++) {
        const struct sph_span *c = &column[x - o->x0];
        for (int y = c->x0; y < c->x1; y++) {
            struct sph_span *row = &o->rows[y + o->y0 + o->margin];
            if (row->x1 <= row->x0) *row = (struct sph_span){x, x};
            if (x < row->x0) row->x0 = x;
            if (x >= row->x1) row->x1 = x + 1;
        }
        o->work.compare += 2 * (unsigned)(c->x1 - c->x0);
    }
    free(column);
    return 0;
}

int sph_outline_border(struct sph_outline *o, int n, struct sph_error *err) {
    int count = o->height + 2 * o->margin;
    struct sph_span *wide = calloc((size_t)count, sizeof *wide);
    if (!wide) return sph_fail(err, "out of memory for %d rows", count);
    for (int at = 0; at < count; at++) {
        if (o->rows[at].x1 <= o->rows[at].x0) continue;
        struct sph_span grown = {o->rows[at].x0 - n, o->rows[at].x1 + n};
        for (int to = at - n; to <= at + n; to++) {
            if (to < 0 || to >= count) continue;
            struct sph_span *row = &wide[to];
            int empty = row->x1 <= row->x0;
            if (empty || grown.x0 < row->x0) row->x0 = grown.x0;
            if (empty || grown.x1 > row->x1) row->x1 = grown.x1;
            o->work.compare += 2;
        }
        o->work.add += 2;
    }
    free(o->rows);
    o->rows = wide;
    return 0;
}

struct sph_span sph_outline_row(const struct sph_outline *o, int y) {
    struct sph_span row = o->rows[y + o->margin];
    if (row.x0 < 0) row.x0 = 0;
    if (row.x1 > o->width) row.x1 = o->width;
    return row.x0 < row.x1 ? row : (struct sph_span){0, 0};
}

/* ---- rect_paper ---- */

int sph_rect_paper(const struct sph_ball *root, const int32_t eye[3], const struct sph_rays *rays,
                   int width, int height, struct sph_span *rows, double point[4][2],
                   struct sph_work *work) {
    double low[2] = {0, 0}, high[2] = {width - 1, height - 1};
    const double x = root->c[0], y = root->c[1], reach = 1.4 * root->r;
    const double at[4][2] = {{x + reach, y}, {x - reach, y}, {x, y + reach}, {x, y - reach}};
    int answer = eye[2] > root->c[2];
    if (answer) {
        double scale = -(double)rays->z / ((double)eye[2] - root->c[2]);
        for (int i = 0; i < 4; i++) {
            point[i][0] =
                floor(((at[i][0] - eye[0]) * scale - rays->x0) / (double)rays->pitch + 0.5);
            point[i][1] =
                floor((rays->y0 - (at[i][1] - eye[1]) * scale) / (double)rays->pitch + 0.5);
        }
        low[0] = fmax(point[1][0], low[0]), high[0] = fmin(point[0][0], high[0]);
        low[1] = fmax(point[2][1], low[1]), high[1] = fmin(point[3][1], high[1]);
        /* the four sums of the paper; the matrix, and pixels: of each point one coordinate counts
         */
        sph_work_add(work, &(struct sph_work){
                               .add = 4 + 1 + 4 * 3, .mul = 1 + 4, .div = 1 + 4, .compare = 4});
    }
    for (int row = 0; row < height; row++) {
        int in = row >= low[1] && row <= high[1] && low[0] <= high[0];
        rows[row] =
            in ? (struct sph_span){(int32_t)low[0], (int32_t)high[0] + 1} : (struct sph_span){0, 0};
    }
    return answer;
}
