/* test_facet_near.c - does a facet come near a sphere: against the distance in long double
 * SPDX-License-Identifier: Apache-2.0
 *
 * Balls about as far from a triangle or plane as their radius and the bound of the error: above the
 * inside, an edge, a corner, or beside them. Small facets, for which roots are exact, and large
 * ones.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "builder/grid/facets.h"
#include "builder/grid/near.h"
#include "builder/prim/build.h"

typedef long double real;

static uint64_t state = 1;

static uint64_t random_word(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return state >> 20;
}
static int whole(int lo, int hi) {
    return lo + (int)(random_word() % (uint64_t)(hi - lo + 1));
}
static real part(void) {
    return (real)(random_word() & 0xffff) / 0x10000;
}

static real dot(const real a[3], const real b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static void cross(const real a[3], const real b[3], real out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Distance of p from the segment a..b. */
static real from_segment(const real a[3], const real b[3], const real p[3]) {
    real e[3], q[3];
    for (int i = 0; i < 3; i++)
        e[i] = b[i] - a[i], q[i] = p[i] - a[i];
    real length = dot(e, e), t = length > 0 ? fminl(1, fmaxl(0, dot(q, e) / length)) : 0;
    for (int i = 0; i < 3; i++)
        q[i] -= t * e[i];
    return sqrtl(dot(q, q));
}

/* Whether the foot of p on the plane lies in the triangle. */
static int inside(real v[3][3], const real n[3], const real p[3]) {
    for (int k = 0; k < 3; k++) {
        real e[3], q[3], c[3];
        for (int i = 0; i < 3; i++)
            e[i] = v[(k + 1) % 3][i] - v[k][i], q[i] = p[i] - v[k][i];
        cross(e, q, c);
        if (dot(c, n) < 0) return 0;
    }
    return 1;
}

/* How far p is from the facet; *rise: the plane's distance counts, whose root is taken upwards. */
static real distance(const struct sph_grid_facet *f, const real p[3], int plane, int *rise) {
    real v[3][3], n[3], q[3], least = INFINITY;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            v[k][i] = f->v[k][i];
    real a[3], b[3];
    for (int i = 0; i < 3; i++)
        a[i] = v[1][i] - v[0][i], b[i] = v[2][i] - v[0][i], q[i] = p[i] - v[0][i];
    cross(a, b, n);
    for (int i = 0; i < 3 && plane; i++)
        n[i] = v[1][i];
    *rise = plane || inside(v, n, p);
    if (*rise) return fabsl(dot(n, q)) / sqrtl(dot(n, n));
    for (int k = 0; k < 3; k++)
        least = fminl(least, from_segment(v[k], v[(k + 1) % 3], p));
    return least;
}

static int32_t clamp(real x, int w) {
    real most = ldexpl(1, w - 1) - 1;
    return (int32_t)fmaxl(-most, fminl(most, roundl(x)));
}

/* A facet whose coordinates are below size, and a ball about as near as can matter. */
static void make(const struct sph_profile *p, int size, int plane, int run,
                 struct sph_grid_facet *f, struct sph_ball *ball) {
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            f->v[k][i] = whole(-size, size);
    while (plane && !f->v[1][0] && !f->v[1][1] && !f->v[1][2])
        f->v[1][whole(0, 2)] = whole(-9, 9);
    const real n[3] = {f->v[1][0], f->v[1][1], f->v[1][2]}; /* of a plane */
    real s = part() * 1.4L - 0.2L, t = part() * 1.4L - 0.2L, way[3], length;
    if (whole(0, 3) == 0) s = whole(0, 1);
    if (whole(0, 3) == 0) t = whole(0, 1);
    do {
        real up = plane && run % 4 ? 1 / sqrtl(dot(n, n)) : 0; /* along the normal */
        for (int i = 0; i < 3; i++)
            way[i] = up ? n[i] * up : part() * 2 - 1;
        length = sqrtl(dot(way, way));
    } while (length < 0.1L);
    ball->r = whole(0, size);
    real bound = ldexpl((real)sph_facet_error(p), -sph_error_bits(p)) + ball->r;
    real far = (bound + whole(-2, 2) + part()) / length;
    for (int i = 0; i < 3; i++) {
        real at = f->v[0][i];
        if (!plane) at += s * (f->v[1][i] - f->v[0][i]) + t * (f->v[2][i] - f->v[0][i]);
        ball->c[i] = clamp(at + far * way[i], p->w);
    }
}

static int empty(const struct sph_grid_facet *f) {
    real a[3], b[3], n[3];
    for (int i = 0; i < 3; i++)
        a[i] = f->v[1][i] - f->v[0][i], b[i] = f->v[2][i] - f->v[0][i];
    cross(a, b, n);
    return dot(n, n) < 1;
}

static void check(int plane) {
    int met[2] = {0, 0}, wilder = 0;
    for (int run = 0; run < 200000; run++) {
        struct sph_profile coarse = sph_profiles[SPH_STANDARD]; /* its points are far off */
        coarse.pq = 8;
        int which = run % (SPH_PROFILES + 1);
        const struct sph_profile *p = which < SPH_PROFILES ? &sph_profiles[which] : &coarse;
        struct sph_grid_facet f = {.kind = plane ? SPH_PLANE : SPH_TRIANGLE};
        struct sph_ball ball;
        int size = 1 << whole(1, p->w - 2), rise;
        make(p, size, plane, run / 5, &f, &ball);
        if (!plane && empty(&f)) continue;
        const real c[3] = {ball.c[0], ball.c[1], ball.c[2]};
        real unit = ldexpl(1, -sph_error_bits(p)), error = unit * (real)sph_facet_error(p);
        real off = distance(&f, c, plane, &rise), reach = ball.r + error;
        /* a root of n.n that is rounded up; of a triangle in finer units */
        real a[3], b[3], n[3];
        for (int i = 0; i < 3; i++)
            a[i] = (f.v[1][i] - f.v[0][i]) / unit, b[i] = (f.v[2][i] - f.v[0][i]) / unit;
        cross(a, b, n);
        for (int i = 0; i < 3 && plane; i++)
            n[i] = f.v[1][i];
        real root = sqrtl(dot(n, n)), up = root < 0x1p30L ? ceill(root) : root * (1 + 0x1p-28L);
        real least = reach * (1 - 1e-15L), most = reach * (rise ? up / root : 1) * (1 + 1e-15L);
        int near = plane ? sph_plane_near(&f, &ball, p) : sph_triangle_near(&f, &ball, p);
        if (off < least) assert_true(near);
        int wild = plane && (real)sph_point_error(p) > 5 * sqrtl(3) / unit;
        wilder += wild;
        if (wild)
            assert_true(near);
        else if (off > most)
            assert_false(near);
        met[near]++;
    }
    printf("# apart %d, near %d\n", met[0], met[1]);
    assert_true(met[0] > 10000 && met[1] > 10000 && !wilder == !plane);
}

static void test_triangle(void **unused) {
    (void)unused;
    check(0);
}
static void test_plane(void **unused) {
    (void)unused;
    check(1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_triangle),
                                       cmocka_unit_test(test_plane)};
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
