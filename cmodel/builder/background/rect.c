/* rect.c - background separation in exact integers; see rect.h and docs/results/effects.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * In the xz plane a ray of slope s = n/d misses the circle (X, depth D, R), D > R, iff
 * (X - sD)^2 > R^2 (1 + s^2). The paper's point X + 1.4R has slope s with (X - sD)^2 = 1.96 R^2,
 * so all slopes beyond it miss if s^2 <= 0.96: 5s = (5X + 7R)/D, (5X + 7R)^2 <= 24 D^2.
 */
#include "builder/background/rect.h"

typedef __int128 wide;

struct circle {
    int64_t x, depth, r; /* relative to the eye */
};

/* Whether the slopes of both points X +- 1.4 R are at most sqrt(0.96). */
static int points_safe(const struct circle *c) {
    wide low = 5 * c->x - 7 * c->r, high = 5 * c->x + 7 * c->r,
         room = (wide)24 * c->depth * c->depth;
    return low * low <= room && high * high <= room;
}

/* (X d - n D)^2 - R^2 (d^2 + n^2): above zero iff a ray of slope n/d misses the circle. */
static wide miss(const struct circle *c, int64_t n, int64_t d) {
    wide offset = (wide)c->x * d - (wide)n * c->depth;
    return offset * offset - (wide)c->r * c->r * ((wide)d * d + (wide)n * n);
}

/* Pixels 0..count-1 have slopes (start + i*pitch)/d. The range of those between the slopes of the
 * points X +- 1.4 R, compared as 5 n D with (5 X +- 7 R) d; exact. */
static void between_points(const struct circle *c, int64_t start, int64_t pitch, int64_t d,
                           int count, int32_t *first, int32_t *end, struct sph_work *work) {
    wide low = (wide)(5 * c->x - 7 * c->r) * d, high = (wide)(5 * c->x + 7 * c->r) * d;
    wide n5 = (wide)5 * start * c->depth, step = (wide)5 * pitch * c->depth;
    for (int i = 0; i < count; i++, n5 += step) {
        if (n5 < low || n5 > high) continue;
        if (!*end) *first = i;
        *end = i + 1;
    }
    work->mul += 8;
    work->add += 2 + (unsigned)count;
    work->compare += 2 * (unsigned)count;
}

/* The range of those that meet the circle, with forward differences of miss(); exact. */
static void between_tangents(const struct circle *c, int64_t start, int64_t pitch, int64_t d,
                             int count, int32_t *first, int32_t *end, struct sph_work *work) {
    wide m = miss(c, start, d), next = miss(c, start + pitch, d);
    wide step = next - m, more = miss(c, start + 2 * pitch, d) - next - step;
    for (int i = 0; i < count; i++, m += step, step += more) {
        if (m > 0) continue;
        if (!*end) *first = i;
        *end = i + 1;
    }
    work->mul += 3 * 7;
    work->add += 3 * 3 + 5 + 2 * (unsigned)count;
    work->compare += (unsigned)count;
}

/* The range of pixels that may see the circle; both ends 0 if none may. */
static void range(const struct circle *c, int64_t start, int64_t pitch, int64_t d, int count,
                  int32_t *first, int32_t *end, struct sph_work *work) {
    *first = *end = 0;
    work->mul += 8;
    work->add += 2;
    work->compare += 2;
    if (points_safe(c))
        between_points(c, start, pitch, d, count, first, end, work);
    else
        between_tangents(c, start, pitch, d, count, first, end, work);
}

/* Widens a range that is not empty by a pixel at each side, within the frame. */
static void widen(int32_t *first, int32_t *end, int count) {
    if (*first > 0) --*first;
    if (*end < count) ++*end;
}

struct sph_rect sph_rect_project(const struct sph_ball *root, const int32_t eye[3],
                                 const struct sph_rays *rays, int width, int height,
                                 struct sph_work *work) {
    const struct sph_rect whole = {0, 0, width, height}, none = {0, 0, 0, 0};
    int64_t x = (int64_t)root->c[0] - eye[0], y = (int64_t)root->c[1] - eye[1];
    int64_t depth = (int64_t)eye[2] - root->c[2], r = root->r;
    work->add += 3 + 2, work->mul += 4, work->compare += 3;
    if (x * x + y * y + depth * depth <= r * r) return whole;
    if (depth <= -r) return none;
    if (depth <= r) return whole;

    struct circle column = {x, depth, r}, row = {-y, depth, r};
    struct sph_rect rect;
    range(&column, rays->x0, rays->pitch, -(int64_t)rays->z, width, &rect.x0, &rect.x1, work);
    range(&row, -(int64_t)rays->y0, rays->pitch, -(int64_t)rays->z, height, &rect.y0, &rect.y1,
          work);
    if (!rect.x1 || !rect.y1) return none;
    widen(&rect.x0, &rect.x1, width);
    widen(&rect.y0, &rect.y1, height);
    return rect;
}
