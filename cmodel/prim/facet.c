/* facet.c - see facet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "prim/facet.h"

#include "core/stages.h"

static void cross(const int64_t a[3], const int64_t b[3], int64_t out[3]) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static sph_i128 dot(const int64_t a[3], const int64_t b[3]) {
    return (sph_i128)a[0] * b[0] + (sph_i128)a[1] * b[1] + (sph_i128)a[2] * b[2];
}

int sph_facet_own(const struct sph_ray *ray, const struct sph_facet_leaf *f) {
    uint32_t skip = ray->skip.id;
    return skip + f->before >= f->id && skip <= f->id + f->after;
}

/* Whether the point that the ray's origin was rounded from lies before the plane with the cube of
 * one guard bit around it: s N.(v0 2^NG - point) > |N_x| + |N_y| + |N_z|, s the sign of N.dir.
 * num: s N.(v0 - org). */
static int ahead(const struct sph_profile *p, const struct sph_ray *ray, const int64_t n[3],
                 int negative, sph_i128 num) {
    sph_i128 lift = dot(n, ray->lift), all = 0; /* s(2W+NG+3), u(2W+2) */
    for (int i = 0; i < 3; i++)
        all += n[i] < 0 ? -n[i] : n[i];
    return num * (1 << p->ng) + (negative ? -lift : lift) > all;
}

/* The volumes that the line spans with two of the edges: U1, U2; U0 + U1 + U2 = N.dir. */
static void volumes(const int64_t dir[3], const int64_t a0[3], const int64_t e1[3],
                    const int64_t e2[3], sph_i128 *u1, sph_i128 *u2) {
    int64_t m[3]; /* s(W+WD+1) */
    cross(dir, a0, m);
    *u2 = dot(m, e1), *u1 = -dot(m, e2); /* s(2W+WD+2) */
}

/* Whether the line meets the triangle, its edges included: the volumes have one sign. */
static int within(const int64_t dir[3], const int64_t a0[3], const int64_t e1[3],
                  const int64_t e2[3], sph_i128 det) {
    sph_i128 u1, u2;
    volumes(dir, a0, e1, e2, &u1, &u2);
    sph_i128 u0 = det - u1 - u2;
    return det > 0 ? u0 >= 0 && u1 >= 0 && u2 >= 0 : u0 <= 0 && u1 <= 0 && u2 <= 0;
}

/* Ends a ray that meets a plane farther than one unit beyond the grid: t becomes that of the face
 * there, along the longest axis of dir, which no point of the grid has behind it. Of the planes
 * there the nearest has the least to add to its key. */
static void end(const struct sph_profile *p, const struct sph_ray *ray,
                struct sph_facet_result *r) {
    int64_t half = (int64_t)1 << (p->w - 1), size[3];
    for (int i = 0; i < 3; i++)
        size[i] = ray->dir[i] < 0 ? -ray->dir[i] : ray->dir[i];
    int k = size[1] > size[0];
    if (size[2] > size[k]) k = 2;
    int64_t room = ray->dir[k] < 0 ? ray->org[k] + half + 1 : half - ray->org[k]; /* 1 .. 2^W */
    sph_i128 face = (sph_i128)r->det * room; /* of t = face / (num * size) that of the face */
    if (r->num * size[k] <= face) return;
    r->add = (uint64_t)(size[k] - (int64_t)((face + r->num - 1) / r->num));
    r->num = room;
    r->det = (sph_u128)size[k];
}

struct sph_facet_result sph_facet_test(const struct sph_profile *p, const struct sph_ray *ray,
                                       const struct sph_facet_leaf *f) {
    struct sph_facet_result r = {0};
    int64_t a0[3], e1[3], e2[3], n[3]; /* s(W+1), n: s(2W+1) */
    int plane = sph_facet_is_plane(f);
    for (int i = 0; i < 3; i++) {
        a0[i] = f->v[0][i] - ray->org[i];
        e1[i] = f->v[1][i] - f->v[0][i];
        e2[i] = f->v[2][i] - f->v[0][i];
        n[i] = f->v[1][i];
    }
    if (!plane) cross(e1, e2, n);
    sph_i128 det = dot(n, ray->dir), num = dot(n, a0);
    r.far = det > 0;
    r.det = (sph_u128)(det < 0 ? -det : det);
    r.num = det < 0 ? -num : num;

    if (plane) SPH_NOTE(ray->stages, SPH_STAGE_PLANE, f->id, det, num);
    if (ray->stages && !plane) {
        sph_i128 u1, u2;
        volumes(ray->dir, a0, e1, e2, &u1, &u2);
        SPH_NOTE(ray->stages, SPH_STAGE_TRIANGLE, f->id, det, num, u1, u2);
    }

    if (sph_facet_own(ray, f) || det == 0 || r.num <= 0) return r;
    int shadow = sph_ray_ends(ray);
    if (shadow && r.num >= (sph_i128)r.det) return r;
    if (shadow && !ahead(p, ray, n, det < 0, r.num)) return r;
    r.hit = plane || within(ray->dir, a0, e1, e2, det);
    if (plane && !shadow) end(p, ray, &r);
    return r;
}

uint64_t sph_facet_key(const struct sph_ray *ray, const struct sph_facet_result *r,
                       uint64_t *divisions) {
    ++*divisions;
    sph_u128 scaled = (sph_u128)r->num * ray->a; /* u(3W+2WD+1) */
    return (uint64_t)((scaled + r->det - 1) / r->det) + r->add;
}
