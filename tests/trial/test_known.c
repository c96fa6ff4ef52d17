/* test_known.c - cells of cores that were synthesised, as the others let expect them
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_known
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "trial/known.h"
#include "trial/known_table.h"

static const struct sph_known_core cores[] = {SPH_KNOWN_CORES};

/* Of each core but itself: a word that no other core has has no price of its own. */
static void test_estimates(void **unused) {
    double sum = 0, most = 0;
    int n = 0;
    (void)unused;
    for (size_t i = 0; i < sizeof cores / sizeof *cores; i++) {
        const struct sph_known_core *c = &cores[i];
        if (!c->lut4eq || strcmp(c->profile, "standard") != 0) continue;
        struct sph_known_core e = sph_known_estimate(c->profile, c->effects, c->pipes);
        if (!e.lut4eq) continue; /* of such a word */
        double off = fabs((double)e.lut4eq / c->lut4eq - 1);
        assert_true(e.cells_estimated && e.bram);
        if (off > most) printf("# %s: %d, expected %d\n", c->effects, c->lut4eq, e.lut4eq);
        most = fmax(most, off);
        sum += off, n++;
    }
    printf("# off by %.1f %% in the mean of %d, %.1f %% at most\n", 100 * sum / n, n, 100 * most);
    assert_true(n > 20 && sum / n < 0.03 && most < 0.15);
}

static void test_what_is_known(void **unused) {
    struct sph_known_core c = sph_known_core("standard", "shadow+reflect2+lights3+inside", 1);
    (void)unused;
    assert_int_equal(c.lut4eq, 16176);
    assert_int_equal(c.seeds, 5);
    assert_false(c.cells_estimated || c.clock_estimated);
    c = sph_known_core("standard", "shadow+reflect2+lights3+inside+facets", 1); /* routed alone */
    assert_true(c.cells_estimated && !c.clock_estimated && c.lut4eq > 20000);
    c = sph_known_core("fine", "shadow+lights1", 1); /* as the profile's core is larger */
    assert_true(c.cells_estimated && c.clock_estimated && c.lut4eq > 16000 && c.lut4eq < 18000);
    static const struct {
        const char *profile, *effects;
        int pipes;
    } unknown[] = {{"standard", "shadow+lights1", 2},       /* pipes */
                   {"standard:pq=13", "shadow+lights1", 1}, /* widths */
                   {"standard", "shadow+nosuch", 1}};       /* a word */
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        c = sph_known_core(unknown[i].profile, unknown[i].effects, unknown[i].pipes);
        assert_true(!c.lut4eq && !(c.median > 0) && !c.cells_estimated && !c.clock_estimated);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_estimates),
                                       cmocka_unit_test(test_what_is_known)};
    return cmocka_run_group_tests_name("cores that are known", tests, NULL, NULL);
}
