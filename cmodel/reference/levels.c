/* levels.c - see levels.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/levels.h"

#include <math.h>

struct sph_levels sph_levels_measure(const struct sph_frame *frame,
                                     const struct sph_reference *reference) {
    struct sph_levels e = {0};
    if (frame->width != reference->width || frame->height != reference->height) return e;
    for (size_t i = 0; i < (size_t)frame->width * (size_t)frame->height; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        const struct sph_reference_pixel *q = &reference->pixels[i];
        uint32_t lod = p->texture >> SPH_LOD_LSB;
        if (lod == SPH_LOD_NONE || !q->textured || p->id != q->id) continue;
        double off = fabs(lod / 256.0 - q->lod[SPH_LOD_MENDED]);
        e.pixels++;
        e.model_mean += off;
        e.model_worst = fmax(e.model_worst, off);
        for (int k = 0; k < SPH_LODS; k++) {
            double from_rays = fabs(q->lod[k] - q->lod[SPH_LOD_RAYS]);
            e.mean[k] += q->lod[k];
            e.off[k] += from_rays;
            e.within_half[k] += from_rays <= 0.5;
        }
    }
    double n = e.pixels ? (double)e.pixels : 1;
    e.model_mean /= n;
    for (int k = 0; k < SPH_LODS; k++)
        e.mean[k] /= n, e.off[k] /= n, e.within_half[k] /= n;
    return e;
}
