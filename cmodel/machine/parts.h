/* parts.h - what a core can do, effect by effect: the list of machine.def in C
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PARTS_H
#define SPH_PARTS_H

#include "common/error.h"
#include "machine/machine.h"

/* Option of build by which a user chooses an effect. */
enum { SPH_OPTION_NONE, SPH_OPTION_WHEN, SPH_OPTION_COUNT, SPH_OPTION_OFF };

/* Effects, which scenes call for, then parts, which cores alone have; in the order of the list. */
#define SPH_PART_NAME(name, ...) SPH_PART_##name,
enum { SPH_EACH_PART(SPH_PART_NAME) SPH_PARTS };
#define SPH_REPORT_NAME(name, ...) SPH_REPORT_##name,
enum { SPH_EACH_EFFECT(SPH_REPORT_NAME) SPH_REPORTS }; /* effects alone, with the same numbers */

struct sph_part {
    const char *word, *core;  /* such as "shadow"; parameter of rt_core */
    int bit;                  /* of register EFFECTS, or -1 */
    int most, all;            /* values of the parameter: the largest, that of the core `all` */
    int option;               /* SPH_OPTION_* */
    uint32_t needs, excludes; /* masks of parts */
    int when, low, high;      /* asked for if this register (-1: none) is in low..high */
    int count;                /* register that says how many, or -1 */
    const char *about;
};
extern const struct sph_part sph_parts[SPH_PARTS];

/* How many of a part the machine asks for, SPH_PART_*; 0: it does not. */
int sph_part_asked(const struct sph_machine *m, int part);

/* Whether the effects that the machine asks for are known and go together. 0, or -1 with
 * "register EFFECTS is ...". */
int sph_validate_effects(const struct sph_machine *m, struct sph_error *err);

#endif
