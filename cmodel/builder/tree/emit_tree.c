/* emit_tree.c - the tree that a machine gets, built and written; see emit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <time.h>

#include "builder/emit.h"

/* Of processor, whatever else runs. */
static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* A tree of one node without children around everything. */
static int root_alone(const struct sph_plants *plants, struct sph_tree *tree,
                      struct sph_error *err) {
    uint32_t n = plants->n_spheres + plants->facets->n;
    uint32_t *index = malloc((n + 1ull) * sizeof *index);
    tree->nodes = calloc(1, sizeof *tree->nodes);
    tree->n_nodes = tree->depth = 1;
    if (index && tree->nodes && plants->facets->n_loose) {
        tree->nodes->ball = sph_filter_whole(plants->profile);
    } else if (index && tree->nodes && n) {
        for (uint32_t i = 0; i < n; i++)
            index[i] = i;
        tree->nodes->ball = sph_filter_enclose(plants->balls, index, n, plants->profile);
    }
    int made = index && tree->nodes;
    free(index);
    return made ? 0 : sph_fail(err, "out of memory for a sphere around %u primitives", n);
}

/* A bounding interval hierarchy, or one leaf. Background separation works on the spheres of nodes
 * of four children, so that such a tree is made too where it is asked for. */
static int emit_bih(const struct sph_scene *scene, const struct sph_build_options *o,
                    const struct sph_plants *plants, struct sph_tree *tree, struct sph_machine *m,
                    struct sph_build_report *report, struct sph_error *err) {
    const struct sph_progress all = tree->progress;
    double half = o->background == SPH_BG_NONE ? 1 : 0.5;
    struct sph_progress first = sph_progress_part(&all, 0, half);
    struct sph_bih_options how = {o->max_prims ? o->max_prims : SPH_BIH_PRIMS,
                                  o->max_tree_depth ? o->max_tree_depth : SPH_BIH_STACK + 1, o->bih,
                                  &first, o->bih_fit};
    struct sph_plants four = *plants;
    if (o->tree == SPH_TREE_BRUTE) how.max_prims = UINT32_MAX;
    four.kind = SPH_TREE_BALANCED;
    double start = seconds();
    if (sph_emit_bih(scene, plants, &how, o->kept, m, &report->bih, err)) return -1;
    report->tree_seconds = seconds() - start;
    report->nodes = report->bih.inner + report->bih.leaves;
    report->depth = report->bih.depth_max;
    tree->progress = sph_progress_part(&all, half, 1);
    return o->background == SPH_BG_NONE ? root_alone(plants, tree, err)
                                        : sph_tree_build(&four, tree, err);
}

static int emit_four(const struct sph_scene *scene, const struct sph_plants *plants,
                     struct sph_kept_tree *kept, int learns, struct sph_tree *tree,
                     struct sph_machine *m, struct sph_build_report *report,
                     struct sph_error *err) {
    double start = seconds();
    tree->learns = learns;
    if (sph_tree_next(plants, kept, tree, err) || sph_emit_memory(scene, plants, tree, m, err))
        return -1;
    report->tree_seconds = seconds() - start;
    report->nodes = tree->n_nodes;
    report->depth = tree->depth;
    return 0;
}

int sph_emit_learned(const struct sph_scene *scene, const struct sph_plants *plants,
                     struct sph_kept_tree *kept, struct sph_tree *tree, struct sph_machine *m,
                     struct sph_build_report *report, struct sph_error *err) {
    if (!tree->split) return 0;
    double start = seconds();
    if (sph_tree_again(plants, kept, m, tree, err) || sph_emit_again(scene, plants, tree, m, err))
        return -1;
    report->tree_seconds += seconds() - start;
    report->nodes = tree->n_nodes;
    report->depth = tree->depth;
    return 0;
}

int sph_emit_tree(const struct sph_scene *scene, const struct sph_build_options *o,
                  const struct sph_plants *plants, struct sph_tree *tree, struct sph_machine *m,
                  struct sph_build_report *report, struct sph_error *err) {
    /* the first hit depends on the order of children; the paper's spheres are made as it says, and
     * those of hardware by rt_build */
    int may =
        o->traverse == SPH_BUILD_NEAREST && o->tree != SPH_TREE_PAPER && o->tree != SPH_TREE_HW;
    struct sph_kept_tree *kept = may ? o->kept : NULL;
    if (kept) kept->refitted = 0, kept->cost = 1;
    if (kept && kept->how == SPH_REFIT_ONLY && sph_kept_fits(kept, plants, scene->path, err))
        return -1;
    int failed = sph_tree_bih(o->tree) ? emit_bih(scene, o, plants, tree, m, report, err)
                                       : emit_four(scene, plants, kept, may, tree, m, report, err);
    report->refitted = kept ? kept->refitted : 0;
    report->tree_cost = kept ? kept->cost : 1;
    return failed;
}
