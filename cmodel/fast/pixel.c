/* pixel.c - see pixel.h; engine/render_pixel.c and render_light.c are read beside it
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/pixel.h"

#include <stddef.h>
#include <string.h>

#include "engine/render_pixel.h"
#include "fast/surface.h"
#include "pixel/walk.h"
#include "prim/sphere.h"
#include "shade/colour.h"

enum {
    KNOWN = 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_INSIDE |
            1 << SPH_EFFECT_FIRST
};

struct job {
    const struct sph_machine *m;
    const struct sph_profile *p;
    const struct sph_fast *fast;
    struct sph_counters *c;
    struct sph_pixel *pixel;
    uint32_t *errors;
    struct sph_trail *trail; /* may be NULL */
    int inside, shadow, reflect;
};

int sph_fast_shades(const struct sph_machine *m) {
    return !(m->regs[SPH_REG_EFFECTS] & ~KNOWN);
}

static struct sph_hit trace(const struct job *j, const struct sph_ray *ray, int counter) {
    j->c->count[counter]++;
    return sph_fast_trace(j->fast, ray, j->c, &j->pixel->visits, j->errors);
}

/* The record of a hit; NULL: nothing is hit, or the record does not lie in memory. */
static const uint32_t *record(const struct job *j, const struct sph_hit *hit) {
    size_t line = (uint32_t)j->m->regs[SPH_REG_PRIM_BASE] + (size_t)hit->id;
    if (!hit->key) return NULL;
    if (line < (uint32_t)j->m->regs[SPH_REG_MEM_LINES]) return sph_line(j->m, line);
    *j->errors |= 1u << SPH_ERROR_BAD_NODE;
    return NULL;
}

/* Light of the lights that the surface faces and sees, u2.15. */
static void light(const struct job *j, const struct sph_hit *hit, const struct sph_surface *s,
                  uint32_t sum[3], struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        int away = lamp[3] >> SPH_LIGHT_SHIFT_LSB;
        struct sph_ray to;
        for (int i = 0; i < 3; i++)
            to.dir[i] = lamp[i] - sph_round(s->point[i], away);
        to.a = sph_fast_square(to.dir);
        to.unit = sph_fast_unit(to.dir, to.a, j->p->wd);
        uint32_t cosine = sph_lambert(&s->unit, &to.unit);
        if (!cosine) continue;
        int blocked = 0;
        if (j->shadow) {
            memcpy(to.org, s->point, sizeof to.org);
            to.kind = SPH_SHADOW;
            to.skip = (struct sph_skip){hit->id, hit->far};
            to.inside = j->inside;
            to.first = 0;
            sph_fast_setup(j->p, &to);
            blocked = trace(j, &to, SPH_COUNT_RAYS_SHADOW).key != 0;
        }
        if (trail) trail->faced |= 1u << l, trail->blocked |= (uint32_t)blocked << l;
        if (blocked) continue;
        for (int i = 0; i < 3; i++)
            sum[i] = sph_light_add(sum[i], cosine, (uint32_t)lamp[3 + i] & 65535);
    }
}

/* The colour, u8.8, of what is hit; its share of the mirror ray. */
static uint32_t shade(const struct job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                      const uint32_t *prim, struct sph_surface *s, uint32_t colour[3],
                      struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    uint32_t sum[3] = {0, 0, 0};
    if (r[SPH_REG_N_LIGHTS] || j->reflect) {
        struct sph_leaf sphere = sph_sphere_read(prim, j->p->w);
        int saturated = sph_fast_surface(j->p, ray, hit, sphere.ctr, s);
        j->c->count[SPH_COUNT_QUOTIENTS]++;
        j->c->count[SPH_COUNT_SATURATIONS] += (uint64_t)saturated;
        light(j, hit, s, sum, trail);
    }
    for (int i = 0; i < 3; i++) {
        uint32_t all = (uint32_t)r[SPH_REG_AMBIENT_R + i] + sum[i];
        all = all < 131071 ? all : 131071;
        colour[i] = sph_surface_colour(sph_field(prim, SPH_PRIM_RED_LSB + 8 * i, 8), all);
    }
    return j->reflect ? sph_field(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS) : 0;
}

static void mirror(const struct job *j, const struct sph_hit *hit, const struct sph_surface *s,
                   struct sph_ray *ray) {
    int64_t dir[3];
    sph_bounce(j->p, ray->dir, s, dir);
    memcpy(ray->dir, dir, sizeof dir);
    memcpy(ray->org, s->point, sizeof ray->org);
    ray->kind = SPH_REFLECTED;
    ray->skip = (struct sph_skip){hit->id, hit->far};
    ray->first = 0;
    sph_fast_prepare(j->p, ray);
}

/* The colours, id and key that the ray and those after it give the pixel. */
static void path(const struct job *j, struct sph_ray *ray) {
    struct sph_shares shares = {{{0}}};
    struct sph_surface s;
    uint32_t weight = 1u << 16;
    struct sph_hit hit = trace(j, ray, SPH_COUNT_RAYS_PRIMARY);
    const uint32_t *prim = record(j, &hit);
    j->pixel->id = prim ? hit.id : SPH_ID_NONE;
    j->pixel->key = prim ? hit.key : 0;
    for (int depth = 0;; depth++) {
        uint32_t colour[3], kr = 0;
        if (prim) {
            kr = shade(j, ray, &hit, prim, &s, colour, depth ? NULL : j->trail);
            if (depth >= j->m->regs[SPH_REG_MAX_DEPTH]) kr = 0;
            if (j->trail) j->trail->depth = depth + 1;
        } else {
            for (int i = 0; i < 3; i++)
                colour[i] = ((uint32_t)j->m->regs[SPH_REG_BG_COLOUR] >> (8 * i) & 255) << 8;
        }
        uint32_t own = sph_share(weight, kr < 256 ? 256 - kr : 0);
        sph_shares_add(&shares, depth, weight, own, colour);
        if (!kr) break;
        weight = sph_share(weight, kr);
        mirror(j, &hit, &s, ray);
        hit = trace(j, ray, SPH_COUNT_RAYS_REFLECTED);
        prim = record(j, &hit);
        if (j->trail && !depth) j->trail->reflected_id = prim ? hit.id : SPH_ID_NONE;
    }
    for (int i = 0; i < SPH_FRAMES; i++)
        j->pixel->colour[i] = sph_shares_colour(&shares, i);
    if (j->trail) memcpy(j->trail->sum, shares.sum, sizeof shares.sum);
}

struct sph_pixel sph_fast_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                int x, int y, struct sph_counters *c, uint32_t *errors,
                                struct sph_trail *trail) {
    if (sph_is_background(m, x, y)) return sph_render_pixel(m, o, x, y, c, errors, trail);
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    struct sph_ray ray = {.kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = sph_machine_effect(m, SPH_EFFECT_INSIDE),
                          .first = sph_machine_effect(m, SPH_EFFECT_FIRST)};
    struct job j = {m,
                    sph_machine_profile(m),
                    o->fast,
                    c,
                    &pixel,
                    errors,
                    trail,
                    ray.inside,
                    sph_machine_effect(m, SPH_EFFECT_SHADOW),
                    sph_machine_effect(m, SPH_EFFECT_REFLECT)};
    if (trail)
        *trail = (struct sph_trail){.reflected_id = SPH_ID_NONE, .refracted_id = SPH_ID_NONE};
    for (int i = 0; i < 3; i++)
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_fast_prepare(j.p, &ray);
    path(&j, &ray);
    return pixel;
}
