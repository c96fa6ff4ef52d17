/* build_auto.c - see build_auto.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/profile/build_auto.h"

int sph_build_auto(const struct sph_scene *scene, struct sph_build_options *options,
                   const struct sph_keep *keep, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err) {
    if (sph_choose_profile(scene, options, keep, choice, err)) return -1;
    options->profile = choice->first;
    int rc = sph_build(scene, options, machine, report, err);
    while (rc && options->profile + 1 < SPH_PROFILES) {
        options->profile++;
        err->text[0] = 0;
        rc = sph_build(scene, options, machine, report, err);
    }
    return rc;
}
