/* tile.c - see tile.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/tile.h"

#include <stddef.h>

#include "fast/path.h"
#include "fast/pixel.h"
#include "pixel/walk.h"

struct tile {
    struct sph_fast_job j;
    int n;
    int x[SPH_PACKET], y[SPH_PACKET];
    struct sph_bundle primary, shadow;
    struct sph_fast_first first[SPH_PACKET];
};

int sph_fast_tiles(const struct sph_machine *m, const struct sph_fast *fast) {
    return sph_fast_shades(m) && !sph_machine_effect(m, SPH_EFFECT_FIRST) && sph_packets_fit(fast);
}

static void add(struct tile *t, int x, int y) {
    int64_t dir[3];
    int i = t->n++;
    t->x[i] = x;
    t->y[i] = y;
    sph_primary_dir(t->j.m, x, y, dir);
    for (int k = 0; k < 3; k++) {
        t->primary.org[k][i] = t->j.m->regs[SPH_REG_EYE_X + k];
        t->primary.dir[k][i] = (int32_t)dir[k];
    }
}

/* What the primary rays hit, and their surfaces. */
static void meet(struct tile *t) {
    struct sph_hit hits[SPH_PACKET];
    t->primary.n = t->n;
    t->primary.kind = SPH_PRIMARY;
    t->primary.inside = t->j.inside;
    sph_packet_nearest(t->j.fast, &t->primary, hits);
    t->j.c->count[SPH_COUNT_RAYS_PRIMARY] += (uint64_t)t->n;
    for (int i = 0; i < t->n; i++) {
        struct sph_fast_first *f = &t->first[i];
        f->hit = hits[i];
        f->prim = sph_fast_record(&t->j, &hits[i]);
        f->hidden = 0;
        if (!f->prim || (!t->j.m->regs[SPH_REG_N_LIGHTS] && !t->j.reflect)) continue;
        struct sph_ray ray = sph_bundle_ray(&t->primary, i);
        sph_fast_meet(&t->j, &ray, &f->hit, f->prim, &f->s);
    }
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
        f->cosine[l] = sph_fast_lamp(&t->j, &f->s, l, &ray);
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

void sph_fast_tile(const struct sph_machine *m, const struct sph_render_options *o, int x0, int y0,
                   int x1, int y1, struct sph_frame *frame, struct sph_counters *c,
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
    meet(&t);
    for (int l = 0; l < m->regs[SPH_REG_N_LIGHTS]; l++)
        hide(&t, l);
    for (int i = 0; i < t.n; i++) {
        size_t at = (size_t)t.y[i] * (size_t)frame->width + (size_t)t.x[i];
        struct sph_pixel *pixel = &frame->pixels[at];
        struct sph_ray ray = sph_bundle_ray(&t.primary, i);
        *pixel = (struct sph_pixel){.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
        t.j.pixel = pixel;
        t.j.trail = o->trails ? o->trails + at : NULL;
        if (t.j.trail) *t.j.trail = sph_no_trail;
        sph_fast_path(&t.j, &ray, &t.first[i]);
    }
}
