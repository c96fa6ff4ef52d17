/* rect_paper.c - see rect_paper.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/background/rect_paper.h"

#include <math.h>

int sph_rect_paper(const struct sph_ball *root, const int32_t eye[3], const struct sph_rays *rays,
                   int width, int height, struct sph_span *rows, double point[4][2],
                   struct sph_work *work) {
    double low[2] = {0, 0}, high[2] = {width - 1, height - 1};
    const double x = root->c[0], y = root->c[1], reach = 1.4 * root->r;
    const double at[4][2] = {{x + reach, y}, {x - reach, y}, {x, y + reach}, {x, y - reach}};
    int answer = eye[2] > root->c[2];
    if (answer) {
        double scale = -(double)rays->z / ((double)eye[2] - root->c[2]);
        for (int i = 0; i < 4; i++) {
            point[i][0] =
                floor(((at[i][0] - eye[0]) * scale - rays->x0) / (double)rays->pitch + 0.5);
            point[i][1] =
                floor((rays->y0 - (at[i][1] - eye[1]) * scale) / (double)rays->pitch + 0.5);
        }
        low[0] = fmax(point[1][0], low[0]), high[0] = fmin(point[0][0], high[0]);
        low[1] = fmax(point[2][1], low[1]), high[1] = fmin(point[3][1], high[1]);
        /* the four sums of the paper; the matrix, and pixels: of each point one coordinate counts
         */
        sph_work_add(work, &(struct sph_work){
                               .add = 4 + 1 + 4 * 3, .mul = 1 + 4, .div = 1 + 4, .compare = 4});
    }
    for (int row = 0; row < height; row++) {
        int in = row >= low[1] && row <= high[1] && low[0] <= high[0];
        rows[row] =
            in ? (struct sph_span){(int32_t)low[0], (int32_t)high[0] + 1} : (struct sph_span){0, 0};
    }
    return answer;
}
