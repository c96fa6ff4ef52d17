/* levels.c - see levels.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/levels.h"

#include <inttypes.h>

#include "tool/json.h"

const char *const tool_level_names[] = {"mended", "paper", "bmrt", "rays", NULL};
static const char *const vias[SPH_VIAS] = {"direct", "flat", "curved"};

void print_levels(FILE *to, const struct sph_levels *e) {
    if (!to || !e->pixels) return;
    fprintf(to, "levels     %" PRIu64 " pixels; model off by %.4f on the mean, %.3f at most\n",
            e->pixels, e->model_mean, e->model_worst);
    for (int k = 0; k < SPH_LODS; k++)
        fprintf(to, "  %-8s level %.2f on the mean, %.2f off rays, %.1f %% within half a level\n",
                tool_level_names[k], e->mean[k], e->off[k], 100 * e->within_half[k]);
    for (int v = 0; v < SPH_VIAS; v++)
        if (e->error[v].pixels)
            fprintf(to, "  %-8s model %+.2f levels off rays, deviation %.2f, %" PRIu64 " pixels\n",
                    vias[v], e->error[v].mean, e->error[v].deviation, e->error[v].pixels);
}

static json_t *slants_json(const struct sph_slant *s) {
    json_t *list = json_array();
    for (int i = 0; i < SPH_SLANTS; i++)
        json_array_append_new(list, json_pack("{sisIsIsfsfsfsf}", "degrees", i * SPH_SLANT_STEP,
                                              "pixels", (json_int_t)s[i].pixels, "within_one",
                                              (json_int_t)s[i].near, "path", s[i].path, "path_low",
                                              s[i].path_low, "path_top", s[i].path_top, "bmrt",
                                              s[i].bmrt));
    return list;
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
    json_t *slant = json_object(), *error = json_object();
    for (int v = 0; v < SPH_VIAS; v++) {
        json_object_set_new(slant, vias[v], slants_json(e->slant[v]));
        json_object_set_new(error, vias[v],
                            json_pack("{sIsfsf}", "pixels", (json_int_t)e->error[v].pixels, "mean",
                                      e->error[v].mean, "deviation", e->error[v].deviation));
    }
    json_object_set_new(json, "slant", slant);
    json_object_set_new(json, "error", error);
    return json;
}

json_t *report_flops(const struct sph_flops *f) {
    json_t *json = json_object();
    report_count(json, "add", f->add);
    report_count(json, "mul", f->mul);
    report_count(json, "div", f->div);
    report_count(json, "sqrt", f->root);
    report_count(json, "log", f->log);
    return json;
}

json_t *level_work_json(const struct sph_level_work *work) {
    static const char *const kinds[SPH_SHAPES] = {"triangle", "plane", "sphere"};
    static const char *const ways[SPH_WAYS] = {"bmrt", "bmrt_alone", "kept", "anew", "anew_alone"};
    json_t *json = json_object();
    for (int kind = 0; kind < SPH_SHAPES; kind++) {
        json_t *entry = json_object();
        report_count(entry, "hits", work->hits[kind]);
        for (int way = 0; way < SPH_WAYS; way++)
            json_object_set_new(entry, ways[way], report_flops(&work->flops[way][kind]));
        json_object_set_new(json, kinds[kind], entry);
    }
    return json;
}
