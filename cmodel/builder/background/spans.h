/* spans.h - background separation by the outline of the root sphere, made safe
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SPANS_H
#define SPH_SPANS_H

#include "builder/background/outline.h"

enum {
    SPH_POINTS_DEFAULT = 16, /* the paper's */
    SPH_POINTS_MIN = 4,
    SPH_POINTS_MAX = 4096,
    SPH_BORDER_MAX = 64
};

enum { SPH_SPANS_OUTLINE, SPH_SPANS_WIDENED, SPH_SPANS_WHOLE, SPH_SPANS_BEHIND };

struct sph_spans {
    struct sph_span *rows;       /* `height` of them; free(rows) */
    int how;                     /* SPH_SPANS_* */
    int points;                  /* with which the outline covered; the most tried if WIDENED */
    struct sph_work work, check; /* of all outlines drawn; of finding out whether they cover */
};

/* The pixels outside of which no primary ray hits the sphere `root` (grid units). The outline of
 * points^2 points with a border of `border` pixels; as long as it leaves out a pixel whose ray
 * hits, which is decided in integers, points is doubled, and beyond SPH_POINTS_MAX its rows are
 * widened. The whole frame if the sphere is not wholly in front of the eye; nothing if it is
 * wholly behind. -1 if memory is out. */
int sph_spans_make(struct sph_spans *spans, const struct sph_ball *root, const int32_t eye[3],
                   const struct sph_rays *rays, int width, int height, int points, int border,
                   struct sph_error *err);

/* The outline alone, unchecked: rows[0 .. height-1] of a sphere in front of the eye, whatever it
 * leaves out. *work: what it cost. -1 if memory is out. */
int sph_spans_draw(struct sph_span *rows, const struct sph_projection *p, int width, int height,
                   int border, struct sph_work *work, struct sph_error *err);

#endif
