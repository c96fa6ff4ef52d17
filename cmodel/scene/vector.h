/* vector.h - arithmetic of points and directions of a scene, in doubles
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VECTOR_H
#define SPH_VECTOR_H

#include <math.h>

#include "scene/nff_lex.h"
#include "scene/scene.h"

static inline struct sph_vec sph_vec_sub(struct sph_vec a, struct sph_vec b) {
    return (struct sph_vec){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* a + times b. */
static inline struct sph_vec sph_vec_add(struct sph_vec a, struct sph_vec b, double times) {
    return (struct sph_vec){a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}

static inline struct sph_vec sph_vec_cross(struct sph_vec a, struct sph_vec b) {
    return (struct sph_vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double sph_vec_dot(struct sph_vec a, struct sph_vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* m times v: its coordinates in a frame whose axes are the rows of m. */
static inline void sph_vec_turn(const double m[9], struct sph_vec v, double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = m[3 * i] * v.x + m[3 * i + 1] * v.y + m[3 * i + 2] * v.z;
}

/* Without overflow or underflow on the way. */
static inline double sph_vec_length(struct sph_vec v) {
    return hypot(hypot(v.x, v.y), v.z);
}

/* The same direction with length 1; no numbers of a vector without length. */
static inline struct sph_vec sph_vec_unit(struct sph_vec v) {
    double length = sph_vec_length(v);
    return (struct sph_vec){v.x / length, v.y / length, v.z / length};
}

/* Whether all its numbers may stand in a file. */
static inline int sph_vec_small(struct sph_vec v) {
    return fabs(v.x) <= SPH_NUMBER_MAX && fabs(v.y) <= SPH_NUMBER_MAX &&
           fabs(v.z) <= SPH_NUMBER_MAX; /* not if it is no number */
}

/* Whether a triangle has normals at its corners: none of them is zero. */
static inline int sph_smooth_given(const struct sph_vec n[3]) {
    return sph_vec_length(n[0]) > 0 && sph_vec_length(n[1]) > 0 && sph_vec_length(n[2]) > 0;
}

/* The axis that s of a plane with normal n follows if nothing is said: x, or z if that is nearer to
 * lying in the plane. */
static inline struct sph_vec sph_plane_axis(struct sph_vec n) {
    return fabs(n.x) <= fabs(n.z) ? (struct sph_vec){1, 0, 0} : (struct sph_vec){0, 0, 1};
}

#endif
