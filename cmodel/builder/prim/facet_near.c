/* facet_near.c - does a facet come near a sphere? See build.h, docs/design/builder.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * Exact integers in units of the error, 2^-(NG+1); with W = 24 and NG = 4 a coordinate has 29 bits,
 * the difference of two 30. Roots are taken upwards, which can only turn no to yes.
 */
#include "builder/grid/near.h"
#include "builder/prim/build.h"

typedef __int128 wide;

static wide dot(const int64_t a[3], const int64_t b[3]) {
    return (wide)a[0] * b[0] + (wide)a[1] * b[1] + (wide)a[2] * b[2];
}

static void sub(const int64_t a[3], const int64_t b[3], int64_t out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

/* An s with s*s >= v and, for small v, the smallest; v < 2^126. */
static wide ceil_root(wide v) {
    int shift = 0;
    while (v >> (2 * shift) >= (wide)1 << 60)
        shift++;
    return (wide)sph_ceil_sqrt((int64_t)(v >> (2 * shift)) + (shift > 0)) << shift;
}

/* Whether the segment a..b comes within r of c. */
static int segment_near(const int64_t a[3], const int64_t b[3], const int64_t c[3], int64_t r) {
    int64_t e[3], p[3], q[3];
    wide square = (wide)r * r;
    sub(b, a, e), sub(c, a, p), sub(c, b, q);
    if (dot(p, p) <= square || dot(q, q) <= square) return 1;
    wide along = dot(p, e), length = dot(e, e); /* 62 bits */
    return along > 0 && along < length && dot(p, p) * length - along * along <= square * length;
}

/* Whether the plane through a with the normal n comes within r of c. */
static int plane_near(const int64_t n[3], const int64_t a[3], const int64_t c[3], int64_t r) {
    int64_t p[3];
    sub(c, a, p);
    wide off = dot(n, p);
    return (off < 0 ? -off : off) <= r * ceil_root(dot(n, n));
}

/* The foot of c on the plane of the triangle lies in it: c is on the inner side of every edge. */
static int above(const int64_t v[3][3], const int64_t n[3], const int64_t c[3]) {
    for (int k = 0; k < 3; k++) {
        int64_t e[3], p[3];
        wide side = 0;
        sub(v[(k + 1) % 3], v[k], e), sub(c, v[k], p);
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, l = (i + 2) % 3;
            side += (wide)(e[j] * p[l] - e[l] * p[j]) * n[i]; /* 61 + 61 bits */
        }
        if (side < 0) return 0;
    }
    return 1;
}

/* Radius and centre of the ball in units of the error; the radius grown by it. */
static int64_t finer(const struct sph_ball *ball, const struct sph_profile *p, int64_t c[3]) {
    int64_t unit = 1ll << sph_error_bits(p);
    for (int i = 0; i < 3; i++)
        c[i] = ball->c[i] * unit;
    return ball->r * unit + sph_facet_error(p);
}

int sph_plane_near(const struct sph_grid_facet *f, const struct sph_ball *ball,
                   const struct sph_profile *p) {
    int64_t c[3], at[3], n[3], unit = 1ll << sph_error_bits(p), r = finer(ball, p, c);
    int64_t error = sph_point_error(p), room = 5 * unit; /* an axis, to where rays to planes end */
    if (error * error > 3 * room * room) return 1;
    for (int i = 0; i < 3; i++)
        at[i] = f->v[0][i] * unit, n[i] = f->v[1][i];
    return plane_near(n, at, c, r);
}

int sph_triangle_near(const struct sph_grid_facet *f, const struct sph_ball *ball,
                      const struct sph_profile *p) {
    int64_t v[3][3], c[3], n[3], e[2][3], unit = 1ll << sph_error_bits(p), r = finer(ball, p, c);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            v[k][i] = f->v[k][i] * unit;
    for (int k = 0; k < 3; k++)
        if (segment_near(v[k], v[(k + 1) % 3], c, r)) return 1;
    sub(v[1], v[0], e[0]), sub(v[2], v[0], e[1]);
    for (int i = 0; i < 3; i++) { /* 60 bits: e is 30 */
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = e[0][j] * e[1][k] - e[0][k] * e[1][j];
    }
    return above((const int64_t(*)[3])v, n, c) && plane_near(n, v[0], c, r);
}
