/* spread.c - see builder/texture/spread.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/texture/spread.h"

#include <math.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/prim/build.h"

uint32_t sph_bend_of(int64_t radius) {
    return (uint32_t)(SPH_BEND_ONE + lround(2 * log2((double)radius)));
}

/* Whether rays leave what has this material. */
static int leaves(const struct sph_machine *m, const struct sph_material *material) {
    return (sph_machine_effect(m, SPH_EFFECT_REFLECT) && sph_material_kr(material)) ||
           (sph_machine_effect(m, SPH_EFFECT_REFRACT) && sph_material_kt(material));
}

/* Bends of the spheres that rays leave, if `put`; how many, which of the scene is the first, and
 * how many of them rays of the frame meet. */
static uint32_t bends(const struct sph_scene *scene, const struct sph_plants *plants,
                      const struct sph_build_options *o, struct sph_machine *m, int put,
                      uint32_t *first, uint32_t *met) {
    uint32_t n = *met = 0;
    for (uint32_t id = 0; id < plants->n_spheres; id++) {
        struct sph_grid_prim prim =
            sph_grid_prim_of(plants->balls, plants->n_spheres, plants->facets, id);
        if (!leaves(m, &scene->materials[sph_grid_appearance(scene, &prim).material])) continue;
        if (!n++) *first = prim.index;
        *met += !sph_is_unmet(scene, o, &prim);
        if (put)
            sph_field_set(sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id), SPH_PRIM_BEND_LSB,
                          SPH_PRIM_BEND_BITS, sph_bend_of(prim.ball->r));
    }
    return n;
}

void sph_emit_spread(const struct sph_scene *scene, const struct sph_plants *plants,
                     const struct sph_build_options *options, struct sph_machine *machine,
                     struct sph_build_report *report) {
    struct sph_effect_report *entry = &report->effects[SPH_REPORT_SPREAD];
    int textured = sph_machine_effect(machine, SPH_EFFECT_TEXTURE);
    uint32_t first = 0, met, n = bends(scene, plants, options, machine, 0, &first, &met);
    entry->called = textured && n;
    if (!textured)
        sph_note(entry->why, sizeof entry->why, "no image is shown");
    else if (!n)
        sph_note(entry->why, sizeof entry->why, "no ray leaves a sphere");
    else
        sph_note(entry->why, sizeof entry->why, "rays leave %u spheres, the first is %s", n,
                 sph_sphere_place(scene, first).text);
    if (entry->called && !met) sph_leave_out(entry, "no ray of this frame meets one");
    sph_settle(entry, options->spread);
    if (entry->on && !textured) sph_drop(entry, "it needs texture, and no image is shown");
    if (entry->on < entry->called)
        sph_note(report->warning, sizeof report->warning, "%s: spread off: %s\n", scene->path,
                 entry->why);
    if (!entry->on) return;
    bends(scene, plants, options, machine, 1, &first, &met);
    machine->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_SPREAD;
}
