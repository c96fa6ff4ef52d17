/* compare.c - how far a frame is from the reference, see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>

#include "reference/reference.h"

enum { FAR_OFF = 8 };

static const double FULL = 255.0 * 255.0 * 3; /* squared error of black against white */

/* Adds the squared differences of three channels to *sum; returns the largest difference. */
static int differ(uint32_t a, uint32_t b, double *sum) {
    int worst = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        int d = abs((int)(a >> shift & 255) - (int)(b >> shift & 255));
        *sum += (double)d * d;
        worst = d > worst ? d : worst;
    }
    return worst;
}

struct sph_image_error sph_reference_compare(const struct sph_frame *frame,
                                             const struct sph_reference *reference) {
    struct sph_image_error e = {.pixels = 0};
    double sum[SPH_FRAMES] = {0};
    if (frame->width != reference->width || frame->height != reference->height) return e;
    e.pixels = (uint64_t)frame->width * (uint64_t)frame->height;
    for (uint64_t i = 0; i < e.pixels; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        const struct sph_reference_pixel *r = &reference->pixels[i];
        int worst = 0;
        if (r->doubt) {
            e.undecidable++;
            continue;
        }
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            worst = differ(p->colour[layer], r->colour[layer], &sum[layer]);
        e.far_off += worst > FAR_OFF;
        e.worst = worst > e.worst ? worst : e.worst;
        if ((p->id == SPH_ID_NONE) != (r->id == SPH_ID_NONE))
            e.silhouette++;
        else if (p->id != r->id)
            e.wrong_id++;
    }
    double n = (double)(e.pixels - e.undecidable);
    for (int layer = 0; layer < SPH_FRAMES; layer++)
        e.psnr[layer] = sum[layer] > 0 ? 10 * log10(FULL * n / sum[layer]) : INFINITY;
    return e;
}
