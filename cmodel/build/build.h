/* build.h - everything that the papers leave to the CPU: scene in, machine out
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. IV (tree), V (background separation); docs/build.md, docs/background.md.
 */
#ifndef SPH_BUILD_H
#define SPH_BUILD_H

#include "build/bound.h"
#include "build/work.h"
#include "machine/machine.h"
#include "scene/scene.h"

enum { SPH_TREE_PAPER = 1, SPH_TREE_BALANCED = 2 };
enum { SPH_BG_NONE = 0, SPH_BG_RECT = 1, SPH_BG_SPANS = 2, SPH_BG_EXACT = 3 };

struct sph_build_options {
    int profile;       /* SPH_DRAFT .. */
    int tree;          /* SPH_TREE_* */
    int background;    /* SPH_BG_* */
    int width, height; /* 0: the scene file's */
    int max_depth;     /* reflections 0..5 */
    int shadow;        /* -1 as the scene asks, 0 off, 1 on */
    int reflect;       /* -1 as the scene asks, 0 off, 1 on */
    int bg_points;     /* spans: meridians, and parallels, 4..4096; 0: 16 */
    int bg_border;     /* spans: pixels around the outline, 0..64 */
    int bg_levels;     /* exact: 0 the root, 1 its children, 2 theirs */
};

/* What build tells the user besides the machine. */
struct sph_build_report {
    double grid_step;       /* scene units */
    double smallest_radius; /* grid units */
    double fov_error;       /* relative error of tan(angle/2) by quantisation */
    uint32_t nodes, depth;  /* of the tree */
    double build_seconds;
    char warning[512];                 /* empty if none; names the finer profile a scene asks for */
    struct sph_ball root;              /* grid units: holds every sphere */
    int bg_points;                     /* spans: meridians that were needed, 0: none */
    struct sph_work bg_work, bg_check; /* spans, exact: set-up; spans: proof that they cover */
    char background[512];              /* how the separation went, one line each */
    char effects[1024];                /* per effect on or off and why, one line each */
};

/* Builds the machine. 0, or -1 with "file:line: ..." (a sphere that does not fit the grid, zero
 * radius on the grid, exact duplicates, raster too wide for the profile). */
int sph_build(const struct sph_scene *scene, const struct sph_build_options *options,
              struct sph_machine *machine, struct sph_build_report *report, struct sph_error *err);

#endif
