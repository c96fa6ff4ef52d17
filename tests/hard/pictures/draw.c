/* draw.c - see draw.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "draw.h"

#include <math.h>
#include <stdlib.h>

#include "../exact.h"
#include "reference/floats.h"
#include "pixel/walk.h"
#include "prim/sphere.h"

struct draw_scene draw_scene(const struct sph_machine *m) {
    struct draw_scene s = {.m = m, .n = (uint32_t)m->regs[SPH_REG_N_PRIMS]};
    s.spheres = malloc((s.n + !s.n) * sizeof *s.spheres);
    if (!s.spheres) {
        perror("draw_scene");
        exit(2);
    }
    for (uint32_t i = 0; i < s.n; i++) {
        const uint32_t *line =
            m->mem + (size_t)SPH_LINE_WORDS * ((uint32_t)m->regs[SPH_REG_PRIM_BASE] + i);
        s.spheres[i] = sph_sphere_read(line, sph_machine_profile(m)->w);
    }
    return s;
}

/* The primary ray, in integers. */
static struct sph_ray primary(const struct draw_scene *s, int x, int y) {
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    for (int i = 0; i < 3; i++)
        ray.org[i] = s->m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(s->m, x, y, ray.dir);
    return ray;
}

/* Colour of the background, or of a surface that the lights of `shines` reach. */
static struct draw_pixel shade(const struct draw_scene *s, uint32_t id, const double at[3],
                               const double normal[3], uint32_t shines) {
    const int32_t *r = s->m->regs;
    struct draw_pixel p = {.id = id};
    double sum[3];
    for (int i = 0; i < 3; i++) {
        sum[i] = r[SPH_REG_AMBIENT_R + i] / 32768.0;
        p.rgb[i] = (uint8_t)(r[SPH_REG_BG_COLOUR] >> (8 * i) & 255);
    }
    if (id == SPH_ID_NONE) return p;
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        double dot = 0, nn = 0, ll = 0;
        for (int i = 0; i < 3; i++) {
            double to = lamp[i] - at[i];
            dot += to * normal[i];
            nn += normal[i] * normal[i];
            ll += to * to;
        }
        if (!(dot > 0) || !(shines >> l & 1)) continue;
        for (int i = 0; i < 3; i++)
            sum[i] += dot / sqrt(nn * ll) * lamp[3 + i] / 32768.0;
    }
    const uint32_t *line =
        s->m->mem + (size_t)SPH_LINE_WORDS * ((uint32_t)r[SPH_REG_PRIM_BASE] + id);
    for (int i = 0; i < 3; i++) {
        double albedo = sph_field(line, SPH_PRIM_RED_LSB + 8 * i, 8);
        p.rgb[i] = (uint8_t)(fmin(albedo * sum[i], 255) + 0.5);
    }
    return p;
}

/* ---- floating point ---- */

/* x as the formula's type has it. A sum, product or quotient of two floats, or a root, taken in
 * double and rounded again is that of float. */
static double rounded(int formula, double x) {
    return formula == SPH_F64_TEXTBOOK ? x : (double)(float)x;
}

/* Whether anything lies between a point and a light. */
static int hidden(const struct draw_scene *s, struct draw_way way, const double at[3],
                  const int32_t lamp[3]) {
    double dir[3], length2 = 0;
    for (int i = 0; i < 3; i++) {
        dir[i] = rounded(way.formula, lamp[i] - at[i]);
        length2 = rounded(way.formula, length2 + rounded(way.formula, dir[i] * dir[i]));
    }
    double length = rounded(way.formula, sqrt(length2));
    double least = rounded(way.formula, rounded(way.formula, way.epsilon) / length);
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        double ctr[3] = {(double)ball->ctr[0], (double)ball->ctr[1], (double)ball->ctr[2]};
        if (sph_float_between(sph_float_roots(way.formula, at, dir, ctr, (double)ball->rad), least,
                              1)
                .hit)
            return 1;
    }
    return 0;
}

struct draw_pixel draw_float(const struct draw_scene *s, struct draw_way way, int x, int y) {
    struct sph_ray ray = primary(s, x, y);
    struct sph_floats best = {0, 0, INFINITY};
    double org[3], dir[3], at[3] = {0}, normal[3] = {0};
    uint32_t id = SPH_ID_NONE, shines = ~0u;
    const int32_t *r = s->m->regs;
    for (int i = 0; i < 3; i++) {
        org[i] = (double)ray.org[i];
        dir[i] = (double)ray.dir[i];
    }
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        double ctr[3] = {(double)ball->ctr[0], (double)ball->ctr[1], (double)ball->ctr[2]};
        struct sph_floats hit = sph_float_between(
            sph_float_roots(way.formula, org, dir, ctr, (double)ball->rad), 0, best.t);
        if (!hit.hit) continue;
        best = hit;
        id = i;
    }
    if (id == SPH_ID_NONE) return shade(s, id, at, normal, 0);
    for (int i = 0; i < 3; i++) {
        at[i] = rounded(way.formula, org[i] + rounded(way.formula, best.t * dir[i]));
        normal[i] = rounded(way.formula, at[i] - (double)s->spheres[id].ctr[i]);
        if (best.far) normal[i] = -normal[i];
    }
    for (int l = 0; sph_machine_effect(s->m, SPH_EFFECT_SHADOW) && l < r[SPH_REG_N_LIGHTS]; l++)
        if (hidden(s, way, at, r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE)) shines &= ~(1u << l);
    return shade(s, id, at, normal, shines);
}

/* ---- exactly ---- */

/* Whether another sphere than `own` lies between a point outside of it and a light. */
static int hidden_exact(const struct draw_scene *s, uint32_t own, const long double at[3],
                        const int32_t lamp[3]) {
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        long double a = 0, b = 0, c = -(long double)ball->rad * (long double)ball->rad;
        if (i == own) continue;
        for (int j = 0; j < 3; j++) {
            long double oc = (long double)ball->ctr[j] - at[j], d = lamp[j] - at[j];
            a += d * d;
            b += oc * d;
            c += oc * oc;
        }
        long double disc = b * b - a * c;
        if (!(disc > 0)) continue;
        long double root = sqrtl(disc), near = b - root, far = b + root;
        if ((near > 0 && near < a) || (far > 0 && far < a)) return 1;
    }
    return 0;
}

struct draw_pixel draw_exact(const struct draw_scene *s, int x, int y) {
    struct sph_ray ray = primary(s, x, y);
    struct exact best = {0};
    long double point[3];
    double at[3] = {0}, normal[3] = {0};
    uint32_t id = SPH_ID_NONE, shines = ~0u;
    const int32_t *r = s->m->regs;
    for (uint32_t i = 0; i < s->n; i++) {
        struct exact e = exact_leaf(&ray, &s->spheres[i]);
        if (!e.hit || (id != SPH_ID_NONE && exact_order(&e, &best) >= 0)) continue;
        best = e;
        id = i;
    }
    if (id == SPH_ID_NONE) return shade(s, id, at, normal, 0);
    for (int i = 0; i < 3; i++) {
        point[i] = (long double)ray.org[i] + exact_t(&best) * (long double)ray.dir[i];
        at[i] = (double)point[i];
        normal[i] = (double)(point[i] - (long double)s->spheres[id].ctr[i]);
        if (best.far) normal[i] = -normal[i];
    }
    for (int l = 0; sph_machine_effect(s->m, SPH_EFFECT_SHADOW) && l < r[SPH_REG_N_LIGHTS]; l++)
        if (hidden_exact(s, id, point, r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE))
            shines &= ~(1u << l);
    return shade(s, id, at, normal, shines);
}
