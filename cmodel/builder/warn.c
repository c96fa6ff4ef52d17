/* warn.c - see warn.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/warn.h"

#include <math.h>

#include "builder/emit.h"
#include "builder/grid/grid.h"

void sph_warn_coarse(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                     struct sph_build_report *report) {
    enum { COARSE = 4 }; /* grid units */
    if (!scene->n_spheres || report->smallest_radius >= COARSE) return;
    int finer =
        sph_grid_finer(scene, profile, axes, report->smallest_radius * report->grid_step, COARSE);
    sph_note(report->warning, sizeof report->warning,
             "%s: the smallest radius is %.2f grid units of profile %s: %s%s\n", scene->path,
             report->smallest_radius, profile->name,
             finer < 0 ? "no finer profile has 4" : "rounder with profile ",
             finer < 0 ? "" : sph_profiles[finer].name);
}

void sph_warn_eye(const struct sph_scene *scene, const struct sph_machine *machine,
                  struct sph_build_report *report) {
    const struct sph_eye *eye = &report->eye;
    if (!(eye->ahead > 0)) return;
    sph_note(
        report->warning, sizeof report->warning,
        "%s: the eye is so far away that the grid would be coarse: it is put %.4g nearer, with "
        "angle %.4g, which moves points in the picture by %.2g pixels at most\n",
        scene->path, eye->ahead, eye->angle,
        eye->off * hypot(machine->regs[SPH_REG_FRAME_W], machine->regs[SPH_REG_FRAME_H]) / 2);
}

void sph_warn_left_out(const struct sph_scene *scene, const struct sph_profile *profile,
                       const struct sph_facets *facets, struct sph_build_report *report) {
    if (facets->n_twice)
        sph_note(
            report->warning, sizeof report->warning,
            "%s:%u: the first of %u triangles that stand in the scene twice: the second is left "
            "out\n",
            scene->path, scene->facets[facets->first_twice].line, facets->n_twice);
    if (facets->n_merged)
        sph_note(report->warning, sizeof report->warning,
                 "%s:%u: the first of %u triangles that the grid of profile %s merges with others, "
                 "as does that of every finer one: they are left out\n",
                 scene->path, scene->facets[facets->first_merged].line, facets->n_merged,
                 profile->name);
    if (!facets->n_empty) return;
    sph_note(report->warning, sizeof report->warning,
             "%s:%u: the first of %u triangles that have no area on the grid of profile %s and are "
             "left out: no ray would meet them\n",
             scene->path, scene->facets[facets->first_empty].line, facets->n_empty, profile->name);
}

void sph_warn_bent(const struct sph_scene *scene, struct sph_build_report *report) {
    if (!scene->n_bent) return;
    sph_note(report->warning, sizeof report->warning,
             "%s:%u: the polygon is not flat, a corner is %.3g off its plane: it is cut into "
             "triangles that meet at an angle%s\n",
             scene->path, scene->bent_line, scene->bent,
             scene->n_bent > 1 ? "; so are others, nearer to flat" : "");
}

/* A part in words: percent, or less than a tenth of one. */
static const char *percent(uint64_t part, uint64_t all, char text[32]) {
    double of = 100.0 * (double)part / (double)all;
    snprintf(text, 32, of < 0.1 ? "less than 0.1 %%" : "%.1f %%", of);
    return text;
}

int sph_warn_cut(const struct sph_scene *scene, const struct sph_machine *machine,
                 struct sph_build_report *report, struct sph_error *err) {
    struct sph_cut *cut = &report->cut;
    char part[32];
    if (sph_cut_measure(scene, machine, cut, err)) return -1;
    if (!cut->beyond && !cut->later) return 0;
    sph_note(report->warning, sizeof report->warning,
             "%s:%u: the plane goes on beyond the grid: ", scene->path,
             scene->facets[cut->plane].line);
    if (cut->beyond)
        sph_note(report->warning, sizeof report->warning,
                 "%s of the pixels see it %.4g or farther from the eye; ",
                 percent(cut->beyond, cut->pixels, part), cut->nearest);
    if (cut->later)
        sph_note(report->warning, sizeof report->warning,
                 "about %s%s see it so in mirrors or glass; ",
                 percent(cut->later, cut->sample, part), cut->beyond ? " more" : " of the pixels");
    sph_note(report->warning, sizeof report->warning,
             "its light may be off there by more than 8 of 255, and so is an image on it\n");
    return 0;
}
