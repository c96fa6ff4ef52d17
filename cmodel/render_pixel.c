/* render_pixel.c - see render_pixel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "render_pixel.h"

#include <stddef.h>

#include "pixel/walk.h"
#include "shade/colour.h"
#include "shade/surface.h"
#include "trace/node.h"
#include "trace/traverse.h"

/* What the units of one pixel share. */
struct job {
    const struct sph_machine *m;
    const struct sph_profile *p;
    int how;
    struct sph_counters *c;
    struct sph_pixel *pixel;
    uint32_t *errors;
};

static struct sph_hit trace(const struct job *j, struct sph_ray *ray) {
    static const int kinds[] = {SPH_COUNT_RAYS_PRIMARY, SPH_COUNT_RAYS_SHADOW,
                                SPH_COUNT_RAYS_REFLECTED};
    j->c->count[kinds[ray->kind]]++;
    int how =
        j->how == SPH_TRAVERSE_FIRST && ray->kind == SPH_REFLECTED ? SPH_TRAVERSE_NEAREST : j->how;
    return sph_traverse(j->m, ray, how, j->c, &j->pixel->visits, j->errors);
}

static const uint32_t *prim_line(const struct job *j, uint32_t id) {
    size_t line = (uint32_t)j->m->regs[SPH_REG_PRIM_BASE] + (size_t)id;
    return line < (uint32_t)j->m->regs[SPH_REG_MEM_LINES] ? j->m->mem + line * SPH_LINE_WORDS
                                                          : NULL;
}

static void surface(const struct job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                    const uint32_t *prim, struct sph_surface *s) {
    struct sph_leaf sphere = sph_leaf_read(prim, 0, j->p->w);
    j->c->count[SPH_COUNT_QUOTIENTS]++;
    if (sph_surface_at(j->p, ray, hit, &sphere, s)) j->c->count[SPH_COUNT_SATURATIONS]++;
}

/* Light that reaches the surface: ambient and every light that it faces and sees; u2.15. */
static void light(const struct job *j, const struct sph_hit *hit, const struct sph_surface *s,
                  uint32_t sum[3]) {
    const int32_t *r = j->m->regs;
    for (int i = 0; i < 3; i++)
        sum[i] = (uint32_t)r[SPH_REG_AMBIENT_R + i];
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        struct sph_ray ray = {.kind = SPH_SHADOW, .skip = {hit->id, hit->far}};
        for (int i = 0; i < 3; i++) {
            ray.org[i] = s->point[i];
            ray.dir[i] = lamp[i] - s->point[i];
        }
        sph_ray_setup(j->p, &ray);
        uint32_t cosine = sph_lambert(&s->unit, &ray.unit);
        if (!cosine) continue;
        if (r[SPH_REG_EFFECTS] >> SPH_EFFECT_SHADOW & 1 && trace(j, &ray).key) continue;
        for (int i = 0; i < 3; i++)
            sum[i] = sph_light_add(sum[i], cosine, (uint32_t)lamp[3 + i]);
    }
}

static struct sph_ray reflected(const struct job *j, const struct sph_ray *ray,
                                const struct sph_hit *hit, const struct sph_surface *s) {
    struct sph_ray next = {.kind = SPH_REFLECTED, .skip = {hit->id, hit->far}};
    for (int i = 0; i < 3; i++)
        next.org[i] = s->point[i];
    sph_bounce(j->p, ray->dir, s, next.dir);
    sph_ray_setup(j->p, &next);
    return next;
}

/* Interpenetrating spheres (Borodavka et al. VI.D): the first leaf found may lie inside another
 * sphere. If the reflected ray starts inside the sphere that it hits, the primary ray sees that
 * sphere instead. Repeated, since the other may lie inside a third. */
static struct sph_hit interpenetration(const struct job *j, const struct sph_ray *ray,
                                       struct sph_hit hit) {
    for (int i = 0; i < SPH_STACK_DEPTH && hit.key; i++) {
        const uint32_t *prim = prim_line(j, hit.id);
        if (!prim) break;
        struct sph_surface s;
        surface(j, ray, &hit, prim, &s);
        struct sph_ray probe = reflected(j, ray, &hit, &s);
        struct sph_hit other = trace(j, &probe);
        if (!other.key || !other.far || other.id == hit.id) break;
        prim = prim_line(j, other.id);
        if (!prim) {
            *j->errors |= 1u << SPH_ERROR_BAD_NODE;
            break;
        }
        struct sph_leaf sphere = sph_leaf_read(prim, 0, j->p->w);
        struct sph_leaf_result r = sph_leaf_test(ray, &sphere);
        j->c->count[SPH_COUNT_LEAF_TESTS]++;
        if (!r.hit) break;
        uint64_t key = sph_leaf_key(&r, &j->c->count[SPH_COUNT_ROOTS]);
        if (key >= hit.key) break;
        hit = (struct sph_hit){key, other.id, r.far};
    }
    return hit;
}

struct sph_pixel sph_render_pixel(const struct sph_machine *m, int how, int x, int y,
                                  struct sph_counters *c, uint32_t *errors) {
    const int32_t *r = m->regs;
    struct sph_pixel pixel = {{0}, SPH_ID_NONE, 0, 0};
    struct job j = {m, sph_machine_profile(m), how, c, &pixel, errors};
    uint32_t colour_bits = (uint32_t)r[SPH_REG_BG_COLOUR];
    if (sph_is_background(m, x, y)) {
        c->count[SPH_COUNT_BACKGROUND]++;
        for (int i = 0; i < SPH_FRAMES; i++)
            pixel.colour[i] = colour_bits;
        return pixel;
    }
    struct sph_blend blend;
    sph_blend_start(&blend);
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}};
    for (int i = 0; i < 3; i++)
        ray.org[i] = r[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_ray_setup(j.p, &ray);
    for (int last = 0; !last;) {
        struct sph_hit hit = trace(&j, &ray);
        if (ray.kind == SPH_PRIMARY && how == SPH_TRAVERSE_FIRST)
            hit = interpenetration(&j, &ray, hit);
        const uint32_t *prim = hit.key ? prim_line(&j, hit.id) : NULL;
        if (hit.key && !prim) *errors |= 1u << SPH_ERROR_BAD_NODE;
        if (ray.kind == SPH_PRIMARY && prim) pixel.id = hit.id, pixel.key = hit.key;
        uint32_t colour[3], kr = 0;
        if (!prim) { /* background */
            for (int i = 0; i < 3; i++)
                colour[i] = (colour_bits >> (8 * i) & 255) << 8;
            last = 1;
        } else {
            struct sph_surface s;
            surface(&j, &ray, &hit, prim, &s);
            uint32_t sum[3];
            light(&j, &hit, &s, sum);
            for (int i = 0; i < 3; i++)
                colour[i] =
                    sph_surface_colour(sph_field(prim, SPH_PRIM_RED_LSB + 8 * i, 8), sum[i]);
            kr = sph_field(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS);
            last = !kr || !(r[SPH_REG_EFFECTS] >> SPH_EFFECT_REFLECT & 1) ||
                   blend.depth == r[SPH_REG_MAX_DEPTH];
            if (!last) ray = reflected(&j, &ray, &hit, &s);
        }
        sph_blend_add(&blend, colour, kr, last);
    }
    for (int i = 0; i < SPH_FRAMES; i++)
        pixel.colour[i] = blend.colour[i];
    return pixel;
}
