/* print_bih.c - what a bounding interval hierarchy is like, as text and as JSON; see print.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>

#include "tool/print.h"
#include "tool/report.h"

static double mean(uint64_t sum, uint32_t n) {
    return n ? (double)sum / n : 0;
}

void print_bih(FILE *to, const struct sph_machine *m, const struct sph_bih_stats *s) {
    if (!to) return;
    fprintf(to, "nodes    %u inner, %u leaves, %u optimized\n", s->inner, s->leaves, s->optimized);
    fprintf(to, "prims    of a leaf: %u least, %.2f mean, %u most\n", s->prims_min,
            mean(s->prims_sum, s->leaves), s->prims_max);
    fprintf(to, "levels   of leaves: %u least, %.2f mean, %u most\n", s->depth_min,
            mean(s->depth_sum, s->leaves), s->depth_max);
    fprintf(to, "leaves   with N primitives:");
    for (int i = 0; i < SPH_BIH_BARS; i++)
        fprintf(to, " %s %d: %.2f %%", i < SPH_BIH_BARS - 1 ? "N =" : "N >",
                i < SPH_BIH_BARS - 1 ? i : i - 1, 100 * mean(s->bars[i], s->leaves));
    fprintf(to,
            "\nbytes    %" PRIu64 " (12 a node, 4 a primitive, 24); here %" PRIu64
            " of nodes and %" PRIu64 " of leaf records\n",
            sph_bih_bytes(s), sph_bih_node_bytes(m), sph_bih_record_bytes(m));
}

void report_bih(json_t *report, const struct sph_machine *m, const struct sph_bih_stats *s) {
    if (!report) return;
    json_t *bih = json_object(), *bars = json_array();
    report_count(bih, "inner", s->inner);
    report_count(bih, "leaves", s->leaves);
    report_count(bih, "optimized", s->optimized);
    report_count(bih, "prims_min", s->prims_min);
    report_number(bih, "prims_mean", mean(s->prims_sum, s->leaves));
    report_count(bih, "prims_max", s->prims_max);
    report_count(bih, "depth_min", s->depth_min);
    report_number(bih, "depth_mean", mean(s->depth_sum, s->leaves));
    report_count(bih, "depth_max", s->depth_max);
    for (int i = 0; i < SPH_BIH_BARS; i++)
        json_array_append_new(bars, json_integer(s->bars[i]));
    json_object_set_new(bih, "leaves_by_prims", bars);
    report_count(bih, "bytes", sph_bih_bytes(s));
    report_count(bih, "node_bytes", sph_bih_node_bytes(m));
    report_count(bih, "record_bytes", sph_bih_record_bytes(m));
    json_object_set_new(report, "bih", bih);
}
