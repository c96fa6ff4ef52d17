/* map.c - see map.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/texture/map.h"

#include <math.h>

#include "math/fx.h"
#include "texture/coords.h"

enum {
    MANTISSA = SPH_MAP_S_X_BITS - 1,
    E_MIN = -(1 << (SPH_MAP_S_E_BITS - 1)),
    E_MAX = -E_MIN - 1,
    REPEATS = 32767 /* largest coordinate of a corner */
};
static const double one = 1 << SPH_ST_FRACTION;

/* What is linear in the hit point: `at` at the point `sum`/3, rising by `slope` a grid unit. */
struct linear {
    double at, slope[3];
    int64_t sum[3]; /* grid units */
};

/* Gradient as whole numbers; 0 if it is too steep for any. */
static int quantise(const struct linear *f, int ng, int32_t g[3], int *e) {
    double most = 0, unit = one / (1 << ng);
    for (int i = 0; i < 3; i++)
        most = fmax(most, fabs(f->slope[i]) * unit);
    *e = most > 0 ? MANTISSA - 1 - ilogb(most) : E_MAX;
    if (lround(ldexp(most, *e)) >= 1 << MANTISSA) --*e; /* rounds up to one bit more */
    if (*e > E_MAX) *e = E_MAX;
    if (*e < E_MIN) return 0;
    for (int i = 0; i < 3; i++)
        g[i] = (int32_t)lround(ldexp(f->slope[i] * unit, *e));
    return 1;
}

/* Writes one coordinate; lsb: of s_x or t_x. -1 if it is too steep. */
static int put_linear(uint32_t *map, int lsb, const struct linear *f, int ng) {
    int32_t g[3] = {0};
    int e = 0;
    if (!quantise(f, ng, g, &e)) return -1;
    sph_i128 dot = 0; /* three times that at the middle */
    for (int i = 0; i < 3; i++)
        dot += (sph_i128)g[i] * f->sum[i] * (1 << ng);
    if (e < 0) dot *= (sph_i128)1 << -e;
    sph_i128 third = 3 * ((sph_i128)1 << (e > 0 ? e : 0));
    sph_i128 middle = (2 * dot + third) / (2 * third);
    if ((2 * dot + third) % (2 * third) < 0) middle--; /* half up, as all */
    uint64_t start = (uint64_t)llround(f->at * one) - (uint64_t)middle;
    int to = lsb - SPH_MAP_S_X_LSB;
    for (int i = 0; i < 3; i++)
        sph_field_set(map, lsb + SPH_MAP_S_X_BITS * i, SPH_MAP_S_X_BITS, (uint32_t)g[i]);
    sph_field_set(map, to + SPH_MAP_S_E_LSB, SPH_MAP_S_E_BITS, (uint32_t)e);
    sph_field_set(map, to + SPH_MAP_S_0_LSB, 32, (uint32_t)start);
    sph_field_set(map, to + SPH_MAP_S_0_LSB + 32, SPH_MAP_S_0_BITS - 32, (uint32_t)(start >> 32));
    return 0;
}

static void put_base(const struct sph_texture_job *job, const struct sph_texture_shape *shape,
                     const struct sph_mip *mip, uint32_t *map) {
    int base = sph_bases_of(job->bases, job->id, shape, (double)mip->width * mip->height);
    sph_field_set(map, SPH_MAP_BASE_LSB, SPH_MAP_BASE_BITS, (uint32_t)base);
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot3(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

int sph_map_triangle(const struct sph_texture_job *job, const struct sph_facet *facet,
                     const int32_t corner[3][3], const struct sph_mip *mip, uint32_t *map,
                     struct sph_error *err) {
    struct sph_texture_shape shape = {.kind = SPH_SHAPE_TRIANGLE};
    double(*st)[2] = shape.st, e1[3], e2[3], n[3], along[2][3];
    struct linear f = {0};
    for (int i = 0; i < 3; i++) {
        e1[i] = (double)corner[1][i] - corner[0][i];
        e2[i] = (double)corner[2][i] - corner[0][i];
        f.sum[i] = (int64_t)corner[0][i] + corner[1][i] + corner[2][i];
        st[i][0] = facet->st[i][0];
        st[i][1] = 1 - facet->st[i][1];
        for (int k = 0; k < 2; k++)
            if (!(fabs(st[i][k]) <= REPEATS))
                return sph_fail(err, "%s:%u: a texture coordinate of %g, at most %d",
                                job->scene->path, facet->line, facet->st[i][k], REPEATS);
    }
    for (int k = 0; k < 3; k++) { /* as the scene has them: in every view the same */
        const struct sph_vec *v = &facet->v[k];
        const double at[3] = {v->x, v->y, v->z};
        for (int i = 0; i < 3; i++)
            shape.corner[k][i] = at[i] / job->grid->step;
    }
    cross(e1, e2, n);
    cross(e2, n, along[0]);
    cross(n, e1, along[1]);
    for (int k = 0; k < 2; k++) {
        f.at = (st[0][k] + st[1][k] + st[2][k]) / 3;
        for (int i = 0; i < 3; i++)
            f.slope[i] =
                ((st[1][k] - st[0][k]) * along[0][i] + (st[2][k] - st[0][k]) * along[1][i]) /
                dot3(n, n);
        int lsb = k ? SPH_MAP_T_X_LSB : SPH_MAP_S_X_LSB;
        struct linear flat = {.at = f.at};
        if (put_linear(map, lsb, &f, job->profile->ng)) /* a sliver: its middle stands for all */
            put_linear(map, lsb, &flat, job->profile->ng);
    }
    put_base(job, &shape, mip, map);
    return 0;
}

/* v in the camera's axes. */
static void turn(const struct sph_grid *grid, struct sph_vec v, double out[3]) {
    const double *m = grid->rotation;
    for (int i = 0; i < 3; i++)
        out[i] = m[3 * i] * v.x + m[3 * i + 1] * v.y + m[3 * i + 2] * v.z;
}

/* 1 if no point of the grid is more than the coordinate's word away. */
static int fits(const struct linear *f, int w) {
    double most = fabs(f->at);
    for (int i = 0; i < 3; i++)
        most += fabs(f->slope[i]) * (ldexp(1, w - 1) + fabs((double)f->sum[i]) / 3);
    return most < ldexp(1, SPH_ST_BITS - SPH_ST_FRACTION - 1) - 1;
}

int sph_map_plane(const struct sph_texture_job *job, const struct sph_facet *facet,
                  const int32_t point[3], const struct sph_mip *mip, uint32_t *map,
                  struct sph_error *err) {
    const struct sph_texture *texture = &job->scene->textures[facet->texture - 1];
    double n[3], along[2][3];
    turn(job->grid, facet->v[1], n);
    turn(job->grid, facet->v[2], along[0]);
    cross(n, along[0], along[1]); /* up; of any length */
    cross(along[1], n, along[0]); /* square to it and to n */
    for (int k = 0; k < 2; k++) {
        double length = sqrt(dot3(along[k], along[k]));
        double rise = job->grid->step / facet->st[0][k] / length;
        struct linear f = {.at = k ? 1 - facet->st[1][1] : facet->st[1][0]};
        for (int i = 0; i < 3; i++) {
            f.slope[i] = (k ? -1 : 1) * rise * along[k][i];
            f.sum[i] = 3ll * point[i];
        }
        if (texture->wrap[k] && !fits(&f, job->profile->w))
            return sph_fail(err, "%s:%u: clamped repeats of %g are too small for the scene",
                            job->scene->path, facet->line, facet->st[0][k]);
        if (!texture->wrap[k]) f.at -= floor(f.at);
        int lsb = k ? SPH_MAP_T_X_LSB : SPH_MAP_S_X_LSB;
        if (put_linear(map, lsb, &f, job->profile->ng))
            return sph_fail(err, "%s:%u: repeats of %g are too small for the grid, step %g",
                            job->scene->path, facet->line, facet->st[0][k], job->grid->step);
    }
    double step = job->grid->step;
    struct sph_texture_shape shape = {.kind = SPH_SHAPE_PLANE,
                                      .st = {{facet->st[0][0] / step, facet->st[0][1] / step}}};
    put_base(job, &shape, mip, map);
    return 0;
}

/* A repeat count as s7.8, an offset as s3.12; both have a field of 16 bits. */
static int put_scaled(const struct sph_texture_job *job, const struct sph_texture *texture, int k,
                      uint32_t *map, struct sph_error *err) {
    static const int scale_lsb[2] = {SPH_MAP_SCALE_S_LSB, SPH_MAP_SCALE_T_LSB};
    static const int plus_lsb[2] = {SPH_MAP_PLUS_S_LSB, SPH_MAP_PLUS_T_LSB};
    enum { HALF = 32768 };
    double scale = round(texture->repeat[k] * 256);
    if (!(scale >= 1 && scale < HALF))
        return sph_fail(err, "%s:%u: %g repeats on a sphere, not within 1/256 and 127",
                        job->scene->path, texture->line, texture->repeat[k]);
    double plus = k ? 1 - scale / 256 - texture->offset[k] : texture->offset[k];
    if (!texture->wrap[k]) plus -= floor(plus);
    plus = round(plus * 4096);
    if (!(fabs(plus) < HALF))
        return sph_fail(err, "%s:%u: an offset of %g on a sphere, clamped: beyond 7 repeats",
                        job->scene->path, texture->line, texture->offset[k]);
    sph_field_set(map, scale_lsb[k], 16, (uint32_t)(int32_t)scale);
    sph_field_set(map, plus_lsb[k], 16, (uint32_t)(int32_t)plus);
    return 0;
}

int sph_map_sphere(const struct sph_texture_job *job, const struct sph_sphere *sphere, int64_t rad,
                   const struct sph_mip *mip, uint32_t *map, struct sph_error *err) {
    const struct sph_texture *texture = &job->scene->textures[sphere->texture - 1];
    sph_field_set(map, SPH_MAP_KIND_LSB, SPH_MAP_KIND_BITS, 1);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) /* the rotation turned over: camera's axes to the world's */
            sph_field_set(map, SPH_MAP_TURN_LSB + SPH_MAP_TURN_BITS * (3 * i + j),
                          SPH_MAP_TURN_BITS,
                          (uint32_t)lround(32767 * job->grid->rotation[3 * j + i]));
    for (int k = 0; k < 2; k++)
        if (put_scaled(job, texture, k, map, err)) return -1;
    struct sph_texture_shape shape = {.kind = SPH_SHAPE_SPHERE,
                                      .st = {{texture->repeat[0], texture->repeat[1]}},
                                      .rad = (double)rad};
    put_base(job, &shape, mip, map);
    return 0;
}
