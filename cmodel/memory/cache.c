/* cache.c - see cache.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "memory/cache.h"

#include <stdlib.h>
#include <string.h>

static int power_of_two(uint32_t x) {
    return x && !(x & (x - 1));
}

int sph_cache_start(struct sph_cache *cache, uint32_t words, uint32_t line_words, uint32_t ways,
                    struct sph_error *err) {
    *cache = (struct sph_cache){.line_words = line_words, .ways = ways};
    if (!power_of_two(words) || !power_of_two(line_words) || !power_of_two(ways))
        return sph_fail(err, "a cache of %u words, lines of %u, %u ways: not powers of two", words,
                        line_words, ways);
    if ((uint64_t)line_words * ways > words)
        return sph_fail(err, "a cache of %u words does not hold a set of %u lines of %u", words,
                        ways, line_words);
    cache->sets = words / line_words / ways;
    cache->lines = calloc((size_t)cache->sets * ways, sizeof *cache->lines);
    return cache->lines ? 0 : sph_fail(err, "out of memory for a cache of %u words", words);
}

/* The way whose line goes; `ways`: all lines of the set are on their way. */
static uint32_t victim(const struct sph_cache *cache, const struct sph_cache_line *set) {
    uint32_t first = cache->ways;
    for (uint32_t at = 0; at < cache->ways; at++) {
        if (cache->late && set[at].miss > cache->came) continue;
        if (!set[at].recent) return at;
        if (first == cache->ways) first = at;
    }
    return first;
}

static void touch(const struct sph_cache *cache, struct sph_cache_line *set, uint32_t way) {
    uint32_t recent = 0;
    set[way].recent = 1;
    for (uint32_t at = 0; at < cache->ways; at++)
        recent += set[at].recent;
    for (uint32_t at = 0; at < cache->ways && recent == cache->ways; at++)
        set[at].recent = at == way;
}

int sph_cache_ask(struct sph_cache *cache, uint32_t word) {
    uint32_t line = word / cache->line_words + 1, at = 0;
    struct sph_cache_line *set = cache->lines + (size_t)(line - 1) % cache->sets * cache->ways;
    while (at < cache->ways && set[at].line != line)
        at++;
    int missed = at == cache->ways;
    if (missed) at = victim(cache, set);
    if (at == cache->ways) return -1;
    cache->asked++;
    cache->missed += (uint64_t)missed;
    if (missed) set[at] = (struct sph_cache_line){line, set[at].recent, cache->missed};
    touch(cache, set, at);
    return missed;
}

void sph_cache_came(struct sph_cache *cache, int error) {
    cache->came++;
    for (size_t i = 0; error && i < (size_t)cache->sets * cache->ways; i++)
        if (cache->lines[i].miss == cache->came) cache->lines[i].line = 0;
}

void sph_cache_forget(struct sph_cache *cache) {
    memset(cache->lines, 0, (size_t)cache->sets * cache->ways * sizeof *cache->lines);
}

void sph_cache_end(struct sph_cache *cache) {
    free(cache->lines);
    cache->lines = NULL;
}
