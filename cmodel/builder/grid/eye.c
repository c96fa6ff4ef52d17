/* eye.c - see eye.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/eye.h"

#include <math.h>

enum {
    LEAST = 4,   /* times u: then c' - u is no small number */
    MARGIN = 16, /* grid units that a grid has besides what lies on it, at most */
    WIDEST = 32  /* tan(angle/2): then a screen of 12 bits still is SPH_MIN_SCREEN away */
};

/* What is seen: depth of its middle, half of what it is deep and wide. */
struct seen {
    double middle, deep, wide;
};

static double moved(const struct seen *s, double c) {
    return s->deep * (s->middle - c) / (s->middle * (c - s->deep));
}

/* How far a point may be off across the view, in units of the scene. */
static double off(const struct seen *s, double c, double step) {
    return s->wide * moved(s, c) + step / 2;
}

/* The middle's depth from an eye put as far away as a grid allows; no farther than it is. */
static double farthest(const struct seen *s, double step, int w) {
    return fmin(s->middle, (ldexp(1, w) - MARGIN) * step - s->deep);
}

struct sph_eye sph_eye_place(const struct sph_scene *scene, const double axis[3],
                             const double lo[3], const double hi[3], int w) {
    const struct sph_camera *cam = &scene->camera;
    struct sph_eye eye = {cam->from, 0, cam->angle, 1, 0};
    struct seen s = {-(lo[2] + hi[2]) / 2, (hi[2] - lo[2]) / 2,
                     fmax(fmax(hi[0], -lo[0]), fmax(hi[1], -lo[1]))};
    double tangent = tan(cam->angle * M_PI / 360), c = s.middle, best;
    s.wide = fmin(s.wide, 2 * tangent * s.middle); /* no more is seen: frames are no wider */
    double least = fmax(LEAST * s.deep, fmax(2 * s.wide, tangent * s.middle / WIDEST));
    if (!(least > 0 && s.middle > least) || !isfinite(s.middle)) return eye;
    double step = exp2(floor(log2(least) - w));
    if (!(step > 0)) return eye; /* below the least of doubles */
    while (farthest(&s, step, w) < s.middle)
        step *= 2;
    best = off(&s, s.middle, step) / 2;
    while ((step /= 2) > 0 && farthest(&s, step, w) > least) {
        double here = farthest(&s, step, w), by = off(&s, here, step);
        if (by < best) best = by, c = here;
    }
    if (c == s.middle) return eye;
    eye.ahead = s.middle - c;
    eye.wider = s.middle / c;
    eye.angle = atan(tangent * eye.wider) * 360 / M_PI;
    eye.off = moved(&s, c);
    eye.from.x -= axis[0] * eye.ahead;
    eye.from.y -= axis[1] * eye.ahead;
    eye.from.z -= axis[2] * eye.ahead;
    return eye;
}
