/* levels.c - see levels.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/levels.h"

#include <inttypes.h>

#include "tool/report.h"

const char *const tool_level_names[] = {"mended", "paper", "bmrt", "rays", NULL};

void print_levels(FILE *to, const struct sph_levels *e) {
    if (!to || !e->pixels) return;
    fprintf(to, "levels     %" PRIu64 " pixels; model off by %.4f on the mean, %.3f at most\n",
            e->pixels, e->model_mean, e->model_worst);
    for (int k = 0; k < SPH_LODS; k++)
        fprintf(to, "  %-8s level %.2f on the mean, %.2f off rays, %.1f %% within half a level\n",
                tool_level_names[k], e->mean[k], e->off[k], 100 * e->within_half[k]);
}

json_t *levels_json(const struct sph_levels *e) {
    json_t *json = json_object();
    report_count(json, "pixels", e->pixels);
    report_number(json, "model_mean", e->model_mean);
    report_number(json, "model_worst", e->model_worst);
    for (int k = 0; k < SPH_LODS; k++)
        json_object_set_new(json, tool_level_names[k],
                            json_pack("{sfsfsf}", "mean", e->mean[k], "off", e->off[k],
                                      "within_half", e->within_half[k]));
    return json;
}
