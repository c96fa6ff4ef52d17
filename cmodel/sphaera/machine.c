/* machine.c - machines of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "trial/choose.h"
#include "trial/met.h"
#include "image/mips.h"
#include "sphaera/opaque.h"
#include "validate/describe.h"
#include "validate/validate.h"

sphaera_machine *sph_api_machine(struct sph_error *err) {
    sphaera_machine *made = calloc(1, sizeof *made);
    if (!made) sph_fail(err, "no memory for a machine");
    if (made) made->holders = made->samples = 1, made->tree_cost = 1;
    return made;
}

sphaera_machine *sph_api_hold(const sphaera_machine *machine) {
    sphaera_machine *m = (sphaera_machine *)(uintptr_t)machine; /* what is counted, nobody sees */
    __atomic_fetch_add(&m->holders, 1, __ATOMIC_RELAXED);
    return m;
}

static void refit_free(struct sph_api_refit *refit) {
    if (refit) sph_kept_free(&refit->kept);
    free(refit);
}

void sphaera_machine_free(sphaera_machine *machine) {
    if (!machine || __atomic_sub_fetch(&machine->holders, 1, __ATOMIC_ACQ_REL)) return;
    sph_fast_free(machine->fast);
    sph_machine_free(&machine->machine);
    refit_free(machine->refit);
    sphaera_machine_free(machine->first);
    free(machine);
}

const struct sph_fast *sph_api_fast(const sphaera_machine *machine) {
    struct sph_fast **place = &((sphaera_machine *)(uintptr_t)machine)->fast, *none = NULL;
    struct sph_fast *fast = __atomic_load_n(place, __ATOMIC_ACQUIRE);
    if (fast) return fast;
    fast = sph_fast_new(&machine->machine, SPH_FAST_BEST);
    if (!fast ||
        __atomic_compare_exchange_n(place, &none, fast, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE))
        return fast;
    sph_fast_free(fast); /* another thread was first */
    return none;
}

/* Notes how the machine was built whose tree is in refit->kept. */
static void note(const struct sph_api_build *b, const struct sph_machine *m,
                 struct sph_api_refit *refit) {
    refit->how = *b;
    struct sph_build_options *o = &refit->how.o;
    refit->how.widths = m->profile;
    o->tree = refit->kept.kind;
    o->width = m->regs[SPH_REG_FRAME_W] / b->samples;
    o->height = m->regs[SPH_REG_FRAME_H] / b->samples;
    o->later = 1;
}

/* Builds; report has room for what build says. */
static int build(const struct sph_scene *given, struct sph_api_build *b, struct sph_kept_tree *kept,
                 struct sph_build_report *report, sphaera_machine *to, struct sph_error *err) {
    struct sph_profile_choice choice;
    struct sph_mip *mips = NULL;
    struct sph_scene aimed, *scene = &aimed;
    int any = !b->o.widths, rc;
    if (sph_api_frame(given, b, scene, err)) return -1;
    if (b->o.texture != SPH_OFF && sph_mips_load(scene, &mips, err)) return -1;
    b->o.mips = mips;
    rc = sph_measure_trees(scene, &b->o, NULL, 0, err);
    b->o.kept = kept;
    if (!rc)
        rc = b->met
                 ? sph_build_met(scene, &b->o, any, &b->bound, &choice, &to->machine, report, err)
             : any ? sph_build_kept(scene, &b->o, 1, &b->bound, &choice, &to->machine, report, err)
                   : sph_build(scene, &b->o, &to->machine, report, err);
    sph_mips_free(mips, scene->n_textures);
    if (rc) return -1;
    if (b->told.end) {
        sph_machine_free(&to->machine);
        return sph_fail(err, "cancelled");
    }
    _Static_assert(sizeof to->warning == sizeof report->warning, "the whole text");
    memcpy(to->warning, report->warning, sizeof to->warning);
    to->ledger = report->ledger;
    to->samples = b->samples;
    to->tree_cost = report->tree_cost;
    if (any) sph_choose_why(&choice, &b->bound, to->why, sizeof to->why);
    return 0;
}

/* The machine of a scene; kept NULL, or the tree to refit. */
static int make(const sphaera_scene *scene, struct sph_api_build *b, struct sph_kept_tree *kept,
                sphaera_machine **machine, struct sph_error *err) {
    sphaera_machine *made = sph_api_machine(err);
    if (!made) return -1;
    struct sph_api_refit *refit = b->refit && !kept ? calloc(1, sizeof *refit) : NULL;
    struct sph_build_report *report = calloc(1, sizeof *report);
    if (refit) refit->kept.how = SPH_REFIT_KEEP, kept = &refit->kept;
    int rc = report && (kept || !b->refit) ? build(&scene->scene, b, kept, report, made, err)
                                           : sph_fail(err, "no memory for a machine");
    free(report);
    if (!rc) {
        sph_machine_core(&made->machine, made->core, sizeof made->core);
        if (refit) note(b, &made->machine, refit);
        made->refit = refit;
        *machine = made;
        return 0;
    }
    refit_free(refit);
    free(made);
    if (b->told.end) snprintf(err->text, sizeof err->text, "cancelled");
    return -1;
}

int sphaera_build(const sphaera_scene *scene, const sphaera_build_options *options,
                  sphaera_machine **machine, sphaera_error *error) {
    if (sph_api_null(scene, "scene", error) || sph_api_null(machine, "machine", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_api_build b;
    *machine = NULL;
    int rc = sph_api_options(options, &b, &err) || make(scene, &b, NULL, machine, &err);
    return rc ? sph_api_failed(&err, error) : 0;
}

int sphaera_refit(const sphaera_scene *scene, const sphaera_machine *machine,
                  sphaera_progress progress, void *user, sphaera_machine **moved,
                  sphaera_error *error) {
    if (sph_api_null(scene, "scene", error) || sph_api_null(machine, "machine", error) ||
        sph_api_null(moved, "moved", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    const sphaera_machine *first = machine->first ? machine->first : machine;
    *moved = NULL;
    if (!first->refit) {
        sph_fail(&err, "%.400s: the machine keeps no tree to refit: option `refit` of build",
                 machine->machine.name);
        return sph_api_failed(&err, error);
    }
    struct sph_api_build b = first->refit->how;
    struct sph_kept_tree kept = first->refit->kept; /* its arrays are read alone */
    kept.how = SPH_REFIT_ONLY;
    b.o.widths = &b.widths;
    sph_api_tell(progress, user, &b);
    if (make(scene, &b, &kept, moved, &err)) return sph_api_failed(&err, error);
    (*moved)->first = sph_api_hold(first);
    return 0;
}

double sphaera_machine_tree_cost(const sphaera_machine *machine) {
    return machine->tree_cost;
}

int sphaera_machine_read(const char *path, sphaera_machine **machine, sphaera_error *error) {
    if (sph_api_null(path, "path", error) || sph_api_null(machine, "machine", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    sphaera_machine *made = sph_api_machine(&err);
    *machine = NULL;
    if (!made || sph_machine_read(path, &made->machine, &err)) {
        free(made);
        return sph_api_failed(&err, error);
    }
    sph_machine_core(&made->machine, made->core, sizeof made->core);
    sph_machine_note(&made->machine, path, &made->ledger);
    *machine = made;
    return 0;
}

int sphaera_machine_write(const sphaera_machine *machine, const char *path, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(path, "path", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    return sph_machine_write(&machine->machine, path, &err) ? sph_api_failed(&err, error) : 0;
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
