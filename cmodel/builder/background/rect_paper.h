/* rect_paper.h - the paper's fast method taken at its word (Borodavka et al. V.C); loses pixels
 * SPDX-License-Identifier: Apache-2.0
 *
 * Only for comparison: no machine is built with it. rect.h is the safe one.
 */
#ifndef SPH_RECT_PAPER_H
#define SPH_RECT_PAPER_H

#include "builder/background/outline.h"

/* The rectangle of the four points C +- 1.4 R along x and y as rows of a frame: rows[0..height-1].
 * point[4]: the points in pixels, not limited to the frame. Returns 0 if the centre is not in
 * front of the eye, so that the method has no answer: then every pixel is in. */
int sph_rect_paper(const struct sph_ball *root, const int32_t eye[3], const struct sph_rays *rays,
                   int width, int height, struct sph_span *rows, double point[4][2],
                   struct sph_work *work);

#endif
