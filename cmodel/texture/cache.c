/* cache.c - see cache.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/cache.h"

#include <stdlib.h>

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

int sph_cache_ask(struct sph_cache *cache, uint32_t word) {
    uint32_t line = word / cache->line_words + 1, at = 0;
    uint32_t *set = cache->lines + (size_t)(line - 1) % cache->sets * cache->ways;
    while (at < cache->ways && set[at] != line)
        at++;
    int missed = at == cache->ways;
    if (missed) at--; /* the one not used for longest */
    for (; at; at--)
        set[at] = set[at - 1];
    set[0] = line;
    cache->asked++;
    cache->missed += (uint64_t)missed;
    return missed;
}

void sph_cache_end(struct sph_cache *cache) {
    free(cache->lines);
    cache->lines = NULL;
}
