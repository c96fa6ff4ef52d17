/* build.c - scene in, machine out; see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/build.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "builder/grid/axes.h"
#include "builder/background/background.h"
#include "builder/tree/box.h"
#include "builder/tree/choose_tree.h"
#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/smooth.h"
#include "builder/background/spans.h"
#include "builder/texture/texture.h"
#include "builder/warn.h"
#include "common/parallel.h"
#include "texture/lookup.h"

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

const char *sph_build_contradiction(const struct sph_build_options *o) {
    if (o->reflect == SPH_ON && !o->max_depth)
        return "reflect on: there must be a reflection to follow, depth is 0";
    if (o->refract == SPH_ON && !o->max_depth)
        return "refract on: there must be a ray to follow, depth is 0";
    if (o->interpenetrate == SPH_ON && o->traverse != SPH_BUILD_FIRST)
        return "interpenetrate on: it corrects the first hit, traverse is nearest";
    if (o->interpenetrate == SPH_ON && o->inside == SPH_OFF)
        return "interpenetrate on: it needs inside, which is off";
    if (o->clear == SPH_ON && o->shadow == SPH_OFF)
        return "clear on: it needs shadow, which is off";
    if (o->spread == SPH_ON && o->texture == SPH_OFF)
        return "spread on: it needs texture, which is off";
    if (o->axes == SPH_AXES_SCENE && o->background != SPH_BG_NONE)
        return "axes scene: background is separated along the camera's axes alone";
    if (o->axes == SPH_AXES_SCENE && o->traverse == SPH_BUILD_FIRST)
        return "axes scene: it is not for traverse first";
    if (o->traverse == SPH_BUILD_FIRST && o->tree == SPH_TREE_BOX4)
        return "traverse first: it walks through nodes of four spheres, this is box4";
    if (o->traverse == SPH_BUILD_FIRST && sph_tree_bih(o->tree))
        return o->tree == SPH_TREE_BIH
                   ? "traverse first: it walks through nodes of four spheres, this is bih"
                   : "traverse first: it walks through nodes of four spheres, this is brute";
    return NULL;
}

/* Whether what is asked of the effects can be. */
static int check_effects(const struct sph_scene *scene, const struct sph_build_options *o,
                         struct sph_error *err) {
    for (int i = 0; i < SPH_REPORTS; i++)
        if (sph_parts[i].option == SPH_OPTION_WHEN &&
            (o->asked[i] < SPH_AUTO || o->asked[i] > SPH_ON))
            return sph_fail(err, "%s is neither auto, off nor on: %d", sph_parts[i].word,
                            o->asked[i]);
    if (o->traverse != SPH_BUILD_NEAREST && o->traverse != SPH_BUILD_FIRST)
        return sph_fail(err, "there is no traversal %d", o->traverse);
    if (o->traverse == SPH_BUILD_FIRST && scene->n_facets)
        return sph_fail(err, "%s:%u: traverse first is for spheres: there are triangles or planes",
                        scene->path, scene->facets[0].line);
    if (o->tree == SPH_TREE_HW && scene->n_facets)
        return sph_fail(err, "%s:%u: tree hw is of spheres: there are triangles or planes",
                        scene->path, scene->facets[0].line);
    if (o->lights < SPH_AUTO || o->lights > scene->n_lights)
        return sph_fail(err, "%s: %d lights are asked for, the scene has %d", scene->path,
                        o->lights, scene->n_lights);
    const char *why = sph_build_contradiction(o);
    return why ? sph_fail(err, "%s: %s", scene->path, why) : 0;
}

const char *const sph_build_trees[] = {"paper", "balanced", "reinserted", "paper-grown",
                                       "hw",    "hw1",      "hw2",        NULL};

void sph_build_set_tree(struct sph_build_options *o, int place) {
    static const struct {
        int tree, grows;
        uint32_t rounds;
    } trees[] = {{SPH_TREE_PAPER, 0, 0}, {SPH_TREE_BALANCED, 0, 0}, {SPH_TREE_REINSERTED, 0, 0},
                 {SPH_TREE_PAPER, 1, 0}, {SPH_TREE_HW, 0, 0},       {SPH_TREE_HW, 0, 1},
                 {SPH_TREE_HW, 0, 2}};
    o->tree = trees[place].tree;
    o->paper_grows = trees[place].grows;
    o->hw_rounds = trees[place].rounds;
}

static int check(const struct sph_scene *scene, const struct sph_build_options *o,
                 struct sph_error *err) {
    if (!o->widths && (o->profile < 0 || o->profile >= SPH_PROFILES))
        return sph_fail(err, "there is no profile %d", o->profile);
    if (sph_profile_check(sph_build_profile(o), err)) return -1;
    if (o->tree < SPH_TREE_PAPER || o->tree > SPH_TREE_LAST)
        return sph_fail(err, "there is no tree %d", o->tree);
    if (o->max_tree_depth > SPH_BIH_STACK + 1)
        return sph_fail(err, "max_tree_depth %u is not in 0..%d", o->max_tree_depth,
                        SPH_BIH_STACK + 1);
    if (o->bih != SPH_BIH_FULL && o->bih != SPH_BIH_LISTING)
        return sph_fail(err, "there is no way %d to build a BIH", o->bih);
    if (o->coarse < 0 || o->coarse > SPH_LOD_BITS)
        return sph_fail(err, "a level has no %d bits of fraction", SPH_LOD_BITS - o->coarse);
    if (o->tex_filter < 0 || o->tex_filter >= SPH_FILTERS)
        return sph_fail(err, "there is no texture filter %d", o->tex_filter);
    if (o->axes != SPH_AXES_CAMERA && o->axes != SPH_AXES_SCENE)
        return sph_fail(err, "there are no axes %d", o->axes);
    if (o->background < SPH_BG_NONE || o->background > SPH_BG_EXACT)
        return sph_fail(err, "there is no background mode %d", o->background);
    if (o->bg_points && (o->bg_points < SPH_POINTS_MIN || o->bg_points > SPH_POINTS_MAX))
        return sph_fail(err, "bg_points %d is not in %d..%d", o->bg_points, SPH_POINTS_MIN,
                        SPH_POINTS_MAX);
    if (o->bg_border < 0 || o->bg_border > SPH_BORDER_MAX)
        return sph_fail(err, "bg_border %d is not in 0..%d", o->bg_border, SPH_BORDER_MAX);
    if (o->bg_levels < 0 || o->bg_levels > SPH_BG_LEVELS)
        return sph_fail(err, "bg_levels %d is not in 0..%d", o->bg_levels, SPH_BG_LEVELS);
    if (o->max_depth < 0 || o->max_depth > SPH_MAX_DEPTH)
        return sph_fail(err, "max_depth %d is not in 0..%d", o->max_depth, SPH_MAX_DEPTH);
    if (scene->n_lights < 0 || scene->n_lights > SPH_MAX_LIGHTS)
        return sph_fail(err, "%s: %d lights, at most %d", scene->path, scene->n_lights,
                        SPH_MAX_LIGHTS);
    if (scene->n_spheres > SPH_MAX_SPHERES)
        return sph_fail(err, "%s: %u spheres, at most %u", scene->path, scene->n_spheres,
                        SPH_MAX_SPHERES);
    if (scene->n_facets > SPH_MAX_FACETS || scene->n_spheres + scene->n_facets > SPH_ID_NONE)
        return sph_fail(err, "%s: %u spheres and %u triangles and planes; at most %d, of them %d",
                        scene->path, scene->n_spheres, scene->n_facets, SPH_ID_NONE,
                        SPH_MAX_FACETS);
    if (check_effects(scene, o, err)) return -1;
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        if (scene->spheres[i].material >= scene->n_materials)
            return sph_fail(err, "%s:%u: sphere without material", scene->path,
                            scene->spheres[i].line);
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        if (scene->spheres[i].texture > scene->n_textures)
            return sph_fail(err, "%s:%u: there is no texture %u", scene->path,
                            scene->spheres[i].line, scene->spheres[i].texture);
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        const struct sph_facet *f = &scene->facets[i];
        if (f->kind == SPH_SPHERE || f->kind < 0 || f->kind >= SPH_KINDS)
            return sph_fail(err, "%s:%u: there is no facet of kind %d", scene->path, f->line,
                            f->kind);
        if (f->material >= scene->n_materials)
            return sph_fail(err, "%s:%u: triangle or plane without material", scene->path, f->line);
        if (f->texture > scene->n_textures)
            return sph_fail(err, "%s:%u: there is no texture %u", scene->path, f->line, f->texture);
    }
    return 0;
}

/* Frame, window, eye and primary rays. */
static int place_camera(const struct sph_scene *scene, const struct sph_build_options *o,
                        const struct sph_grid *grid, struct sph_rays *rays, struct sph_machine *m,
                        struct sph_build_report *report, struct sph_error *err) {
    int width = o->width ? o->width : scene->camera.width;
    int height = o->height ? o->height : scene->camera.height;
    if (width < 1 || height < 1 || width > SPH_MAX_SIDE || height > SPH_MAX_SIDE)
        return sph_fail(err, "%s: a raster of %dx%d, sides are 1..%d", scene->path, width, height,
                        SPH_MAX_SIDE);
    const struct sph_profile *p = sph_build_profile(o);
    const struct sph_raster raster =
        sph_raster_of(&scene->camera, width, height, grid->seen_from.angle);
    struct sph_steps steps, *turned = grid->axes == SPH_AXES_CAMERA ? NULL : &steps;
    struct sph_error why = {{0}};
    if (sph_rays_of(&raster, p, rays, &why) ||
        (turned && sph_rays_turn(rays, &raster, grid, p, turned, &why)))
        return sph_fail(err, "%s: profile %s: %.450s", scene->path, p->name, why.text);
    sph_rays_tile(&scene->camera, width, height, rays, turned);
    int32_t *regs = m->regs;
    regs[SPH_REG_FRAME_W] = regs[SPH_REG_WIN_X1] = width;
    regs[SPH_REG_FRAME_H] = regs[SPH_REG_WIN_Y1] = height;
    for (int i = 0; i < 3; i++)
        regs[SPH_REG_EYE_X + i] = grid->eye[i];
    regs[SPH_REG_DIR_X0] = rays->x0;
    regs[SPH_REG_DIR_Y0] = rays->y0;
    regs[SPH_REG_DIR_Z] = rays->z;
    regs[SPH_REG_PITCH] = rays->pitch;
    report->fov_error = rays->fov_error + grid->seen_from.off;
    if (!turned) return 0;
    for (int i = 0; i < 3; i++) {
        regs[SPH_REG_DIR_X0 + i] = steps.first[i];
        regs[SPH_REG_ACROSS_X + i] = steps.across[i];
        regs[SPH_REG_DOWN_X + i] = steps.down[i];
    }
    regs[SPH_REG_PITCH] = 0;
    report->fov_error += steps.off;
    return 0;
}

/* Shares of the time of a large scene until it is on the grid, and until its tree is written. */
#define GRID 0.05
#define TREE 0.9

/* What build works on. */
struct parts {
    struct sph_ball *balls; /* of every id: spheres, then facets */
    struct sph_facets facets;
    struct sph_tree tree;
    uint8_t *lost; /* of every sphere: how it ends in the ledger, 0: it is on the grid */
};

/* Spheres and facets on the grid; balls[id] for all ids, and numbers[id] unless it is NULL. 1: some
 * spheres are lost on every grid. */
static int quantise(const struct sph_scene *scene, const struct sph_grid *grid,
                    const struct sph_build_options *o, struct parts *parts,
                    struct sph_build_report *report, struct sph_error *err) {
    const struct sph_profile *profile = sph_build_profile(o);
    uint32_t *numbers = o->numbers;
    int lost = sph_grid_spheres(grid, scene, profile, parts->balls, parts->lost,
                                &report->smallest_radius, err);
    if (lost) return lost;
    if (sph_grid_facets(grid, scene, profile, &parts->facets, err)) return -1;
    for (uint32_t i = 0; i < parts->facets.n; i++)
        parts->balls[scene->n_spheres + i] = parts->facets.list[i].ball;
    for (uint32_t i = 0; numbers && i < scene->n_spheres + parts->facets.n; i++)
        numbers[i] = i < scene->n_spheres
                         ? i
                         : scene->n_spheres + parts->facets.list[i - scene->n_spheres].scene;
    report->loose = parts->facets.n_loose;
    report->facets = parts->facets.n;
    sph_warn_coarse(scene, profile, grid->axes, report);
    return sph_note_left_out(scene, &parts->facets, report, err) ||
                   sph_note_limited(scene, report, err) ||
                   sph_note_images(scene, o->mips, &report->ledger, err)
               ? -1
               : 0;
}

/* The work of sph_build() on memory that the caller frees. 1: spheres are lost, nothing is built.
 */
static int build(const struct sph_scene *scene, const struct sph_build_options *o,
                 struct parts *parts, struct sph_machine *m, struct sph_build_report *report,
                 struct sph_error *err) {
    const struct sph_ball *balls = parts->balls;
    const struct sph_facets *facets = &parts->facets;
    struct sph_tree *tree = &parts->tree;
    const struct sph_profile *profile = sph_build_profile(o);
    struct sph_grid grid;
    struct sph_rays rays = {0};
    sph_machine_set_profile(m, profile);
    m->regs[SPH_REG_TREE] = o->tree;
    m->regs[SPH_REG_FRAME] = SPH_FRAMES - 1;
    if (sph_grid_fit(scene, profile->w, o->axes, &grid, err)) return -1;
    if (place_camera(scene, o, &grid, &rays, m, report, err)) return -1;
    report->grid_step = grid.step;
    report->eye = grid.seen_from;
    sph_warn_eye(scene, m, report);
    int lost = quantise(scene, &grid, o, parts, report, err);
    if (lost) return lost;

    uint32_t n = scene->n_spheres;
    struct sph_plants plants = {balls, n, facets, profile, grid.eye, o->tree, &rays};
    if (sph_progress_at(o->progress, GRID)) return sph_fail(err, "%s: cancelled", scene->path);
    tree->grows = o->paper_grows;
    tree->rounds = o->hw_rounds;
    tree->progress = sph_progress_part(o->progress, GRID, TREE);
    if (sph_emit_tree(scene, o, &plants, tree, m, report, err)) return -1;
    if (sph_progress_at(o->progress, TREE)) return sph_fail(err, "%s: cancelled", scene->path);

    if (sph_emit_background(tree, balls, &rays, o, m, report, err)) return -1;
    sph_emit_colours(scene, m);
    int mended =
        o->traverse == SPH_BUILD_NEAREST || (o->interpenetrate != SPH_OFF && o->inside != SPH_OFF);
    struct sph_world world = {balls, n, profile, grid.eye, facets, mended};
    struct sph_survey survey = {scene, &grid, o, world, 0, 0};
    if (sph_emit_effects(&survey, m, report, err) ||
        sph_emit_smooth(scene, &grid, &plants, m, report, err) ||
        sph_emit_learned(scene, &plants, o->kept, tree, m, report, err) ||
        sph_emit_textures(scene, &grid, &plants, o, m, report, err))
        return -1;
    sph_emit_spread(scene, &plants, o, m, report);
    sph_emit_left_out(o, m, report);
    if (sph_box_order(m, err)) return -1;
    snprintf(m->name, sizeof m->name, "%s", scene->name);
    m->grid_log2 = grid.log2;
    memcpy(m->origin, grid.origin, sizeof m->origin);
    memcpy(m->rotation, grid.rotation, sizeof m->rotation);
    return o->later ? 0 : sph_warn_cut(scene, m, report, err);
}

/* Builds what is left of a scene without the spheres that are lost on every grid. */
static int build_rest(const struct sph_scene *scene, const struct sph_build_options *options,
                      const uint8_t *lost, struct sph_machine *machine,
                      struct sph_build_report *report, struct sph_error *err) {
    struct sph_scene rest = *scene;
    struct sph_build_options o = *options;
    struct sph_unmet unmet = {0};
    uint32_t n = scene->n_spheres, *was = malloc(((size_t)n + 1) * sizeof *was);
    uint8_t *prims = malloc((size_t)n + scene->n_facets + 1);
    rest.spheres = malloc(((size_t)n + 1) * sizeof *rest.spheres);
    if (!was || !prims || !rest.spheres) {
        free(rest.spheres);
        free(prims);
        free(was);
        return sph_fail(err, "out of memory for %u spheres", n);
    }
    int rc = 0;
    rest.n_spheres = 0;
    for (uint32_t i = 0; i < n && !rc; i++) {
        if (lost[i]) {
            rc = sph_ledger_note(&rest.ledger, (enum sph_read)lost[i], scene->path,
                                 scene->spheres[i].line, err);
            sph_ledger_take_back(
                &rest.ledger, scene->ledger.row[SPH_READ_ATOM].n ? SPH_READ_ATOM : SPH_READ_SPHERE);
            continue;
        }
        if (o.unmet) prims[rest.n_spheres] = o.unmet->prims[i];
        was[rest.n_spheres] = i;
        rest.spheres[rest.n_spheres++] = scene->spheres[i];
    }
    if (!rc && o.unmet) {
        unmet = *o.unmet;
        memcpy(prims + rest.n_spheres, unmet.prims + n, scene->n_facets);
        unmet.prims = prims;
        o.unmet = &unmet;
    }
    if (!rc) rc = sph_build(&rest, &o, machine, report, err);
    for (int32_t k = 0; !rc && o.numbers && k < machine->regs[SPH_REG_N_PRIMS]; k++)
        o.numbers[k] =
            o.numbers[k] < rest.n_spheres ? was[o.numbers[k]] : o.numbers[k] - rest.n_spheres + n;
    free(rest.spheres);
    free(prims);
    free(was);
    return rc;
}

int sph_build(const struct sph_scene *scene, const struct sph_build_options *options,
              struct sph_machine *machine, struct sph_build_report *report, struct sph_error *err) {
    double start = seconds();
    clock_t busy = clock();
    struct parts parts = {0};
    memset(machine, 0, sizeof *machine);
    memset(report, 0, sizeof *report);
    report->ledger = scene->ledger;
    struct sph_build_options o = *options;
    sph_choose_tree(scene, &o, report);
    if (o.axes == SPH_AXES_AUTO) o.axes = sph_axes_of(scene, &o);
    if (check(scene, &o, err)) return -1;
    uint64_t n = (uint64_t)scene->n_spheres + scene->n_facets;
    int threads = sph_parallel_if(n >= SPH_BUILD_SHARED);
    parts.balls = malloc((n + 1) * sizeof *parts.balls);
    parts.lost = calloc((size_t)scene->n_spheres + 1, 1);
    int result = parts.balls && parts.lost
                     ? build(scene, &o, &parts, machine, report, err)
                     : sph_fail(err, "out of memory for %u spheres", scene->n_spheres);
    free(parts.balls);
    sph_tree_free(&parts.tree);
    sph_facets_free(&parts.facets);
    sph_parallel_most(threads);
    if (result > 0) result = build_rest(scene, options, parts.lost, machine, report, err);
    free(parts.lost);
    if (result) sph_machine_free(machine);
    report->build_seconds = seconds() - start;
    report->cpu_seconds = (double)(clock() - busy) / CLOCKS_PER_SEC;
    return result;
}
