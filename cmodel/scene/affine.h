/* affine.h - maps of points: scale, turn and move, one after another
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_AFFINE_H
#define SPH_AFFINE_H

#include "scene/vector.h"

/* p becomes m[.][0..2] p + m[.][3]. */
struct sph_affine {
    double m[3][4];
};

/* w + x i + y j + z k; of length 1 it is a turn. */
struct sph_turn {
    double w, x, y, z;
};

/* The turn by an angle (degrees) around an axis; no turn if the axis is zero. */
static inline struct sph_turn sph_turn_of(struct sph_vec axis, double degrees) {
    double length = sph_vec_length(axis), half = degrees * M_PI / 360;
    if (!(length > 0)) return (struct sph_turn){1, 0, 0, 0};
    double s = sin(half) / length;
    return (struct sph_turn){cos(half), s * axis.x, s * axis.y, s * axis.z};
}

static inline struct sph_vec sph_affine_point(const struct sph_affine *a, struct sph_vec p) {
    double out[3];
    for (int i = 0; i < 3; i++)
        out[i] = a->m[i][0] * p.x + a->m[i][1] * p.y + a->m[i][2] * p.z + a->m[i][3];
    return (struct sph_vec){out[0], out[1], out[2]};
}

/* First scale, then turn, then move. */
static inline struct sph_affine sph_affine_of(struct sph_vec scale, struct sph_turn q,
                                              struct sph_vec move) {
    double w = q.w, x = q.x, y = q.y, z = q.z;
    double s[3] = {scale.x, scale.y, scale.z};
    struct sph_affine a = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            a.m[i][k] *= s[k];
    a.m[0][3] = move.x, a.m[1][3] = move.y, a.m[2][3] = move.z;
    return a;
}

/* First b, then a. */
static inline struct sph_affine sph_affine_after(const struct sph_affine *a,
                                                 const struct sph_affine *b) {
    struct sph_affine out;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            out.m[i][k] = a->m[i][0] * b->m[0][k] + a->m[i][1] * b->m[1][k] +
                          a->m[i][2] * b->m[2][k] + (k == 3 ? a->m[i][3] : 0);
    return out;
}

/* The normal of a surface that is mapped, of any length: by the cofactors, which turn over with a
 * mirroring map as the surface does. */
static inline struct sph_vec sph_affine_normal(const struct sph_affine *a, struct sph_vec n) {
    double out[3];
    for (int i = 0; i < 3; i++) {
        const double *p = a->m[(i + 1) % 3], *q = a->m[(i + 2) % 3];
        out[i] = (p[1] * q[2] - p[2] * q[1]) * n.x + (p[2] * q[0] - p[0] * q[2]) * n.y +
                 (p[0] * q[1] - p[1] * q[0]) * n.z;
    }
    return (struct sph_vec){out[0], out[1], out[2]};
}

/* What it multiplies all lengths by; 0 if it does not do so by one number. */
double sph_affine_scale(const struct sph_affine *a);

#endif
