/* energy.c - see energy.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/energy.h"

#include <string.h>

#include "trial/known_table.h"

static const struct {
    int counter;
    double nj;
    const char *name, *tree; /* tree: of the cores that have it, "": all */
} events[] = {SPH_KNOWN_EVENTS};
enum { EVENTS = sizeof events / sizeof *events };
_Static_assert((int)EVENTS < (int)SPH_ENERGY_PARTS, "idle clocks are a part too");

static const struct profile {
    const char *name;
    double scale, clock, with_facets; /* a clock of cores without facets, with them; 0: not known */
} profiles[] = {SPH_KNOWN_PROFILE_ENERGIES};

static const char *const words[] = {SPH_KNOWN_ENERGY_WORDS};
enum { WORDS = sizeof words / sizeof *words };

/* What a core with such a list of effects walks, as events have it. NULL: it has a word, whatever
 * its count, that no core has which was measured. */
static const char *tree_of(const char *list) {
    const char *tree = "spheres";
    for (size_t length; *list; list += length + (list[length] == '+')) {
        length = strcspn(list, "+");
        size_t letters = strcspn(list, "0123456789+");
        int i = 0;
        while (i < WORDS && (strlen(words[i]) != letters || strncmp(words[i], list, letters) != 0))
            i++;
        if (i == WORDS) return NULL;
        for (int e = 0; e < EVENTS; e++)
            if (!strcmp(events[e].tree, words[i])) tree = words[i];
    }
    return tree;
}

static void add(struct sph_energy *e, const char *name, double nj) {
    e->part[e->parts].name = name;
    e->part[e->parts++].pixel = nj;
    e->pixel += nj;
}

struct sph_energy sph_energy_expect(const struct sph_known_core *core,
                                    const struct sph_cycles *cycles) {
    struct sph_energy e = {0};
    const struct profile *of = NULL;
    for (size_t i = 0; i < sizeof profiles / sizeof *profiles; i++)
        if (!strcmp(profiles[i].name, core->profile)) of = &profiles[i];
    const char *tree = tree_of(core->effects);
    if (!of || !core->lut4eq || core->pipes != 1 || !tree) return e;
    double clock = strstr(core->effects, "facets") ? of->with_facets : of->clock;
    if (!(clock > 0)) return e;
    add(&e, "idle clock", clock * core->lut4eq * cycles->pixel);
    for (int i = 0; i < EVENTS; i++)
        if (cycles->count[events[i].counter] > 0 &&
            (!*events[i].tree || !strcmp(events[i].tree, tree)))
            add(&e, events[i].name, of->scale * events[i].nj * cycles->count[events[i].counter]);
    return e;
}
