/* surface.c - see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/surface.h"

#include <stddef.h>

#include "core/stages.h"
#include "machine/records.h"
#include "math/fx.h"
#include "math/arith.h"

int sph_surface_point(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key,
                      struct sph_surface *s) {
    struct sph_quotient t = sph_quotient(key, p->w + p->wd + 2, ray->a, 2 * p->wd, p->pq);
    int shift = t.exp - p->ng, saturated = 0;
    if (shift < 0) shift = 0, saturated = 1; /* t too long for any point of the grid */
    if (shift > 62) shift = 62;              /* rounds to zero all the same */
    for (int i = 0; i < 3; i++) {
        int64_t offset = sph_round((int64_t)t.mant * ray->dir[i], shift);
        s->guarded[i] = sph_saturate(ray->org[i] * (1 << p->ng) + offset, p->w + p->ng, &saturated);
    }
    SPH_NOTE(ray->stages, SPH_STAGE_QUOTIENT, 0, t.mant, t.exp);
    return saturated;
}

int sph_surface_nearest(const struct sph_profile *p, struct sph_surface *s) {
    int saturated = 0;
    s->flat = 0;
    for (int i = 0; i < 3; i++)
        s->point[i] = sph_saturate(sph_round(s->guarded[i], p->ng), p->w, &saturated);
    return saturated;
}

int sph_surface_outwards(const struct sph_profile *p, int far, const int64_t vector[3],
                         struct sph_surface *s) {
    int64_t unit = 1ll << p->ng;
    int saturated = 0;
    s->flat = 1;
    for (int i = 0; i < 3; i++) {
        int64_t n = far ? -vector[i] : vector[i], up = n > 0 ? unit : n < 0 ? -1 : unit >> 1;
        s->point[i] = sph_saturate((s->guarded[i] + up) >> p->ng, p->w, &saturated);
    }
    return saturated;
}

void sph_surface_behind(const struct sph_profile *p, const struct sph_surface *s, int64_t out[3]) {
    int saturated, lost = p->w + 2 - p->pq;
    int64_t back = 2 + (lost < 0 ? 0 : 1ll << lost);
    for (int i = 0; i < 3; i++) {
        int side = s->flat ? (s->side[i] > 0) - (s->side[i] < 0) : 0;
        out[i] = sph_saturate(s->point[i] - side * back, p->w, &saturated);
    }
}

/* The normal along a vector. */
static void take(const struct sph_profile *p, const sph_i128 vector[3], struct sph_surface *s) {
    sph_normalise(vector, p->wd, s->normal);
    const int64_t *n = s->normal;
    s->nn = (uint64_t)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    s->unit = sph_unit(n, s->nn, p->wd);
}

void sph_surface_turn(const struct sph_profile *p, const struct sph_ray *ray, int far,
                      const int64_t vector[3], struct sph_surface *s) {
    sph_i128 normal[3];
    int any = vector[0] || vector[1] || vector[2];
    for (int i = 0; i < 3; i++)
        normal[i] = !any ? -ray->dir[i] : far ? -vector[i] : vector[i];
    take(p, normal, s);
    for (int i = 0; i < 3; i++)
        s->side[i] = s->normal[i];
    s->bent = 0;
}

void sph_surface_bend(const struct sph_profile *p, int far, const int64_t vector[3],
                      struct sph_surface *s) {
    sph_i128 normal[3];
    if (!vector[0] && !vector[1] && !vector[2]) return;
    for (int i = 0; i < 3; i++)
        normal[i] = far ? -vector[i] : vector[i];
    take(p, normal, s);
    s->bent = 1;
}

void sph_reflect(const struct sph_profile *p, const int64_t dir[3], const struct sph_surface *s,
                 int64_t out[3]) {
    const int64_t *n = s->normal;
    int64_t dn = dir[0] * n[0] + dir[1] * n[1] + dir[2] * n[2];
    sph_i128 mirrored[3];
    for (int i = 0; i < 3; i++)
        mirrored[i] = (sph_i128)dir[i] * s->nn - (sph_i128)n[i] * dn * 2;
    sph_normalise(mirrored, p->wd, out);
}

void sph_mirror(const struct sph_profile *p, const int64_t dir[3], const struct sph_surface *s,
                int64_t out[3]) {
    const int64_t *n = s->side;
    int64_t once[3];
    sph_reflect(p, dir, s, out);
    if (!s->bent || out[0] * n[0] + out[1] * n[1] + out[2] * n[2] >= 0) return;
    struct sph_surface facet = {.nn = (uint64_t)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])};
    for (int i = 0; i < 3; i++)
        facet.normal[i] = n[i], once[i] = out[i];
    sph_reflect(p, once, &facet, out);
}

/* ---- smooth ---- */

void sph_smooth_normal(const struct sph_profile *p, const uint32_t *record,
                       const int64_t guarded[3], int64_t normal[3]) {
    int e = (int)sph_field(record, SPH_SMOOTH_E_LSB, SPH_SMOOTH_E_BITS), limited;
    int64_t d[3]; /* s(W+NG) */
    for (int k = 0; k < 3; k++) {
        int64_t base = sph_field_signed(
            record, SPH_SMOOTH_B_X_LSB + (SPH_SMOOTH_B_Y_LSB - SPH_SMOOTH_B_X_LSB) * k, p->w);
        d[k] = sph_saturate(guarded[k] - base * (1 << p->ng), p->w + p->ng, &limited);
    }
    for (int i = 0; i < 3; i++) {
        int64_t sum = 0; /* s(W+NG+16) */
        for (int k = 0; k < 3; k++)
            sum += d[k] * sph_field_signed(record,
                                           SPH_SMOOTH_M_XX_LSB + SPH_SMOOTH_M_STEP * (3 * i + k),
                                           SPH_SMOOTH_M_XX_BITS);
        int64_t n = sph_field_signed(
            record, SPH_SMOOTH_N_X_LSB + (SPH_SMOOTH_N_Y_LSB - SPH_SMOOTH_N_X_LSB) * i,
            SPH_SMOOTH_N_X_BITS);
        normal[i] = sph_saturate(n + sph_round(sum, e), SPH_SMOOTH_BITS, &limited);
    }
}

const uint32_t *sph_smooth_record(const struct sph_machine *m, const uint32_t *prim, int *outside) {
    uint32_t number = sph_field(prim, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS);
    *outside = 0;
    if (!sph_machine_effect(m, SPH_EFFECT_SMOOTH) || sph_prim_kind(m, prim) == SPH_SPHERE ||
        !number)
        return NULL;
    uint64_t line = (uint64_t)(uint32_t)m->regs[SPH_REG_SMOOTH_BASE] + number - 1;
    if (line < (uint32_t)m->regs[SPH_REG_MEM_LINES]) return sph_line(m, line);
    *outside = 1;
    return NULL;
}
