/* accuracy.c - see accuracy.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/accuracy.h"

#include <math.h>

#include "machine/camera.h"
#include "math/arith.h"
#include "pixel/background.h"

/* Distance from the eye to the hit of pixel x, y in grid units, as the machine's quotient has it.
 */
static double distance(const struct sph_machine *m, int x, int y, uint64_t key) {
    const struct sph_profile *p = sph_machine_profile(m);
    int64_t dir[3];
    sph_primary_dir(m, x, y, dir);
    uint64_t a = (uint64_t)(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
    struct sph_quotient t = sph_quotient(key, p->w + p->wd + 2, a, 2 * p->wd, p->pq);
    return ldexp((double)t.mant, -t.exp) * sqrt((double)a);
}

/* The scene's distance from the eye in grid units, as seen from the machine's eye. */
static double expected(const struct sph_accuracy_frame *f, int x, int y, double from_eye) {
    int64_t dir[3];
    if (!(f->ahead > 0)) return ldexp(from_eye, -f->machine->grid_log2);
    sph_primary_dir(f->machine, x, y, dir);
    struct sph_machine_camera camera = sph_machine_camera(f->machine);
    double ahead = sph_camera_ahead(&camera, dir), square = 0;
    for (int i = 0; i < 3; i++)
        square += (double)dir[i] * (double)dir[i];
    double aside = sqrt(fmax(square / (ahead * ahead) - 1, 0));
    double depth = from_eye / hypot(1, aside / f->wider) - f->ahead;
    return ldexp(depth * hypot(1, aside), -f->machine->grid_log2);
}

/* Bits of the machine's lights as bits of the scene's. */
static uint32_t scene_lights(const struct sph_accuracy_frame *f, uint32_t bits) {
    uint32_t mapped = 0;
    for (int l = 0; l < f->machine->regs[SPH_REG_N_LIGHTS]; l++)
        mapped |= (bits >> l & 1) << f->lights[l];
    return mapped;
}

static void number(const uint32_t *numbers, uint32_t *id) {
    if (*id != SPH_ID_NONE) *id = numbers[*id];
}

void sph_accuracy_number(const uint32_t *numbers, struct sph_frame *frame,
                         struct sph_trail *trails) {
    for (int64_t i = 0; i < (int64_t)frame->width * frame->height; i++) {
        number(numbers, &frame->pixels[i].id);
        number(numbers, &trails[i].reflected_id);
        number(numbers, &trails[i].refracted_id);
    }
}

struct sph_accuracy sph_accuracy_measure(const struct sph_accuracy_frame *f,
                                         const struct sph_reference *reference) {
    struct sph_accuracy e = {.image = sph_reference_compare(f->frame, reference), .x = -1, .y = -1};
    uint64_t width = (uint64_t)f->machine->regs[SPH_REG_FRAME_W];
    double sum = 0;
    for (uint64_t i = 0; i < e.image.pixels; i++) {
        const struct sph_pixel *p = &f->frame->pixels[i];
        const struct sph_reference_pixel *r = &reference->pixels[i];
        if (p->id != r->id || p->id == SPH_ID_NONE || r->doubt) continue;
        uint32_t faced = scene_lights(f, f->trails[i].faced) & r->faced;
        e.same++;
        e.shadow += ((scene_lights(f, f->trails[i].blocked) ^ r->shadow) & faced) != 0;
        e.reflected += f->trails[i].reflected_id != r->reflected_id;
        e.refracted += f->trails[i].refracted_id != r->refracted_id;
        uint64_t at = f->places ? f->places[i] : i;
        int x = (int)(at % width), y = (int)(at / width);
        double off = fabs(distance(f->machine, x, y, p->key) - expected(f, x, y, r->distance));
        sum += off;
        if (e.x < 0 || off > e.t_worst) e.t_worst = off, e.x = x, e.y = y;
    }
    if (e.same) e.t_mean = sum / (double)e.same;
    return e;
}
