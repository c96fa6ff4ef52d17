/* grid.c - the grid; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/grid.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "builder/grid/huge_bounds.h"
#include "builder/grid/light.h"
#include "prim/prim.h"
#include "scene/prim.h"
#include "scene/vector.h"
#include "machine/records.h"

enum {
    FAR = 4,   /* times finer: then the grid is made without the lights */
    LEAST = 12 /* bits that planes leave to what has an end, and half of those beyond */
};

/* Adds the points of facets. */
static int add_facets(const struct sph_scene *scene, const double m[9], struct sph_box *box,
                      struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        const struct sph_facet *f = &scene->facets[i];
        const struct sph_prim_scene *kind = sph_prim_scene_of((uint32_t)f->kind);
        for (int k = 0; k < 3; k++) {
            double at[3], size = fabs(f->v[k].x) + fabs(f->v[k].y) + fabs(f->v[k].z);
            sph_vec_turn(m, sph_vec_sub(f->v[k], scene->camera.from), at);
            if (!isfinite(size + at[0] + at[1] + at[2]) || (k == kind->points && !(size > 0)))
                return sph_fail(err, "%s:%u: %s needs %s", scene->path, f->line,
                                sph_kind_name((uint32_t)f->kind), kind->wants);
            if (k < kind->points) sph_box_add(box, at, 0);
        }
    }
    return 0;
}

/* Adds the lights but for black ones. */
static int add_lights(const struct sph_scene *scene, struct sph_vec from, const double m[9],
                      struct sph_box *box, struct sph_error *err) {
    double at[3];
    for (int l = 0; l < scene->n_lights; l++) {
        sph_vec_turn(m, sph_vec_sub(scene->lights[l].pos, from), at);
        if (!isfinite(at[0] + at[1] + at[2]))
            return sph_fail(err, "%s: light %d is not at a finite place", scene->path, l);
        if (!sph_light_black(&scene->lights[l])) sph_box_add(box, at, 0);
    }
    return 0;
}

/* The box, in axes around the eye, of facets and all spheres but one. */
static int bounds(const struct sph_scene *scene, const double m[9], uint32_t but,
                  struct sph_box *box, struct sph_error *err) {
    double at[3];
    *box = (struct sph_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_sphere *s = &scene->spheres[i];
        sph_vec_turn(m, sph_vec_sub(s->ctr, scene->camera.from), at);
        if (!isfinite(at[0] + at[1] + at[2] + s->rad) || !(s->rad > 0))
            return sph_fail(err, "%s:%u: sphere needs a finite centre and a radius above zero",
                            scene->path, s->line);
        if (i != but) sph_box_add(box, at, s->rad);
    }
    return add_facets(scene, m, box, err);
}

/* Makes the box of all smaller if the grid need not hold all of the largest sphere. Its number, or
 * that of spheres. */
static uint32_t cut_huge(const struct sph_scene *scene, const double m[9], int w,
                         struct sph_box *box) {
    uint32_t huge = sph_huge_sphere_find(scene);
    struct sph_box rest;
    double at[3];
    if (huge == scene->n_spheres || bounds(scene, m, huge, &rest, NULL)) return scene->n_spheres;
    sph_box_add(&rest, (const double[3]){0, 0, 0}, 0); /* the eye */
    sph_vec_turn(m, sph_vec_sub(scene->spheres[huge].ctr, scene->camera.from), at);
    return sph_huge_sphere_cut(at, scene->spheres[huge].rad, &rest, w, box) ? huge
                                                                            : scene->n_spheres;
}

/* Adds the corners of a room of planes. */
static void add_corners(const struct sph_scene *scene, const double m[9], struct sph_box *box) {
    struct sph_vec corners[SPH_CORNERS];
    double at[3];
    for (int i = sph_plane_bounds_corners(scene, corners); i-- > 0;) {
        sph_vec_turn(m, corners[i], at);
        sph_box_add(box, at, 0);
    }
}

/* The side of the grid, in units of the scene: planes may ask for more than the box. */
static double side(const struct sph_scene *scene, const struct sph_box *box, int w) {
    double span = sph_box_side(box);
    if (w < LEAST) return span;
    return fmax(span, fmin(2 * sph_plane_bounds_reach(scene), ldexp(span, (w - LEAST) / 2)));
}

/* What of the scene has an end, on the grid; rays start no farther from it than the margin. */
static struct sph_extent extent_of(const struct sph_grid *grid, const struct sph_scene *scene,
                                   const struct sph_box *box) {
    struct sph_extent e = {.rad = 0};
    for (int i = 0; i < 3; i++) {
        e.lo[i] = floor(box->lo[i] / grid->step) + grid->eye[i] - 2 * SPH_GRID_MARGIN;
        e.hi[i] = ceil(box->hi[i] / grid->step) + grid->eye[i] + 2 * SPH_GRID_MARGIN;
    }
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        e.rad = fmax(e.rad, scene->spheres[i].rad / grid->step + 1);
    return e;
}

/* Whether the centre of a sphere that is not all on the grid lies there, a child of a node may be
 * as large, and all that is met of it lies on the grid. A child's radius has 14 bits, for which
 * centre, radius and the filter's margin are rounded up by no more than 5. */
static int huge_fits(const struct sph_grid *grid, const struct sph_ball *huge,
                     const struct sph_box *box) {
    const struct sph_ball centre = {{huge->c[0], huge->c[1], huge->c[2]}, 0};
    int less = grid->w > SPH_CHILD_RAD_BITS ? 5 << (grid->w - SPH_CHILD_RAD_BITS) : 1;
    if (!sph_grid_fits(grid, &centre) || huge->r > (1 << grid->w) - less) return 0;
    for (int end = 0; end < 2; end++) {
        struct sph_ball corner = {.r = 0};
        for (int i = 0; i < 3; i++)
            corner.c[i] = grid->eye[i] + (int32_t)(end ? ceil(box->hi[i] / grid->step)
                                                       : floor(box->lo[i] / grid->step));
        if (!sph_grid_fits(grid, &corner)) return 0;
    }
    return 1;
}

/* Whether eye and spheres, quantised, lie inside w bits with the margin, and lights do or are as
 * good as there. box: of what has an end. */
static int all_fit(const struct sph_grid *grid, const struct sph_scene *scene,
                   const struct sph_box *box) {
    struct sph_extent extent = extent_of(grid, scene, box);
    struct sph_ball ball = {.r = 0};
    memcpy(ball.c, grid->eye, sizeof ball.c);
    if (!sph_grid_fits(grid, &ball)) return 0;
    for (int l = 0; l < scene->n_lights; l++) {
        const struct sph_light *lamp = &scene->lights[l];
        if (!sph_light_black(lamp) && !sph_light_sound(grid, lamp->pos, &extent)) return 0;
    }
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        ball = sph_grid_ball(grid, &scene->spheres[i]);
        if (i == grid->huge ? !huge_fits(grid, &ball, box) : !sph_grid_fits(grid, &ball)) return 0;
    }
    ball.r = 0;
    for (uint32_t i = 0; i < scene->n_facets; i++)
        for (int k = 0; k < sph_prim_scene_of((uint32_t)scene->facets[i].kind)->points; k++) {
            sph_grid_point(grid, scene->facets[i].v[k], ball.c);
            if (!sph_grid_fits(grid, &ball)) return 0;
        }
    return 1;
}

int sph_grid_fit(const struct sph_scene *scene, int w, int axes, struct sph_grid *grid,
                 struct sph_error *err) {
    struct sph_box box, lit;
    double back[3] = {0, 0, 1}; /* the camera's z */
    memset(grid, 0, sizeof *grid);
    grid->step = 1;
    grid->w = w;
    grid->axes = axes;
    if (sph_camera_axes(scene, grid->camera, err) ||
        bounds(scene, grid->camera, scene->n_spheres, &box, err))
        return -1;
    int planes = 0;
    for (uint32_t i = 0; i < scene->n_facets; i++)
        planes |= sph_kind_unbounded((uint32_t)scene->facets[i].kind);
    grid->seen_from = (struct sph_eye){scene->camera.from, 0, scene->camera.angle, 1, 0};
    if (!planes) grid->seen_from = sph_eye_place(scene, grid->camera + 6, box.lo, box.hi, w);
    memcpy(grid->rotation, axes == SPH_AXES_SCENE ? sph_scene_axes : grid->camera,
           sizeof grid->rotation);
    if (axes == SPH_AXES_SCENE) {
        memcpy(back, grid->camera + 6, sizeof back);
        if (bounds(scene, grid->rotation, scene->n_spheres, &box, err)) return -1;
    }
    for (int i = 0; i < 3; i++) {
        box.lo[i] += back[i] * grid->seen_from.ahead;
        box.hi[i] += back[i] * grid->seen_from.ahead;
    }
    sph_box_add(&box, (const double[3]){0, 0, 0}, 0); /* the eye */
    grid->huge = scene->n_spheres;
    if (!planes && !(grid->seen_from.ahead > 0))
        grid->huge = cut_huge(scene, grid->rotation, w, &box);
    add_corners(scene, grid->rotation, &box);
    lit = box;
    if (add_lights(scene, grid->seen_from.from, grid->rotation, &lit, err)) return -1;
    double span = side(scene, &box, w), all = side(scene, &lit, w), from[3];
    if (planes || all < FAR * span || !(span > 0)) box = lit, span = all;
    if (!isfinite(span)) return sph_fail(err, "%s: the scene is too large", scene->path);
    /* one unit too fine at most: all_fit() decides; 1 / unit has to be a number */
    if (span > 0) grid->log2 = (int)fmax(floor(log2(span / ldexp(1, w))), DBL_MIN_EXP);
    for (;; grid->log2++) {
        if (grid->log2 > DBL_MAX_EXP - w) /* its ends are no numbers */
            return sph_fail(err, "%s: the scene is too large", scene->path);
        grid->step = ldexp(1, grid->log2);
        if (span / grid->step > ldexp(1, w)) continue;
        for (int i = 0; i < 3; i++)
            grid->eye[i] = (int32_t)lround(-(box.lo[i] + box.hi[i]) / 2 / grid->step);
        if (all_fit(grid, scene, &box)) break;
    }
    sph_vec_turn(grid->rotation, grid->seen_from.from, from);
    for (int i = 0; i < 3; i++)
        grid->origin[i] = from[i] - grid->eye[i] * grid->step;
    return 0;
}
