/* draw.h - single pixels of a machine, by the fast walk where it knows the machine
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TRIAL_DRAW_H
#define SPH_TRIAL_DRAW_H

#include "fast/pixel.h"

struct sph_drawer {
    const struct sph_machine *machine;
    struct sph_render_options how;
    struct sph_fast *fast; /* NULL: literally */
    int shades;            /* the machine is one of fast/pixel.h */
};

/* Of a machine that stays as it is until sph_drawer_end(). */
static inline struct sph_drawer sph_drawer_begin(const struct sph_machine *m) {
    struct sph_fast *fast = sph_fast_new(m, SPH_FAST_BEST);
    return (struct sph_drawer){
        m, {.traverse = SPH_TRAVERSE_FAST, .fast = fast}, fast, fast && sph_fast_shades(m)};
}

static inline void sph_drawer_end(struct sph_drawer *d) {
    sph_fast_free(d->fast);
}

/* As sph_render_pixel(). */
static inline struct sph_pixel sph_drawer_pixel(const struct sph_drawer *d, int x, int y,
                                                struct sph_counters *c, uint32_t *errors,
                                                struct sph_trail *trail) {
    return (d->shades ? sph_fast_pixel : sph_render_pixel)(d->machine, &d->how, x, y, c, errors,
                                                           trail);
}

#endif
