/* choose_profile.h - which widths a scene asks for, and what those given will cost its picture
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_CHOOSE_PROFILE_H
#define SPH_CHOOSE_PROFILE_H

#include "builder/profile/estimate.h"

/* What a picture must not miss: how far a point that the eye sees is moved at most, in pixels, and
 * dB of its colours. */
struct sph_error_bound {
    double pixels, psnr;
};

#define SPH_ERROR_BOUND_PIXELS 0.125
#define SPH_ERROR_BOUND_PSNR 45.0

struct sph_profile_choice {
    int first; /* the cheapest that keeps it, or the finest */
    int kept;  /* it keeps it */
    struct sph_estimate estimate[SPH_PROFILES];
};

/* Estimates every profile. 0, or -1 with a message as sph_estimate(). */
int sph_choose_profile(const struct sph_scene *scene, const struct sph_build_options *options,
                       const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                       struct sph_error *err);

/* Why profile p was taken, one line without its end. */
void sph_profile_why(const struct sph_profile_choice *choice, const struct sph_error_bound *bound,
                     int p, char *text, size_t size);

/* Estimates the widths of the options, and appends a line to warning if they miss what is to be
 * kept. 0, or -1 with a message as sph_estimate(). */
int sph_check_profile(const struct sph_scene *scene, const struct sph_build_options *options,
                      const struct sph_error_bound *bound, struct sph_estimate *mine, char *warning,
                      size_t size, struct sph_error *err);

/* Builds in the profile that sph_choose_profile() takes; one that cannot hold the scene gives way
 * to the next. options->profile becomes the one that did, options->widths must be NULL. 0, or -1
 * with a message. */
int sph_build_auto(const struct sph_scene *scene, struct sph_build_options *options,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err);

/* What the tool builds with. choose: as above; else with the widths of the options, and a line in
 * report->warning if they miss what is to be kept. choice->estimate[options->profile] then says
 * what is expected. 0, or -1 with a message. */
int sph_build_kept(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err);

#endif
