/* pixel.c - the rays of one pixel, stage by stage: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "core/ray_log.h"
#include "core/stages.h"
#include "engine/render_pixel.h"
#include "sphaera/opaque.h"

struct sphaera_pixel {
    sphaera_machine *machine;
    struct sph_ray_log log;
    struct sph_stages stages;
    char text[SPH_STAGE_TEXT];
};

static int trace(sphaera_pixel *p, int x, int y, struct sph_error *err) {
    const struct sph_machine *m = &p->machine->machine;
    struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_TREE, .threads = 1, .log = &p->log, .stages = &p->stages};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    if (sph_api_whole("x", x, 0, m->regs[SPH_REG_FRAME_W] - 1, err) ||
        sph_api_whole("y", y, 0, m->regs[SPH_REG_FRAME_H] - 1, err))
        return -1;
    sph_render_pixel(m, &how, x, y, &counters, &errors, NULL);
    sph_stages_sort(&p->stages);
    return p->log.full || p->stages.full ? sph_fail(err, "no memory for the rays of a pixel") : 0;
}

int sphaera_pixel_trace(const sphaera_machine *machine, int x, int y, sphaera_pixel **pixel,
                        sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(pixel, "pixel", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *pixel = NULL;
    sphaera_pixel *made = calloc(1, sizeof *made);
    if (made) made->machine = sph_api_hold(machine);
    if (made ? !trace(made, x, y, &err) : sph_fail(&err, "no memory for a pixel") == 0) {
        *pixel = made;
        return 0;
    }
    sphaera_pixel_free(made);
    return sph_api_failed(&err, error);
}

void sphaera_pixel_free(sphaera_pixel *pixel) {
    if (!pixel) return;
    sph_ray_log_free(&pixel->log);
    sph_stages_free(&pixel->stages);
    sphaera_machine_free(pixel->machine);
    free(pixel);
}

int sphaera_pixel_ray(const sphaera_pixel *pixel, int number, sphaera_ray *ray) {
    static const char *const kinds[] = {"primary", "shadow", "reflected", "refracted"};
    if (!pixel || !ray || number < 0 || number >= pixel->log.n) return -1;
    const struct sph_logged *l = &pixel->log.rays[number];
    int any = l->hit.key != 0, told = any && l->ray.kind != SPH_SHADOW;
    *ray = (sphaera_ray){.kind = kinds[l->ray.kind],
                         .parent = l->parent,
                         .depth = l->depth,
                         .hit = any,
                         .inside = told && l->hit.far,
                         .id = told ? l->hit.id : SPHAERA_NONE,
                         .visits = l->visits,
                         .key = told ? l->hit.key : 0};
    memcpy(ray->origin, l->ray.org, sizeof ray->origin);
    memcpy(ray->direction, l->ray.dir, sizeof ray->direction);
    return 0;
}

static const struct sph_stage_line *line_of(const sphaera_pixel *pixel, int stage) {
    return pixel && stage >= 0 && stage < pixel->stages.n ? &pixel->stages.lines[stage] : NULL;
}

int sphaera_pixel_stage(const sphaera_pixel *pixel, int number, sphaera_stage *stage) {
    const struct sph_stage_line *l = line_of(pixel, number);
    struct sph_operand any;
    if (!l || !stage) return -1;
    *stage = (sphaera_stage){.name = sph_stages_name(l->stage),
                             .ray = l->ray < INT_MAX ? l->ray : -1,
                             .visit = l->visit,
                             .number = l->number};
    while (!sph_stages_operand(&pixel->machine->machine, l, stage->operands, &any))
        stage->operands++;
    return 0;
}

int sphaera_pixel_operand(const sphaera_pixel *pixel, int stage, int number,
                          sphaera_operand *operand) {
    const struct sph_stage_line *l = line_of(pixel, stage);
    struct sph_operand o;
    if (!l || !operand || sph_stages_operand(&pixel->machine->machine, l, number, &o)) return -1;
    *operand = (sphaera_operand){o.name, o.bits, o.sign, (uint64_t)o.word, (uint64_t)(o.word >> 64),
                                 o.value};
    return 0;
}

const char *sphaera_pixel_text(sphaera_pixel *pixel, int stage) {
    const struct sph_stage_line *l = line_of(pixel, stage);
    if (!l) return NULL;
    sph_stages_text(&pixel->machine->machine, l, pixel->text);
    return pixel->text;
}
