/* pdb_frame.c - see pdb_frame.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/pdb_frame.h"
#include "scene/edit.h"
#include "scene/vector.h"

#include <math.h>

#define ANGLE 30.0  /* degrees, vertical */
#define MARGIN 1.04 /* of the distance */
/* A mesh is seen from the front, from so much above it and to the right. */
#define TALL 0.3
#define SIDE 0.5

/* Eigenvectors of the symmetric matrix m as columns of axes, by Jacobi's rotations; the
 * eigenvalues are left on the diagonal of m. */
static void eigen(double m[3][3], double axes[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            axes[i][j] = i == j;
    for (int sweep = 0; sweep < 30; sweep++)
        for (int p = 0; p < 2; p++)
            for (int q = p + 1; q < 3; q++) {
                if (m[p][q] == 0) continue;
                double angle = 0.5 * atan2(2 * m[p][q], m[p][p] - m[q][q]);
                double c = cos(angle), s = sin(angle);
                for (int k = 0; k < 3; k++) {
                    double kp = m[k][p], kq = m[k][q];
                    m[k][p] = c * kp + s * kq;
                    m[k][q] = c * kq - s * kp;
                }
                for (int k = 0; k < 3; k++) {
                    double pk = m[p][k], qk = m[q][k], ap = axes[k][p], aq = axes[k][q];
                    m[p][k] = c * pk + s * qk;
                    m[q][k] = c * qk - s * pk;
                    axes[k][p] = c * ap + s * aq;
                    axes[k][q] = c * aq - s * ap;
                }
                m[p][q] = m[q][p] = 0;
            }
}

/* Principal axes of the centres: right is the longest, to_eye the thinnest; right-handed. */
static void principal(const struct sph_scene *scene, struct sph_vec *right, struct sph_vec *up,
                      struct sph_vec *to_eye) {
    double mean[3] = {0}, m[3][3] = {{0}}, axes[3][3];
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_vec c = scene->spheres[i].ctr;
        mean[0] += c.x / scene->n_spheres;
        mean[1] += c.y / scene->n_spheres;
        mean[2] += c.z / scene->n_spheres;
    }
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_vec c = scene->spheres[i].ctr;
        const double d[3] = {c.x - mean[0], c.y - mean[1], c.z - mean[2]};
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                m[j][k] += d[j] * d[k] / scene->n_spheres;
    }
    eigen(m, axes);
    int longest = 0, thinnest = 2;
    for (int k = 0; k < 3; k++)
        if (m[k][k] > m[longest][longest]) longest = k;
    for (int k = 2; k >= 0; k--)
        if (k != longest && (thinnest == longest || m[k][k] < m[thinnest][thinnest])) thinnest = k;
    *right = sph_vec_of(axes[0][longest], axes[1][longest], axes[2][longest]);
    *to_eye = sph_vec_of(axes[0][thinnest], axes[1][thinnest], axes[2][thinnest]);
    *up = sph_vec_of(to_eye->y * right->z - to_eye->z * right->y,
                     to_eye->z * right->x - to_eye->x * right->z,
                     to_eye->x * right->y - to_eye->y * right->x);
}

/* What is to be seen: spheres, then corners of triangles, whose radius is 0. */
static uint64_t count(const struct sph_scene *scene) {
    return scene->n_spheres + 3 * (uint64_t)scene->n_facets;
}

static struct sph_vec ball(const struct sph_scene *scene, uint64_t i, double *rad) {
    uint64_t k = i - scene->n_spheres;
    *rad = i < scene->n_spheres ? scene->spheres[i].rad : 0;
    return i < scene->n_spheres ? scene->spheres[i].ctr : scene->facets[k / 3].v[k % 3];
}

/* Middle of its extent along the axis. */
static double middle(const struct sph_scene *scene, struct sph_vec axis) {
    double low = INFINITY, high = -INFINITY, rad;
    for (uint64_t i = 0; i < count(scene); i++) {
        double along = sph_vec_dot(ball(scene, i, &rad), axis);
        low = fmin(low, along - rad);
        high = fmax(high, along + rad);
    }
    return (low + high) / 2;
}

static struct sph_vec combine(struct sph_vec a, double na, struct sph_vec b, double nb,
                              struct sph_vec c, double nc) {
    return sph_vec_of(na * a.x + nb * b.x + nc * c.x, na * a.y + nb * b.y + nc * c.y,
                      na * a.z + nb * b.z + nc * c.z);
}

/* Camera and lights as far as there are none. */
static void look(struct sph_scene *scene, struct sph_vec right, struct sph_vec up,
                 struct sph_vec to_eye) {
    const double x0 = middle(scene, right), y0 = middle(scene, up), z0 = middle(scene, to_eye);
    const double tall = ANGLE / 360 * M_PI;
    const double wide = atan(tan(tall) * scene->camera.width / scene->camera.height);
    double dist = 0;
    /* A sphere is below the plane through the eye at half angle h if
     * (dist - z) sin h - y cos h >= rad. */
    for (uint64_t i = 0; i < count(scene); i++) {
        double rad;
        const struct sph_vec c = ball(scene, i, &rad);
        double x = fabs(sph_vec_dot(c, right) - x0), y = fabs(sph_vec_dot(c, up) - y0);
        double z = sph_vec_dot(c, to_eye) - z0;
        dist = fmax(dist, z + (x * cos(wide) + rad) / sin(wide));
        dist = fmax(dist, z + (y * cos(tall) + rad) / sin(tall));
    }
    dist *= MARGIN;
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.15;
        scene->background[i] = 0.03125 * (i + 2);
    }
    struct sph_vec key = combine(right, x0 - dist / 2, up, y0 + dist / 2, to_eye, z0 + dist);
    struct sph_vec fill = combine(right, x0 + dist, up, y0, to_eye, z0 + dist / 2);
    if (!scene->n_lights) {
        scene->n_lights = 2;
        scene->lights[0] = (struct sph_light){key, {0.9, 0.9, 0.85}, 0};
        scene->lights[1] = (struct sph_light){fill, {0.3, 0.3, 0.35}, 0};
    }
    if (scene->camera.angle > 0) return;
    scene->camera.from = combine(right, x0, up, y0, to_eye, z0 + dist);
    scene->camera.at = combine(right, x0, up, y0, to_eye, z0);
    scene->camera.up = up;
    scene->camera.angle = ANGLE;
    scene->camera.hither = 0.01;
}

void sph_scene_frame(struct sph_scene *scene) {
    struct sph_vec right, up, to_eye;
    principal(scene, &right, &up, &to_eye);
    look(scene, right, up, to_eye);
}

static struct sph_vec unit(struct sph_vec v) {
    double length = sph_vec_length(v), by = length > 0 ? 1 / length : 1;
    return sph_vec_of(by * v.x, by * v.y, by * v.z);
}

void sph_scene_frame_mesh(struct sph_scene *scene, char axis) {
    const struct sph_camera *c = &scene->camera;
    struct sph_vec up = sph_vec_of(axis == 'x', axis == 'y', axis == 'z');
    /* The front is +z if y is up, -y if z is up, +y if x is up: the left hand of whoever looks from
     * there is -x, or -z. */
    struct sph_vec front = axis == 'x'   ? sph_vec_of(TALL, SIDE, 1)
                           : axis == 'y' ? sph_vec_of(SIDE, TALL, 1)
                                         : sph_vec_of(SIDE, -1, TALL);
    if (c->angle > 0) front = sph_vec_sub(c->from, c->at), up = c->up;
    struct sph_vec to_eye = unit(front), right = unit(sph_vec_cross(up, to_eye));
    look(scene, right, sph_vec_cross(to_eye, right), to_eye);
}
