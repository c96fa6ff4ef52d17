/* places.h - trees of two places, as a host of rt_top sees them  RTL: rtl/top/rt_trees.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A tree is built where the newest one is not, so that this stays whole if it fails.
 */
#ifndef SPH_BUILD_PLACES_H
#define SPH_BUILD_PLACES_H

#include "build/build_tree.h"

struct sph_bt_places {
    uint32_t tree[2]; /* lines of the roots */
    int valid;        /* a tree is complete, */
    int newest;       /* in this place */
};

/* What memory answers: no error, one of a record that is read, one of a line that is written. */
enum { SPH_BT_ANSWERS, SPH_BT_READ_ERROR, SPH_BT_WRITE_ERROR };

/* One BUILD: as sph_bt_words(), but for job->root, which is the place's. Returns what register
 * ERRORS gets from BUILD_MANY on, 0: the tree is the newest; -1 with a message if memory is out. */
int sph_bt_build(struct sph_bt_places *places, uint32_t *memory, const struct sph_bt_job *job,
                 uint32_t most, int bus, const struct sph_profile *profile, uint32_t *written,
                 struct sph_error *err);

#endif
