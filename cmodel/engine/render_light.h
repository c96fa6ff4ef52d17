/* render_light.h - what the parts of a pixel share, and the light of one surface
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RENDER_LIGHT_H
#define SPH_RENDER_LIGHT_H

#include "core/frame.h"
#include "core/met.h"
#include "core/ray_log.h"
#include "core/stages.h"
#include "core/tracer.h"
#include "core/trail.h"
#include "shade/material.h"
#include "shade/surface.h"
#include "texture/lookup.h"
#include "trace/setup.h"

struct sph_job {
    const struct sph_machine *m;
    const struct sph_profile *p;
    int how, inside;
    struct sph_counters *c;
    struct sph_pixel *pixel;
    uint32_t *errors;
    struct sph_texture_work *texture;
    struct sph_trail *trail;     /* may be NULL */
    struct sph_ray_log *log;     /* may be NULL */
    struct sph_stages *stages;   /* may be NULL */
    const struct sph_fast *fast; /* NULL: literally */
    struct sph_met *met;         /* may be NULL */
};

/* sph_ray_setup() */
void sph_job_setup(const struct sph_job *j, struct sph_ray *ray);

/* A ray through the tree, counted by its kind. */
struct sph_hit sph_job_trace(const struct sph_job *j, const struct sph_ray *ray);

/* The colour, u8.8, of the surface that the ray hits: s is where, shading its material, tint what
 * its rgb is multiplied by (0xAABBGGRR). Sends rays to the lights. trail may be NULL. */
void sph_job_light(const struct sph_job *j, const struct sph_ray *ray, const struct sph_hit *hit,
                   const struct sph_surface *s, const struct sph_shading *shading, uint32_t tint,
                   uint32_t colour[3], struct sph_trail *trail);

#endif
