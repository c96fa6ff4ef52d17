/* opaque.h - what the opaque types of sphaera.h hold, and what its functions share
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPHAERA_OPAQUE_H
#define SPHAERA_OPAQUE_H

#include <fenv.h>

#include "builder/build.h"
#include "core/frame.h"
#include "core/trail.h"
#include "fast/fast.h"
#include "machine/machine.h"
#include "scene/scene.h"
#include "scene/window.h"
#include "sphaera/sphaera.h"
#include "trial/choose.h"

struct sphaera_scene {
    struct sph_scene scene;
};

struct sphaera_machine {
    struct sph_machine machine;
    struct sph_api_refit *refit; /* NULL, or what others of its tree are made of */
    sphaera_machine *first;      /* whose `refit` made this one, and which it holds; or NULL */
    double tree_cost;            /* as of sph_build_report */
    char warning[8192];          /* as of sph_build_report */
    char why[512];               /* as of sph_choose_why(), or empty */
    char core[256];              /* as of sph_machine_core() */
    struct sph_ledger ledger;
    int samples;           /* rays a pixel across and down that it was built for */
    int holders;           /* who uses it: the caller, and each of its frames */
    struct sph_fast *fast; /* NULL until rays are sent, or if its tree is not known there */
};

struct sphaera_frame {
    sphaera_machine *machine;
    struct sph_frame frame;
    struct sph_trail *trails; /* one for each pixel */
    struct sph_counters counters;
    uint32_t errors;
};

/* From here to the end of the function it counts in the default floating-point environment, which
 * the caller's takes the place of again. */
#define SPH_API_ENVIRONMENT                                                                        \
    fenv_t environment __attribute__((cleanup(sph_api_leave)));                                    \
    sph_api_enter(&environment)
void sph_api_enter(fenv_t *callers);
void sph_api_leave(fenv_t *callers);

/* Is an argument NULL that must not be? Then *to says so by its name. */
int sph_api_null(const void *argument, const char *name, sphaera_error *to);

/* Position of a word in choices, which end with NULL; -1 with "name is 'word', none of ...". */
int sph_api_choice(const char *name, const char *word, const char *const *choices,
                   struct sph_error *err);

/* Is value within low..high? 0, or -1 with "name is 7, not 0 to 5". */
int sph_api_whole(const char *name, int64_t value, int64_t low, int64_t high,
                  struct sph_error *err);
int sph_api_real(const char *name, double value, double low, double high, struct sph_error *err);

enum { SPH_API_THREADS = 1024 }; /* that may be asked for */

/* Progress as the user wants it told, and whether he has ended the call. */
struct sph_api_told {
    sphaera_progress progress;
    void *user;
    int end;
};
int sph_api_show(void *told, int done, int all); /* as of sph_progress */

/* What the user asked build for, as the builder takes it. */
struct sph_api_build {
    struct sph_build_options o;
    struct sph_profile widths;    /* where o.widths points to, if a profile is named */
    struct sph_error_bound bound; /* of "auto" */
    struct sph_aim aim;           /* of the scene's camera */
    int met, samples, refit;
    struct sph_api_told told;
    struct sph_progress progress; /* where o.progress points to */
};

/* How a machine was built that keeps its tree. */
struct sph_api_refit {
    struct sph_api_build how; /* profile, tree and size as they were chosen */
    struct sph_kept_tree kept;
};

/* from NULL: the defaults. 0, or -1 with a message that names the option; *to must not move. */
int sph_api_options(const sphaera_build_options *from, struct sph_api_build *to,
                    struct sph_error *err);

/* Who is told how far a build is, NULL: nobody; *to must not move. */
void sph_api_tell(sphaera_progress progress, void *user, struct sph_api_build *to);

/* The scene as its camera is to see it: *to has all of the scene's memory, which stays the scene's.
 * Sets the size of the frame: what was asked for, or the scene's, times the samples. 0, or -1. */
int sph_api_frame(const struct sph_scene *scene, struct sph_api_build *b, struct sph_scene *to,
                  struct sph_error *err);

/* A new machine, empty, that one holds; NULL with a message if memory is out. */
sphaera_machine *sph_api_machine(struct sph_error *err);

/* One more holds it; the last who frees it ends it. */
sphaera_machine *sph_api_hold(const sphaera_machine *machine);

/* Its decoded tree, made when it is first asked for; NULL: as of sph_fast_new(). */
const struct sph_fast *sph_api_fast(const sphaera_machine *machine);

/* Row `number` of those of a ledger that count something; -1 if there is none. */
int sph_api_record(const struct sph_ledger *ledger, int number, sphaera_record *record);

/* The library's message as the user's; returns -1. */
int sph_api_failed(const struct sph_error *from, sphaera_error *to);

#endif
