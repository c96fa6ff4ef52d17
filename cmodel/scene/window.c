/* window.c - see window.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/window.h"

#include <math.h>
#include <string.h>

#include "scene/edit.h"
#include "scene/vector.h"

static const double pi = 3.14159265358979323846;

int sph_wall_columns(const struct sph_camera *camera) {
    return camera->wall.columns ? camera->wall.columns : 1;
}

int sph_wall_rows(const struct sph_camera *camera) {
    return camera->wall.rows ? camera->wall.rows : 1;
}

struct sph_window sph_window_of(const struct sph_camera *c, int width, int height) {
    double across = (double)sph_wall_columns(c) * width, down = (double)sph_wall_rows(c) * height;
    return (struct sph_window){
        .left = c->shift[0] * down - (across - 1) / 2 + (double)c->wall.column * width,
        .top = c->shift[1] * down + (down - 1) / 2 - (double)c->wall.row * height,
        .screen = down / 2 / tan(c->angle * pi / 360)};
}

int sph_camera_move_eye(struct sph_camera *camera, double right, double up, double back,
                        const char *where, struct sph_error *err) {
    struct sph_camera c = *camera;
    struct sph_vec arm = sph_vec_sub(c.from, c.at), z = sph_vec_unit(arm);
    struct sph_vec x = sph_vec_unit(sph_vec_cross(c.up, z)), y = sph_vec_cross(z, x);
    double near = sph_vec_length(arm), far = near + back;
    double height = 2 * near * tan(c.angle * pi / 360);
    if (!(far > 0))
        return sph_fail(err, "%s: camera: %g before the screen, the eye cannot move %g towards it",
                        where, near, -back);
    const double by[3] = {right * x.x + up * y.x, right * x.y + up * y.y, right * x.z + up * y.z};
    c.at = sph_vec_of(c.at.x + by[0], c.at.y + by[1], c.at.z + by[2]);
    c.from = sph_vec_of(c.at.x + far * z.x, c.at.y + far * z.y, c.at.z + far * z.z);
    c.angle = atan(height / 2 / far) * 360 / pi;
    c.shift[0] -= right / height;
    c.shift[1] -= up / height;
    if (sph_camera_check(&c, where, err)) return -1;
    *camera = c;
    return 0;
}

int sph_camera_aim(const struct sph_aim *aim, struct sph_camera *camera, const char *where,
                   struct sph_error *err) {
    const double *eye = aim->eye;
    if (aim->shifted) memcpy(camera->shift, aim->shift, sizeof camera->shift);
    camera->wall = aim->wall;
    if (eye[0] == 0 && eye[1] == 0 && eye[2] == 0) return 0;
    return sph_camera_move_eye(camera, eye[0], eye[1], eye[2], where, err);
}
