/* render_pixel.c - see render_pixel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "render_pixel.h"

#include <stddef.h>

#include "pixel/walk.h"
#include "shade/colour.h"
#include "shade/surface.h"
#include "texture/filter.h"
#include "texture/lod.h"
#include "texture/lookup.h"
#include "trace/node.h"
#include "trace/traverse.h"

/* What the units of one pixel share. */
struct job {
    const struct sph_machine *m;
    const struct sph_profile *p;
    int how, inside;
    struct sph_counters *c;
    struct sph_pixel *pixel;
    uint32_t *errors;
    struct sph_texture_work *texture;
    struct sph_trail *trail; /* may be NULL */
};

static struct sph_hit trace(const struct job *j, const struct sph_ray *ray) {
    static const int kinds[] = {SPH_COUNT_RAYS_PRIMARY, SPH_COUNT_RAYS_SHADOW,
                                SPH_COUNT_RAYS_REFLECTED};
    j->c->count[kinds[ray->kind]]++;
    return sph_traverse(j->m, ray, j->how, j->c, &j->pixel->visits, j->errors);
}

/* The primitive record of a hit; NULL if nothing is hit or the record does not lie in memory. */
static const uint32_t *prim_line(const struct job *j, const struct sph_hit *hit) {
    size_t line = (uint32_t)j->m->regs[SPH_REG_PRIM_BASE] + (size_t)hit->id;
    if (!hit->key) return NULL;
    if (line < (uint32_t)j->m->regs[SPH_REG_MEM_LINES]) return j->m->mem + line * SPH_LINE_WORDS;
    *j->errors |= 1u << SPH_ERROR_BAD_NODE;
    return NULL;
}

/* Point and normal, unless nothing will start at the point and no texture lies there. */
static void surface(const struct job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                    const uint32_t *prim, struct sph_surface *s) {
    if (!j->m->regs[SPH_REG_N_LIGHTS] && !sph_machine_effect(j->m, SPH_EFFECT_REFLECT) &&
        !sph_machine_effect(j->m, SPH_EFFECT_INTERPENETRATE) &&
        !sph_machine_effect(j->m, SPH_EFFECT_TEXTURE))
        return;
    int saturated;
    if (sph_machine_effect(j->m, SPH_EFFECT_FACETS) &&
        sph_field(prim, SPH_PRIM_FACET_LSB, SPH_PRIM_FACET_BITS)) {
        int64_t normal[3];
        sph_vector_read(prim, SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS, normal);
        saturated = sph_surface_facet(j->p, ray, hit, normal, s);
    } else {
        struct sph_leaf sphere = sph_leaf_read(prim, 0, j->p->w);
        saturated = sph_surface_at(j->p, ray, hit, &sphere, s);
    }
    j->c->count[SPH_COUNT_QUOTIENTS]++;
    j->c->count[SPH_COUNT_SATURATIONS] += (uint64_t)saturated;
}

/* Light that reaches the surface: ambient and every light that it faces and sees; u2.15. */
static void light(const struct job *j, const struct sph_hit *hit, const struct sph_surface *s,
                  uint32_t sum[3], struct sph_trail *trail) {
    const int32_t *r = j->m->regs;
    for (int i = 0; i < 3; i++)
        sum[i] = (uint32_t)r[SPH_REG_AMBIENT_R + i];
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        struct sph_ray ray = {.kind = SPH_SHADOW, .skip = {hit->id, hit->far}, .inside = j->inside};
        for (int i = 0; i < 3; i++) {
            ray.org[i] = s->point[i];
            ray.dir[i] = lamp[i] - s->point[i];
        }
        sph_ray_setup(j->p, &ray);
        uint32_t cosine = sph_lambert(&s->unit, &ray.unit);
        if (!cosine) continue;
        int blocked = sph_machine_effect(j->m, SPH_EFFECT_SHADOW) && trace(j, &ray).key;
        if (trail) trail->faced |= 1u << l, trail->blocked |= (uint32_t)blocked << l;
        if (blocked) continue;
        for (int i = 0; i < 3; i++)
            sum[i] = sph_light_add(sum[i], cosine, (uint32_t)lamp[3 + i]);
    }
}

/* What the surface's colour is multiplied by, 0xAABBGGRR: white without texture. path: from the eye
 * to the hit. */
static uint32_t texel(const struct job *j, const struct sph_hit *hit, const uint32_t *prim,
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

static struct sph_ray reflected(const struct job *j, const struct sph_ray *ray,
                                const struct sph_hit *hit, const struct sph_surface *s) {
    struct sph_ray next = {.kind = SPH_REFLECTED, .skip = {hit->id, hit->far}, .inside = j->inside};
    for (int i = 0; i < 3; i++)
        next.org[i] = s->point[i];
    sph_bounce(j->p, ray->dir, s, next.dir);
    sph_ray_setup(j->p, &next);
    return next;
}

static struct sph_ray primary(const struct job *j, int x, int y, int first) {
    struct sph_ray ray = {
        .kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = j->inside, .first = first};
    for (int i = 0; i < 3; i++)
        ray.org[i] = j->m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(j->m, x, y, ray.dir);
    sph_ray_setup(j->p, &ray);
    return ray;
}

/* The colours, id and key that a primary ray and its reflections give the pixel. Returns 1 if they
 * are void: the mirror ray of the surface that a FIRST ray found starts inside the other sphere
 * that it hits, so the surface lies in there too (Borodavka et al. VI.D). */
static int path(const struct job *j, struct sph_ray ray) {
    const int32_t *r = j->m->regs;
    struct sph_surface s = {0};
    struct sph_blend blend;
    sph_blend_start(&blend);
    if (j->trail) *j->trail = (struct sph_trail){0, 0, SPH_ID_NONE};
    struct sph_hit hit = trace(j, &ray);
    const uint32_t *prim = prim_line(j, &hit);
    uint64_t length = 0;
    j->texture->lod = SPH_LOD_NONE; /* a repeated pixel begins anew */
    j->texture->words = 0;
    j->pixel->id = prim ? hit.id : SPH_ID_NONE;
    j->pixel->key = prim ? hit.key : 0;
    for (;;) {
        uint32_t colour[3], kr = 0;
        int last = 1;
        struct sph_trail *trail = ray.kind == SPH_PRIMARY ? j->trail : NULL;
        if (!prim) { /* background */
            for (int i = 0; i < 3; i++)
                colour[i] = ((uint32_t)r[SPH_REG_BG_COLOUR] >> (8 * i) & 255) << 8;
        } else {
            uint32_t sum[3];
            surface(j, &ray, &hit, prim, &s);
            length = sph_path_add(j->p, &ray, hit.key, length);
            uint32_t tint = texel(j, &hit, prim, &s, length);
            light(j, &hit, &s, sum, trail);
            for (int i = 0; i < 3; i++) {
                uint32_t albedo = sph_field(prim, SPH_PRIM_RED_LSB + 8 * i, 8);
                albedo = sph_texture_albedo(albedo, tint >> (8 * i) & 255);
                colour[i] = sph_surface_colour(albedo, sum[i]);
            }
            kr = sph_field(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS);
            last = !kr || !sph_machine_effect(j->m, SPH_EFFECT_REFLECT) ||
                   blend.depth == r[SPH_REG_MAX_DEPTH];
        }
        sph_blend_add(&blend, colour, kr, last);

        int probe = prim && ray.first && sph_machine_effect(j->m, SPH_EFFECT_INTERPENETRATE);
        if (last && !probe) break;
        struct sph_ray next = reflected(j, &ray, &hit, &s);
        struct sph_hit other = trace(j, &next);
        prim = prim_line(j, &other);
        if (probe && prim && other.far && other.id != hit.id) return 1;
        if (last) break;
        if (trail) trail->reflected_id = prim ? other.id : SPH_ID_NONE;
        ray = next;
        hit = other;
    }
    for (int i = 0; i < SPH_FRAMES; i++)
        j->pixel->colour[i] = blend.colour[i];
    return 0;
}

struct sph_pixel sph_render_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                  int x, int y, struct sph_counters *c, uint32_t *errors,
                                  struct sph_trail *trail) {
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    struct sph_texture_work texture = {
        .fetch = o->fetch, .user = o->fetch_user, .lod_drop = o->lod_drop};
    if (trail) *trail = (struct sph_trail){0, 0, SPH_ID_NONE};
    if (sph_is_background(m, x, y)) {
        c->count[SPH_COUNT_BACKGROUND]++;
        for (int i = 0; i < SPH_FRAMES; i++)
            pixel.colour[i] = (uint32_t)m->regs[SPH_REG_BG_COLOUR];
        return pixel;
    }
    int inside = sph_machine_effect(m, SPH_EFFECT_INSIDE);
    int first = sph_machine_effect(m, SPH_EFFECT_FIRST) && o->traverse == SPH_TRAVERSE_TREE;
    struct job j = {m,    sph_machine_profile(m), o->traverse, inside, c, &pixel, errors, &texture,
                    trail};
    if (path(&j, primary(&j, x, y, first))) path(&j, primary(&j, x, y, 0));
    c->count[SPH_COUNT_TEXELS] += texture.texels;
    *errors |= texture.errors;
    pixel.texture = texture.lod << SPH_LOD_LSB | texture.words;
    return pixel;
}
