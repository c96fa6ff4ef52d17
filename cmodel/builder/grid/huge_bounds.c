/* huge_bounds.c - see huge_bounds.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "builder/grid/grid.h"
#include "builder/grid/huge_bounds.h"
#include "machine/records.h"
#include "scene/vector.h"

void sph_box_add(struct sph_box *box, const double at[3], double rad) {
    for (int i = 0; i < 3; i++) {
        box->lo[i] = fmin(box->lo[i], at[i] - rad);
        box->hi[i] = fmax(box->hi[i], at[i] + rad);
    }
}

double sph_box_side(const struct sph_box *box) {
    double side = 0;
    for (int i = 0; i < 3; i++)
        side = fmax(side, box->hi[i] - box->lo[i]);
    return side;
}

uint32_t sph_huge_sphere_find(const struct sph_scene *scene) {
    uint32_t largest = 0;
    for (uint32_t i = 1; i < scene->n_spheres; i++)
        if (scene->spheres[i].rad > scene->spheres[largest].rad) largest = i;
    if (!scene->n_spheres) return 0;
    const struct sph_material *m = &scene->materials[scene->spheres[largest].material];
    return m->sum.on && m->trans > 0 ? scene->n_spheres : largest;
}

/* |p - c|^2 - r^2 at the corner of a box where it is largest. */
static double tangent(const double at[3], double rad, const struct sph_box *box) {
    double square = -rad * rad;
    for (int i = 0; i < 3; i++) {
        double most = fmax(fabs(box->lo[i] - at[i]), fabs(box->hi[i] - at[i]));
        square += most * most;
    }
    return square;
}

int sph_huge_sphere_cut(const double at[3], double rad, const struct sph_box *rest, int w,
                        struct sph_box *box) {
    double from_eye = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    double square = tangent(at, rad, rest), all = sph_box_side(box);
    double off = 2 * SPH_GRID_MARGIN * ldexp(2 * all, -w);
    if (!(from_eye - rad > off) || !isfinite(square)) return 0;
    double far = sqrt(square + 4 * off * (rad + sqrt(square)));
    struct sph_box cut = *rest;
    for (int i = 0; i < 3; i++) {
        cut.lo[i] = fmin(cut.lo[i], fmax(rest->lo[i] - far, at[i] - rad));
        cut.hi[i] = fmax(cut.hi[i], fmin(rest->hi[i] + far, at[i] + rad));
    }
    sph_box_add(&cut, at, 0);
    if (sph_box_side(&cut) >= all) return 0;
    *box = cut;
    return 1;
}

/* ---- plane_bounds ---- */

#define ROUNDING 1e-9   /* of directions, at most */
#define POWER_50_DB 1e5 /* what is white over what may be off, both squared */

/* A plane seen from the eye: x is on the eye's side if normal.x + height >= 0. */
struct wall {
    struct sph_vec normal; /* of length 1, towards the eye */
    double height;
};

static struct sph_vec scaled(struct sph_vec v, double by) {
    return (struct sph_vec){v.x * by, v.y * by, v.z * by};
}

static struct sph_vec sum(struct sph_vec a, struct sph_vec b, struct sph_vec c) {
    return (struct sph_vec){a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z};
}

static struct wall wall_of(const struct sph_scene *scene, const struct sph_facet *f) {
    struct sph_vec n = scaled(f->v[1], 1 / sph_vec_length(f->v[1]));
    double height = sph_vec_dot(n, sph_vec_sub(scene->camera.from, f->v[0]));
    return (struct wall){height < 0 ? scaled(n, -1) : n, fabs(height)};
}

/* The planes; no more than there may be. */
static int walls_of(const struct sph_scene *scene, struct wall walls[SPH_MAX_PLANES]) {
    int n = 0;
    for (uint32_t i = 0; i < scene->n_facets && n < SPH_MAX_PLANES; i++)
        if (sph_kind_unbounded((uint32_t)scene->facets[i].kind))
            walls[n++] = wall_of(scene, &scene->facets[i]);
    return n;
}

/* Whether one can go on from the eye along v for ever, but for roundings; not asked of walls i and
 * j, along which v lies. */
static int unbounded(const struct wall *walls, int n, int i, int j, struct sph_vec v) {
    for (int k = 0; k < n; k++)
        if (k != i && k != j && sph_vec_dot(walls[k].normal, v) < -ROUNDING) return 0;
    return 1;
}

/* Directions in which nothing ends make a cone; if there are any, two walls' common ones are. */
static int closed(const struct wall *walls, int n) {
    int pairs = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            struct sph_vec v = sph_vec_cross(walls[i].normal, walls[j].normal);
            if (sph_vec_length(v) < ROUNDING) continue; /* parallel */
            if (unbounded(walls, n, i, j, v) || unbounded(walls, n, i, j, scaled(v, -1))) return 0;
            pairs++;
        }
    return pairs > 0;
}

int sph_plane_bounds_corners(const struct sph_scene *scene, struct sph_vec corners[SPH_CORNERS]) {
    struct wall w[SPH_MAX_PLANES];
    int n = walls_of(scene, w), found = 0;
    if (!closed(w, n)) return 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            for (int k = 0; k < j; k++) {
                struct sph_vec jk = sph_vec_cross(w[j].normal, w[k].normal);
                struct sph_vec ki = sph_vec_cross(w[k].normal, w[i].normal);
                struct sph_vec ij = sph_vec_cross(w[i].normal, w[j].normal);
                double det = sph_vec_dot(w[i].normal, jk);
                struct sph_vec at =
                    sum(scaled(jk, -w[i].height / det), scaled(ki, -w[j].height / det),
                        scaled(ij, -w[k].height / det));
                int inside = isfinite(at.x + at.y + at.z);
                for (int l = 0; l < n; l++)
                    if (l != i && l != j && l != k)
                        inside &= sph_vec_dot(w[l].normal, at) + w[l].height >= 0;
                if (inside) corners[found++] = at;
            }
    return found;
}

double sph_plane_bounds_reach(const struct sph_scene *scene) {
    struct wall w[SPH_MAX_PLANES];
    struct sph_vec corners[SPH_CORNERS];
    int n = walls_of(scene, w);
    double most = 0, slope = 2 * tan(scene->camera.angle * M_PI / 360);
    if (sph_plane_bounds_corners(scene, corners)) return 0;
    for (int i = 0; i < n; i++)
        for (int l = 0; l < scene->n_lights; l++) {
            const struct sph_light *light = &scene->lights[l];
            struct sph_vec from_eye = sph_vec_sub(light->pos, scene->camera.from);
            double height = sph_vec_dot(w[i].normal, from_eye) + w[i].height;
            double bright = fmax(light->rgb[0], fmax(light->rgb[1], light->rgb[2])) * height;
            most = fmax(most, cbrt(POWER_50_DB * w[i].height * bright * bright / slope));
        }
    return most;
}
