/* pixel_rays.c - see pixel_rays.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/pixel_rays.h"

#include <inttypes.h>
#include <math.h>

#include "engine/render_pixel.h"

static const char *const kinds[] = {"primary", "shadow", "reflected", "refracted"};

int pixel_rays(const struct sph_machine *m, int x, int y, struct sph_ray_log *log,
               struct sph_stages *stages, struct sph_error *err) {
    struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_TREE, .threads = 1, .log = log, .stages = stages};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    sph_render_pixel(m, &how, x, y, &counters, &errors, NULL);
    if (stages) sph_stages_sort(stages);
    return log->full || (stages && stages->full)
               ? sph_fail(err, "%s: no memory for the rays of a pixel", m->name)
               : 0;
}

/* From the origin to the hit, grid units. */
static double distance(const struct sph_logged *l) {
    return (double)l->hit.key / sqrt((double)l->ray.a);
}

void print_rays(FILE *to, const struct sph_ray_log *log) {
    if (!to) return;
    fprintf(to, "rays     %d\n", log->n);
    for (int i = 0; i < log->n; i++) {
        const struct sph_logged *l = &log->rays[i];
        int shadow = l->ray.kind == SPH_SHADOW;
        fprintf(to, "  %*s%-9s ", 2 * (l->depth + shadow), "", kinds[l->ray.kind]);
        if (shadow)
            fprintf(to, "light %s", l->hit.key ? "hidden" : "seen");
        else if (l->hit.key)
            fprintf(to, "id %u%s, key %" PRIu64 ", distance %.4g", l->hit.id,
                    l->hit.far ? " from inside" : "", l->hit.key, distance(l));
        else
            fprintf(to, "nothing");
        fprintf(to, ", %u visits\n", l->visits);
    }
}

void print_stages(FILE *to, const struct sph_machine *m, const struct sph_stages *stages) {
    char text[SPH_STAGE_TEXT];
    for (int i = 0; to && i < stages->n; i++) {
        sph_stages_text(m, &stages->lines[i], text);
        fprintf(to, "%s\n", text);
    }
}

static json_t *vector(const int64_t v[3]) {
    return json_pack("[I, I, I]", (json_int_t)v[0], (json_int_t)v[1], (json_int_t)v[2]);
}

void report_rays(json_t *report, const struct sph_ray_log *log) {
    json_t *list = json_array();
    for (int i = 0; i < log->n; i++) {
        const struct sph_logged *l = &log->rays[i];
        json_t *ray = json_object();
        report_text(ray, "kind", kinds[l->ray.kind]);
        report_add(ray, "parent", l->parent < 0 ? NULL : json_integer(l->parent));
        report_count(ray, "depth", (uint64_t)l->depth);
        report_add(ray, "org", vector(l->ray.org));
        report_add(ray, "dir", vector(l->ray.dir));
        report_count(ray, "visits", l->visits);
        report_add(ray, "hit", json_boolean(l->hit.key));
        if (l->hit.key && l->ray.kind != SPH_SHADOW) {
            report_count(ray, "id", l->hit.id);
            report_count(ray, "key", l->hit.key);
            report_add(ray, "inside", json_boolean(l->hit.far));
            report_number(ray, "distance", distance(l));
        }
        json_array_append_new(list, ray);
    }
    report_add(report, "pixel_rays", list);
}

void report_stages(json_t *report, const struct sph_machine *m, const struct sph_stages *stages) {
    json_t *list = json_array();
    char text[SPH_STAGE_TEXT];
    for (int i = 0; i < stages->n; i++) {
        sph_stages_text(m, &stages->lines[i], text);
        json_array_append_new(list, json_string(text));
    }
    report_add(report, "stages", list);
}
