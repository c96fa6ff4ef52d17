/* left_out.c - effects that no ray of the frame asks for, though the scene does; see effects.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "machine/camera.h"

void sph_leave_out(struct sph_effect_report *entry, const char *why) {
    entry->called = 0;
    entry->left_out = 1;
    sph_note(entry->why, sizeof entry->why, "; %s", why);
}

int sph_depth(const struct sph_build_options *o) {
    int most = o->max_depth;
    return o->unmet && o->reflect == SPH_AUTO && o->unmet->depth < most ? o->unmet->depth : most;
}

int sph_is_unmet(const struct sph_scene *scene, const struct sph_build_options *o,
                 const struct sph_grid_prim *prim) {
    return o->unmet && o->unmet->prims[prim->facet ? scene->n_spheres + prim->index : prim->index];
}

void sph_emit_camera(struct sph_machine *m, struct sph_build_report *report) {
    struct sph_effect_report *entry = &report->effects[SPH_REPORT_CAMERA];
    m->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_CAMERA;
    m->regs[SPH_REG_ONE_CAMERA] = sph_camera_sum(m);
    entry->on = entry->called = 1;
    snprintf(entry->why, sizeof entry->why, "something is left out: another camera is refused");
}

void sph_emit_left_out(const struct sph_build_options *o, struct sph_machine *m,
                       struct sph_build_report *report) {
    int most = m->regs[SPH_REG_MAX_DEPTH], any = o->unmet && o->unmet->fewer;
    snprintf(report->effects[SPH_REPORT_CAMERA].why, sizeof report->effects->why,
             "all that rays may meet is there: any will do");
    for (int i = 0; i < SPH_REPORTS; i++)
        any |= report->effects[i].left_out;
    if (sph_depth(o) < most && (any || most > sph_parts[SPH_PART_REFLECT].all)) {
        struct sph_effect_report *reflect = &report->effects[SPH_REPORT_REFLECT];
        m->regs[SPH_REG_MAX_DEPTH] = sph_depth(o);
        if (reflect->on) reflect->on = reflect->called = sph_depth(o);
        sph_note(report->left_out, sizeof report->left_out,
                 "depths beyond %d: no ray of this frame goes there\n", sph_depth(o));
        any = 1;
    }
    if (any) sph_emit_camera(m, report);
}
