/* left_out.c - effects that no ray of the frame asks for, though the scene does; see effects.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/smooth.h"

void sph_leave_out(struct sph_effect_report *entry, const char *why) {
    entry->called = 0;
    entry->left_out = 1;
    sph_note(entry->why, sizeof entry->why, "; %s", why);
}

int sph_is_unmet(const struct sph_scene *scene, const struct sph_build_options *o,
                 const struct sph_grid_prim *prim) {
    return o->unmet && o->unmet->prims[prim->facet ? scene->n_spheres + prim->index : prim->index];
}

/* Whether a primitive asks for an effect that was left out. */
static int asks(const struct sph_scene *scene, const struct sph_grid_prim *prim,
                const struct sph_effect_report *e) {
    struct sph_grid_appearance look = sph_grid_appearance(scene, prim);
    const struct sph_material *m = &scene->materials[look.material];
    return (e[SPH_REPORT_REFLECT].left_out && sph_material_kr(m)) ||
           (e[SPH_REPORT_REFRACT].left_out && sph_material_kt(m)) ||
           (e[SPH_REPORT_SPECULAR].left_out && sph_material_ks(m)) ||
           (e[SPH_REPORT_SUM].left_out && m->sum.on) ||
           (e[SPH_REPORT_TEXTURE].left_out && look.texture) ||
           (e[SPH_REPORT_SMOOTH].left_out && prim->facet &&
            sph_smooth_bends(&scene->facets[prim->index]));
}

void sph_emit_left_out(const struct sph_survey *s, struct sph_machine *m,
                       const struct sph_build_report *report) {
    const struct sph_world *w = &s->world;
    if (!s->options->unmet) return;
    for (int i = 0; i < SPH_REPORTS; i++)
        m->regs[SPH_REG_ONE_CAMERA] |= report->effects[i].left_out;
    for (uint32_t id = 0; id < w->n + w->facets->n; id++) {
        struct sph_grid_prim prim = sph_grid_prim_of(w->balls, w->n, w->facets, id);
        if (sph_is_unmet(s->scene, s->options, &prim) && asks(s->scene, &prim, report->effects))
            sph_field_set(sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id),
                          SPH_PRIM_LEFT_OUT_LSB, SPH_PRIM_LEFT_OUT_BITS, 1);
    }
}
