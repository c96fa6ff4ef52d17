/* levels.c - see levels.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/levels.h"

#include <math.h>

/* A level that is a whole number was limited, 0 or the image's last; any other comes so by chance
 * alone. */
static int limited(double lod) {
    return lod == floor(lod);
}

static void add_slant(struct sph_levels *e, const struct sph_reference_pixel *q) {
    double rays = q->lod[SPH_LOD_RAYS], path = q->lod[SPH_LOD_MENDED] - rays;
    if (limited(rays) || limited(q->lod[SPH_LOD_MENDED]) || limited(q->lod[SPH_LOD_BMRT])) return;
    int angle = (int)(acos(fmin(q->facing, 1)) * 180 / acos(-1.0) / SPH_SLANT_STEP);
    if (angle >= SPH_SLANTS) angle = SPH_SLANTS - 1;
    struct sph_slant *s = &e->slant[q->via][angle];
    s->path_low = s->pixels ? fmin(s->path_low, path) : path;
    s->path_top = s->pixels ? fmax(s->path_top, path) : path;
    s->pixels++;
    s->near += fabs(path) <= 1;
    s->path += path;
    s->bmrt += q->lod[SPH_LOD_BMRT] - rays;
}

/* `lod` of the machine; sums of the error and of its square, until they are finished. */
static void add_error(struct sph_levels *e, const struct sph_reference_pixel *q, double lod) {
    struct sph_level_error *to = &e->error[q->via];
    double off = lod - q->lod[SPH_LOD_RAYS];
    if (limited(q->lod[SPH_LOD_RAYS])) return;
    to->pixels++;
    to->mean += off;
    to->deviation += off * off;
}

static void finish_errors(struct sph_levels *e) {
    for (int via = 0; via < SPH_VIAS; via++) {
        struct sph_level_error *to = &e->error[via];
        double n = to->pixels ? (double)to->pixels : 1;
        to->mean /= n;
        to->deviation = sqrt(fmax(0, to->deviation / n - to->mean * to->mean));
    }
}

static void finish_slants(struct sph_levels *e) {
    for (int i = 0; i < SPH_VIAS * SPH_SLANTS; i++) {
        struct sph_slant *s = &e->slant[i / SPH_SLANTS][i % SPH_SLANTS];
        s->path /= s->pixels ? (double)s->pixels : 1;
        s->bmrt /= s->pixels ? (double)s->pixels : 1;
    }
}

struct sph_levels sph_levels_measure(const struct sph_frame *frame,
                                     const struct sph_reference *reference) {
    struct sph_levels e = {.pixels = 0};
    if (frame->width != reference->width || frame->height != reference->height) return e;
    for (size_t i = 0; i < (size_t)frame->width * (size_t)frame->height; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        const struct sph_reference_pixel *q = &reference->pixels[i];
        uint32_t lod = p->texture >> SPH_LOD_LSB;
        if (lod == SPH_LOD_NONE || !q->textured || p->id != q->id) continue;
        double off = fabs(lod / 256.0 - q->lod[SPH_LOD_MENDED]);
        add_slant(&e, q);
        add_error(&e, q, lod / 256.0);
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
    finish_slants(&e);
    finish_errors(&e);
    return e;
}
