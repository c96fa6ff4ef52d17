/* machine.c - machines of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "trial/choose.h"
#include "image/mips.h"
#include "sphaera/opaque.h"
#include "texture/lookup.h"
#include "validate/describe.h"
#include "validate/validate.h"

void sphaera_build_init(sphaera_build_options *options) {
    *options = (sphaera_build_options){.size = sizeof *options,
                                       .profile = "auto",
                                       .accel = "auto",
                                       .depth = 2,
                                       .shadow = SPHAERA_AUTO,
                                       .reflect = SPHAERA_AUTO,
                                       .refract = SPHAERA_AUTO,
                                       .specular = SPHAERA_AUTO,
                                       .texture = SPHAERA_AUTO};
}

int sph_api_options(const sphaera_build_options *from, struct sph_build_options *to,
                    struct sph_profile *widths, struct sph_error *err) {
    static const struct {
        const char *name;
        int tree;
    } accels[] = {{"auto", SPH_TREE_AUTO},
                  {"bvh4", SPH_TREE_REINSERTED},
                  {"bih", SPH_TREE_BIH},
                  {"brute", SPH_TREE_BRUTE},
                  {"box4", SPH_TREE_BOX4}};
    enum { ACCELS = sizeof accels / sizeof *accels };
    int accel = 0;
    sphaera_build_options defaults;
    sphaera_build_init(&defaults);
    if (!from) from = &defaults;
    *to = (struct sph_build_options)SPH_BUILD_DEFAULT;
    if (from->size != sizeof *from || !from->profile || !from->accel)
        return sph_fail(err, "build options: not those of sphaera_build_init()");
    while (accel < ACCELS && strcmp(accels[accel].name, from->accel) != 0)
        accel++;
    if (accel == ACCELS)
        return sph_fail(err, "accel is '%.40s', none of auto, bvh4, bih, brute, box4", from->accel);
    if (from->depth < 0 || from->depth > SPH_MAX_DEPTH)
        return sph_fail(err, "depth is %d, not 0 to %d", from->depth, SPH_MAX_DEPTH);
    if (from->width < 0 || from->height < 0 || from->width > SPH_MAX_SIDE ||
        from->height > SPH_MAX_SIDE)
        return sph_fail(err, "size is %dx%d, sides are 1 to %d, or 0", from->width, from->height,
                        SPH_MAX_SIDE);
    const struct {
        const char *name;
        int value;
    } choices[] = {{"shadow", from->shadow},
                   {"reflect", from->reflect},
                   {"refract", from->refract},
                   {"specular", from->specular},
                   {"texture", from->texture}};
    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++)
        if (choices[i].value < SPHAERA_AUTO || choices[i].value > SPHAERA_ON)
            return sph_fail(err, "%s is %d, not SPHAERA_AUTO, _OFF or _ON", choices[i].name,
                            choices[i].value);
    to->tree = accels[accel].tree;
    to->width = from->width;
    to->height = from->height;
    to->max_depth = from->depth;
    to->shadow = from->shadow;
    to->reflect = from->reflect;
    to->refract = from->refract;
    to->specular = from->specular;
    to->texture = from->texture;
    if (!strcmp(from->profile, "auto")) return 0;
    to->widths = widths;
    return sph_profile_parse(from->profile, widths, err);
}

/* Builds; report has room for what build says. */
static int build(const struct sph_scene *scene, struct sph_build_options *o,
                 struct sph_build_report *report, struct sphaera_machine *to,
                 struct sph_error *err) {
    const struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};
    struct sph_profile_choice choice;
    struct sph_mip *mips = NULL;
    if (o->texture != SPH_OFF && sph_mips_load(scene, &mips, err)) return -1;
    o->mips = mips;
    int rc = o->widths ? sph_build(scene, o, &to->machine, report, err)
                       : sph_build_kept(scene, o, 1, &bound, &choice, &to->machine, report, err);
    sph_mips_free(mips, scene->n_textures);
    _Static_assert(sizeof to->warning == sizeof report->warning, "the whole text");
    if (!rc) memcpy(to->warning, report->warning, sizeof to->warning), to->ledger = report->ledger;
    if (!rc && !o->widths) sph_choose_why(&choice, &bound, to->why, sizeof to->why);
    return rc;
}

int sphaera_build(const sphaera_scene *scene, const sphaera_build_options *options,
                  sphaera_machine **machine, sphaera_error *error) {
    if (sph_api_null(scene, "scene", error) || sph_api_null(machine, "machine", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_profile widths;
    struct sph_build_options o;
    sphaera_machine *made = calloc(1, sizeof *made);
    struct sph_build_report *report = calloc(1, sizeof *report);
    int rc = -1;
    if (!made || !report)
        sph_fail(&err, "no memory for a machine");
    else if (!sph_api_options(options, &o, &widths, &err))
        rc = build(&scene->scene, &o, report, made, &err);
    free(report);
    *machine = rc ? NULL : made;
    if (!rc) return 0;
    free(made);
    return sph_api_failed(&err, error);
}

int sphaera_machine_read(const char *path, sphaera_machine **machine, sphaera_error *error) {
    if (sph_api_null(path, "path", error) || sph_api_null(machine, "machine", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *machine = calloc(1, sizeof **machine);
    int rc = *machine ? sph_machine_read(path, &(*machine)->machine, &err)
                      : sph_fail(&err, "no memory for a machine");
    if (!rc) {
        sph_machine_note(&(*machine)->machine, path, &(*machine)->ledger);
        return 0;
    }
    free(*machine);
    *machine = NULL;
    return sph_api_failed(&err, error);
}

int sphaera_machine_write(const sphaera_machine *machine, const char *path, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(path, "path", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    return sph_machine_write(&machine->machine, path, &err) ? sph_api_failed(&err, error) : 0;
}

void sphaera_machine_free(sphaera_machine *machine) {
    if (machine) sph_machine_free(&machine->machine);
    free(machine);
}

int sphaera_machine_width(const sphaera_machine *machine) {
    return machine->machine.regs[SPH_REG_FRAME_W];
}

int sphaera_machine_height(const sphaera_machine *machine) {
    return machine->machine.regs[SPH_REG_FRAME_H];
}

const char *sphaera_machine_profile(const sphaera_machine *machine) {
    return machine->machine.profile.name;
}

int sphaera_machine_record(const sphaera_machine *machine, int number, sphaera_record *record) {
    return sph_api_record(&machine->ledger, number, record);
}

const char *sphaera_machine_warning(const sphaera_machine *machine) {
    return machine->warning;
}

const char *sphaera_machine_why(const sphaera_machine *machine) {
    return machine->why;
}
