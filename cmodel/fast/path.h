/* path.h - what pixels and tiles of them share
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_PATH_H
#define SPH_FAST_PATH_H

#include "fast/fast.h"
#include "fast/setup.h"

struct sph_fast_job {
    const struct sph_machine *m;
    const struct sph_profile *p;
    const struct sph_fast *fast;
    struct sph_counters *c;
    struct sph_pixel *pixel;
    uint32_t *errors;
    struct sph_trail *trail; /* may be NULL */
    int inside, shadow, reflect;
};

/* What a tile has found of a pixel. */
struct sph_fast_first {
    struct sph_hit hit;
    const uint32_t *prim; /* its record; NULL: the background, and there is no more */
    struct sph_surface s;
    uint32_t cosine[SPH_MAX_LIGHTS]; /* to each light */
    uint32_t hidden;                 /* bit l: light l is */
    uint32_t visits;                 /* of its rays so far */
};

static const struct sph_trail sph_no_trail = {.reflected_id = SPH_ID_NONE,
                                              .refracted_id = SPH_ID_NONE};

/* All but pixel and trail. */
struct sph_fast_job sph_fast_job_of(const struct sph_machine *m, const struct sph_fast *fast,
                                    struct sph_counters *c, uint32_t *errors);

/* The record of a hit; NULL: nothing is hit, or the record does not lie in memory. */
const uint32_t *sph_fast_record(const struct sph_fast_job *j, const struct sph_hit *hit);

/* The surface of a sphere that the ray hits. */
void sph_fast_meet(const struct sph_fast_job *j, const struct sph_ray *ray,
                   const struct sph_hit *hit, const uint32_t *prim, struct sph_surface *s);

/* The direction to a light. */
static inline void sph_fast_towards(const struct sph_fast_job *j, const struct sph_surface *s,
                                    int light, int64_t dir[3]) {
    const int32_t *lamp = j->m->regs + SPH_REG_LIGHT0_X + light * SPH_LIGHT_STRIDE;
    int away = lamp[3] >> SPH_LIGHT_SHIFT_LSB;
    for (int i = 0; i < 3; i++)
        dir[i] = lamp[i] - sph_round(s->point[i], away);
}

/* Direction, unit and square of the ray to a light; the cosine, 0: it is behind the surface. */
uint32_t sph_fast_light(const struct sph_fast_job *j, const struct sph_surface *s, int light,
                        struct sph_ray *to);

/* The colours, id and key that the ray and those after it give the pixel. known: what was found of
 * the ray, which needs no set-up then; else NULL. */
void sph_fast_path(const struct sph_fast_job *j, struct sph_ray *ray,
                   const struct sph_fast_first *known);

#endif
