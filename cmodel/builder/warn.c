/* warn.c - see warn.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/warn.h"

#include <math.h>
#include <stdlib.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/grid/grid.h"
#include "scene/record.h"

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

int sph_note_left_out(const struct sph_scene *scene, const struct sph_facets *facets,
                      struct sph_build_report *report, struct sph_error *err) {
    const struct {
        enum sph_read kind;
        uint32_t n, first;
    } out[] = {{SPH_READ_TRIANGLE_TWICE, facets->n_twice, facets->first_twice},
               {SPH_READ_TRIANGLE_GRID, facets->n_merged, facets->first_merged},
               {SPH_READ_NO_AREA_GRID, facets->n_empty, facets->first_empty}};
    for (size_t i = 0; i < sizeof out / sizeof *out; i++)
        if (out[i].n && sph_ledger_add(&report->ledger, out[i].kind, out[i].n, scene->path,
                                       scene->facets[out[i].first].line, 0, err))
            return -1;
    if (!facets->n_twice && !facets->n_merged && !facets->n_empty) return 0;
    uint8_t *left = calloc(scene->n_facets, 1);
    if (!left) return sph_fail(err, "out of memory for %u triangles", scene->n_facets);
    for (uint32_t i = 0; i < facets->n; i++)
        left[facets->list[i].scene] = 1;
    struct sph_recount recount = {.ledger = &report->ledger};
    for (uint32_t i = 0; i < scene->n_facets; i++)
        sph_recount_facet(&recount, &scene->facets[i], left[i]);
    sph_recount_facet(&recount, NULL, 0);
    free(left);
    return 0;
}

/* Whether a colour of light is more or less than registers hold. */
static int beyond(const double rgb[3]) {
    for (int i = 0; i < 3; i++)
        if (rgb[i] < 0 || rgb[i] > SPH_COLOUR_MOST) return 1;
    return 0;
}

int sph_note_images(const struct sph_scene *scene, const struct sph_mip *mips,
                    struct sph_ledger *ledger, struct sph_error *err) {
    for (uint32_t i = 0; mips && i < scene->n_textures; i++) {
        const struct sph_texture *t = &scene->textures[i];
        int told = !mips[i].decoded || t->colours != SPH_COLOURS_OF_FILE;
        if (sph_ledger_note(ledger, told ? SPH_READ_IMAGE : SPH_READ_SRGB, scene->path, t->line,
                            err))
            return -1;
    }
    return 0;
}

int sph_note_limited(const struct sph_scene *scene, struct sph_build_report *report,
                     struct sph_error *err) {
    for (int l = 0; l <= scene->n_lights; l++) {
        int ambient = l == scene->n_lights;
        if (beyond(ambient ? scene->ambient : scene->lights[l].rgb) &&
            sph_ledger_note(&report->ledger, SPH_READ_LIGHT_LIMITED, scene->path,
                            ambient ? 0 : scene->lights[l].line, err))
            return -1;
    }
    return 0;
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
