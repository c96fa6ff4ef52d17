/* main.c - shadow_acne: pixels of triangles that are falsely dark or lit, by rules of where rays
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: shadow_acne SCENE.nff PROFILE [--show]
 * Prints rows "dark lit" for each rule of rules[]. A pixel counts if no point of its triangle
 * within 4 units of what the eye meets has the light that it has. Points, lights and triangles are
 * those of the grid, their light is taken in long double by testing every primitive: 64 bits of
 * mantissa hold products of three coordinates of 20 bits. --show prints each pixel that would be
 * falsely dark if every facet ahead of a ray's start counted: what the eye meets, where the ray
 * starts, what it would meet there.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "builder/build.h"
#include "common/parallel.h"
#include "machine/records.h"
#include "pixel/background.h"
#include "prim/facet.h"
#include "prim/prim.h"
#include "scene/scene.h"
#include "texture/lookup.h"
#include "trace/setup.h"
#include "trace/traverse.h"

/* ---- a machine's facets as real numbers: which of their points have light ---- */

/* Where a ray to a light starts: at the nearest point of the grid; at the next one outwards; there
 * too, but as the machine's do it meets no facet that the guarded point may have behind it. */
enum { NEAREST, OUTWARDS, GUARDED, RULES };

struct acne_facet {
    struct sph_facet_leaf leaf;
    long double n[3]; /* N */
};

struct acne {
    struct sph_machine m;
    const struct sph_profile *p;
    struct acne_facet *facet;
    long double (*sphere)[4]; /* centre, radius */
    uint32_t n_facets, n_spheres;
};

/* Reads and builds a scene. 0, or -1 with a message: as sph_scene_read() and sph_build() say, no
 * such profile, no memory. */
int acne_open(struct acne *w, const char *path, const char *profile, struct sph_error *err);
void acne_close(struct acne *w);

/* Where light l is, grid units; 0 if it is too far away for 64-bit numbers. */
int acne_light(const struct acne *w, int l, long double at[3]);

/* Distance of a point from a facet's plane, to the side of N. */
long double acne_height(const struct acne_facet *f, const long double at[3]);

/* Corners that two triangles have in common. */
int acne_common(const struct acne_facet *a, const struct acne_facet *b);

/* Whether anything lies between a point of a facet and a light. */
int acne_dark(const struct acne *w, const struct acne_facet *own, const long double at[3],
              const long double light[3]);

/* Whether some point of the facet within 4 units of `at` is dark or not, as `dark` says. */
int acne_explained(const struct acne *w, const struct acne_facet *own, const long double at[3],
                   const long double light[3], int dark);

/* ---- acne ---- */

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

static const char *const rules[RULES] = {"nearest", "outwards", "guarded"};

/* What the eye meets. */
struct seen {
    struct sph_ray ray;
    struct sph_hit hit;
    const struct acne_facet *facet;
    int64_t normal[3]; /* of its record */
    long double at[3];
};

static int look(const struct acne *w, int x, int y, struct seen *s) {
    struct sph_counters c = {0};
    uint32_t visits = 0, errors = 0;
    *s = (struct seen){.ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1}};
    for (int i = 0; i < 3; i++)
        s->ray.org[i] = w->m.regs[SPH_REG_EYE_X + i];
    sph_primary_dir(&w->m, x, y, s->ray.dir);
    sph_ray_setup(w->p, &s->ray);
    s->hit = sph_traverse(&w->m, &s->ray, SPH_TRAVERSE_TREE, &c, &visits, &errors);
    if (!s->hit.key || s->hit.id < w->n_spheres) return 0;
    s->facet = &w->facet[s->hit.id - w->n_spheres];
    if (s->facet->leaf.kind != SPH_TRIANGLE) return 0;
    sph_stored_normal(w->p, sph_line(&w->m, (uint32_t)w->m.regs[SPH_REG_PRIM_BASE] + s->hit.id),
                      NULL, s->normal);
    long double num = 0, det = 0;
    for (int i = 0; i < 3; i++) {
        num += s->facet->n[i] * (long double)(s->facet->leaf.v[0][i] - s->ray.org[i]);
        det += s->facet->n[i] * (long double)s->ray.dir[i];
    }
    for (int i = 0; i < 3; i++)
        s->at[i] = (long double)s->ray.org[i] + num / det * (long double)s->ray.dir[i];
    return 1;
}

/* Id + 1 of what keeps light l from the surface by a rule, 0: lit. */
static uint32_t blocked(const struct acne *w, const struct seen *eye, int rule, int l,
                        int64_t from[3]) {
    const int32_t *lamp = w->m.regs + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
    struct sph_ray to = {.kind = SPH_SHADOW, .skip = {eye->hit.id, eye->hit.far}, .inside = 1};
    struct sph_counters c = {0};
    uint32_t visits = 0, errors = 0;
    struct sph_surface s;
    sph_surface_point(w->p, &eye->ray, eye->hit.key, &s);
    if (rule == NEAREST)
        sph_surface_nearest(w->p, &s);
    else
        sph_surface_outwards(w->p, eye->hit.far, eye->normal, &s);
    sph_surface_spawn(w->p, &s, &to);
    for (int i = 0; i < 3; i++) {
        from[i] = s.point[i];
        to.dir[i] = lamp[i] - sph_round(s.point[i], lamp[3] >> SPH_LIGHT_SHIFT_LSB);
        if (rule != GUARDED) to.lift[i] = to.dir[i] * (1ll << 40); /* all is ahead of it */
    }
    sph_ray_setup(w->p, &to);
    struct sph_hit by = sph_traverse(&w->m, &to, SPH_TRAVERSE_TREE, &c, &visits, &errors);
    return by.key ? by.id + 1 : 0;
}

static void show(const struct acne *w, const struct seen *s, const int64_t from[3],
                 const long double light[3], uint32_t by, int x, int y) {
    if (by < w->n_spheres) return;
    const struct acne_facet *f = &w->facet[by - w->n_spheres];
    printf("pixel %d,%d: facet %u at %.3Lf %.3Lf %.3Lf, from %ld %ld %ld, meets facet %u;", x, y,
           s->hit.id, s->at[0], s->at[1], s->at[2], (long)from[0], (long)from[1], (long)from[2],
           by);
    long double start[3] = {(long double)from[0], (long double)from[1], (long double)from[2]};
    printf(" before it %.4Lf, its start %.4Lf, the light %.1Lf units; %d corners in common\n",
           acne_height(f, s->at), acne_height(f, start), acne_height(f, light),
           acne_common(s->facet, f));
}

/* A picture, and its pixels by rule and what is wrong with them: lit, dark. */
struct picture {
    struct acne *w;
    int shown;
    long counts[RULES][2];
};

/* Compares the lights of a pixel. */
static void compare(struct picture *p, const struct seen *s, int x, int y) {
    const struct acne *w = p->w;
    for (int l = 0; l < w->m.regs[SPH_REG_N_LIGHTS]; l++) {
        long double light[3];
        if (!acne_light(w, l, light)) continue;
        long double faces = acne_height(s->facet, light);
        if (s->hit.far ? faces >= 0 : faces <= 0) continue;
        int right = acne_dark(w, s->facet, s->at, light), other = -1;
        for (int rule = 0; rule < RULES; rule++) {
            int64_t from[3];
            uint32_t by = blocked(w, s, rule, l, from);
            if ((by != 0) == right) continue;
            if (other < 0) other = acne_explained(w, s->facet, s->at, light, !right);
            if (other) continue;
            sph_parallel_lock();
            p->counts[rule][by != 0]++;
            if (by && rule == OUTWARDS && p->shown) show(w, s, from, light, by - 1, x, y);
            sph_parallel_unlock();
        }
    }
}

static void pixels(void *user, uint32_t first, uint32_t end) {
    struct picture *p = user;
    int wide = p->w->m.regs[SPH_REG_FRAME_W];
    for (int i = (int)first; i < (int)end; i++) {
        struct seen s;
        if (look(p->w, i % wide, i / wide, &s)) compare(p, &s, i % wide, i / wide);
    }
}

int main(int argc, char **argv) {
    if (argc < 3 || argc > 4 || (argc == 4 && strcmp(argv[3], "--show"))) {
        fprintf(stderr, "usage: shadow_acne SCENE.nff PROFILE [--show]\n");
        return 2;
    }
    struct acne w;
    struct sph_error err = {{0}};
    if (acne_open(&w, argv[1], argv[2], &err)) {
        fprintf(stderr, "shadow_acne: %s\n", err.text);
        return 2;
    }
    struct picture picture = {&w, argc == 4, {{0}}};
    uint32_t n = (uint32_t)(w.m.regs[SPH_REG_FRAME_W] * w.m.regs[SPH_REG_FRAME_H]);
    sph_parallel_for(n, 1024, pixels, &picture);
    for (int rule = 0; rule < RULES; rule++)
        printf("%-8s dark %ld lit %ld\n", rules[rule], picture.counts[rule][1],
               picture.counts[rule][0]);
    acne_close(&w);
    return 0;
}
