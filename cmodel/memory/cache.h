/* cache.h - what a cache would fetch for a stream of word addresses
 * SPDX-License-Identifier: Apache-2.0
 *
 * Sets by the low bits of the line address, replacement as in rtl/memory/rt_cache.v: the first line
 * of the set that was not used since all were, and never one that is still on its way. With every
 * request and every line that memory gave, in the order in which rt_cache had them, `missed` is
 * what rt_cache counts. Alone, the requests of a stream tell what a memory without delay would be
 * asked.
 */
#ifndef SPH_CACHE_H
#define SPH_CACHE_H

#include <stdint.h>

#include "common/error.h"

struct sph_cache_line {
    uint32_t line;   /* its number + 1; 0: empty, or a bus error came with it */
    uint32_t recent; /* used since all of the set were */
    uint64_t miss;   /* it was fetched by this miss, the first is 1 */
};

struct sph_cache {
    uint32_t line_words, sets, ways;
    struct sph_cache_line *lines; /* sets * ways */
    uint64_t asked, missed;
    int late;      /* set by the user: lines come when sph_cache_came() says so, not at once */
    uint64_t came; /* misses whose lines came: with `late`, lines of later ones are on their way */
};

/* A cache of `words` words in lines of line_words, `ways` lines in a set. Each is a power of two
 * and a set fits in: -1 with a message if not, or if memory is out. */
int sph_cache_start(struct sph_cache *cache, uint32_t words, uint32_t line_words, uint32_t ways,
                    struct sph_error *err);

/* Asks for the word at an address; 1 if its line has to be fetched, 0 if it is there or on its way,
 * -1 if each line of its set is on its way: then it cannot be asked for before one came. */
int sph_cache_ask(struct sph_cache *cache, uint32_t word);

/* The line of the oldest miss whose line is on its way came, with a bus error or without. */
void sph_cache_came(struct sph_cache *cache, int error);

/* Forgets every line; what is on its way still comes. */
void sph_cache_forget(struct sph_cache *cache);

void sph_cache_end(struct sph_cache *cache);

#endif
