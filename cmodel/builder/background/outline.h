/* outline.h - the paper's accurate method, step by step (Borodavka et al. V.A, V.B)
 * SPDX-License-Identifier: Apache-2.0
 *
 * Points on meridians and parallels of a sphere, projected to pixels; first and last of each row;
 * first and last of each column; a border. docs/results/effects.md shows a picture of each step.
 * In double, and so by itself safe for no picture: spans.h checks the result in integers.
 */
#ifndef SPH_OUTLINE_H
#define SPH_OUTLINE_H

#include "builder/background/work.h"
#include "builder/grid/bound.h"
#include "builder/grid/grid.h"
#include "common/error.h"

/* The pixels x0 <= x < x1 of a row; none if x1 <= x0. */
struct sph_span {
    int32_t x0, x1;
};

/* Rows -margin .. height-1+margin of a frame with `margin` pixels more at each side: what lies
 * beyond is drawn into the outermost ones. */
struct sph_outline {
    int32_t width, height, margin;
    int32_t x0, y0, x1, y1; /* the minimal box, ends exclusive; x1 <= x0: nothing drawn */
    struct sph_span *rows;  /* row y: rows[y + margin] */
    struct sph_work work;   /* of all steps so far */
};

/* What all points of a projection share. */
struct sph_projection {
    const struct sph_ball *ball;
    const int32_t *eye;
    const struct sph_rays *rays;
    int n; /* meridians, and parallels with the poles among them */
};

/* Whether every point of the sphere lies in front of the eye, so that it can be projected. */
int sph_in_front(const struct sph_ball *ball, const int32_t eye[3]);

/* An empty outline; free(rows). -1 if memory is out. */
int sph_outline_start(struct sph_outline *o, int width, int height, int margin,
                      struct sph_error *err);

/* Projects points j = 0 .. n-1 of parallel i = 0 .. n-1 to pixels, not limited to any frame. The
 * sphere must be in front. */
void sph_project_parallel(const struct sph_projection *p, int i, double (*pixel)[2],
                          struct sph_work *work);

/* Projects all points; rows then reach from the first to the last point in them. -1 if memory is
 * out. */
int sph_outline_rows(struct sph_outline *o, const struct sph_projection *p, struct sph_error *err);

/* Fills each column from its first to its last pixel. -1 if memory is out. */
int sph_outline_columns(struct sph_outline *o, struct sph_error *err);

/* Adds the pixels at most n rows and columns away. -1 if memory is out. */
int sph_outline_border(struct sph_outline *o, int n, struct sph_error *err);

/* Row y of the frame, 0 <= y < height; {0, 0} if it has no pixel. */
struct sph_span sph_outline_row(const struct sph_outline *o, int y);

/* ---- the paper's fast method taken at its word (Borodavka et al. V.C); loses pixels ---- */
/* Only for comparison: no machine is built with it. rect.h is the safe one. */

/* The rectangle of the four points C +- 1.4 R along x and y as rows of a frame: rows[0..height-1].
 * point[4]: the points in pixels, not limited to the frame. Returns 0 if the centre is not in
 * front of the eye, so that the method has no answer: then every pixel is in. */
int sph_rect_paper(const struct sph_ball *root, const int32_t eye[3], const struct sph_rays *rays,
                   int width, int height, struct sph_span *rows, double point[4][2],
                   struct sph_work *work);

#endif
