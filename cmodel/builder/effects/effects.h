/* effects.h - which effects a scene calls for, which the machine gets, and why
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_EFFECTS_H
#define SPH_EFFECTS_H

#include "builder/build.h"
#include "builder/effects/occlude.h"
#include "builder/grid/grid.h"
#include "builder/prim/build.h"

/* A scene on the grid, and what is asked for. */
struct sph_survey {
    const struct sph_scene *scene;
    const struct sph_grid *grid;
    const struct sph_build_options *options;
    struct sph_world world;
    int refracts; /* the machine has REFRACT: rays see the inside of what is transparent */
    int passes;   /* it may have CLEAR: shadow rays pass something */
};

/* The lights that the machine gets, as indices of the scene. */
struct sph_lights {
    int count, index[SPH_MAX_LIGHTS];
    int n_shining, shining[SPH_MAX_LIGHTS]; /* those of them that may reach something */
    int called;                             /* lights of the scene that may */
};

/* EFFECTS, MAX_DEPTH, lights, and report->effects. Warns in report->warning of what is called for
 * and left out. -1 if what is asked for is impossible or memory is out. */
int sph_emit_effects(const struct sph_survey *survey, struct sph_machine *machine,
                     struct sph_build_report *report, struct sph_error *err);

/* Chooses the lights and says why; writes nothing to the machine. */
void sph_choose_lights(const struct sph_survey *survey, struct sph_lights *lights,
                       struct sph_effect_report *report);

/* REFLECT, REFRACT, SPECULAR and SUM: what hangs on materials. REFRACT before all others, since
 * what rays may see hangs on it; -1 if it cannot be. */
int sph_find_refract(const struct sph_survey *survey, struct sph_effect_report *entry,
                     struct sph_error *err);
void sph_find_reflect(const struct sph_survey *survey, struct sph_effect_report *entry);
void sph_find_specular(const struct sph_survey *survey, const struct sph_lights *lights,
                       struct sph_effect_report *entry);
void sph_find_sum(const struct sph_survey *survey, struct sph_effect_report *entry);

/* CLEAR, if there is SHADOW; and whether there is something that shadow rays may pass. */
void sph_find_clear(const struct sph_survey *survey, int shadow, struct sph_effect_report *entry);
int sph_may_pass(const struct sph_survey *survey);

/* SMOOTH: triangles with normals that are not their own. */
void sph_find_smooth(const struct sph_survey *survey, struct sph_effect_report *entry);

/* An effect for which all calls that rays of the frame do not meet: leaves it out and says so. */
void sph_leave_out(struct sph_effect_report *entry, const char *why);

/* 1 if no ray of the frame asks what primitive `prim` looks like. */
int sph_is_unmet(const struct sph_scene *scene, const struct sph_build_options *options,
                 const struct sph_grid_prim *prim);

/* How many rays may follow a primary one, one after another. */
int sph_depth(const struct sph_build_options *options);

/* Behind all other effects: MAX_DEPTH as the frame needs it where something is left out, or if the
 * core `all` follows fewer than asked; then sph_emit_camera(). */
void sph_emit_left_out(const struct sph_build_options *options, struct sph_machine *machine,
                       struct sph_build_report *report);

/* Effect CAMERA and register ONE_CAMERA: something is left out. */
void sph_emit_camera(struct sph_machine *machine, struct sph_build_report *report);

/* What `asked` makes of an effect that the scene calls for or not; entry->why tells that. */
void sph_settle(struct sph_effect_report *entry, int asked);

/* Takes back an effect that is on as asked and cannot be; `why` is the whole reason. */
void sph_drop(struct sph_effect_report *entry, const char *why);

/* The part of the effects that hangs on triangles and planes; nothing without them. */
void sph_find_facets(const struct sph_survey *survey, struct sph_effect_report *report);

/* Whether facets call for SHADOW: entry->called and why. */
void sph_find_facet_shadow(const struct sph_survey *survey, struct sph_effect_report *entry);

/* INSIDE: a facet that is near a sphere. 1 with the reason appended to entry->why, or 0. */
int sph_find_facet_inside(const struct sph_survey *survey, struct sph_effect_report *entry);

/* Light registers. */
void sph_emit_lights(const struct sph_survey *survey, const struct sph_lights *lights,
                     struct sph_machine *machine, struct sph_build_report *report);

/* Writes "file:line", or "what N" (from 1) if what was generated has no line. */
struct sph_place {
    char text[560];
};
struct sph_place sph_place_of(const struct sph_scene *scene, uint32_t line, const char *what,
                              uint32_t index);
struct sph_place sph_sphere_place(const struct sph_scene *scene, uint32_t index);
struct sph_place sph_facet_place(const struct sph_survey *survey, uint32_t facet);
struct sph_place sph_light_place(const struct sph_scene *scene, int index);

/* The most that light of a colour may be; lround(32768 * c) for c limited to 0..that. */
#define SPH_COLOUR_MOST (65535.0 / SPH_COLOUR_ONE)
int32_t sph_u1_15(double c);

#endif
