/* named.h - the hard cases that have a name: one table, and what its vectors are made with
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_NAMED_H
#define HARD_NAMED_H

#include "gen.h"
#include "hard.h"
#include "machine/machine.h"
#include "list.h"

/* A run of one named case in one profile. */
struct named {
    const struct sph_profile *p;
    int profile;
    int64_t half, most, scale; /* 2^(W-1); greatest direction component; 2^(W-12) */
    struct hard_tally tally;
    uint64_t vectors;
    int wrong;
    const char *scenes;         /* file */
    struct hard_list *list;     /* vectors are added here and not judged; NULL: judged */
    struct hard_facets *facets; /* with list: those of facets (facet.h), NULL: left out */
    FILE *out;
};

enum { ORACLE, MISS, NEAR, FAR, EXIT }; /* ORACLE: whatever the oracles say */

struct hard_named {
    const char *name;
    const char *sentence; /* what it is for, and the outcome where the rules fix it */
    void (*run)(struct named *n);
};
extern const struct hard_named hard_named[];
extern const int hard_n_named;

/* A run that has not begun. */
struct named hard_named_start(int profile);

/* A primary ray and a sphere. */
struct hard_case vector(const int64_t org[3], const int64_t dir[3], const int64_t ctr[3],
                        int64_t rad);
#define V3(x, y, z) ((const int64_t[3]){(x), (y), (z)})

/* The case with each axis in each place: the model against all oracles, and against the expected
 * outcome of the first sphere; a key of 0 is not fixed. */
void expect(struct named *n, struct hard_case c, int outcome, uint64_t key);

/* A case of any kind, as it is. */
void expect_case(struct named *n, const struct hard_case *c);

/* The same with the second sphere's outcome not fixed, and then both orders of storage and both
 * orders of ids through the tree: the sphere that comes first by t wins. winner 0 or 1: which one;
 * -1: the lower id, since the keys are equal. */
void expect_first(struct named *n, struct hard_case c, int winner);

/* One check that is no vector. */
void require(struct named *n, int holds, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Runs one named case, or all for number 0, in every profile; prints a TAP line for each with its
 * failures behind it. Returns the number of cases that failed. */
int hard_named_run(int number, const char *scenes, FILE *out);

/* Named cases and families as tables, for docs/results/hard_cases.md. */
void hard_named_list(FILE *out);

typedef void named_case(struct named *n);
named_case named_tangent, named_pell_hit, named_pell_miss, named_distance, named_tangent_off,
    named_tiny_far, named_huge_outside, named_huge_inside, named_surface_entering,
    named_surface_leaving, named_surface_along, named_own_outward, named_no_id, named_own_inward,
    named_own_exit, named_at_centre, named_inside_away, named_axes, named_unit_axis,
    named_one_and_power, named_dir0, named_rad0, named_rad0_centre, named_ends, named_disc_ends,
    named_disc_one, named_same_point, named_tie, named_near_far, named_concentric, named_identical,
    named_lens, named_contact, named_behind, named_light_on, named_light_in, named_light_zero,
    named_isqrt, named_quotient, named_off_grid, named_normal0, named_grazed, named_node_radius,
    named_node_largest, named_node_corner, named_disc_small, named_alternate, named_facet_edge_on,
    named_facet_edge, named_facet_neighbours, named_facet_corner, named_facet_origin_on,
    named_facet_group, named_facet_back, named_facet_light, named_facet_ties, named_facet_horizon,
    named_facet_grazing, named_facet_ends, named_facet_sliver, named_facet_dir0, named_critical,
    named_refract_along, named_refract_away, named_refract_head_on, named_refract_ends,
    named_refract_graze, named_refract_centre, named_refract_cancel, named_planes_equal,
    named_plane_along, named_facets_flat, named_seam, named_texel_edge, named_texel_mean,
    named_level, named_clip, named_walk, named_glass_in_glass, named_unit_ends, named_facet_beside,
    named_coplane, named_pixel, named_ridge, named_meet, named_glass, named_eye;

/* Scenes: the model, brute force and the naive model draw the same picture. */
void named_scene(struct named *n, const char *name);

/* A machine of one node with two leaves, in this order; their ids are 0 and 1. mem: 4 lines. */
void two_leaves(const struct named *n, const struct sph_leaf leaf[2], uint32_t *mem,
                struct sph_machine *m);

/* Makes of it a BIH of one primitive a leaf, or one leaf: tree is SPH_TREE_BIH or SPH_TREE_BRUTE.
 */
enum { TWO_LINES = 16 };
void two_in_bih(struct named *n, const struct sph_leaf leaf[2], int tree,
                uint32_t mem[TWO_LINES * SPH_LINE_WORDS], struct sph_machine *m);

#endif
