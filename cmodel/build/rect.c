/* rect.c - background separation in exact integers; see rect.h and docs/build.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * In the xz plane a ray of slope s = n/d misses the circle (X, depth D, R), D > R, iff
 * (X - sD)^2 > R^2 (1 + s^2). The paper's point X + 1.4R has slope s with (X - sD)^2 = 1.96 R^2,
 * so all slopes beyond it miss if s^2 <= 0.96: 5s = (5X + 7R)/D, (5X + 7R)^2 <= 24 D^2.
 */
#include "build/rect.h"

typedef __int128 wide;

struct circle {
    int64_t x, depth, r; /* relative to the eye */
};

/* Whether a ray of slope n/d misses the circle; exact. */
static int misses(const struct circle *c, int64_t n, int64_t d) {
    wide offset = (wide)c->x * d - (wide)n * c->depth;
    return offset * offset > (wide)c->r * c->r * ((wide)d * d + (wide)n * n);
}

/* Whether the slopes of both points X +- 1.4 R are at most sqrt(0.96). */
static int points_safe(const struct circle *c) {
    wide low = 5 * c->x - 7 * c->r, high = 5 * c->x + 7 * c->r,
         room = (wide)24 * c->depth * c->depth;
    return low * low <= room && high * high <= room;
}

/* Whether slope n/d lies outside the slopes of the points X +- 1.4 R; exact. */
static int outside(const struct circle *c, int64_t n, int64_t d) {
    wide n5 = (wide)5 * n * c->depth;
    return n5 < (wide)(5 * c->x - 7 * c->r) * d || n5 > (wide)(5 * c->x + 7 * c->r) * d;
}

/* The range of pixels 0..count-1 with numerators start + i*pitch that may see the circle. */
static void range(const struct circle *c, int64_t start, int64_t pitch, int64_t d, int count,
                  int32_t *first, int32_t *end) {
    int points = points_safe(c);
    *first = *end = 0;
    for (int i = 0; i < count; i++) {
        int64_t n = start + i * pitch;
        if (points ? outside(c, n, d) : misses(c, n, d)) continue;
        if (!*end) *first = i;
        *end = i + 1;
    }
}

/* Widens a range that is not empty by a pixel at each side, within the frame. */
static void widen(int32_t *first, int32_t *end, int count) {
    if (*first > 0) --*first;
    if (*end < count) ++*end;
}

struct sph_rect sph_rect_project(const struct sph_ball *root, const int32_t eye[3],
                                 const struct sph_rays *rays, int width, int height) {
    const struct sph_rect whole = {0, 0, width, height}, none = {0, 0, 0, 0};
    int64_t x = (int64_t)root->c[0] - eye[0], y = (int64_t)root->c[1] - eye[1];
    int64_t depth = (int64_t)eye[2] - root->c[2], r = root->r;
    if (x * x + y * y + depth * depth <= r * r) return whole;
    if (depth <= -r) return none;
    if (depth <= r) return whole;

    struct circle column = {x, depth, r}, row = {-y, depth, r};
    struct sph_rect rect;
    range(&column, rays->x0, rays->pitch, -(int64_t)rays->z, width, &rect.x0, &rect.x1);
    range(&row, -(int64_t)rays->y0, rays->pitch, -(int64_t)rays->z, height, &rect.y0, &rect.y1);
    if (!rect.x1 || !rect.y1) return none;
    widen(&rect.x0, &rect.x1, width);
    widen(&rect.y0, &rect.y1, height);
    return rect;
}
