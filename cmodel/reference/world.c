/* world.c - see world.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/world.h"

#include <math.h>

/* ---- view ---- */

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
    view->window = sph_window_of(c, width, height);
    return isfinite(view->window.screen) && view->window.screen > 0;
}

void sph_ref_view_dir(const struct sph_ref_view *v, int x, int y, double dir[3]) {
    for (int i = 0; i < 3; i++)
        dir[i] = (v->window.left + x) * v->axes[0][i] + (v->window.top - y) * v->axes[1][i] -
                 v->window.screen * v->axes[2][i];
}

enum { SHOWS = 8 }; /* levels: what frames are said to be far off by */

struct sph_ends sph_ends_of(const struct sph_machine *m) {
    return (struct sph_ends){m->rotation, m->origin, ldexp(1, m->grid_log2),
                             ldexp(1, sph_machine_profile(m)->w - 1)};
}

/* The coordinate along an axis of the grid. */
static double along(const double *axis, const double p[3]) {
    return axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
}

double sph_ends_at(const struct sph_ends *e, const double org[3], const double dir[3]) {
    int k = 0;
    double most = 0;
    for (int i = 0; i < 3; i++) {
        double size = fabs(along(&e->rotation[3 * i], dir));
        if (size > most) most = size, k = i;
    }
    double at = (along(&e->rotation[3 * k], org) - e->origin[k]) / e->step;
    double room = along(&e->rotation[3 * k], dir) < 0 ? at + e->half + 1 : e->half - at;
    return room * e->step / most;
}

/* The angle between the ways to a light from two points. */
static double angle(const struct sph_vec *lamp, const double p[3], const double q[3]) {
    const double a[3] = {lamp->x - p[0], lamp->y - p[1], lamp->z - p[2]};
    const double b[3] = {lamp->x - q[0], lamp->y - q[1], lamp->z - q[2]};
    double dot = 0, cross = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        double c = a[i] * b[j] - a[j] * b[i];
        dot += a[i] * b[i];
        cross += c * c;
    }
    return atan2(sqrt(cross), dot);
}

/* How far each light turns; 0 if the ray is not ended. */
static int turns(const struct sph_ends *e, const struct sph_scene *scene, const double org[3],
                 const double dir[3], double t, double by[SPH_MAX_LIGHTS]) {
    double end = sph_ends_at(e, org, dir), p[3], q[3];
    if (!(t > end)) return 0;
    for (int i = 0; i < 3; i++) {
        p[i] = org[i] + t * dir[i];
        q[i] = org[i] + end * dir[i];
    }
    for (int l = 0; l < scene->n_lights; l++)
        by[l] = angle(&scene->lights[l].pos, p, q);
    return 1;
}

double sph_ends_turn(const struct sph_ends *e, const struct sph_scene *scene, const double org[3],
                     const double dir[3], double t) {
    double by[SPH_MAX_LIGHTS], most = 0;
    if (!turns(e, scene, org, dir, t, by)) return 0;
    for (int l = 0; l < scene->n_lights; l++)
        most = fmax(most, by[l]);
    return most;
}

double sph_ends_levels(const struct sph_ends *e, const struct sph_scene *scene, const double org[3],
                       const double dir[3], double t) {
    double by[SPH_MAX_LIGHTS], sum = 0;
    if (!turns(e, scene, org, dir, t, by)) return 0;
    for (int l = 0; l < scene->n_lights; l++) {
        const double *rgb = scene->lights[l].rgb;
        sum += fmin(by[l], 1) * fmax(rgb[0], fmax(rgb[1], rgb[2]));
    }
    return 255 * sum;
}

int sph_ends_show(const struct sph_ends *e, const struct sph_scene *scene,
                  const struct sph_facet *plane, const double org[3], const double dir[3],
                  double t) {
    if (plane->texture) return t > sph_ends_at(e, org, dir);
    return sph_ends_levels(e, scene, org, dir, t) > SHOWS;
}
