/* render_light.c - see render_light.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "engine/render_light.h"

#include "math/fx.h"
#include "shade/colour.h"
#include "texture/texel.h"
#include "trace/traverse.h"
#include "trace/setup.h"

void sph_job_setup(const struct sph_job *j, struct sph_ray *ray) {
    if (j->fast)
        sph_tracer_of(j->fast)->setup(j->p, ray);
    else
        sph_ray_setup(j->p, ray);
}

struct sph_hit sph_job_trace(const struct sph_job *j, const struct sph_ray *ray) {
    static const int kinds[] = {SPH_COUNT_RAYS_PRIMARY, SPH_COUNT_RAYS_SHADOW,
                                SPH_COUNT_RAYS_REFLECTED, SPH_COUNT_RAYS_REFRACTED};
    j->c->count[kinds[ray->kind]]++;
    uint32_t before = j->pixel->visits;
    uint32_t *visits = &j->pixel->visits;
    if (j->stages) sph_stages_begin(j->stages, ray);
    struct sph_hit hit = j->fast
                             ? sph_tracer_of(j->fast)->trace(j->fast, ray, j->c, visits, j->errors)
                             : sph_traverse(j->m, ray, j->how, j->c, visits, j->errors);
    if (j->stages) sph_stages_end(j->stages, ray, &hit);
    if (j->met && hit.fars) sph_met_add(&j->met->inside, 1);
    if (j->log) sph_ray_log_add(j->log, ray, hit, j->pixel->visits - before);
    return hit;
}

/* Whether a ray that came to its light would not have come there without CLEAR. */
static int passes(const struct sph_job *j, struct sph_ray to) {
    struct sph_machine opaque = *j->m;
    struct sph_counters c = {{0}};
    uint32_t visits = 0, errors = 0;
    opaque.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_CLEAR);
    to.stages = NULL;
    sph_ray_setup(j->p, &to);
    return sph_traverse(&opaque, &to, SPH_TRAVERSE_TREE, &c, &visits, &errors).key != 0;
}

/* Notes what a ray to light l has met. */
static void note(const struct sph_job *j, int l, const struct sph_ray *to,
                 const struct sph_hit *by) {
    if (by->key) {
        sph_met_add(&j->met->blocked, 1u << l);
        sph_met_add(&j->met->prims[by->id], 1u << l);
        return;
    }
    sph_met_add(&j->met->lit, 1u << l);
    if (sph_machine_effect(j->m, SPH_EFFECT_CLEAR) &&
        !__atomic_load_n(&j->met->passed, __ATOMIC_RELAXED) && passes(j, *to))
        sph_met_add(&j->met->passed, 1);
}

/* Light of the lights that the surface faces and sees, u2.15: matt, and as a highlight. */
struct sums {
    uint32_t matt[3], gloss[3];
};

/* Adds what light l gives. */
static void add(const struct sph_job *j, const struct sph_ray *ray, const struct sph_ray *to_light,
                const struct sph_surface *s, const struct sph_shading *shading, uint32_t cosine,
                const int32_t *rgb, struct sums *sums) {
    uint32_t shine = 0;
    if (shading->ks) {
        uint32_t c = sph_specular_cosine(&s->unit, &to_light->unit, &ray->unit);
        shine = sph_power(c, shading->power);
        j->c->count[SPH_COUNT_POWERS]++;
        SPH_NOTE(j->stages, SPH_STAGE_HIGHLIGHT, 0, shine);
    }
    for (int i = 0; i < 3; i++) {
        sums->matt[i] = sph_light_add(sums->matt[i], cosine, (uint32_t)rgb[i] & 65535);
        sums->gloss[i] = sph_light_add(sums->gloss[i], shine, (uint32_t)rgb[i] & 65535);
    }
}

void sph_job_light(const struct sph_job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                   const struct sph_surface *s, const struct sph_shading *shading, uint32_t tint,
                   uint32_t colour[3], struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    struct sums sums = {{0}, {0}};
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        struct sph_ray to = {.kind = SPH_SHADOW,
                             .skip = {hit->id, hit->far},
                             .inside = j->inside,
                             .stages = j->stages};
        sph_surface_spawn(j->p, s, &to);
        for (int i = 0; i < 3; i++)
            to.dir[i] = lamp[i] - sph_round(s->point[i], lamp[3] >> SPH_LIGHT_SHIFT_LSB);
        sph_job_setup(j, &to);
        uint32_t cosine = sph_lambert(&s->unit, &to.unit);
        SPH_NOTE(j->stages, SPH_STAGE_LIGHT, 0, SPH_THREE(to.dir), (sph_i128)to.a,
                 SPH_THREE(to.unit.u), cosine);
        if (!cosine) continue;
        struct sph_hit by = {0};
        if (sph_machine_effect(j->m, SPH_EFFECT_SHADOW)) by = sph_job_trace(j, &to);
        int blocked = by.key != 0;
        if (j->met) note(j, l, &to, &by);
        if (trail) trail->faced |= 1u << l, trail->blocked |= (uint32_t)blocked << l;
        if (!blocked) add(j, ray, &to, s, shading, cosine, lamp + 3, &sums);
    }
    uint32_t albedo[3];
    for (int i = 0; i < 3; i++) {
        uint32_t light =
            sph_shading_light(shading, (uint32_t)r[SPH_REG_AMBIENT_R + i], sums.matt[i]);
        albedo[i] = sph_texture_albedo(shading->rgb[i], tint >> (8 * i) & 255);
        uint32_t all =
            sph_surface_colour(albedo[i], light) + sph_surface_colour(shading->ks, sums.gloss[i]);
        colour[i] = all < 65280 ? all : 65280;
    }
    if (sph_machine_effect(j->m, SPH_EFFECT_TEXTURE))
        SPH_NOTE(j->stages, SPH_STAGE_ALBEDO, 0, SPH_THREE(albedo));
}
