/* cmd_texels.c - `sphaera texels`: orders of texels in memory, compared by the hits of caches
 * SPDX-License-Identifier: Apache-2.0
 *
 * Pixels are taken as the core walks them, in columns of eight; the texels of a pixel in the order
 * in which the model asks for them.
 */
#include <inttypes.h>

#include "engine/render_pixel.h"
#include "memory/cache.h"
#include "texture/order.h"
#include "tool/print.h"
#include "tool/report.h"
#include "tool/shapes.h"

enum { SIZES = SHAPES_SIZES, SMALLEST = SHAPES_SMALLEST, WAYS = 4, COLUMN = 8 };
enum { BASES_WORD = 32 / SPH_MAP_BASE_BITS };                    /* of P_b alone, packed */
static const char *const orders[] = {"rows", "tiles", "morton"}; /* SPH_ORDER_* */

static error_t parse(int key, char *arg, struct argp_state *state) {
    return tool_report_key(key, arg, state, "no scene given");
}

/* Caches of every size for every order, which see the same texels. */
struct caches {
    const struct sph_machine *m;
    struct sph_cache cache[SPH_ORDERS][SIZES];
    struct sph_cache maps[SIZES], bases[SIZES]; /* mapping records; P_b of each, apart from it */
    struct shapes shapes;                       /* for the order that the machine has */
    uint64_t level[SPH_TEXTURE_LEVELS];         /* texels of each level */
};

static void count_texel(void *user, const struct sph_texel *t) {
    struct caches *c = user;
    const uint32_t *head = sph_line(c->m, t->image);
    uint32_t w = sph_field(head, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS) + 1;
    uint32_t h = sph_field(head, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS) + 1;
    c->level[t->level]++;
    for (int s = 0; s < SIZES && t->first; s++) {
        sph_cache_ask(&c->maps[s], SPH_LINE_WORDS * t->map);
        sph_cache_ask(&c->bases[s], t->map / BASES_WORD);
    }
    shapes_ask(&c->shapes, t->word);
    for (int o = 0; o < SPH_ORDERS; o++) {
        /* no order needs more than four times the lines of another: images stay apart */
        uint32_t word =
            4 * SPH_LINE_WORDS * (t->image + 1) + sph_order_word(o, w, h, t->level, t->x, t->y);
        for (int s = 0; s < SIZES; s++)
            sph_cache_ask(&c->cache[o][s], word);
    }
}

static void walk(const struct sph_machine *m, struct caches *c) {
    struct sph_render_options how = {.fetch = count_texel, .fetch_user = c};
    const int32_t *r = m->regs;
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    for (int x0 = r[SPH_REG_WIN_X0]; x0 < r[SPH_REG_WIN_X1]; x0 += COLUMN)
        for (int y = r[SPH_REG_WIN_Y0]; y < r[SPH_REG_WIN_Y1]; y++)
            for (int x = x0; x < x0 + COLUMN && x < r[SPH_REG_WIN_X1]; x++)
                sph_render_pixel(m, &how, x, y, &counters, &errors, NULL);
}

/* Misses of caches of all sizes, with their hits in a row. */
static json_t *row(const char *name, const struct sph_cache cache[SIZES], FILE *to) {
    json_t *missed = json_array();
    if (to) fprintf(to, "%-17s ", name);
    for (int s = 0; s < SIZES; s++) {
        uint64_t asked = cache[s].asked, had = asked - cache[s].missed;
        if (to) fprintf(to, "%7.2f", asked ? 100.0 * (double)had / (double)asked : 0);
        json_array_append_new(missed, json_integer((json_int_t)cache[s].missed));
    }
    if (to) fprintf(to, "\n");
    return missed;
}

/* The table, and the same numbers for the report. */
static void print_table(const struct caches *c, FILE *to, json_t *report) {
    json_t *list = json_array(), *levels = json_array();
    uint64_t asked = c->cache[0][0].asked;
    if (to) {
        fprintf(to, "levels, %%");
        for (int l = 0; l < SPH_TEXTURE_LEVELS; l++)
            fprintf(to, " %.1f", asked ? 100.0 * (double)c->level[l] / (double)asked : 0);
        fprintf(to, "\n");
        fprintf(to, "texels   %" PRIu64 "\nhits, %%  cache of ", asked);
        for (int s = 0; s < SIZES; s++)
            fprintf(to, "%7d", SMALLEST << s);
        fprintf(to, " lines, %d ways\n", WAYS);
    }
    for (int o = 0; o < SPH_ORDERS; o++) {
        json_t *entry = json_object();
        report_text(entry, "order", orders[o]);
        json_object_set_new(entry, "missed", row(orders[o], c->cache[o], to));
        json_array_append_new(list, entry);
    }
    json_t *records = json_object();
    report_count(records, "lookups", c->maps[0].asked);
    json_object_set_new(records, "map_missed", row("mapping records", c->maps, to));
    json_object_set_new(records, "base_missed", row("P_b alone", c->bases, to));
    json_t *shapes = shapes_tell(&c->shapes, to);
    for (int l = 0; l < SPH_TEXTURE_LEVELS; l++)
        json_array_append_new(levels, json_integer((json_int_t)c->level[l]));
    if (report) {
        report_count(report, "texels", asked);
        json_object_set(report, "levels", levels);
        json_object_set(report, "orders", list);
        json_object_set(report, "records", records);
        json_object_set(report, "shapes", shapes);
    }
    json_decref(records);
    json_decref(list);
    json_decref(levels);
    json_decref(shapes);
}

static int start(struct caches *c, struct sph_error *err) {
    for (int s = 0; s < SIZES; s++) {
        uint32_t words = (uint32_t)(SPH_LINE_WORDS * SMALLEST) << s;
        for (int o = 0; o < SPH_ORDERS; o++)
            if (sph_cache_start(&c->cache[o][s], words, SPH_LINE_WORDS, WAYS, err)) return -1;
        if (sph_cache_start(&c->maps[s], words, SPH_LINE_WORDS, WAYS, err) ||
            sph_cache_start(&c->bases[s], words, SPH_LINE_WORDS, WAYS, err))
            return -1;
    }
    return shapes_start(&c->shapes, err);
}

int tool_texels(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        tool_report_options,
        parse,
        "MACHINE.sph|SCENE",
        "Renders with the golden model and asks caches of several sizes for the texels, as they "
        "would stand in rows, in tiles of 4 x 2, and in the same tiles along a Z curve, for "
        "mapping records and for P_b of these in words of its own; and for tiles caches that fetch "
        "1, 2 or 4 lines together and have 1, 2 or 4 ways.",
        children,
        NULL,
        NULL};
    struct tool_report_arguments a = {.source = tool_source_default};
    struct tool_built built;
    struct caches c = {0};
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);
    if (tool_load(a.input, &a.source, &built, &err)) return tool_failed(&err);
    c.m = &built.machine;
    int rc = start(&c, &err);
    if (!rc) {
        walk(&built.machine, &c);
        json_t *report = report_new("texels");
        report_text(report, "input", a.input);
        print_table(&c, print_stream(a.json), report);
        rc = report_write(report, a.json, &err);
    }
    for (int i = 0; i < SPH_ORDERS * SIZES; i++)
        sph_cache_end(&c.cache[i / SIZES][i % SIZES]);
    for (int s = 0; s < SIZES; s++) {
        sph_cache_end(&c.maps[s]);
        sph_cache_end(&c.bases[s]);
    }
    shapes_end(&c.shapes);
    sph_machine_free(&built.machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
