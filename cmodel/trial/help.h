/* help.h - what would make a picture that no profile draws well enough better, tried
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TRIAL_HELP_H
#define SPH_TRIAL_HELP_H

#include "trial/judge.h"

enum { SPH_HELPS = 3 }; /* that are told at most */

/* Draws the scene in other ways: with widths of one's own, fewer reflections, far lights nearer, a
 * large sphere smaller, a plane with an end, each against double precision. Appends a line to
 * report->warning for each of those that help most, with its figures; now: what the picture is like
 * as it is. 0, or -1 with a message if memory is out. */
int sph_help(const struct sph_scene *scene, const struct sph_build_options *options,
             const struct sph_error_bound *bound, const struct sph_known_picture *now,
             struct sph_build_report *report, struct sph_error *err);

#endif
