/* choose_profile.c - see choose_profile.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/profile/choose_profile.h"

#include <stdio.h>
#include <string.h>

#include "builder/emit.h"

static int within(const struct sph_estimate *e, const struct sph_error_bound *bound) {
    return e->fits && e->pixels <= bound->pixels && e->psnr >= bound->psnr;
}

int sph_choose_profile(const struct sph_scene *scene, const struct sph_build_options *o,
                       const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                       struct sph_error *err) {
    struct sph_estimate *of = choice->estimate;
    *choice = (struct sph_profile_choice){.first = SPH_PROFILES - 1};
    if (sph_estimate(scene, o, sph_profiles, SPH_PROFILES, of, err)) return -1;
    for (int p = SPH_PROFILES - 1; p >= 0; p--)
        if (within(&of[p], bound)) choice->first = p, choice->kept = 1;
    return 0;
}

/* "0.0123 pixels off, 47.1 dB" */
static const char *says(const struct sph_estimate *e, char text[64]) {
    snprintf(text, 64, "%.2g pixels off, %.1f dB", e->pixels, e->psnr);
    return text;
}

/* The widths miss what is to be kept: how far, and which profile would not. */
static void warn(const struct sph_scene *scene, const struct sph_build_options *o,
                 const struct sph_estimate *mine, const struct sph_profile_choice *choice,
                 const struct sph_error_bound *bound, char *text, size_t size) {
    const struct sph_estimate *best = &choice->estimate[choice->first];
    char is[64];
    int better = choice->kept || (best->fits && best->psnr > mine->psnr);
    sph_note(text, size,
             "%s: %s expected of profile %s, which misses %g pixels, %g dB: ", scene->path,
             says(mine, is), sph_build_profile(o)->name, bound->pixels, bound->psnr);
    if (better)
        sph_note(text, size, "profile %s %s, %s\n", sph_profiles[choice->first].name,
                 choice->kept ? "would do" : "comes nearest", says(best, is));
    else
        sph_note(text, size, "no profile would do\n");
}

int sph_check_profile(const struct sph_scene *scene, const struct sph_build_options *o,
                      const struct sph_error_bound *bound, struct sph_estimate *mine, char *warning,
                      size_t size, struct sph_error *err) {
    struct sph_profile_choice choice;
    if (sph_estimate(scene, o, sph_build_profile(o), 1, mine, err)) return -1;
    if (!mine->fits || within(mine, bound)) return 0;
    if (sph_choose_profile(scene, o, bound, &choice, err)) return -1;
    warn(scene, o, mine, &choice, bound, warning, size);
    return 0;
}

void sph_profile_why(const struct sph_profile_choice *choice, const struct sph_error_bound *bound,
                     int p, char *text, size_t size) {
    char is[64];
    const struct sph_estimate *e = choice->estimate;
    text[0] = 0;
    sph_note(text, size, "%s%s: %s expected, %s %g pixels, %g dB", sph_profiles[p].name,
             choice->kept ? "" : ", the finest", says(&e[p], is),
             choice->kept ? "within" : "which misses", bound->pixels, bound->psnr);
    if (p && e[p - 1].fits)
        sph_note(text, size, "; of %s %s", sph_profiles[p - 1].name, says(&e[p - 1], is));
}

int sph_build_auto(const struct sph_scene *scene, struct sph_build_options *options,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err) {
    if (sph_choose_profile(scene, options, bound, choice, err)) return -1;
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
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err) {
    if (choose) return sph_build_auto(scene, options, bound, choice, machine, report, err);
    *choice = (struct sph_profile_choice){.first = options->profile};
    if (sph_build(scene, options, machine, report, err)) return -1;
    if (!sph_check_profile(scene, options, bound, &choice->estimate[options->profile],
                           report->warning, sizeof report->warning, err))
        return 0;
    sph_machine_free(machine);
    return -1;
}
