/* render_pixel.c - see render_pixel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "engine/render_pixel.h"

#include <stddef.h>
#include <string.h>

#include "pixel/background.h"
#include "engine/render_light.h"
#include "shade/colour.h"
#include "shade/refract.h"
#include "shade/surface.h"
#include "texture/lod.h"
#include "texture/lookup.h"
#include "prim/prim.h"
#include "trace/traverse.h"

static const struct sph_trail no_trail = {.reflected_id = SPH_ID_NONE, .refracted_id = SPH_ID_NONE};

/* The primitive record of a hit; NULL if nothing is hit or the record does not lie in memory. */
static const uint32_t *prim_line(const struct sph_job *j, const struct sph_hit *hit) {
    size_t line = (uint32_t)j->m->regs[SPH_REG_PRIM_BASE] + (size_t)hit->id;
    if (!hit->key) return NULL;
    if (line >= (uint32_t)j->m->regs[SPH_REG_MEM_LINES]) {
        *j->errors |= 1u << SPH_ERROR_BAD_NODE;
        return NULL;
    }
    const uint32_t *prim = sph_line(j->m, line);
    if (j->met) sph_met_add(&j->met->prims[hit->id], SPH_MET_SHADED);
    return prim;
}

/* Point and normal, unless nothing will start at the point and no texture lies there. */
static void surface(const struct sph_job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                    const uint32_t *prim, struct sph_surface *s) {
    if (!j->m->regs[SPH_REG_N_LIGHTS] && !sph_machine_effect(j->m, SPH_EFFECT_REFLECT) &&
        !sph_machine_effect(j->m, SPH_EFFECT_INTERPENETRATE) &&
        !sph_machine_effect(j->m, SPH_EFFECT_TEXTURE) &&
        !sph_machine_effect(j->m, SPH_EFFECT_REFRACT))
        return;
    int64_t normal[3];
    int saturated = sph_surface_point(j->p, ray, hit->key, s);
    const struct sph_prim *kind = sph_prim_of(sph_prim_kind(j->m, prim));
    kind->normal(j->p, prim, s->guarded, normal);
    saturated |=
        kind->flat ? sph_surface_outwards(j->p, hit->far, normal, s) : sph_surface_nearest(j->p, s);
    sph_surface_turn(j->p, ray, hit->far, normal, s);
    int outside;
    const uint32_t *smooth = sph_smooth_record(j->m, prim, &outside);
    if (outside) *j->errors |= 1u << SPH_ERROR_BAD_NODE;
    if (smooth) {
        sph_smooth_normal(j->p, smooth, s->guarded, normal);
        sph_surface_bend(j->p, hit->far, normal, s);
    }
    SPH_NOTE(j->stages, SPH_STAGE_POINT, 0, SPH_THREE(s->guarded), SPH_THREE(s->point));
    SPH_NOTE(j->stages, SPH_STAGE_NORMAL, 0, SPH_THREE(s->normal), (sph_i128)s->nn,
             SPH_THREE(s->unit.u));
    j->c->count[SPH_COUNT_QUOTIENTS]++;
    j->c->count[SPH_COUNT_SATURATIONS] += (uint64_t)saturated;
}

/* How a surface spreads the rays that leave it; 0 without SPREAD. */
static uint32_t bend_of(const struct sph_job *j, const uint32_t *prim) {
    return sph_machine_effect(j->m, SPH_EFFECT_SPREAD)
               ? sph_field(prim, SPH_PRIM_BEND_LSB, SPH_PRIM_BEND_BITS)
               : 0;
}

/* What the surface's colour is multiplied by, 0xAABBGGRR: white without texture. path: from the eye
 * to the hit. */
static uint32_t texel(const struct sph_job *j, const struct sph_hit *hit, const uint32_t *prim,
                      const struct sph_surface *s, uint64_t path) {
    uint32_t map = sph_field(prim, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
    if (!sph_machine_effect(j->m, SPH_EFFECT_TEXTURE) || !map) return 0xffffffff;
    struct sph_textured where = {.far = hit->far, .path = path};
    for (int i = 0; i < 3; i++) {
        where.guarded[i] = s->guarded[i];
        where.unit[i] = s->unit.u[i];
    }
    return sph_lookup(j->m, map, &where, j->texture);
}

static struct sph_ray reflected(const struct sph_job *j, const struct sph_ray *ray,
                                const struct sph_hit *hit, const struct sph_surface *s) {
    struct sph_ray next = {.kind = SPH_REFLECTED,
                           .skip = {hit->id, hit->far},
                           .inside = j->inside,
                           .stages = j->stages};
    for (int i = 0; i < 3; i++)
        next.org[i] = s->point[i];
    sph_mirror(j->p, ray->dir, s, next.dir);
    sph_job_setup(j, &next);
    return next;
}

/* The refracted ray; 0 if all is reflected. */
static int refracted(const struct sph_job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                     const struct sph_surface *s, uint32_t index, struct sph_ray *next) {
    uint32_t from = hit->far ? index : SPH_INDEX_ONE, to = hit->far ? SPH_INDEX_ONE : index;
    *next = (struct sph_ray){.kind = SPH_REFRACTED,
                             .skip = {hit->id, !hit->far},
                             .inside = j->inside,
                             .stages = j->stages};
    sph_surface_behind(j->p, s, next->org);
    if (!sph_refract(j->p, ray, s, from, to, next->dir)) return 0;
    sph_job_setup(j, next);
    return 1;
}

static struct sph_ray primary(const struct sph_job *j, int x, int y, int first) {
    struct sph_ray ray = {.kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = j->inside,
                          .first = first,
                          .stages = j->stages};
    for (int i = 0; i < 3; i++)
        ray.org[i] = j->m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(j->m, x, y, ray.dir);
    sph_job_setup(j, &ray);
    return ray;
}

/* A ray on its way, with what it has of its pixel. */
struct branch {
    struct sph_ray ray;
    uint32_t weight; /* u1.16 */
    int depth;
    uint64_t length; /* of the path to its origin */
    int spread;      /* at the surface that it left, and how that bends it; with SPREAD */
    uint32_t bend;
};

/* What leaves a surface: a mirror ray, a refracted ray, or both. */
struct leaving {
    uint32_t kr, kt; /* u1.8 */
    struct sph_ray refracted;
};

/* The rays that leave a surface, unless it is as deep as they go. */
static struct leaving leaving_rays(const struct sph_job *j, const struct branch *at,
                                   const struct sph_hit *hit, const struct sph_surface *s,
                                   const struct sph_shading *shading) {
    struct leaving l = {0};
    if (at->depth >= j->m->regs[SPH_REG_MAX_DEPTH]) return l;
    uint32_t least = (uint32_t)j->m->regs[SPH_REG_LEAST_WEIGHT];
    l.kr = sph_shading_worth(at->weight, shading->kr, least);
    l.kt = sph_shading_worth(at->weight, shading->kt, least);
    if (l.kt && !refracted(j, &at->ray, hit, s, shading->index, &l.refracted)) {
        l.kr = l.kr + l.kt < 256 ? l.kr + l.kt : 256;
        l.kt = 0;
    }
    return l;
}

/* Colour and rays of what the branch's ray has hit; prim NULL: the background. */
static struct leaving shade(const struct sph_job *j, struct branch *at, const struct sph_hit *hit,
                            const uint32_t *prim, struct sph_surface *s,
                            struct sph_shares *shares) {
    struct sph_trail *trail = at->ray.kind == SPH_PRIMARY ? j->trail : NULL;
    struct leaving l = {0};
    struct sph_shading shading = {0};
    uint32_t colour[3];
    if (prim) {
        shading = sph_shading_read(j->m, prim);
        if (j->stages) sph_shading_note(j->stages, &shading);
        surface(j, &at->ray, hit, prim, s);
        at->spread = sph_spread(at->length, at->spread, at->bend);
        at->length = sph_path_add(j->p, &at->ray, hit->key, at->length, at->spread);
        if (sph_machine_effect(j->m, SPH_EFFECT_TEXTURE))
            SPH_NOTE(j->stages, SPH_STAGE_PATH, 0, (sph_i128)at->length);
        uint32_t tint = texel(j, hit, prim, s, at->length);
        sph_job_light(j, &at->ray, hit, s, &shading, tint, colour, trail);
        l = leaving_rays(j, at, hit, s, &shading);
        if (j->trail && j->trail->depth <= at->depth) j->trail->depth = at->depth + 1;
    } else {
        for (int i = 0; i < 3; i++)
            colour[i] = ((uint32_t)j->m->regs[SPH_REG_BG_COLOUR] >> (8 * i) & 255) << 8;
    }
    if (prim || at->depth) /* what the eye sees behind all is no surface */
        SPH_NOTE(j->stages, SPH_STAGE_COLOUR, 0, SPH_THREE(colour), at->weight);
    uint32_t own = sph_share(at->weight, sph_shading_own(&shading, l.kr, l.kt));
    sph_shares_add(shares, at->depth, at->weight, own, colour);
    return l;
}

/* The colours, id and key that a primary ray and the rays after it give the pixel. Returns 1 if
 * they are void: the mirror ray of the surface that a FIRST ray found starts inside another sphere,
 * whichever it hits first, so the surface lies in there too (Borodavka et al. VI.D: "when we find
 * an intersected sphere then we test it"). */
static int path(const struct sph_job *j, struct sph_ray ray) {
    struct sph_surface s = {0};
    struct sph_shares shares = {{{0}}};
    struct branch at = {ray, 1u << 16, 0, 0, 0, 0}, waiting[SPH_MAX_DEPTH];
    int n_waiting = 0; /* the deepest last */
    if (j->trail) *j->trail = no_trail;
    if (j->log) j->log->depth = 0;
    struct sph_hit hit = sph_job_trace(j, &ray);
    const uint32_t *prim = prim_line(j, &hit);
    j->texture->lod = SPH_LOD_NONE; /* a repeated pixel begins anew */
    j->texture->words = 0;
    j->pixel->id = prim ? hit.id : SPH_ID_NONE;
    j->pixel->key = prim ? hit.key : 0;
    for (;;) {
        struct leaving l = shade(j, &at, &hit, prim, &s, &shares);
        int last = !l.kr && !l.kt;
        int probe = prim && at.ray.first && sph_machine_effect(j->m, SPH_EFFECT_INTERPENETRATE);
        if (last && !probe && !n_waiting) break;
        uint32_t bend = prim ? bend_of(j, prim) : 0;
        struct branch refracted_ray = {l.refracted,  sph_share(at.weight, l.kt),
                                       at.depth + 1, at.length,
                                       at.spread,    sph_bend_through(bend, hit.far)};
        int own = hit.far; /* the mirror ray starts in the sphere that it leaves */
        if (last && !probe) {
            at = waiting[--n_waiting];
        } else if (l.kr || probe) {
            if (l.kt) waiting[n_waiting++] = refracted_ray;
            at = (struct branch){reflected(j, &at.ray, &hit, &s),
                                 sph_share(at.weight, l.kr),
                                 at.depth + 1,
                                 at.length,
                                 at.spread,
                                 bend};
        } else {
            at = refracted_ray;
        }
        if (j->log) j->log->depth = at.depth;
        if (j->met) sph_met_add(&j->met->depths, 1u << at.depth);
        hit = sph_job_trace(j, &at.ray);
        prim = prim_line(j, &hit);
        if (probe && prim && hit.fars > own) return 1;
        if (last && probe) break;
        if (j->trail && at.depth == 1) {
            int bent = at.ray.kind == SPH_REFRACTED;
            *(bent ? &j->trail->refracted_id : &j->trail->reflected_id) =
                prim ? hit.id : SPH_ID_NONE;
        }
    }
    for (int i = 0; i < SPH_FRAMES; i++)
        j->pixel->colour[i] = sph_shares_colour(&shares, i);
    if (j->trail) memcpy(j->trail->sum, shares.sum, sizeof shares.sum);
    return 0;
}

/* A texel is fetched for the ray that user follows. */
static void note_texel(void *user, const struct sph_texel *texel) {
    if (texel->first) SPH_NOTE(user, SPH_STAGE_LEVEL, 0, texel->lod);
    SPH_NOTE(user, SPH_STAGE_TEXEL, 0, texel->word);
}

struct sph_pixel sph_render_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                  int x, int y, struct sph_counters *c, uint32_t *errors,
                                  struct sph_trail *trail) {
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    struct sph_texture_work texture = {.fetch = o->fetch, .user = o->fetch_user};
    if (o->stages) texture.fetch = note_texel, texture.user = o->stages;
    if (trail) *trail = no_trail;
    if (sph_is_background(m, x, y)) {
        c->count[SPH_COUNT_BACKGROUND]++;
        for (int i = 0; i < SPH_FRAMES; i++)
            pixel.colour[i] = (uint32_t)m->regs[SPH_REG_BG_COLOUR];
        for (int i = 0; trail && i < 3 * SPH_FRAMES; i++)
            trail->sum[i / 3][i % 3] = (pixel.colour[0] >> 8 * (i % 3) & 255) << 8;
        if (o->stages) sph_stages_pixel(o->stages, &pixel);
        return pixel;
    }
    int inside = sph_machine_effect(m, SPH_EFFECT_INSIDE);
    int first = sph_machine_effect(m, SPH_EFFECT_FIRST) && o->traverse != SPH_TRAVERSE_BRUTE;
    struct sph_job j = {m,           sph_machine_profile(m),
                        o->traverse, inside,
                        c,           &pixel,
                        errors,      &texture,
                        trail,       o->log,
                        o->stages,   o->fast,
                        o->met};
    if (path(&j, primary(&j, x, y, first))) path(&j, primary(&j, x, y, 0));
    c->count[SPH_COUNT_TEXELS] += texture.texels;
    *errors |= texture.errors;
    pixel.texture = texture.lod << SPH_LOD_LSB | texture.words;
    if (o->stages) sph_stages_pixel(o->stages, &pixel);
    return pixel;
}
