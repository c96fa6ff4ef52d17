/* opaque.h - what the opaque types of sphaera.h hold
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPHAERA_OPAQUE_H
#define SPHAERA_OPAQUE_H

#include <fenv.h>

#include "builder/build.h"
#include "core/frame.h"
#include "core/trail.h"
#include "machine/machine.h"
#include "scene/scene.h"
#include "sphaera/sphaera.h"

struct sphaera_scene {
    struct sph_scene scene;
};

struct sphaera_machine {
    struct sph_machine machine;
    char warning[8192]; /* as of sph_build_report */
    char why[512];      /* as of sph_choose_why(), or empty */
    struct sph_ledger ledger;
};

struct sphaera_frame {
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

/* Options of the library as build takes them, NULL: the defaults; widths: where they point to if a
 * profile is named. 0, or -1 with a message. */
int sph_api_options(const sphaera_build_options *from, struct sph_build_options *to,
                    struct sph_profile *widths, struct sph_error *err);

/* Row `number` of those of a ledger that count something; -1 if there is none. */
int sph_api_record(const struct sph_ledger *ledger, int number, sphaera_record *record);

/* The library's message as the user's; returns -1. */
int sph_api_failed(const struct sph_error *from, sphaera_error *to);

#endif
