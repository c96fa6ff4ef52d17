/* cache.h - how often a cache would hit on a stream of word addresses
 * SPDX-License-Identifier: Apache-2.0
 *
 * Sets by the low bits of the line address; in a set the line that was not used for longest goes.
 * rtl/memory/rt_cache.v comes within 1 % of that rule.
 */
#ifndef SPH_CACHE_H
#define SPH_CACHE_H

#include <stdint.h>

#include "error.h"

struct sph_cache {
    uint32_t line_words, sets, ways;
    uint32_t *lines; /* sets * ways, the last used first; line + 1, 0: empty */
    uint64_t asked, missed;
};

/* A cache of `words` words in lines of line_words, `ways` lines in a set. Each is a power of two
 * and a set fits in: -1 with a message if not, or if memory is out. */
int sph_cache_start(struct sph_cache *cache, uint32_t words, uint32_t line_words, uint32_t ways,
                    struct sph_error *err);

/* Asks for the word at an address; 1 if its line had to be fetched. */
int sph_cache_ask(struct sph_cache *cache, uint32_t word);

void sph_cache_end(struct sph_cache *cache);

#endif
