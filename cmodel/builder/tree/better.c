/* better.c - see better.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/better.h"

#include <stdlib.h>
#include <string.h>

#include "builder/tree/agglomerate.h"
#include "builder/tree/reinsert.h"

enum { SPLITS, TIGHT, LOOSE, WAYS };

/* Makes a tree one way, of a split if it starts there, and puts it in the place of *out. */
static int make(struct sph_links *l, int way, const struct sph_split *split,
                struct sph_split *out) {
    if (way == SPLITS)
        sph_links_take(l, split);
    else if (sph_agglomerate(l, way == TIGHT))
        return -1;
    if (sph_reinsert(l)) return -1;
    sph_links_give(l, out);
    return 0;
}

/* Makes it in *spare, and puts it in the place of *split if it costs less. */
static int make_cheaper(struct sph_links *l, int way, struct sph_split *split,
                        struct sph_split *spare) {
    if (make(l, way, split, spare)) return -1;
    if (spare->pairs[0].cost[1] >= split->pairs[0].cost[1]) return 0;
    struct sph_split swap = *split;
    *split = *spare, *spare = swap;
    return 0;
}

int sph_split_better(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                     const struct sph_profile *profile, const struct sph_progress *progress,
                     struct sph_split *split, struct sph_error *err) {
    struct sph_links links;
    struct sph_split spare = {NULL, 0, NULL};
    int failed = sph_links_new(balls, boxes, n, sph_pair_margin(profile), &links);
    links.progress = progress;
    int many = n > SPH_TREE_FEW || boxes; /* one way must do */
    if (!many) {
        spare.pairs = malloc((n - 1) * sizeof *spare.pairs);
        spare.order = malloc(n * sizeof *spare.order);
        failed |= !spare.pairs || !spare.order;
        sph_split_fill(balls, NULL, profile, split);
    }
    for (int way = 0; way < WAYS && !failed && !many; way++)
        failed = make_cheaper(&links, way, split, &spare);
    if (!failed && many) failed = make(&links, SPLITS, split, split);
    sph_links_free(&links);
    sph_split_free(&spare);
    return failed ? sph_fail(err, "out of memory for a tree of %u spheres", n) : 0;
}
