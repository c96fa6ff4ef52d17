/* pixel.c - see pixel.h; engine/render_pixel.c and render_light.c are read beside it
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/pixel.h"

#include <stddef.h>
#include <string.h>

#include "engine/render_pixel.h"
#include "fast/path.h"
#include "pixel/background.h"
#include "prim/sphere.h"
#include "shade/colour.h"
#include "shade/material.h"

enum {
    KNOWN = 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_INSIDE |
            1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_TURNED | 1 << SPH_EFFECT_CAMERA
};

int sph_fast_shades(const struct sph_machine *m) {
    return !(m->regs[SPH_REG_EFFECTS] & ~KNOWN);
}

static struct sph_hit trace(const struct sph_fast_job *j, const struct sph_ray *ray, int counter) {
    j->c->count[counter]++;
    return sph_fast_trace(j->fast, ray, j->c, &j->pixel->visits, j->errors);
}

const uint32_t *sph_fast_record(const struct sph_fast_job *j, const struct sph_hit *hit) {
    size_t line = (uint32_t)j->m->regs[SPH_REG_PRIM_BASE] + (size_t)hit->id;
    if (!hit->key) return NULL;
    if (line >= (uint32_t)j->m->regs[SPH_REG_MEM_LINES]) {
        *j->errors |= 1u << SPH_ERROR_BAD_NODE;
        return NULL;
    }
    return sph_line(j->m, line);
}

uint32_t sph_fast_light(const struct sph_fast_job *j, const struct sph_surface *s, int light,
                        struct sph_ray *to) {
    sph_fast_towards(j, s, light, to->dir);
    to->a = sph_fast_square(to->dir);
    to->unit = sph_fast_unit(to->dir, to->a, j->p->wd);
    return sph_lambert(&s->unit, &to->unit);
}

void sph_fast_meet(const struct sph_fast_job *j, const struct sph_ray *ray,
                   const struct sph_hit *hit, const uint32_t *prim, struct sph_surface *s) {
    struct sph_leaf sphere = sph_sphere_read(prim, j->p->w);
    int saturated = sph_fast_surface(j->p, ray, hit, sphere.ctr, s);
    j->c->count[SPH_COUNT_QUOTIENTS]++;
    j->c->count[SPH_COUNT_SATURATIONS] += (uint64_t)saturated;
}

/* Whether light l does not come to the surface. */
static int blocked(const struct sph_fast_job *j, const struct sph_hit *hit,
                   const struct sph_surface *s, struct sph_ray *to) {
    memcpy(to->org, s->point, sizeof to->org);
    to->kind = SPH_SHADOW;
    to->skip = (struct sph_skip){hit->id, hit->far};
    to->inside = j->inside;
    to->first = 0;
    to->stages = NULL;
    sph_fast_setup(j->p, to);
    return trace(j, to, SPH_COUNT_RAYS_SHADOW).key != 0;
}

/* Light of the lights that the surface faces and sees, u2.15. */
static void light(const struct sph_fast_job *j, const struct sph_fast_first *known,
                  const struct sph_hit *hit, const struct sph_surface *s, uint32_t sum[3],
                  struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        struct sph_ray to;
        uint32_t cosine = known ? known->cosine[l] : sph_fast_light(j, s, l, &to);
        if (!cosine) continue;
        int dark = known ? (int)(known->hidden >> l & 1) : j->shadow && blocked(j, hit, s, &to);
        if (trail) trail->faced |= 1u << l, trail->blocked |= (uint32_t)dark << l;
        if (dark) continue;
        for (int i = 0; i < 3; i++)
            sum[i] = sph_light_add(sum[i], cosine, (uint32_t)lamp[3 + i] & 65535);
    }
}

/* The colour, u8.8, of what is hit; its share of the mirror ray. */
static uint32_t shade(const struct sph_fast_job *j, const struct sph_fast_first *known,
                      const struct sph_ray *ray, const struct sph_hit *hit, const uint32_t *prim,
                      struct sph_surface *s, uint32_t colour[3], struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    uint32_t sum[3] = {0, 0, 0};
    if (known)
        light(j, known, hit, s, sum, trail);
    else if (r[SPH_REG_N_LIGHTS] || j->reflect) {
        sph_fast_meet(j, ray, hit, prim, s);
        light(j, NULL, hit, s, sum, trail);
    }
    for (int i = 0; i < 3; i++) {
        uint32_t all = (uint32_t)r[SPH_REG_AMBIENT_R + i] + sum[i];
        all = all < 131071 ? all : 131071;
        colour[i] = sph_surface_colour(sph_field(prim, SPH_PRIM_RED_LSB + 8 * i, 8), all);
    }
    return j->reflect ? sph_shading_mirror(prim) : 0;
}

static void mirror(const struct sph_fast_job *j, const struct sph_hit *hit,
                   const struct sph_surface *s, struct sph_ray *ray) {
    int64_t dir[3];
    sph_reflect(j->p, ray->dir, s, dir);
    memcpy(ray->dir, dir, sizeof dir);
    memcpy(ray->org, s->point, sizeof ray->org);
    ray->kind = SPH_REFLECTED;
    ray->skip = (struct sph_skip){hit->id, hit->far};
    ray->first = 0;
    sph_fast_prepare(j->p, ray);
}

void sph_fast_path(const struct sph_fast_job *j, struct sph_ray *ray,
                   const struct sph_fast_first *known) {
    struct sph_shares shares = {{{0}}};
    struct sph_surface s;
    uint32_t weight = 1u << 16;
    struct sph_hit hit = known ? known->hit : trace(j, ray, SPH_COUNT_RAYS_PRIMARY);
    const uint32_t *prim = known ? known->prim : sph_fast_record(j, &hit);
    if (known && prim) s = known->s;
    j->pixel->id = prim ? hit.id : SPH_ID_NONE;
    j->pixel->key = prim ? hit.key : 0;
    for (int depth = 0;; depth++) {
        uint32_t colour[3], kr = 0;
        if (prim) {
            kr = shade(j, depth ? NULL : known, ray, &hit, prim, &s, colour,
                       depth ? NULL : j->trail);
            if (depth >= j->m->regs[SPH_REG_MAX_DEPTH]) kr = 0;
            kr = sph_shading_worth(weight, kr, (uint32_t)j->m->regs[SPH_REG_LEAST_WEIGHT]);
            if (j->trail) j->trail->depth = depth + 1;
        } else {
            for (int i = 0; i < 3; i++)
                colour[i] = ((uint32_t)j->m->regs[SPH_REG_BG_COLOUR] >> (8 * i) & 255) << 8;
        }
        uint32_t own = sph_share(weight, 256 - kr);
        sph_shares_add(&shares, depth, weight, own, colour);
        if (!kr) break;
        weight = sph_share(weight, kr);
        mirror(j, &hit, &s, ray);
        hit = trace(j, ray, SPH_COUNT_RAYS_REFLECTED);
        prim = sph_fast_record(j, &hit);
        if (j->trail && !depth) j->trail->reflected_id = prim ? hit.id : SPH_ID_NONE;
    }
    for (int i = 0; i < SPH_FRAMES; i++)
        j->pixel->colour[i] = sph_shares_colour(&shares, i);
    if (j->trail) memcpy(j->trail->sum, shares.sum, sizeof shares.sum);
}

struct sph_fast_job sph_fast_job_of(const struct sph_machine *m, const struct sph_fast *fast,
                                    struct sph_counters *c, uint32_t *errors) {
    return (struct sph_fast_job){.m = m,
                                 .p = sph_machine_profile(m),
                                 .fast = fast,
                                 .c = c,
                                 .errors = errors,
                                 .inside = sph_machine_effect(m, SPH_EFFECT_INSIDE),
                                 .shadow = sph_machine_effect(m, SPH_EFFECT_SHADOW),
                                 .reflect = sph_machine_effect(m, SPH_EFFECT_REFLECT)};
}

struct sph_pixel sph_fast_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                int x, int y, struct sph_counters *c, uint32_t *errors,
                                struct sph_trail *trail) {
    if (sph_is_background(m, x, y)) return sph_render_pixel(m, o, x, y, c, errors, trail);
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    struct sph_fast_job j = sph_fast_job_of(m, o->fast, c, errors);
    struct sph_ray ray = {.kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = j.inside,
                          .first = sph_machine_effect(m, SPH_EFFECT_FIRST)};
    j.pixel = &pixel;
    j.trail = trail;
    if (trail) *trail = sph_no_trail;
    for (int i = 0; i < 3; i++)
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_fast_prepare(j.p, &ray);
    sph_fast_path(&j, &ray, NULL);
    return pixel;
}
