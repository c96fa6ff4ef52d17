/* check_vector.c - refracted rays and unit vectors; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "naive/math.h"
#include "naive/optics.h"
#include "shade/refract.h"
#include "surface.h"

/* Whether all is reflected: textbook by cosines of unit vectors, paper by the integers' formula. */
#define TOTAL(real, root, name)                                                                    \
    static int total_##name(int integers, const int64_t dir[3], const int64_t normal[3],           \
                            uint32_t from, uint32_t to) {                                          \
        real a = 0, n = 0, b = 0, eta = (real)from / (real)to, p = (real)from, q = (real)to;       \
        for (int i = 0; i < 3; i++) {                                                              \
            a += (real)dir[i] * (real)dir[i];                                                      \
            n += (real)normal[i] * (real)normal[i];                                                \
            b += (real)dir[i] * (real)normal[i];                                                   \
        }                                                                                          \
        if (integers) return q * q * a * n - p * p * (a * n - b * b) < 0;                          \
        real cosine = b / (root(a) * root(n));                                                     \
        return 1 - eta * eta * (1 - cosine * cosine) < 0;                                          \
    }
TOTAL(float, sqrtf, single)
TOTAL(double, sqrt, full)

void check_refraction(struct job *j) {
    const struct hard_case *c = j->c;
    struct sph_surface s = {.nn = 0};
    int64_t out[3] = {0}, other[3] = {0};
    for (int i = 0; i < 3; i++) {
        s.normal[i] = c->v[i];
        s.nn += (uint64_t)(c->v[i] * c->v[i]);
    }
    if (!s.nn || !j->ray.a) return; /* of no hit */
    s.unit = sph_unit(s.normal, s.nn, j->p->wd);
    int through = sph_refract(j->p, &j->ray, &s, c->from, c->to, out);
    int expected = exact_refract(j->p, c->ray.dir, c->v, c->from, c->to, other);
    j->t->hits += expected != 0;
    j->t->column[HARD_OURS].hit += through != expected;
    if (through != expected)
        job_wrong(j, HARD_HIT, "not reflected wholly where it should be, or so");
    if (memcmp(out, other, sizeof out)) job_wrong(j, HARD_BOUNCE, "not the rounded refracted ray");
    j->t->column[SPH_F32_TEXTBOOK].hit +=
        total_single(0, c->ray.dir, c->v, c->from, c->to) == expected;
    j->t->column[SPH_F32_PAPER].hit +=
        total_single(1, c->ray.dir, c->v, c->from, c->to) == expected;
    j->t->column[SPH_F64_TEXTBOOK].hit +=
        total_full(0, c->ray.dir, c->v, c->from, c->to) == expected;
    if (!j->naive) return;
    j->t->naive++;
    if (through != sph_naive_refract(j->p, c->ray.dir, c->v, c->from, c->to, other) ||
        memcmp(out, other, sizeof out))
        job_wrong(j, HARD_NAIVE, "refracted ray");
}

/* Within half a unit of 2^-16 above v/|v|, and SPH_RSQRT_ERROR of 2^16 more below. */
void check_units(struct job *j) {
    const int64_t *v = j->c->v;
    uint64_t vv = (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    struct sph_unit u = sph_unit(v, vv, j->p->wd);
    long double length = sqrtl((long double)vv);
    float single =
        sqrtf((float)v[0] * (float)v[0] + (float)v[1] * (float)v[1] + (float)v[2] * (float)v[2]);
    double full = sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] +
                       (double)v[2] * (double)v[2]);
    int64_t naive[3];
    j->t->hits += vv != 0;
    if (j->naive) sph_naive_unit(v, j->p->wd, naive), j->t->naive++;
    for (int i = 0; i < 3; i++) {
        if (j->naive && naive[i] != u.u[i]) job_wrong(j, HARD_NAIVE, "unit vector");
        if (!vv) {
            if (u.u[i]) job_wrong(j, HARD_UNIT, "a direction of nothing");
            continue;
        }
        long double exact = 65536 * fabsl((long double)v[i]) / length, got = abs(u.u[i]);
        struct hard_column *column = j->t->column;
        if (got > exact + 0.501L || got < exact * (1 - 7 / 65536.0L) - 0.501L)
            job_wrong(j, HARD_UNIT, "not v/|v|");
        if ((v[i] < 0 && u.u[i] > 0) || (v[i] > 0 && u.u[i] < 0))
            job_wrong(j, HARD_UNIT, "turned round");
        column[HARD_OURS].worst = fmax(column[HARD_OURS].worst, (double)fabsl(got - exact));
        double f32 = fabs(65536 * (double)(fabsf((float)v[i]) / single) - (double)exact);
        double f64 = fabs(65536 * (fabs((double)v[i]) / full) - (double)exact);
        column[SPH_F32_TEXTBOOK].worst = fmax(column[SPH_F32_TEXTBOOK].worst, f32);
        column[SPH_F64_TEXTBOOK].worst = fmax(column[SPH_F64_TEXTBOOK].worst, f64);
    }
}
