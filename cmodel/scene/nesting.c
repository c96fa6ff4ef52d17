/* nesting.c - see nesting.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Transparent spheres are taken in the order of their least x: those that hold one begin before it
 * and end behind it.
 */
#include "scene/nesting.h"

#include <math.h>
#include <stdlib.h>

#include "machine/records.h"
#include "scene/edit.h"
#include "scene/vector.h"

int sph_material_clear(const struct sph_material *m) {
    return m->sum.on && m->trans > 0;
}

double sph_index_inside(const struct sph_material *m) {
    return m->sum.hollow ? 1 : m->ior;
}

double sph_index_ratio(const struct sph_material *m) {
    double outside = m->sum.hollow ? m->ior : m->sum.around > 0 ? m->sum.around : 1;
    return sph_index_inside(m) / outside;
}

/* Adds a material like another one; its index. */
static int add_like(struct sph_scene *scene, uint32_t *material, int hollow, double around,
                    struct sph_error *err) {
    struct sph_material m = scene->materials[*material];
    m.sum.of = *material + 1, m.sum.hollow = hollow, m.sum.around = around;
    if (sph_scene_add_material(scene, &m, err)) return -1;
    *material = scene->n_materials - 1;
    return 0;
}

int sph_scene_hollow(struct sph_scene *scene, uint32_t *material, struct sph_error *err) {
    const struct sph_material *newest = &scene->materials[scene->n_materials - 1];
    if (newest->sum.hollow && newest->sum.of == *material + 1) {
        *material = scene->n_materials - 1;
        return 0;
    }
    return add_like(scene, material, 1, 0, err);
}

/* A sphere that rays go through, by its number. */
struct clear {
    double low; /* least x */
    uint32_t id;
};

static int by_low(const void *a, const void *b) {
    double d = ((const struct clear *)a)->low - ((const struct clear *)b)->low;
    return d < 0 ? -1 : d > 0;
}

static const struct sph_material *look(const struct sph_scene *scene, uint32_t sphere) {
    return &scene->materials[scene->spheres[sphere].material];
}

static int holds(const struct sph_sphere *a, const struct sph_sphere *b) {
    double apart = sph_vec_length(sph_vec_sub(a->ctr, b->ctr));
    return a->rad > b->rad && apart + b->rad <= a->rad;
}

/* Of their radii: what rounding leaves of the distance of spheres that touch. */
#define ROUNDED 1e-9

/* Whether the surfaces of two spheres cut each other. */
static int cuts(const struct sph_sphere *a, const struct sph_sphere *b) {
    double apart = sph_vec_length(sph_vec_sub(a->ctr, b->ctr)), sum = a->rad + b->rad;
    return apart < sum * (1 - ROUNDED) && apart > fabs(a->rad - b->rad) + sum * ROUNDED;
}

/* Notes glass that cuts glass. */
static int note_cut(struct sph_scene *scene, uint32_t line, uint32_t other, struct sph_error *err) {
    return sph_ledger_add(&scene->ledger, SPH_READ_GLASS_MEETS, 1, scene->path, line, other, err);
}

/* How far a sphere lies behind a plane; below 0: not wholly. */
static double behind(const struct sph_facet *plane, const struct sph_sphere *s) {
    struct sph_vec n = plane->v[1], p = plane->v[0];
    return -sph_vec_dot(n, sph_vec_sub(s->ctr, p)) / sph_vec_length(n) - s->rad;
}

/* *index: of refraction of the nearest transparent plane that the sphere is wholly behind; 1 if
 * there is none. -1 under `strict` if one cuts it. */
static int behind_planes(struct sph_scene *scene, const struct sph_sphere *s, double *index,
                         struct sph_error *err) {
    double nearest = INFINITY;
    *index = 1;
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        const struct sph_facet *f = &scene->facets[i];
        if (!sph_kind_unbounded((uint32_t)f->kind) ||
            !sph_material_clear(&scene->materials[f->material]))
            continue;
        double deep = behind(f, s);
        if (deep >= 0 && deep < nearest)
            nearest = deep, *index = sph_index_inside(&scene->materials[f->material]);
        if (deep < -ROUNDED * s->rad && deep > -(2 - ROUNDED) * s->rad &&
            note_cut(scene, s->line, f->line, err))
            return -1;
    }
    return 0;
}

/* Notes what is around a sphere. last[m]: the newest material that is made of material m, + 1. */
static int surround(struct sph_scene *scene, uint32_t id, double around, uint32_t *last,
                    struct sph_error *err) {
    struct sph_sphere *s = &scene->spheres[id];
    uint32_t of = s->material;
    if (scene->materials[of].sum.hollow || around == 1) return 0;
    if (!last[of] || scene->materials[last[of] - 1].sum.around != around) {
        last[of] = of;
        if (add_like(scene, &last[of], 0, around, err)) return -1;
        last[of]++;
    }
    s->material = last[of] - 1;
    double one = SPH_INDEX_ONE, ratio = sph_index_ratio(&scene->materials[s->material]);
    if (ratio * one >= SPH_INDEX_MIN && ratio * one <= SPH_INDEX_MAX) return 0;
    return sph_fail(err,
                    "%s:%u: `s`: index of refraction %g in %g: the ratio is not within %g to %g",
                    scene->path, s->line, scene->materials[of].ior, around, SPH_INDEX_MIN / one,
                    SPH_INDEX_MAX / one);
}

/* Takes the spheres in order; open: those before that are not ended. */
static int nest(struct sph_scene *scene, const struct clear *list, uint32_t n, uint32_t *open,
                uint32_t *last, struct sph_error *err) {
    uint32_t n_open = 0;
    for (uint32_t i = 0; i < n; i++) {
        const struct sph_sphere *s = &scene->spheres[list[i].id], *in = NULL;
        uint32_t kept = 0;
        for (uint32_t k = 0; k < n_open; k++) {
            const struct sph_sphere *o = &scene->spheres[open[k]];
            if (o->ctr.x + o->rad < list[i].low) continue;
            open[kept++] = open[k];
            if (holds(o, s) && (!in || o->rad < in->rad)) in = o;
            if (cuts(o, s) && note_cut(scene, s->line, o->line, err)) return -1;
        }
        open[kept] = list[i].id;
        n_open = kept + 1;
        double around;
        if (behind_planes(scene, s, &around, err)) return -1;
        if (in) around = sph_index_inside(&scene->materials[in->material]);
        if (surround(scene, list[i].id, around, last, err)) return -1;
    }
    return 0;
}

int sph_scene_nest(struct sph_scene *scene, struct sph_error *err) {
    uint32_t n = 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        n += (uint32_t)sph_material_clear(look(scene, i));
    if (!n) return 0;
    struct clear *list = malloc(n * sizeof *list);
    uint32_t *open = malloc(n * sizeof *open), *last = calloc(scene->n_materials, sizeof *last);
    int rc = 0;
    n = 0;
    for (uint32_t i = 0; list && i < scene->n_spheres; i++)
        if (sph_material_clear(look(scene, i)))
            list[n++] = (struct clear){scene->spheres[i].ctr.x - scene->spheres[i].rad, i};
    if (!list || !open || !last) {
        rc = sph_fail(err, "%s: no memory for %u spheres", scene->path, scene->n_spheres);
    } else {
        qsort(list, n, sizeof *list, by_low);
        rc = nest(scene, list, n, open, last, err);
    }
    free(list);
    free(open);
    free(last);
    return rc;
}
