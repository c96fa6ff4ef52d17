/* shapes.c - see shapes.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/shapes.h"

#include "machine/layout.h"
#include "tool/json.h"

static uint32_t group(int shape) {
    return 1u << shape / 3;
}

static uint32_t ways(int shape) {
    return 1u << shape % 3;
}

int shapes_start(struct shapes *shapes, struct sph_error *err) {
    for (int i = 0; i < SHAPES; i++)
        for (int s = 0; s < SHAPES_SIZES; s++) {
            uint32_t lines = (uint32_t)SHAPES_SMALLEST << s;
            if (group(i) * ways(i) <= lines &&
                sph_cache_start(&shapes->cache[i][s], lines * SPH_LINE_WORDS,
                                group(i) * SPH_LINE_WORDS, ways(i), err))
                return -1;
        }
    return 0;
}

void shapes_ask(struct shapes *shapes, uint32_t word) {
    for (int i = 0; i < SHAPES; i++)
        for (int s = 0; s < SHAPES_SIZES; s++)
            if (shapes->cache[i][s].lines) sph_cache_ask(&shapes->cache[i][s], word);
}

static void row(const struct shapes *shapes, int shape, int traffic, FILE *to) {
    fprintf(to, "%8u%5u     ", group(shape), ways(shape));
    for (int s = 0; s < SHAPES_SIZES; s++) {
        const struct sph_cache *cache = &shapes->cache[shape][s];
        double missed = cache->asked ? (double)cache->missed / (double)cache->asked : 0;
        if (!cache->lines)
            fprintf(to, "%7s", "-");
        else
            fprintf(to, traffic ? "%7.4f" : "%7.2f",
                    traffic ? missed * group(shape) : 100 * (1 - missed));
    }
    fprintf(to, "\n");
}

json_t *shapes_tell(const struct shapes *shapes, FILE *to) {
    json_t *list = json_array();
    for (int traffic = 0; to && traffic < 2; traffic++) {
        fprintf(to, "together ways     %s, tiles\n",
                traffic ? "lines fetched per texel" : "hits, %");
        for (int i = 0; i < SHAPES; i++)
            row(shapes, i, traffic, to);
    }
    for (int i = 0; i < SHAPES; i++) {
        json_t *entry = json_object(), *missed = json_array();
        report_count(entry, "together", group(i));
        report_count(entry, "ways", ways(i));
        for (int s = 0; s < SHAPES_SIZES; s++) {
            const struct sph_cache *cache = &shapes->cache[i][s];
            json_array_append_new(missed, cache->lines ? json_integer((json_int_t)cache->missed)
                                                       : json_null());
        }
        json_object_set_new(entry, "missed", missed);
        json_array_append_new(list, entry);
    }
    return list;
}

void shapes_end(struct shapes *shapes) {
    for (int i = 0; i < SHAPES * SHAPES_SIZES; i++)
        sph_cache_end(&shapes->cache[i / SHAPES_SIZES][i % SHAPES_SIZES]);
}
