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

int sph_build_kept(const struct sph_scene *scene, struct sph_build_options *options, int choose,
                   const struct sph_keep *keep, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err) {
    if (choose) return sph_build_auto(scene, options, keep, choice, machine, report, err);
    *choice = (struct sph_profile_choice){.first = options->profile};
    if (sph_build(scene, options, machine, report, err)) return -1;
    if (!sph_check_profile(scene, options, keep, &choice->estimate[options->profile],
                           report->warning, sizeof report->warning, err))
        return 0;
    sph_machine_free(machine);
    return -1;
}
