/* build_auto.h - a machine in the cheapest profile that does for the scene
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_AUTO_H
#define SPH_BUILD_AUTO_H

#include "builder/profile/choose_profile.h"

/* Builds in the profile that sph_choose_profile() takes; one that cannot hold the scene gives way
 * to the next. options->profile becomes the one that did, options->widths must be NULL. 0, or -1
 * with a message. */
int sph_build_auto(const struct sph_scene *scene, struct sph_build_options *options,
                   const struct sph_keep *keep, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err);

/* What the tool builds with. choose: as above; else with the widths of the options, and a line in
 * report->warning if they miss what is to be kept. choice->estimate[options->profile] then says
 * what is expected. 0, or -1 with a message. */
int sph_build_kept(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                   const struct sph_keep *keep, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err);

#endif
