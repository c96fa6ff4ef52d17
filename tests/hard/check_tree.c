/* check_tree.c - planes of a BIH, and spheres in one; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "check.h"
#include "exact.h"
#include "named.h"
#include "trace/bih.h"
#include "trace/traverse.h"

/* Sign of a*v/|d| - t * 2^t_shift, v >= 0. */
static int against(const struct job *j, const struct sph_bih_ray *b, int64_t v, int64_t d,
                   uint32_t t) {
    sph_i128 exact = (sph_i128)j->ray.a * v, bound = ((sph_i128)t << b->t_shift) * d;
    return exact < bound ? -1 : exact > bound;
}

/* A slab test without margin: t = v/d rounded; which side of the exact t it must not lie on. */
static void clip_floats(struct job *j, int64_t v, int64_t d, int leaves) {
    double side = leaves ? -1 : 1, t32 = (double)((float)v * (1 / (float)d));
    double t64 = (double)v * (1 / (double)d);
    j->t->column[SPH_F32_TEXTBOOK].hit += side * fma(t32, (double)d, -(double)v) > 0;
    j->t->column[SPH_F64_TEXTBOOK].hit += side * fma(t64, (double)d, -(double)v) > 0;
}

void check_clips(struct job *j) {
    int axis = j->c->clip.axis, below = j->c->clip.below;
    int64_t d = j->ray.dir[axis], v = j->c->clip.at - j->ray.org[axis];
    struct sph_bih_ray b;
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    if (!j->ray.a) return;
    sph_bih_setup(j->p, &j->ray, &b);
    int left = sph_bih_cut(&b, &j->ray, axis, j->c->clip.at, below, &span);
    int starts = below ? v >= 0 : v <= 0; /* on this side */
    int comes = below ? d < 0 : d > 0;    /* or gets there */
    j->t->hits += starts || comes;
    if (left != (starts || comes)) job_wrong(j, HARD_TREE, "a side that the ray sees, or does not");
    if (!left || !d) return;
    if (d < 0) d = -d, v = -v;
    if (v < 0 || (!comes && v == 0)) {
        if (span.lo) job_wrong(j, HARD_TREE, "bounded though nothing is behind");
        return;
    }
    if (comes ? span.hi != SPH_BIH_NO_BOUND : span.lo != 0)
        job_wrong(j, HARD_TREE, "the other bound moved");
    if (comes && against(j, &b, v, d, span.lo) < 0)
        job_wrong(j, HARD_TREE, "what lies at the plane is left out");
    if (!comes && span.hi != SPH_BIH_NO_BOUND && against(j, &b, v, d, span.hi) > 0)
        job_wrong(j, HARD_TREE, "what lies before the plane is left out");
    if (v < 1ll << 24) clip_floats(j, v, d, !comes);
}

/* The first of both spheres: a BIH of two leaves, one leaf, the exact order. */
void check_walks(struct job *j) {
    struct named n = hard_named_start((int)(j->p - sph_profiles));
    struct sph_leaf leaf[2] = {j->c->sphere[0], j->c->sphere[1]};
    uint32_t words[TWO_LINES * SPH_LINE_WORDS], id = SPH_ID_NONE;
    uint64_t key = 0;
    struct sph_machine m;
    n.list = &(struct hard_list){0}; /* a BIH that cannot be built says so by its answers */
    for (int i = 0; i < 2; i++) {
        struct exact e = exact_leaf(&j->ray, &leaf[i]);
        uint64_t at = (uint64_t)(e.whole + (e.part > 0));
        leaf[i].id = (uint32_t)i;
        j->t->hits += e.hit != 0;
        if (!e.hit || (id != SPH_ID_NONE && at >= key)) continue;
        key = at;
        id = (uint32_t)i;
    }
    two_leaves(&n, leaf, words, &m);
    for (int kind = SPH_TREE_BIH; kind <= SPH_TREE_BRUTE; kind++) {
        uint32_t visits = 0, errors = 0;
        struct sph_counters counters = {0};
        two_in_bih(&n, leaf, kind, words, &m);
        struct sph_hit hit =
            sph_traverse(&m, &j->ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
        j->t->column[HARD_OURS].hit += (hit.key != 0) != (key != 0);
        if (errors || hit.id != id || hit.key != key)
            job_wrong(j, HARD_TREE, kind == SPH_TREE_BIH ? "another hit in a BIH" : "of one leaf");
    }
}
