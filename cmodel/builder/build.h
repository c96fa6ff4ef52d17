/* build.h - everything that the papers leave to the CPU: scene in, machine out
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. IV (tree), V (background separation); docs/design/builder.md,
 * docs/results/effects.md.
 */
#ifndef SPH_BUILD_H
#define SPH_BUILD_H

#include "builder/grid/axes.h"
#include "builder/tree/refit.h"
#include "builder/texture/keep.h"
#include "builder/tree/tree.h"
#include "builder/background/work.h"
#include "machine/machine.h"
#include "machine/parts.h"
#include "reference/cut.h"
#include "scene/scene.h"
#include "texture/texel.h"

enum { SPH_BG_NONE = 0, SPH_BG_RECT = 1, SPH_BG_SPANS = 2, SPH_BG_EXACT = 3 };
enum { SPH_BUILD_NEAREST = 0, SPH_BUILD_FIRST = 1 };
enum { SPH_AUTO = -1, SPH_OFF = 0, SPH_ON = 1 }; /* auto: as the scene calls for */

/* What rays of the frame do not meet, as a drawing of it has shown: trial/met.h. */
struct sph_unmet {
    const uint8_t *prims; /* 1: no ray asks what the surface looks like; by number in the scene */
    uint32_t lights;      /* bit l: light l of the scene lights nothing; it is black there */
    int shadow;           /* nothing stands between a light and what it lights */
    int inside;           /* no ray starts in a sphere */
    int clear;            /* no ray to a light passes what lets such rays pass */
    int depth;            /* so many rays follow a primary one, one after another, at most */
    int fewer;            /* the scene lacks primitives that no ray meets */
};

struct sph_build_options {
    const struct sph_profile *widths; /* NULL: those of `profile` */
    int profile;                      /* SPH_DRAFT .. */
    int tree;                         /* SPH_TREE_*: four children a node, BIH, or one leaf; or
                                         SPH_TREE_AUTO (choose_tree.h) */
    uint32_t max_prims;               /* BIH: primitives of a leaf that is not cut; 0: 4 */
    uint32_t max_tree_depth;          /* BIH: levels, 1 .. SPH_BIH_STACK + 1; 0: these */
    int bih;                          /* SPH_BIH_FULL, SPH_BIH_LISTING */
    uint32_t bih_fit;                 /* percent, as sph_bih_options has it; 0: 130 */
    int paper_grows;                  /* SPH_TREE_PAPER: nodes may be larger than the whole */
    uint32_t hw_rounds;               /* SPH_TREE_HW: of joining that follow the first, 0 to 3 */
    int axes;                         /* SPH_AXES_*: of the grid; auto: axes.h */
    int background;                   /* SPH_BG_* */
    int width, height;                /* 0: the scene file's */
    int max_depth;                    /* reflections 0..10 */
    int least_weight;                 /* u1.8 of a pixel, 0..256: no lighter ray is followed */
    union {
        int asked[SPH_REPORTS]; /* of each effect with an option: SPH_AUTO, SPH_OFF, SPH_ON; of
                                   lights SPH_AUTO, or how many of the scene's, from the first on */
#define SPH_FIELD(name, word, ...) int word;
        struct {
            SPH_EACH_EFFECT(SPH_FIELD)
        }; /* the same by name */
    };
    int traverse;                    /* SPH_BUILD_*: how a primary ray finds its hit */
    int bg_points;                   /* spans: meridians, and parallels, 4..4096; 0: 16 */
    int bg_border;                   /* spans: pixels around the outline, 0..64 */
    int bg_levels;                   /* exact: 0 the root, 1 its children, 2 theirs */
    int tex_filter;                  /* SPH_FILTER_* */
    int coarse;                      /* bits of levels' fractions that are left out, 0..8 */
    int lod_literal;                 /* 1: base as the paper prints it (docs/design/textures.md) */
    const struct sph_mip *mips;      /* of the scene's textures, in its order; equal images may
                                        share texels */
    struct sph_texture_bases *bases; /* NULL, or what the frame before left, of the same scene */
    struct sph_kept_tree *kept;      /* the same of its tree */
    int later;                       /* of a sequence, not the first: nothing is measured to be told
                                        alone, so that planes_cut and its warning are left out */
    const struct sph_progress *progress; /* NULL, or who is told how far it is */
    const struct sph_unmet *unmet;       /* NULL: rays may meet all that the scene names */
    uint32_t *numbers; /* NULL, or where the number in the scene of each of the machine's primitives
                          goes: spheres, then facets; as many words as the scene has */
};

enum { SPH_TREE_AUTO = 0 };

/* What is built if nothing is asked for; constant, for initialisers. */
#define SPH_BUILD_ASKED(...) SPH_AUTO,
enum { SPH_BUILD_SHARED = 1000 }; /* primitives from which on threads share a build */

#define SPH_BUILD_DEFAULT                                                                          \
    {                                                                                              \
        .profile = SPH_STANDARD, .tree = SPH_TREE_REINSERTED, .background = SPH_BG_NONE,           \
        .axes = SPH_AXES_AUTO, .bg_border = 1, .max_depth = 2,                                     \
        .asked = {SPH_EACH_EFFECT(SPH_BUILD_ASKED)}, .tex_filter = SPH_FILTER_BETWEEN              \
    }

/* A leaf of no more is not cut if nothing else is asked for: docs/results/trees.md has what it
 * costs.
 */
enum { SPH_BIH_PRIMS = 4 };

/* Trees of four children a node by the names that people give them, NULL behind the last. */
extern const char *const sph_build_trees[];

/* Asks for one of them, by its place in that list: tree, paper_grows, hw_rounds. */
void sph_build_set_tree(struct sph_build_options *o, int place);

/* Whether options make the picture another one on purpose, not by fewer bits or effects. */
static inline int sph_build_approximate(const struct sph_build_options *o) {
    return o->least_weight || o->coarse || o->lod_literal;
}

/* The widths that are asked for. */
static inline const struct sph_profile *sph_build_profile(const struct sph_build_options *o) {
    return o->widths ? o->widths : &sph_profiles[o->profile];
}

/* What became of one effect. */
struct sph_effect_report {
    const char *name;
    int on, called; /* lights, reflections, or 0 and 1: in the machine; called for by the scene */
    int left_out;   /* the scene names what calls for it, but no ray of the frame meets that */
    char why[2048]; /* names the material, light or spheres; no line ends */
};

enum { SPH_TREE_WHY = 128 }; /* characters, with the 0 behind them */

/* What build tells the user besides the machine. */
struct sph_build_report {
    double grid_step;       /* scene units */
    double smallest_radius; /* grid units */
    double fov_error;       /* of tan(angle/2), relative; and by how much of their distance from
                               the middle of the picture an eye put nearer moves points */
    struct sph_eye eye;     /* where it is put */
    uint32_t nodes, depth;  /* of the tree: how many, on how many levels */
    char tree_why[SPH_TREE_WHY]; /* empty if it was asked for */
    int refitted;                /* the tree is that of the frame before, in new places */
    double tree_cost;       /* then: its cost over that of the tree when it was built; else 1 */
    uint32_t facets, loose; /* primitives that are no spheres; of them, without bounds */
    double build_seconds, cpu_seconds;   /* all of build; of processor, of all threads */
    double tree_seconds;                 /* of processor, of tree and memory image alone */
    struct sph_bih_stats bih;            /* with TREE_BIH and TREE_BRUTE */
    struct sph_ledger ledger;            /* the scene's, and what the grid leaves out or limits */
    char warning[8192];                  /* empty if none; finer profiles, effects left out */
    struct sph_cut cut;                  /* of the planes */
    struct sph_ball root;                /* grid units: holds every primitive */
    int bg_points;                       /* spans: meridians that were needed, 0: none */
    struct sph_work bg_work, bg_check;   /* spans, exact: set-up; spans: proof that they cover */
    char background[512];                /* how the separation went, one line each */
    uint64_t bases_computed, bases_kept; /* P_b of textured primitives */
    struct sph_flops bases_flops;        /* of those computed */
    struct sph_effect_report effects[SPH_REPORTS];
    char left_out[2048]; /* what else the frame does not ask for, one line each (trial/met.h) */
    int lights[SPH_MAX_LIGHTS]; /* number in the scene of each light of the machine */
};

/* Why no scene can be built with these options: two of them exclude each other. NULL if none do. */
const char *sph_build_contradiction(const struct sph_build_options *o);

/* Builds the machine. 0, or -1 with "file:line: ..." (a sphere that does not fit the grid, zero
 * radius on the grid or two of one place, if a finer profile would do; more than SPH_MAX_PLANES
 * planes, raster too wide for the profile, effects that exclude each other). */
int sph_build(const struct sph_scene *scene, const struct sph_build_options *options,
              struct sph_machine *machine, struct sph_build_report *report, struct sph_error *err);

#endif
