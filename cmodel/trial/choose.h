/* choose.h - which widths a scene asks for: its picture drawn in some, against double precision
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cheapest profile that keeps what is asked for is taken. How far points are moved is bounded
 * before anything is drawn, dB are measured where sph_judge_cannot() has nothing against it. What
 * is drawn is counted in pixels, so that neither clock nor threads change the choice:
 * docs/design/builder.md.
 */
#ifndef SPH_TRIAL_CHOOSE_H
#define SPH_TRIAL_CHOOSE_H

#include "trial/judge.h"

struct sph_profile_choice {
    int taken;                /* of `of`: a profile, or SPH_PROFILES: widths by hand */
    int kept;                 /* it keeps what is asked for */
    const char *not_measured; /* NULL, or why not: of sph_judge_cannot() */
    struct sph_known_picture of[SPH_PROFILES + 1];
};

/* options->profile becomes the cheapest that keeps the bound, or the finest; options->widths must
 * be NULL. 0, or -1 with a message as sph_estimate(). */
int sph_choose(const struct sph_scene *scene, struct sph_build_options *options,
               const struct sph_error_bound *bound, struct sph_profile_choice *choice,
               struct sph_error *err);

/* Why it was taken, one line without its end. */
void sph_choose_why(const struct sph_profile_choice *choice, const struct sph_error_bound *bound,
                    char *text, size_t size);

/* Where no tree was asked for (SPH_TREE_AUTO): that of nodes of four spheres or of four boxes which
 * costs less for this frame, in clocks of it (cycles.h) times cells of the core that the machine
 * asks for (known.h). That of sph_tree_of() stays if the other does not cost a quarter less. *why
 * says so, one line without its end. Scenes of more than SPH_TREES_PRIMS primitives, or with
 * planes, whose clocks in boxes the counters do not tell, machines that cannot be built and cores
 * of unknown cells are left to sph_build(), and *why is empty. why: NULL if nobody asks. 0, or -1
 * with a message if memory is short. */
int sph_measure_trees(const struct sph_scene *scene, struct sph_build_options *options, char *why,
                      size_t size, struct sph_error *err);

enum { SPH_TREES_PRIMS = 4096 };

/* sph_choose() if choose is set, then sph_build(); a profile that cannot hold the scene gives way
 * to the next. 0, or -1 with a message. */
int sph_build_chosen(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                     const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                     struct sph_machine *machine, struct sph_build_report *report,
                     struct sph_error *err);

/* Appends to report->warning if the bound is missed: by how much, which profile would do, or what
 * would help (help.h). Widths that were not chosen are estimated first, and measured if that misses
 * it. 0, or -1 with a message as sph_estimate(). */
int sph_choose_tell(const struct sph_scene *scene, const struct sph_build_options *options,
                    int choose, const struct sph_error_bound *bound,
                    struct sph_profile_choice *choice, struct sph_build_report *report,
                    struct sph_error *err);

/* Both: what the tool builds with. */
int sph_build_kept(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err);

#endif
