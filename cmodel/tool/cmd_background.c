/* cmd_background.c - `sphaera background`: the ways of background separation compared
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "tool/print.h"
#include "tool/report.h"
#include "tool/background_compare.h"

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
