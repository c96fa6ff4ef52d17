/* number.h - seeds and counts that are given to test programs
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_NUMBER_H
#define SPH_TEST_NUMBER_H

#include <stdio.h>
#include <stdlib.h>

#include "common/number.h"

/* The number that a text is, decimal; another one for no text. Ends the program if it is none. */
static inline uint64_t test_number(const char *text, const char *what, uint64_t other) {
    uint64_t n = other;
    if (!text || !sph_parse_count(text, 0, UINT64_MAX, &n)) return n;
    fprintf(stderr, "%s: '%s' is no number\n", what, text);
    exit(2);
}

/* SEED of the environment, 1 unless it is set. */
static inline uint64_t test_seed(void) {
    return test_number(getenv("SEED"), "SEED", 1);
}

/* ---- whether this program runs under sanitizers, which slow it down about tenfold ---- */
/* They look for other mistakes than wrong numbers: a share of the cases does for them. */

#ifdef __SANITIZE_ADDRESS__
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif

#endif
