/* layers.c - see layers.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "engine/layers.h"

#include <math.h>
#include <stdlib.h>

#include "machine/camera.h"
#include "pixel/background.h"
#include "prim/prim.h"
#include "shade/material.h"
#include "shade/surface.h"
#include "trace/setup.h"

const uint32_t sph_depth_colours[SPH_MAX_DEPTH + 2] = {0,        0x0000ff, 0x00ff00, 0xff0000,
                                                       0x00ffff, 0xff00ff, 0xffffff, 0xffff00,
                                                       0x0080ff, 0xff0080, 0x808080, 0x80c0ff};

/* The vector of the grid's axes, towards the eye, as a unit vector of the scene's. */
static void put_normal(const struct sph_machine *m, const int64_t v[3], const int64_t dir[3],
                       float out[3]) {
    double along = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        along += (double)v[i] * (double)dir[i];
        square += (double)v[i] * (double)v[i];
    }
    if (!(square > 0)) return;
    double scale = (along > 0 ? -1 : 1) / sqrt(square);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            out[i] += (float)(m->rotation[3 * k + i] * (double)v[k] * scale);
}

struct sph_layer sph_layer_of(const struct sph_machine *m, const struct sph_pixel *pixel, int x,
                              int y) {
    struct sph_layer layer = {.depth = INFINITY, .distance = INFINITY, .level = -1};
    size_t line = (uint32_t)m->regs[SPH_REG_PRIM_BASE] + (size_t)pixel->id;
    uint32_t level = pixel->texture >> SPH_LOD_LSB;
    if (!pixel->key || line >= (uint32_t)m->regs[SPH_REG_MEM_LINES]) return layer;
    const uint32_t *prim = sph_line(m, line);
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}};
    struct sph_surface s = {0};
    int64_t normal[3];
    for (int i = 0; i < 3; i++)
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_ray_setup(&m->profile, &ray);
    sph_surface_point(&m->profile, &ray, pixel->key, &s);
    sph_prim_of(sph_prim_kind(m, prim))->normal(&m->profile, prim, s.guarded, normal);
    int outside;
    const uint32_t *smooth = sph_smooth_record(m, prim, &outside);
    if (smooth) sph_smooth_normal(&m->profile, smooth, s.guarded, normal);
    put_normal(m, normal, ray.dir, layer.normal);
    double t = (double)pixel->key / (double)ray.a;
    struct sph_machine_camera camera = sph_machine_camera(m);
    layer.depth = (float)ldexp(t * sph_camera_ahead(&camera, ray.dir), m->grid_log2);
    layer.distance = (float)ldexp(t * sqrt((double)ray.a), m->grid_log2);
    struct sph_shading shading = sph_shading_read(m, prim);
    for (int i = 0; i < 3; i++)
        layer.albedo[i] = (float)shading.rgb[i] / 255;
    if (level != SPH_LOD_NONE) layer.level = (float)level / 256;
    return layer;
}

struct sph_layer *sph_layers_of(const struct sph_machine *m, const struct sph_frame *frame) {
    size_t n = (size_t)frame->width * (size_t)frame->height;
    struct sph_layer *layers = calloc(n, sizeof *layers);
    for (size_t i = 0; layers && i < n; i++)
        layers[i] = sph_layer_of(m, &frame->pixels[i], (int)(i % (size_t)frame->width),
                                 (int)(i / (size_t)frame->width));
    return layers;
}
