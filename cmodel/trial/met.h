/* met.h - builds what the rays of a frame meet, and not all that the scene names
 * SPDX-License-Identifier: Apache-2.0
 *
 * A machine with everything draws every pixel of the frame once by the fast walk, and what its rays
 * met is noted. The machine without the rest draws the same frame: docs/design/builder.md.
 */
#ifndef SPH_TRIAL_MET_H
#define SPH_TRIAL_MET_H

#include "trial/choose.h"

/* Pixels that are drawn at most, of all frames together; where there are more, all is kept. */
enum { SPH_CENSUS_PIXELS = 1 << 22 };

/* What rays of some frames of a scene met. All zeros: of none. */
struct sph_census {
    uint32_t n;                      /* primitives of the scene: spheres, then facets */
    uint32_t *prims;                 /* of each: SPH_MET_SHADED, and by lights of the scene */
    uint32_t lights;                 /* of the scene that the machines have, a bit each */
    uint32_t lit, blocked;           /* as in core/met.h, by lights of the scene */
    uint32_t inside, passed, depths; /* the same */
    uint64_t pixels;
    const char *kept; /* NULL, or why all is kept */
    /* what sph_census_unmet() has made of it */
    uint8_t *shaded;
    struct sph_unmet unmet;
};

/* Draws a frame: the machine was built of the scene with these options, whose `numbers` are set and
 * `unmet` is not. 0, or -1 with a message if memory is out. */
int sph_census_add(struct sph_census *c, const struct sph_scene *scene,
                   const struct sph_build_options *options, const struct sph_machine *machine,
                   const struct sph_build_report *report, struct sph_error *err);

/* What the frames do not meet, for sph_build_options; NULL if all is kept. The lights that light
 * nothing become black in *scene, unless their number was asked for. */
const struct sph_unmet *sph_census_unmet(struct sph_census *c, struct sph_scene *scene,
                                         const struct sph_build_options *options);

void sph_census_free(struct sph_census *c);

/* sph_build_kept() without what the rays of the frame do not meet: effects, lights, and what would
 * make the grid coarse. report->left_out says what besides effects and lights. options->numbers
 * gets numbers of the whole scene. */
int sph_build_met(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                  const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                  struct sph_machine *machine, struct sph_build_report *report,
                  struct sph_error *err);

#endif
