/* main.c - shadow_acne: pixels of triangles that are falsely dark or lit, by rules of where rays
 * start SPDX-License-Identifier: Apache-2.0
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

#include "acne.h"

#include "pixel/walk.h"
#include "common/parallel.h"
#include "prim/prim.h"
#include "trace/setup.h"

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
    sph_surface_leave(w->p, &s, &to);
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
