/* camera.c - see camera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/camera.h"

#include <math.h>

#include "reference/world.h"
#include "scene/vector.h"
#include "scene/window.h"

static const double degree = 3.14159265358979323846 / 180;

/* v around a unit axis, counterclockwise as seen from its tip (Rodrigues). */
static struct sph_vec turned(struct sph_vec v, struct sph_vec axis, double angle) {
    double c = cos(angle);
    struct sph_vec to = {c * v.x, c * v.y, c * v.z};
    to = sph_vec_add(to, sph_vec_cross(axis, v), sin(angle));
    return sph_vec_add(to, axis, sph_vec_dot(axis, v) * (1 - c));
}

/* A vector around `up`, and then towards it; not onto the poles. */
static struct sph_vec swung(struct sph_vec v, struct sph_vec up, double around, double towards) {
    up = sph_vec_unit(up);
    v = turned(v, up, around);
    double cosine = sph_vec_dot(sph_vec_unit(v), up);
    double is = acos(fmax(-1, fmin(1, cosine))), least = VIEW_POLE, most = 180 * degree - VIEW_POLE;
    double to = fmax(fmin(least, is), fmin(fmax(most, is), is - towards));
    return turned(v, sph_vec_unit(sph_vec_cross(v, up)), is - to);
}

double view_distance(const struct sph_camera *c) {
    return sph_vec_length(sph_vec_sub(c->from, c->at));
}

void view_orbit(struct sph_camera *c, double right, double up) {
    c->from = sph_vec_add(c->at, swung(sph_vec_sub(c->from, c->at), c->up, right, up), 1);
}

void view_look(struct sph_camera *c, double right, double up) {
    c->at = sph_vec_add(c->from, swung(sph_vec_sub(c->at, c->from), c->up, -right, up), 1);
}

/* The camera's axes: right, up, back. */
static int axes(const struct sph_camera *c, struct sph_vec axis[3]) {
    struct sph_ref_view view;
    if (!sph_ref_view_of(c, 1, 1, &view)) return 0;
    for (int i = 0; i < 3; i++)
        axis[i] = (struct sph_vec){view.axes[i][0], view.axes[i][1], view.axes[i][2]};
    return 1;
}

void view_walk(struct sph_camera *c, double right, double up, double forward) {
    struct sph_vec axis[3], by = {0, 0, 0};
    if (!axes(c, axis)) return;
    by = sph_vec_add(sph_vec_add(sph_vec_add(by, axis[0], right), axis[1], up), axis[2], -forward);
    c->from = sph_vec_add(c->from, by, 1);
    c->at = sph_vec_add(c->at, by, 1);
}

void view_pan(struct sph_camera *c, double right, double down) {
    double height = 2 * tan(c->angle / 2 * degree) * view_distance(c);
    view_walk(c, -right * height, down * height, 0);
}

void view_near(struct sph_camera *c, double factor) {
    c->from = sph_vec_add(c->at, sph_vec_sub(c->from, c->at), factor);
}

void view_angle(struct sph_camera *c, double factor) {
    double angle = 2 * atan(tan(c->angle / 2 * degree) * factor) / degree;
    c->angle = fmax(VIEW_NARROW, fmin(VIEW_WIDE, angle));
}

void view_head(struct sph_camera *c, double at[2], double right, double up) {
    double height = 2 * tan(c->angle / 2 * degree) * view_distance(c);
    if (sph_camera_move_eye(c, (right - at[0]) * height, (up - at[1]) * height, 0, "view", NULL))
        return;
    at[0] = right, at[1] = up;
}

int view_line(const struct sph_camera *c, int width, int height, struct sph_vec a, struct sph_vec b,
              double ends[4]) {
    struct sph_ref_view view;
    const struct sph_window *w = &view.window;
    struct sph_vec axis[3], end[2] = {sph_vec_sub(a, c->from), sph_vec_sub(b, c->from)};
    double ahead[2], hither = view_distance(c) / 1000; /* nearer is behind */
    if (!axes(c, axis) || !sph_ref_view_of(c, width, height, &view)) return 0;
    for (int i = 0; i < 2; i++)
        ahead[i] = -sph_vec_dot(end[i], axis[2]);
    if (!(ahead[0] > hither) && !(ahead[1] > hither)) return 0;
    for (int i = 0; i < 2; i++) {
        struct sph_vec at = end[i];
        double depth = ahead[i];
        if (depth < hither) {
            double part = (hither - depth) / (ahead[1 - i] - depth);
            at = sph_vec_add(at, sph_vec_sub(end[1 - i], end[i]), part);
            depth = hither;
        }
        ends[2 * i] = sph_vec_dot(at, axis[0]) / depth * w->screen - w->left;
        ends[2 * i + 1] = w->top - sph_vec_dot(at, axis[1]) / depth * w->screen;
    }
    return 1;
}
