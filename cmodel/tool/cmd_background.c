/* cmd_background.c - `sphaera background`: the ways of background separation compared
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "builder/background/outline.h"
#include "image/image.h"
#include "tool/background_compare.h"
#include "tool/print.h"
#include "tool/report.h"

/* ---- pictures of background separation; see background_compare.h ---- */
/* The steps in the manner of Borodavka et al., Figures 5 to 8, and one picture for each way.
 * Pixels of a small frame are enlarged, so that they can be counted. */

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

struct arguments {
    struct tool_source source;
    const char *input, *pictures, *json;
};

enum { KEY_JSON = 512, KEY_PICTURES };

static const struct argp_option options[] = {
    {"pictures", KEY_PICTURES, "FOLDER", 0,
     "PNG of every step and way, into a folder, made if there is none", 0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case KEY_PICTURES:
        a->pictures = arg;
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->input, "no scene given");
    }
}

static double percent(uint64_t part, uint64_t whole) {
    return whole ? 100.0 * (double)part / (double)whole : 0;
}

static void print_ways(FILE *to, const struct ways *w) {
    double n = (double)w->width * w->height;
    fprintf(to, "scene    %s, %dx%d: %" PRIu64 " pixels see no sphere\n", w->name, w->width,
            w->height, w->background);
    fprintf(to, "%-23s %8s %7s %6s  %8s %8s %6s %6s %8s  %9s %6s %6s %6s\n", "way", "rays", "found",
            "wrong", "add", "mul", "div", "trig", "compare", "check", "add/px", "cmp/px", "wd/px");
    for (int i = 0; i < WAYS; i++) {
        const struct way *p = &w->way[i];
        fprintf(to,
                "%-23s %8" PRIu64 " %6.1f%% %6" PRIu64 "  %8" PRIu64 " %8" PRIu64 " %6" PRIu64
                " %6" PRIu64 " %8" PRIu64 "  %9" PRIu64 " %6.2f %6.2f %6.3f%s\n",
                way_names[i], p->rays, percent(p->found, w->background), p->wrong, p->work.add,
                p->work.mul, p->work.div, p->work.trig, p->work.compare,
                p->check.add + p->check.mul + p->check.compare, (double)p->add / n,
                (double)p->compare / n, (double)p->words / n, p->no_answer ? "  no answer" : "");
    }
    for (int i = 0; i < WAYS; i++)
        if (w->way[i].background[0]) fprintf(to, "build    %s", w->way[i].background);
    if (!w->in_front) return;
    fprintf(to, "points   missed, wrong without border; missed, wrong with one; rays it costs\n");
    for (int i = 0; i < SERIES; i++) {
        const struct series *s = &w->series[i];
        fprintf(
            to, "%2dx%-5d %6" PRIu64 " %6" PRIu64 "   %6" PRIu64 " %6" PRIu64 "   %6" PRIu64 "\n",
            s->points, s->points, s->missed[0], s->wrong[0], s->missed[1], s->wrong[1], s->border);
    }
}

static json_t *json_work(const struct sph_work *work) {
    return json_pack("{s:I, s:I, s:I, s:I, s:I}", "add", (json_int_t)work->add, "mul",
                     (json_int_t)work->mul, "div", (json_int_t)work->div, "trig",
                     (json_int_t)work->trig, "compare", (json_int_t)work->compare);
}

static void report_ways(json_t *report, const struct ways *w) {
    json_t *list = json_array(), *series = json_array();
    report_text(report, "scene", w->name);
    report_count(report, "width", (uint64_t)w->width);
    report_count(report, "height", (uint64_t)w->height);
    report_count(report, "background", w->background);
    for (int i = 0; i < WAYS; i++) {
        const struct way *p = &w->way[i];
        json_t *way = json_object();
        report_text(way, "way", way_names[i]);
        report_count(way, "rays", p->rays);
        report_count(way, "found", p->found);
        report_count(way, "wrong", p->wrong);
        json_object_set_new(way, "no_answer", json_boolean(p->no_answer));
        report_text(way, "build", p->background);
        json_object_set_new(way, "setup", json_work(&p->work));
        json_object_set_new(way, "check", json_work(&p->check));
        report_count(way, "walk_add", p->add);
        report_count(way, "walk_compare", p->compare);
        report_count(way, "walk_words", p->words);
        json_array_append_new(list, way);
    }
    for (int i = 0; i < SERIES && w->in_front; i++) {
        const struct series *s = &w->series[i];
        json_array_append_new(series,
                              json_pack("{s:i, s:[I, I], s:[I, I], s:I}", "points", s->points,
                                        "missed", (json_int_t)s->missed[0],
                                        (json_int_t)s->missed[1], "wrong", (json_int_t)s->wrong[0],
                                        (json_int_t)s->wrong[1], "border", (json_int_t)s->border));
    }
    json_object_set_new(report, "ways", list);
    json_object_set_new(report, "series", series);
}

/* Everything after reading the scene. */
static int compare(const struct arguments *a, const struct sph_scene *scene,
                   struct sph_error *err) {
    struct ways ways;
    if (a->pictures && mkdir(a->pictures, 0777) && errno != EEXIST)
        return sph_fail(err, "%s: %s", a->pictures, strerror(errno));
    struct sph_build_options how = a->source.build;
    int rc = tool_frame_size(&a->source, scene, &how, err);
    struct sph_profile_choice choice;
    if (!rc) rc = tool_profile(&a->source, scene, &how, &choice, err);
    if (!rc) rc = ways_measure(scene, &how, &ways, err);
    if (!rc && a->pictures) rc = ways_draw(&ways, a->pictures, err);
    FILE *to = print_stream(a->json);
    if (!rc && to) print_ways(to, &ways);
    if (!rc) {
        json_t *report = report_new("background");
        report_text(report, "input", a->input);
        report_ways(report, &ways);
        rc = report_write(report, a->json, err);
    }
    ways_free(&ways);
    return rc;
}

/* Notes what will be drawn. */
static int name_pictures(struct arguments *a, char **drawn, struct sph_error *err) {
    for (int i = 0; i < PICTURES; i++) {
        drawn[i] = ways_picture(a->pictures, i);
        if (!drawn[i]) return sph_fail(err, "out of memory");
        tool_output(&a->source.outputs, -1 - i, drawn[i]);
    }
    return 0;
}

int tool_background(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "Compares every way of background separation on the view of a scene.\v"
        "For each way: rays traced, how much of the true background it finds, wrong pixels (hits "
        "left out), operations of set-up, of proving an outline, and per pixel. The literal "
        "methods are the paper's at their word; no machine is built with them.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default};
    a.source.every_background = 1;
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_wants_scene(a.input, &err)) return tool_failed(&err);
    char *drawn[PICTURES] = {NULL};
    int rc = a.pictures ? name_pictures(&a, drawn, &err) : 0;
    if (!rc && !(rc = tool_scene_read(a.input, &a.source, &scene, &err))) {
        rc = compare(&a, &scene, &err);
        sph_scene_free(&scene);
    }
    for (int i = 0; i < PICTURES; i++)
        free(drawn[i]);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
