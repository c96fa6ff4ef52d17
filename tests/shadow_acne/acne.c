/* acne.c - see acne.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "acne.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "machine/records.h"
#include "prim/prim.h"
#include "scene/scene.h"
#include "texture/lookup.h"

static void cross(const long double a[3], const long double b[3], long double out[3]) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static long double dot(const long double a[3], const long double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void from_line(const uint32_t *line, struct acne_facet *f) {
    static const int lsb[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB, SPH_TRIANGLE_V2_X_LSB};
    f->leaf.kind = (int)sph_record_kind(1, line);
    for (int k = 0; k < 3; k++)
        sph_vector_read(line, lsb[k], 24, f->leaf.v[k]);
    if (f->leaf.kind == SPH_TRIANGLE) {
        f->leaf.before = sph_field(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS);
        f->leaf.after = sph_field(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        int64_t(*v)[3] = f->leaf.v;
        f->n[i] = (long double)(f->leaf.kind != SPH_TRIANGLE
                                    ? v[1][i]
                                    : (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) -
                                          (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]));
    }
}

int acne_open(struct acne *w, const char *path, const char *profile, struct sph_error *err) {
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_build_report report;
    struct sph_scene scene;
    memset(w, 0, sizeof *w);
    for (o.profile = 0; o.profile < SPH_PROFILES; o.profile++)
        if (!strcmp(sph_profiles[o.profile].name, profile)) break;
    if (o.profile == SPH_PROFILES) return sph_fail(err, "no profile is called %s", profile);
    if (sph_scene_read(path, NULL, &scene, err)) return -1;
    int rc = sph_build(&scene, &o, &w->m, &report, err);
    sph_scene_free(&scene);
    if (rc) return -1;
    const int32_t *r = w->m.regs;
    w->p = sph_machine_profile(&w->m);
    w->n_spheres = (uint32_t)(report.facets ? r[SPH_REG_N_SPHERES] : r[SPH_REG_N_PRIMS]);
    w->n_facets = report.facets;
    w->facet = calloc(w->n_facets + 1ull, sizeof *w->facet);
    w->sphere = calloc(w->n_spheres + 1ull, sizeof *w->sphere);
    if (!w->facet || !w->sphere) {
        acne_close(w);
        return sph_fail(err, "%s: no memory for its primitives", path);
    }
    for (uint32_t k = 0; k < w->n_facets; k++) {
        from_line(sph_line(&w->m, (uint32_t)r[SPH_REG_FACET_BASE] + k), &w->facet[k]);
        w->facet[k].leaf.id = w->n_spheres + k;
    }
    for (uint32_t k = 0; k < w->n_spheres; k++) {
        const uint32_t *line = sph_line(&w->m, (uint32_t)r[SPH_REG_PRIM_BASE] + k);
        int64_t ctr[3];
        sph_vector_read(line, SPH_LEAF_CTR_X_LSB, 24, ctr);
        for (int i = 0; i < 3; i++)
            w->sphere[k][i] = (long double)ctr[i];
        w->sphere[k][3] = (long double)sph_field(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
    }
    return 0;
}

void acne_close(struct acne *w) {
    sph_machine_free(&w->m);
    free(w->facet);
    free(w->sphere);
}

int acne_light(const struct acne *w, int l, long double at[3]) {
    const int32_t *lamp = w->m.regs + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
    int shift = lamp[3] >> SPH_LIGHT_SHIFT_LSB;
    for (int i = 0; i < 3; i++)
        at[i] = ldexpl((long double)lamp[i], shift);
    return shift < 24;
}

long double acne_height(const struct acne_facet *f, const long double at[3]) {
    long double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += f->n[i] * (at[i] - (long double)f->leaf.v[0][i]);
    return sum / sqrtl(dot(f->n, f->n));
}

int acne_common(const struct acne_facet *a, const struct acne_facet *b) {
    int common = 0;
    for (int i = 0; i < 9; i++)
        common += !memcmp(a->leaf.v[i / 3], b->leaf.v[i % 3], sizeof *a->leaf.v);
    return common;
}

/* Whether a facet lies between a point and a light, `d` away. */
static int facet_between(const struct acne_facet *f, const long double at[3],
                         const long double d[3]) {
    long double a0[3], e1[3], e2[3], m[3];
    for (int i = 0; i < 3; i++) {
        a0[i] = (long double)f->leaf.v[0][i] - at[i];
        e1[i] = (long double)(f->leaf.v[1][i] - f->leaf.v[0][i]);
        e2[i] = (long double)(f->leaf.v[2][i] - f->leaf.v[0][i]);
    }
    long double det = dot(f->n, d), num = dot(f->n, a0);
    if (det == 0 || num / det <= 1e-14L || num / det >= 1) return 0; /* 0 but for rounding */
    if (f->leaf.kind != SPH_TRIANGLE) return 1;
    cross(d, a0, m);
    long double u2 = dot(m, e1), u1 = -dot(m, e2), u0 = det - u1 - u2;
    return det > 0 ? u0 >= 0 && u1 >= 0 && u2 >= 0 : u0 <= 0 && u1 <= 0 && u2 <= 0;
}

int acne_dark(const struct acne *w, const struct acne_facet *own, const long double at[3],
              const long double light[3]) {
    long double d[3], oc[3];
    for (int i = 0; i < 3; i++)
        d[i] = light[i] - at[i];
    for (uint32_t k = 0; k < w->n_facets; k++) {
        const struct sph_facet_leaf *f = &w->facet[k].leaf;
        int group = own->leaf.id + f->before >= f->id && own->leaf.id <= f->id + f->after;
        if (!group && facet_between(&w->facet[k], at, d)) return 1;
    }
    for (uint32_t k = 0; k < w->n_spheres; k++) {
        for (int i = 0; i < 3; i++)
            oc[i] = w->sphere[k][i] - at[i];
        long double a = dot(d, d), b = dot(oc, d);
        long double disc = b * b - a * (dot(oc, oc) - w->sphere[k][3] * w->sphere[k][3]);
        if (disc <= 0) continue;
        long double root = sqrtl(disc), t = b > root ? b - root : b + root;
        if (t > 0 && t < a) return 1;
    }
    return 0;
}

static int inside(const struct acne_facet *f, const long double at[3]) {
    for (int k = 0; k < 3; k++) {
        const int64_t *a = f->leaf.v[k], *b = f->leaf.v[(k + 1) % 3];
        long double edge[3], way[3], c[3];
        for (int i = 0; i < 3; i++) {
            edge[i] = (long double)(b[i] - a[i]);
            way[i] = at[i] - (long double)a[i];
        }
        cross(edge, way, c);
        if (dot(c, f->n) < 0) return 0;
    }
    return 1;
}

int acne_explained(const struct acne *w, const struct acne_facet *own, const long double at[3],
                   const long double light[3], int dark) {
    long double x[3], y[3], point[3], n[3];
    for (int i = 0; i < 3; i++)
        x[i] = (long double)(own->leaf.v[1][i] - own->leaf.v[0][i]);
    long double size = sqrtl(dot(x, x)), length = sqrtl(dot(own->n, own->n));
    for (int i = 0; i < 3; i++)
        x[i] /= size, n[i] = own->n[i] / length;
    cross(n, x, y);
    for (int k = 0; k < 16 * 24; k++) { /* 16 circles, 24 points on each */
        long double far = 0.25L * (long double)(k / 24 + 1), angle = 0.26179938779915L * k + far;
        for (int i = 0; i < 3; i++)
            point[i] = at[i] + far * (cosl(angle) * x[i] + sinl(angle) * y[i]);
        if (inside(own, point) && acne_dark(w, own, point, light) == dark) return 1;
    }
    return 0;
}
