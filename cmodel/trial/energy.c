/* energy.c - see energy.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/energy.h"

#include <stddef.h>
#include <string.h>

#include "trial/known_table.h"

static const struct {
    int counter;
    double nj;
    const char *name;
} events[] = {SPH_KNOWN_EVENTS};
enum { EVENTS = sizeof events / sizeof *events };

static const struct profile {
    const char *name;
    double scale, clock;
} profiles[] = {SPH_KNOWN_PROFILE_ENERGIES};

/* Whether all words of the list, whatever their counts, are of cores that were measured. */
static int measured(const char *list) {
    static const char *const known[] = {"shadow", "reflect", "lights", "inside", "camera", "none"};
    for (size_t length; *list; list += length + (list[length] == '+')) {
        length = strcspn(list, "+");
        size_t letters = strcspn(list, "0123456789+"), i = 0;
        while (i < sizeof known / sizeof *known &&
               (strlen(known[i]) != letters || strncmp(known[i], list, letters) != 0))
            i++;
        if (i == sizeof known / sizeof *known) return 0;
    }
    return 1;
}

static void add(struct sph_energy *e, const char *name, double nj) {
    int i = 0;
    while (i < e->parts && strcmp(e->part[i].name, name) != 0)
        i++;
    if (i == SPH_ENERGY_PARTS) return;
    e->parts += i == e->parts;
    e->part[i].name = name;
    e->part[i].pixel += nj;
    e->pixel += nj;
}

struct sph_energy sph_energy_expect(const struct sph_known_core *core,
                                    const struct sph_cycles *cycles) {
    struct sph_energy e = {0};
    const struct profile *of = NULL;
    for (size_t i = 0; i < sizeof profiles / sizeof *profiles; i++)
        if (!strcmp(profiles[i].name, core->profile)) of = &profiles[i];
    if (!of || !core->lut4eq || core->pipes != 1 || !measured(core->effects)) return e;
    add(&e, "idle clock", of->clock * core->lut4eq * cycles->pixel);
    for (int i = 0; i < EVENTS; i++)
        add(&e, events[i].name, of->scale * events[i].nj * cycles->count[events[i].counter]);
    return e;
}
