/* tile.c - see tile.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/tile.h"

#include <stddef.h>
#include <string.h>

#include "fast/path.h"
#include "fast/pixel.h"
#include "fast/prepare.h"
#include "pixel/background.h"
#include "shade/colour.h"

struct tile {
    struct sph_fast_job j;
    int n;
    int x[SPH_PACKET], y[SPH_PACKET];
    int64_t dir[SPH_PACKET][3]; /* of primary rays */
    struct sph_bundle primary, shadow;
    struct sph_fast_first first[SPH_PACKET];
};

/* Rays that are set up together, and their pixels. */
struct some {
    int n, of[SPH_TOGETHER];
    struct sph_ray rays[SPH_TOGETHER];
};

int sph_fast_tiles(const struct sph_machine *m, const struct sph_fast *fast) {
    return sph_fast_shades(m) && !sph_machine_effect(m, SPH_EFFECT_FIRST) && sph_packets_fit(fast);
}

static void add(struct tile *t, int x, int y) {
    int i = t->n++;
    t->x[i] = x;
    t->y[i] = y;
    sph_primary_dir(t->j.m, x, y, t->dir[i]);
}

/* What primary ray i has hit, and its surface. */
static void meet(struct tile *t, int i, const struct sph_ray *ray, struct sph_hit hit) {
    struct sph_fast_first *f = &t->first[i];
    f->hit = hit;
    f->prim = sph_fast_record(&t->j, &hit);
    f->hidden = 0;
    if (f->prim && (t->j.m->regs[SPH_REG_N_LIGHTS] || t->j.reflect))
        sph_fast_meet(&t->j, ray, &f->hit, f->prim, &f->s);
}

/* The primary rays, together. */
static void packet_meets(struct tile *t) {
    struct sph_hit hits[SPH_PACKET];
    t->primary.n = t->n;
    t->primary.kind = SPH_PRIMARY;
    t->primary.inside = t->j.inside;
    for (int i = 0; i < t->n; i++)
        for (int k = 0; k < 3; k++) {
            t->primary.org[k][i] = t->j.m->regs[SPH_REG_EYE_X + k];
            t->primary.dir[k][i] = (int32_t)t->dir[i][k];
        }
    sph_packet_nearest(t->j.fast, &t->primary, hits);
    for (int i = 0; i < t->n; i++) {
        struct sph_ray ray = sph_bundle_ray(&t->primary, i);
        t->first[i].visits = 0;
        meet(t, i, &ray, hits[i]);
    }
}

/* The primary rays, one after another. */
static void each_meets(struct tile *t) {
    struct sph_ray rays[SPH_TOGETHER];
    int first = sph_machine_effect(t->j.m, SPH_EFFECT_FIRST);
    for (int from = 0; from < t->n; from += SPH_TOGETHER) {
        int n = t->n - from < SPH_TOGETHER ? t->n - from : SPH_TOGETHER;
        for (int i = 0; i < n; i++) {
            rays[i] = (struct sph_ray){.kind = SPH_PRIMARY,
                                       .skip = {SPH_ID_NONE, 0},
                                       .inside = t->j.inside,
                                       .first = first};
            for (int k = 0; k < 3; k++) {
                rays[i].org[k] = t->j.m->regs[SPH_REG_EYE_X + k];
                rays[i].dir[k] = t->dir[from + i][k];
            }
        }
        sph_fast_prepare_all(t->j.fast, rays, n);
        for (int i = 0; i < n; i++) {
            uint32_t *visits = &t->first[from + i].visits;
            *visits = 0;
            meet(t, from + i, &rays[i],
                 sph_fast_trace(t->j.fast, &rays[i], t->j.c, visits, t->j.errors));
        }
    }
}

/* Sends shadow rays to light l, one after another. */
static void send(struct tile *t, struct some *s, int l) {
    sph_fast_prepare_all(t->j.fast, s->rays, s->n);
    for (int i = 0; i < s->n; i++) {
        struct sph_fast_first *f = &t->first[s->of[i]];
        const struct sph_ray *ray = &s->rays[i];
        f->cosine[l] = sph_lambert(&f->s.unit, &ray->unit);
        if (!f->cosine[l]) continue;
        t->j.c->count[SPH_COUNT_RAYS_SHADOW]++;
        struct sph_hit hit = sph_fast_trace(t->j.fast, ray, t->j.c, &f->visits, t->j.errors);
        f->hidden |= (uint32_t)(hit.key != 0) << l;
    }
    s->n = 0;
}

/* From which surfaces light l is hidden, ray by ray. */
static void hide_each(struct tile *t, int l) {
    struct some s;
    s.n = 0;
    for (int i = 0; i < t->n; i++) {
        const struct sph_fast_first *f = &t->first[i];
        if (!f->prim) continue;
        struct sph_ray *ray = &s.rays[s.n];
        s.of[s.n++] = i;
        *ray = (struct sph_ray){
            .kind = SPH_SHADOW, .skip = {f->hit.id, f->hit.far}, .inside = t->j.inside};
        memcpy(ray->org, f->s.point, sizeof ray->org);
        sph_fast_towards(&t->j, &f->s, l, ray->dir);
        if (s.n == SPH_TOGETHER) send(t, &s, l);
    }
    send(t, &s, l);
}

/* From which surfaces light l is hidden. */
static void hide(struct tile *t, int l) {
    int lanes[SPH_PACKET];
    struct sph_bundle *to = &t->shadow;
    to->n = 0;
    to->kind = SPH_SHADOW;
    to->inside = t->j.inside;
    for (int i = 0; i < t->n; i++) {
        struct sph_fast_first *f = &t->first[i];
        struct sph_ray ray;
        if (!f->prim) continue;
        f->cosine[l] = sph_fast_light(&t->j, &f->s, l, &ray);
        if (!f->cosine[l]) continue;
        for (int k = 0; k < 3; k++) {
            to->org[k][to->n] = (int32_t)f->s.point[k];
            to->dir[k][to->n] = (int32_t)ray.dir[k];
        }
        to->skip[to->n] = (struct sph_skip){f->hit.id, f->hit.far};
        lanes[to->n++] = i;
    }
    if (!t->j.shadow || !to->n) return;
    t->j.c->count[SPH_COUNT_RAYS_SHADOW] += (uint64_t)to->n;
    for (uint64_t dark = sph_packet_hidden(t->j.fast, to); dark; dark &= dark - 1)
        t->first[lanes[__builtin_ctzll(dark)]].hidden |= 1u << l;
}

void sph_fast_tile(const struct sph_machine *m, const struct sph_render_options *o, int packets,
                   int x0, int y0, int x1, int y1, struct sph_frame *frame, struct sph_counters *c,
                   uint32_t *errors) {
    struct tile t;
    t.j = sph_fast_job_of(m, o->fast, c, errors);
    t.n = 0;
    for (int i = 0; i < SPH_PACKET; i++) {
        int x = x0 + sph_tile_x(i), y = y0 + sph_tile_y(i);
        size_t at = (size_t)y * (size_t)frame->width + (size_t)x;
        if (x >= x1 || y >= y1) continue;
        if (sph_is_background(m, x, y))
            frame->pixels[at] =
                sph_fast_pixel(m, o, x, y, c, errors, o->trails ? o->trails + at : NULL);
        else
            add(&t, x, y);
    }
    if (!t.n) return;
    t.j.c->count[SPH_COUNT_RAYS_PRIMARY] += (uint64_t)t.n;
    (packets ? packet_meets : each_meets)(&t);
    for (int l = 0; l < m->regs[SPH_REG_N_LIGHTS]; l++)
        (packets || !t.j.shadow ? hide : hide_each)(&t, l);
    for (int i = 0; i < t.n; i++) {
        size_t at = (size_t)t.y[i] * (size_t)frame->width + (size_t)t.x[i];
        struct sph_pixel *pixel = &frame->pixels[at];
        struct sph_ray ray = {.inside = t.j.inside};
        memcpy(ray.dir, t.dir[i], sizeof ray.dir);
        *pixel = (struct sph_pixel){
            .id = SPH_ID_NONE, .visits = t.first[i].visits, .texture = SPH_NO_TEXTURE};
        t.j.pixel = pixel;
        t.j.trail = o->trails ? o->trails + at : NULL;
        if (t.j.trail) *t.j.trail = sph_no_trail;
        sph_fast_path(&t.j, &ray, &t.first[i]);
    }
}
