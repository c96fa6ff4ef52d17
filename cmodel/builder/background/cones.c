/* cones.c - see cones.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/background/cones.h"

#include "machine/machine.h"

typedef __int128 wide;

/* The sphere as seen from the eye. */
struct view {
    int64_t oc[3], k;
};

/* f at direction dir; b too. */
static wide f_at(const struct view *v, const int64_t dir[3], int64_t *b, struct sph_work *work) {
    int64_t a = dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2];
    *b = v->oc[0] * dir[0] + v->oc[1] * dir[1] + v->oc[2] * dir[2];
    work->mul += 8;
    work->add += 5;
    return (wide)v->k * a + (wide)*b * *b;
}

struct sph_cone sph_cone_make(const struct sph_ball *ball, const int32_t eye[3],
                              const struct sph_rays *rays, struct sph_work *work) {
    struct view v = {.k = (int64_t)ball->r * ball->r};
    for (int i = 0; i < 3; i++) {
        v.oc[i] = (int64_t)ball->c[i] - eye[i];
        v.k -= v.oc[i] * v.oc[i];
    }
    wide f[3][3] = {{0}}; /* [y][x] */
    int64_t b[3][3] = {{0}};
    for (int y = 0; y <= 2; y++)
        for (int x = 0; x + y <= 2; x++) {
            int64_t dir[3] = {rays->x0 + x * (int64_t)rays->pitch,
                              rays->y0 - y * (int64_t)rays->pitch, rays->z};
            f[y][x] = f_at(&v, dir, &b[y][x], work);
        }
    /* oc and k; directions by steps of the pitch; the differences below */
    work->mul += 4;
    work->add += 6 + 4 + 11;
    return (struct sph_cone){
        .f = f[0][0],
        .fx = f[0][1] - f[0][0],
        .fy = f[1][0] - f[0][0],
        .fxx = f[0][2] - 2 * f[0][1] + f[0][0],
        .fxy = f[1][1] - f[1][0] - f[0][1] + f[0][0],
        .fyy = f[2][0] - 2 * f[1][0] + f[0][0],
        .b = b[0][0],
        .bx = b[0][1] - b[0][0],
        .by = b[1][0] - b[0][0],
        .inside = v.k > 0,
    };
}

void sph_cone_row(const struct sph_cone *cone, int width, int y, int32_t *first, int32_t *end,
                  struct sph_work *work) {
    wide f = cone->f + (wide)y * cone->fy + (wide)y * (y - 1) / 2 * cone->fyy;
    wide fx = cone->fx + (wide)y * cone->fxy;
    int64_t b = cone->b + y * cone->by;
    *first = *end = 0;
    for (int x = 0; x < width; x++) {
        if (f > 0 && (b > 0 || cone->inside)) {
            if (!*end) *first = x;
            *end = x + 1;
        }
        f += fx, fx += cone->fxx, b += cone->bx;
    }
    work->add += 3u * (unsigned)width + 3; /* a row's start follows from the row before */
    work->compare += 2u * (unsigned)width;
}

/* Stores the low n*32 bits of value in n words. */
static void store_words(uint32_t *line, int lsb, int n, wide value) {
    for (int i = 0; i < n; i++)
        line[lsb / 32 + i] = (uint32_t)((unsigned __int128)value >> 32 * i);
}

void sph_cone_put(uint32_t *lines, const struct sph_cone *cone) {
    store_words(lines, SPH_CONE_F_LSB, SPH_CONE_F_BITS / 32, cone->f);
    store_words(lines, SPH_CONE_FX_LSB, SPH_CONE_FX_BITS / 32, cone->fx);
    store_words(lines, SPH_CONE_FY_LSB, SPH_CONE_FY_BITS / 32, cone->fy);
    store_words(lines, SPH_CONE_FXX_LSB, SPH_CONE_FXX_BITS / 32, cone->fxx);
    store_words(lines, SPH_CONE_FXY_LSB, SPH_CONE_FXY_BITS / 32, cone->fxy);
    store_words(lines, SPH_CONE_FYY_LSB, SPH_CONE_FYY_BITS / 32, cone->fyy);
    store_words(lines, SPH_CONE_B_LSB, SPH_CONE_B_BITS / 32, cone->b);
    store_words(lines, SPH_CONE_BX_LSB, SPH_CONE_BX_BITS / 32, cone->bx);
    store_words(lines, SPH_CONE_BY_LSB, SPH_CONE_BY_BITS / 32, cone->by);
    store_words(lines, SPH_CONE_INSIDE_LSB & ~31, 1, cone->inside);
}
