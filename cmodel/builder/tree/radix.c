/* radix.c - see radix.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/radix.h"

enum { DIGIT = 11, LOW = 32, PASSES = 3, VALUES = 1 << DIGIT };

static inline size_t digit(uint64_t key, int pass) {
    return key >> (LOW + pass * DIGIT) & (VALUES - 1);
}

uint64_t *sph_radix(uint64_t *keys, uint64_t *spare, size_t n) {
    size_t count[PASSES][VALUES] = {{0}};
    for (size_t i = 0; i < n; i++)
        for (int pass = 0; pass < PASSES; pass++)
            count[pass][digit(keys[i], pass)]++;
    for (int pass = 0; pass < PASSES; pass++) {
        size_t *place = count[pass], sum = 0;
        if (n && place[digit(keys[0], pass)] == n) continue; /* all are equal here */
        for (int v = 0; v < VALUES; v++) {
            size_t here = place[v];
            place[v] = sum, sum += here;
        }
        for (size_t i = 0; i < n; i++)
            spare[place[digit(keys[i], pass)]++] = keys[i];
        uint64_t *swap = keys;
        keys = spare, spare = swap;
    }
    return keys;
}
