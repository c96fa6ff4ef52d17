/* bound.c - spheres in filter units that hold grid spheres, in exact integers; see bound.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/bound.h"

#include <math.h>

#include "math/fx.h"

int64_t sph_ceil_sqrt(int64_t v) {
    int64_t s = (int64_t)sqrt((double)v);
    while (s * s < v)
        s++;
    while (s > 0 && (s - 1) * (s - 1) >= v)
        s--;
    return s;
}

/* v / 2^k, up. */
static int64_t ceil_shift(int64_t v, int k) {
    return -(-v >> k);
}

int32_t sph_filter_coord(int64_t v, const struct sph_profile *profile) {
    int64_t top = (1ll << (profile->fw - 1)) - 1;
    int64_t f = sph_round(v, profile->w - profile->fw);
    return (int32_t)(f > top ? top : f < -top - 1 ? -top - 1 : f);
}

/* The square of how far a ball's centre is from filter point cf, in grid units. */
static int64_t apart(const int32_t cf[3], const struct sph_ball *ball, int k) {
    int64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        int64_t d = (int64_t)cf[i] * (1ll << k) - ball->c[i];
        sum += d * d;
    }
    return sum;
}

int32_t sph_filter_radius(const int32_t cf[3], const struct sph_ball *ball, int k) {
    return (int32_t)ceil_shift(sph_ceil_sqrt(apart(cf, ball, k)) + ball->r, k);
}

struct sph_ball sph_filter_leaf(const struct sph_ball *leaf, const struct sph_profile *profile) {
    struct sph_ball out;
    for (int i = 0; i < 3; i++)
        out.c[i] = sph_filter_coord(leaf->c[i], profile);
    out.r = sph_filter_radius(out.c, leaf, profile->w - profile->fw);
    return out;
}

/* The smallest filter radius at cf that holds all balls, or `enough` if it would be no less. */
static int64_t radius_all(const int32_t cf[3], const struct sph_ball *balls, const uint32_t *index,
                          uint32_t n, int k, int64_t enough) {
    int64_t most = 0;
    for (uint32_t i = 0; i < n; i++) {
        const struct sph_ball *ball = &balls[index ? index[i] : i];
        int64_t sum = apart(cf, ball, k), room = most - ball->r;
        if (room >= 0 && sum <= room * room) continue; /* no farther */
        most = sph_ceil_sqrt(sum) + ball->r;
        if (ceil_shift(most, k) >= enough) return enough;
    }
    return ceil_shift(most, k);
}

struct sph_ball sph_filter_whole(const struct sph_profile *profile) {
    int64_t half = 1ll << (profile->fw - 1);
    return (struct sph_ball){.r = (int32_t)sph_ceil_sqrt(3 * half * half)};
}

struct sph_ball sph_filter_enclose(const struct sph_ball *balls, const uint32_t *index, uint32_t n,
                                   const struct sph_profile *profile) {
    double sphere[4];
    sph_enclose(balls, index, n, sphere);
    return sph_filter_around(balls, index, n, sphere, profile);
}

struct sph_ball sph_filter_around(const struct sph_ball *balls, const uint32_t *index, uint32_t n,
                                  const double sphere[4], const struct sph_profile *profile) {
    enum { FEW = 64 };
    int k = profile->w - profile->fw;
    double unit = ldexp(1.0, k);
    struct sph_ball best;
    for (int i = 0; i < 3; i++)
        best.c[i] = sph_filter_coord((int64_t)llround(sphere[i]), profile);
    int64_t r = radius_all(best.c, balls, index, n, k, INT32_MAX);
    for (int corner = 0; corner < 8 && n <= FEW; corner++) {
        int32_t cf[3];
        for (int i = 0; i < 3; i++) {
            double down = floor(sphere[i] / unit) + (corner >> i & 1);
            cf[i] = sph_filter_coord((int64_t)(down * unit), profile);
        }
        int64_t other = radius_all(cf, balls, index, n, k, r);
        if (other < r) {
            r = other;
            for (int i = 0; i < 3; i++)
                best.c[i] = cf[i];
        }
    }
    best.r = (int32_t)r;
    struct sph_ball whole = sph_filter_whole(profile);
    return best.r > whole.r ? whole : best;
}

struct sph_ball sph_grid_whole(const struct sph_profile *profile) {
    int64_t half = 1ll << (profile->w - 1);
    return (struct sph_ball){.r = (int32_t)sph_ceil_sqrt(3 * half * half)};
}
