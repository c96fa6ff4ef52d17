/* record.h - where a record stands; those of which nothing is left count as used no more
 * SPDX-License-Identifier: Apache-2.0
 *
 * A reader notes a record as used when it is read. What poses or builds the scene later, and leaves
 * primitives out, notes that, and goes through all primitives here.
 */
#ifndef SPH_SCENE_RECORD_H
#define SPH_SCENE_RECORD_H

#include "scene/scene.h"

/* "line 12", or where the file has no lines "sphere 11"; with the path before it "a.nff:12", or
 * "a.stl: triangle 11". The text is the caller's. */
#define SPH_PLACE 600
static inline const char *sph_record_line(char text[SPH_PLACE], uint32_t line, const char *what,
                                          uint32_t number) {
    if (line)
        snprintf(text, SPH_PLACE, "line %u", line);
    else
        snprintf(text, SPH_PLACE, "%s %u", what, number);
    return text;
}

static inline const char *sph_record_place(char text[SPH_PLACE], const char *path, uint32_t line,
                                           const char *what, uint32_t number) {
    if (line)
        snprintf(text, SPH_PLACE, "%s:%u", path, line);
    else
        snprintf(text, SPH_PLACE, "%s: %s %u", path, what, number);
    return text;
}

/* Zeroed but for the ledger. */
struct sph_recount {
    struct sph_ledger *ledger;
    struct sph_facet of; /* the newest facet */
    int begun, left;     /* there is one; of its record some are left */
};

/* Facets one after another, NULL at the end: those of one record stand together. left: it is there
 * still. Takes a record back when none of its facets is left. */
static inline void sph_recount_facet(struct sph_recount *r, const struct sph_facet *f, int left) {
    int joined = r->of.read == SPH_READ_MESH || r->of.read == SPH_READ_CONE ||
                 r->of.read == SPH_READ_BENT; /* else a record is one group */
    int same = f && r->begun && f->read == r->of.read && f->line == r->of.line &&
               (joined || f->group == r->of.group);
    if (r->begun && !same && !r->left) sph_ledger_take_back(r->ledger, r->of.read);
    r->left = left || (same && r->left);
    r->begun = f != NULL;
    if (f) r->of = *f;
}

#endif
