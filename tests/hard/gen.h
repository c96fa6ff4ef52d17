/* gen.h - what the generators of hard cases share
 * SPDX-License-Identifier: Apache-2.0
 *
 * Only operations that round the same on every machine: + - * / and square roots.
 */
#ifndef HARD_GEN_H
#define HARD_GEN_H

#include "hard.h"
#include "vectors.h"

/* Coordinates are -half .. half-1, radii 0 .. 2*half-1. */
static inline int64_t gen_half(const struct sph_profile *p) {
    return 1ll << (p->w - 1);
}

/* 1 in n. */
static inline int gen_one_in(struct sph_rng *rng, uint64_t n) {
    return sph_rng_next(rng) % n == 0;
}

static inline int64_t gen_sign(struct sph_rng *rng) {
    return sph_rng_next(rng) & 1 ? 1 : -1;
}

/* 1 .. 2^bits-1, every length as often. */
static inline int64_t gen_log(struct sph_rng *rng, int bits) {
    int64_t top = 1ll << vec_pick(rng, 0, bits - 1);
    return top + vec_pick(rng, 0, top - 1);
}

/* x limited to the coordinates of the profile. */
static inline int64_t gen_clamp(const struct sph_profile *p, int64_t x) {
    int64_t half = gen_half(p);
    return x < -half ? -half : x >= half ? half - 1 : x;
}

static inline int gen_on_grid(const struct sph_profile *p, const int64_t v[3]) {
    int64_t half = gen_half(p);
    for (int i = 0; i < 3; i++)
        if (v[i] < -half || v[i] >= half) return 0;
    return 1;
}

/* A case with a primary ray that may start inside, and one sphere, all zero. */
void gen_start(struct hard_case *c);

void gen_point(struct sph_rng *rng, const struct sph_profile *p, int64_t v[3]);

/* Direction from the origin of the case to a point: the longest component fills WD bits, or a
 * random length of at least `least` bits. */
void gen_aim(struct sph_rng *rng, const struct sph_profile *p, const double to[3], int least,
             struct hard_case *c);

/* Turns the ray into one to a light; 0 if the light is not on the grid. */
int gen_shadow(const struct sph_profile *p, const int64_t light[3], struct hard_case *c);

/* Integer vectors u, v, w of the same whole length, at right angles to one another; returns it.
 * Numbers of the quaternion that makes them are at most `most`. */
int64_t gen_frame(struct sph_rng *rng, int64_t most, int64_t u[3], int64_t v[3], int64_t w[3]);

/* A sphere whose surface passes exactly through `at`: its centre on a whole frame vector. */
void gen_through(struct sph_rng *rng, const struct sph_profile *p, const int64_t at[3],
                 struct sph_leaf *s);

/* Makes a case of n facets of a kind, all zero. */
void gen_facets(struct hard_case *c, int kind, int n);

void gen_corners(struct sph_facet_leaf *f, const int64_t a[3], const int64_t b[3],
                 const int64_t c[3]);

/* To a point exactly, at t = 1 over a whole number, and `through` says so; now and then a light
 * there, or in front of it, or a component of the direction is one off. */
void gen_towards(struct sph_rng *rng, const struct sph_profile *p, const int64_t at[3],
                 struct hard_case *c);

/* A random unit vector. */
void gen_unit(struct sph_rng *rng, double v[3]);

/* The makers of the table, by topic. */
typedef void gen_maker(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c);
gen_maker gen_random, gen_inside, gen_axis, gen_corner, gen_rad0, gen_dir0, gen_tiny_far,
    gen_huge_near, gen_graze0, gen_graze1, gen_surf_out, gen_surf_in, gen_own, gen_shadows,
    gen_pair, gen_concentric, gen_root, gen_quotient, gen_surface, gen_filter, gen_nested, gen_edge,
    gen_vertex, gen_sliver, gen_flat, gen_skim, gen_plane, gen_planes, gen_critical, gen_seam,
    gen_texel, gen_level, gen_clip, gen_walk, gen_unit_vector, gen_coplane, gen_pixel, gen_ridge,
    gen_meet, gen_eye, gen_glass;

#endif
