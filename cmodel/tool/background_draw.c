/* background_draw.c - pictures of background separation; see background_compare.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * The steps in the manner of Borodavka et al., Figures 5 to 8, and one picture for each way.
 * Pixels of a small frame are enlarged, so that they can be counted.
 */
#include <stdlib.h>
#include <string.h>

#include "builder/background/rect_paper.h"
#include "image/image.h"
#include "tool/background_compare.h"

/* Colours as in struct sph_pixel: red in the lowest byte. */
#define RGB(r, g, b) ((uint32_t)(r) | (uint32_t)(g) << 8 | (uint32_t)(b) << 16)
static const uint32_t ground = RGB(24, 27, 32); /* not traced */
static const uint32_t disc = RGB(62, 72, 92);   /* sees the root sphere */
static const uint32_t spent = RGB(58, 96, 160); /* traced, sees nothing */
static const uint32_t seen = RGB(240, 196, 64); /* traced, sees a sphere */
static const uint32_t lost = RGB(224, 48, 48);  /* not traced, would see one */
static const uint32_t point = RGB(250, 250, 250);
static const uint32_t row = RGB(86, 150, 214), column = RGB(96, 176, 120), rim = RGB(190, 120, 200);

struct canvas {
    int width, height;
    uint32_t *colour;
};

static int start(struct canvas *c, const struct ways *w, struct sph_error *err) {
    size_t n = (size_t)w->width * (size_t)w->height;
    *c = (struct canvas){w->width, w->height, malloc(n * sizeof *c->colour)};
    if (!c->colour) return sph_fail(err, "out of memory");
    for (size_t i = 0; i < n; i++)
        c->colour[i] = w->root[i] ? disc : ground;
    return 0;
}

static void set(struct canvas *c, double x, double y, uint32_t colour) {
    if (x >= 0 && x < c->width && y >= 0 && y < c->height)
        c->colour[(size_t)y * (size_t)c->width + (size_t)x] = colour;
}

char *ways_picture(const char *folder, int picture) {
    static const char *const names[PICTURES] = {"points",           "rows",       "outline",
                                                "square",           "way_none",   "way_rect",
                                                "way_rect_literal", "way_spans",  "way_spans16",
                                                "way_spans16_bare", "way_exact0", "way_exact1",
                                                "way_exact2"};
    size_t size = strlen(folder) + strlen(names[picture]) + sizeof "/.png";
    char *path = malloc(size);
    if (path) snprintf(path, size, "%s/%s.png", folder, names[picture]);
    return path;
}

/* Writes the canvas enlarged to about 640 columns, with a line between pixels if there is room for
 * it. */
static int finish(struct canvas *c, const char *folder, int picture, struct sph_error *err) {
    int zoom = c->width < 640 ? 640 / c->width : 1, line = zoom >= 5;
    struct sph_frame frame = {c->width * zoom, c->height * zoom, NULL};
    size_t n = (size_t)frame.width * (size_t)frame.height;
    frame.pixels = calloc(n, sizeof *frame.pixels);
    if (!frame.pixels) return sph_fail(err, "out of memory");
    for (size_t i = 0; i < n; i++) {
        int x = (int)(i % (size_t)frame.width), y = (int)(i / (size_t)frame.width);
        uint32_t colour = c->colour[(y / zoom) * c->width + x / zoom];
        if (line && (x % zoom == 0 || y % zoom == 0)) colour = colour >> 2 & 0x3f3f3f;
        frame.pixels[i].colour[0] = colour;
    }
    char *path = ways_picture(folder, picture);
    int rc = path ? sph_image_write(path, &frame, 0, err) : sph_fail(err, "out of memory");
    free(path);
    free(frame.pixels);
    return rc;
}

static void paint(struct canvas *c, const struct sph_outline *o, uint32_t colour, int over) {
    for (int y = 0; y < c->height; y++) {
        struct sph_span span = sph_outline_row(o, y);
        for (int x = span.x0; x < span.x1; x++) {
            uint32_t was = c->colour[y * c->width + x];
            if (over || was == ground || was == disc) set(c, x, y, colour);
        }
    }
}

/* Points, after the scan of rows, after columns and border: Figures 5, 6 and 7. */
static int draw_steps(const struct ways *w, const char *folder, struct sph_error *err) {
    enum { N = 16 };
    struct sph_projection p = {&w->ball, w->eye, &w->rays, N};
    struct sph_work work = {0};
    struct sph_outline o;
    struct canvas points = {0}, rows = {0}, final = {0};
    double pixel[N][2];
    int rc = sph_outline_start(&o, w->width, w->height, 2, err) || start(&points, w, err) ||
             start(&rows, w, err) || start(&final, w, err);
    if (!rc) rc = sph_outline_rows(&o, &p, err);
    if (!rc) paint(&rows, &o, row, 1), paint(&final, &o, row, 1);
    if (!rc) rc = sph_outline_columns(&o, err);
    if (!rc) paint(&final, &o, column, 0);
    if (!rc) rc = sph_outline_border(&o, 1, err);
    if (!rc) paint(&final, &o, rim, 0);
    for (int i = 0; i < N && !rc; i++) {
        sph_project_parallel(&p, i, pixel, &work);
        for (int j = 0; j < N; j++) {
            set(&points, pixel[j][0], pixel[j][1], point);
            set(&rows, pixel[j][0], pixel[j][1], point);
        }
    }
    for (int i = 0; i < w->width * w->height && !rc; i++)
        if (w->root[i] && final.colour[i] == disc) final.colour[i] = lost;
    rc = rc || finish(&points, folder, PICTURE_POINTS, err) ||
         finish(&rows, folder, PICTURE_ROWS, err) || finish(&final, folder, PICTURE_OUTLINE, err);
    free(points.colour), free(rows.colour), free(final.colour);
    free(o.rows);
    return rc ? -1 : 0;
}

/* The four points and their square: Figure 8. */
static int draw_square(const struct ways *w, const char *folder, struct sph_error *err) {
    const struct way *way = &w->way[WAY_RECT_LITERAL];
    struct sph_span *rows = calloc((size_t)w->height, sizeof *rows);
    struct canvas c;
    struct sph_work work = {0};
    double at[4][2] = {{0}};
    if (!rows) return sph_fail(err, "out of memory");
    int rc = start(&c, w, err);
    if (!rc) {
        sph_rect_paper(&w->ball, w->eye, &w->rays, w->width, w->height, rows, at, &work);
        for (int i = 0; i < w->width * w->height; i++)
            if (w->root[i])
                c.colour[i] = way->traced[i] ? disc : lost;
            else if (way->traced[i])
                c.colour[i] = spent;
        for (int i = 0; i < 4 && !way->no_answer; i++)
            set(&c, at[i][0], at[i][1], point);
        rc = finish(&c, folder, PICTURE_SQUARE, err);
    }
    free(c.colour);
    free(rows);
    return rc;
}

static int draw_way(const struct ways *w, int index, const char *folder, struct sph_error *err) {
    const uint8_t *traced = w->way[index].traced;
    struct canvas c;
    if (start(&c, w, err)) return -1;
    for (int i = 0; i < w->width * w->height; i++)
        if (traced[i])
            c.colour[i] = w->hit[i] ? seen : spent;
        else
            c.colour[i] = w->hit[i] ? lost : ground;
    int rc = finish(&c, folder, PICTURE_WAYS + index, err);
    free(c.colour);
    return rc;
}

int ways_draw(const struct ways *w, const char *folder, struct sph_error *err) {
    if (w->in_front && (draw_steps(w, folder, err) || draw_square(w, folder, err))) return -1;
    for (int i = 0; i < WAYS; i++)
        if (draw_way(w, i, folder, err)) return -1;
    return 0;
}
