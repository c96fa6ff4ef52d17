/* view.c - see view.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/view.h"

#include <math.h>

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Scales v to length 1; 0 if it has none. */
static int unit(double v[3]) {
    double n = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++)
        v[i] /= n;
    return isfinite(n) && n > 0;
}

int sph_ref_view_of(const struct sph_camera *c, int width, int height, struct sph_ref_view *view) {
    double up[3] = {c->up.x, c->up.y, c->up.z};
    *view = (struct sph_ref_view){
        .eye = {c->from.x, c->from.y, c->from.z}, .width = width, .height = height};
    double *right = view->axes[0], *back = view->axes[2];
    back[0] = c->from.x - c->at.x, back[1] = c->from.y - c->at.y, back[2] = c->from.z - c->at.z;
    if (!unit(back)) return 0;
    cross(up, back, right);
    if (!unit(right)) return 0;
    cross(back, right, view->axes[1]);
    view->screen = height / 2.0 / tan(c->angle * acos(-1.0) / 360);
    return isfinite(view->screen) && view->screen > 0;
}

void sph_ref_view_dir(const struct sph_ref_view *v, int x, int y, double dir[3]) {
    for (int i = 0; i < 3; i++)
        dir[i] = (x - (v->width - 1) / 2.0) * v->axes[0][i] +
                 ((v->height - 1) / 2.0 - y) * v->axes[1][i] - v->screen * v->axes[2][i];
}
