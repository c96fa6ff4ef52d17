/* path.c - ray differentials (Igehy 1999); see texture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "reference/texture.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void sph_ref_path_start(struct sph_ref_path *path, const double dir[3], const double right[3],
                        const double up[3]) {
    const double *const step[2] = {right, up};
    double square = dot(dir, dir), cube = square * sqrt(square);
    *path = (struct sph_ref_path){.spread = 1};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            path->dir[k][i] = (square * step[k][i] - dot(dir, step[k]) * dir[i]) / cube;
}

void sph_ref_path_hit(struct sph_ref_path *path, const double dir[3], double t,
                      const double normal[3]) {
    double length = sqrt(dot(dir, dir)), away = t * length;
    for (int k = 0; k < 2; k++) {
        double moved[3];
        for (int i = 0; i < 3; i++)
            moved[i] = path->org[k][i] + away * path->dir[k][i];
        double more = -dot(moved, normal) / dot(dir, normal); /* times dir: back onto the surface */
        for (int i = 0; i < 3; i++)
            path->org[k][i] = moved[i] + more * dir[i];
    }
    path->length += away;
    path->wide += away * path->spread;
}

void sph_ref_path_mirror(struct sph_ref_path *path, const double dir[3], const double normal[3],
                         double curvature) {
    double length = sqrt(dot(dir, dir)), size = sqrt(dot(normal, normal)), d[3], n[3];
    for (int i = 0; i < 3; i++) {
        d[i] = dir[i] / length;
        n[i] = normal[i] / size;
    }
    path->spread += 4 * fabs(curvature) * path->wide;
    for (int k = 0; k < 2; k++) {
        double dn[3];
        for (int i = 0; i < 3; i++)
            dn[i] = curvature * path->org[k][i];
        double rise = dot(path->dir[k], n) + dot(d, dn);
        for (int i = 0; i < 3; i++)
            path->dir[k][i] -= 2 * (dot(d, n) * dn[i] + rise * n[i]);
    }
}

void sph_ref_path_refract(struct sph_ref_path *path, const double dir[3], const double normal[3],
                          double curvature, double ratio) {
    double length = sqrt(dot(dir, dir)), size = sqrt(dot(normal, normal)), d[3], n[3];
    for (int i = 0; i < 3; i++) {
        d[i] = dir[i] / length;
        n[i] = normal[i] / size;
    }
    if (curvature < 0) path->spread -= curvature * path->wide;
    double dn = dot(d, n), out = -sqrt(1 - ratio * ratio * (1 - dn * dn)); /* cosine behind */
    double mu = ratio * dn - out, steep = ratio - ratio * ratio * dn / out;
    for (int k = 0; k < 2; k++) {
        double turn[3];
        for (int i = 0; i < 3; i++)
            turn[i] = curvature * path->org[k][i];
        double rise = dot(path->dir[k], n) + dot(d, turn);
        for (int i = 0; i < 3; i++)
            path->dir[k][i] = ratio * path->dir[k][i] - (mu * turn[i] + steep * rise * n[i]);
    }
}
