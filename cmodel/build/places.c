/* places.c - trees of two places, as a host of rt_top sees them  RTL: rtl/top/rt_trees.v
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build/places.h"

int sph_bt_build(struct sph_bt_places *places, uint32_t *memory, const struct sph_bt_job *job,
                 uint32_t most, int bus, const struct sph_profile *profile, uint32_t *written,
                 struct sph_error *err) {
    struct sph_bt_job to = *job;
    int at = places->valid && !places->newest;
    to.root = places->tree[at];
    *written = 0;
    if (bus == SPH_BT_READ_ERROR && !sph_bt_refused(&to, most)) return SPH_BT_BUS;
    int wrong = sph_bt_words(memory, &to, most, profile, written, err);
    if (wrong) return wrong;
    if (bus == SPH_BT_WRITE_ERROR) return SPH_BT_BUS;
    places->valid = 1;
    places->newest = at;
    return 0;
}
