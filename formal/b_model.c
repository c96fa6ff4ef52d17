/* b_model.c - the model's operations stay within their types, for all inputs of a profile
 * SPDX-License-Identifier: Apache-2.0
 *
 * CBMC turns a FUNCTION into a formula, with one check before each operation that might leave its
 * type: a signed sum or product, a shift, a division, a conversion (explicit ones too), an index, a
 * loop of more passes than are unrolled. Where an operand is what another function made, what is
 * assumed of it here is asserted there, or its header shows it. What is asserted besides are the
 * widths that headers tell.
 */
// NOLINTBEGIN(bugprone-suspicious-include): static functions too
#include "math/arith.c"
#include "prim/facet.c"
#include "shade/colour.c"
#include "shade/refract.c"
#include "trace/bih.c"
#include "trace/filter.c"
#include "shade/material.c"
// NOLINTEND(bugprone-suspicious-include)

#ifndef W
#define W 24
#endif
#define WD (W + 1)

enum { FAR = 40 }; /* more than any shift of a plane's product */
static const struct sph_profile profile = {.w = W, .wd = WD, .pq = W + 4, .ng = 2, .fw = 14};

void __CPROVER_assume(_Bool what);
void __CPROVER_assert(_Bool what, const char *text);
#define ASSUME(what) __CPROVER_assume(what)
#ifndef REACH
#define ASSERT(what) __CPROVER_assert(what, #what)
#define END
#else /* whether anything is left of what is assumed: then this one fails */
#define ASSERT(what) (void)(what)
#define END __CPROVER_assert(0, "an end is reached")
#endif

static int is_signed(int64_t v, int bits) {
    return v >= -(1ll << (bits - 1)) && v < 1ll << (bits - 1);
}
static int is_unsigned(sph_u128 v, int bits) {
    return v >> bits == 0;
}
static int are_signed(const int64_t v[3], int bits) {
    return is_signed(v[0], bits) && is_signed(v[1], bits) && is_signed(v[2], bits);
}

/* ---- math ---- */

void root(sph_u128 x, int bits) {
    int inexact;
    ASSUME(is_unsigned(x, 2 * W + 2 * WD) && bits >= 0 && bits < W + WD);
    uint64_t r = sph_isqrt_bits(x, bits, &inexact);
    ASSERT(is_unsigned(r, W + WD));
    END;
}

void quotient(uint64_t key, uint64_t a) {
    ASSUME(key && is_unsigned(key, W + WD + 2) && a && is_unsigned(a, 2 * WD));
    struct sph_quotient q = sph_quotient(key, W + WD + 2, a, 2 * WD, profile.pq);
    ASSERT(is_unsigned(q.mant, profile.pq) && q.mant >> (profile.pq - 2));
    END;
}

/* ---- filter, planes, boxes ---- */

void filter(struct sph_ray ray, struct sph_child child, int32_t depth_max) {
    for (int i = 0; i < 3; i++)
        ASSUME(is_signed(child.ctr[i], 14) && is_signed(ray.forg[i], 14) &&
               is_signed(ray.across.q[i], 18));
    ASSUME(child.rad >= 0 && is_unsigned((uint32_t)child.rad, 14));
    ASSUME(is_signed(ray.across.p_a, 18) && is_signed(ray.across.p_b, 18));
    ASSUME(ray.axis >= 0 && ray.axis < 3);
    ASSUME(ray.across.axis_a >= 0 && ray.across.axis_b > ray.across.axis_a &&
           ray.across.axis_b < 3);
    int32_t near;
    sph_filter(&ray, &child, depth_max, &near);
    ASSERT(is_signed(near, 16));
    END;
}

static int axis_holds(const struct sph_bih_axis *x) {
    return is_unsigned(x->mant, 18) && x->shift > -FAR && x->shift < FAR;
}

void planes(struct sph_ray ray) {
    struct sph_bih_ray bih;
    ASSUME(are_signed(ray.org, W) && are_signed(ray.dir, WD) && is_unsigned(ray.a, 2 * WD));
    for (int i = 0; i < 3; i++)
        ASSUME((int64_t)ray.a >= ray.dir[i] * ray.dir[i]);
    sph_bih_setup(&profile, &ray, &bih);
    for (int i = 0; i < 3; i++)
        ASSERT(axis_holds(&bih.axis[i]));
    ASSERT(bih.limit <= SPH_BIH_NO_BOUND);
    END;
}

static void set_up(struct sph_bih_ray *bih) {
    bih->v_shift = at_least_0(W + 2 - SPH_BIH_V);
    bih->t_shift = at_least_0(W + WD + 2 - SPH_BIH_T);
    for (int i = 0; i < 3; i++)
        ASSUME(axis_holds(&bih->axis[i]));
}

void plane(struct sph_bih_ray bih, struct sph_ray ray, int axis, int64_t clip, int below) {
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    set_up(&bih);
    ASSUME(axis >= 0 && axis < 3 && is_signed(clip, W + 2) && (below == 0 || below == 1));
    ASSUME(are_signed(ray.org, W));
    sph_bih_cut(&bih, &ray, axis, clip, below, &span);
    ASSERT(span.lo <= SPH_BIH_NO_BOUND && span.hi <= SPH_BIH_NO_BOUND);
    END;
}

void box(struct sph_bih_ray bih, struct sph_ray ray, struct sph_box_frame frame,
         struct sph_box_planes planes, int32_t depth_max) {
    struct sph_box_axis axes[3];
    set_up(&bih);
    ASSUME(are_signed(ray.org, W));
    for (int i = 0; i < 3; i++) {
        ASSUME(is_signed(frame.org[i], W > 14 ? W : 14));
        ASSUME(frame.step[i] >= sph_frame_step_shift(&profile) &&
               frame.step[i] <= sph_frame_step_shift(&profile) + 15);
        ASSUME(planes.lo[i] < SPH_BOX_CODES && planes.hi[i] < SPH_BOX_CODES);
    }
    sph_box_axes(&profile, &bih, &ray, &frame, axes);
    for (int i = 0; i < 3; i++) {
        ASSERT(is_signed(axes[i].enter, SPH_BOX_CROSS + 9));
        ASSERT(is_signed(axes[i].leave, SPH_BOX_CROSS + 9));
        ASSERT(is_unsigned((uint32_t)axes[i].step, SPH_BOX_CROSS));
    }
    int32_t near;
    ray.stages = NULL;
    sph_box_meets(axes, &ray, &planes, depth_max, &near);
    ASSERT(near >= 0);
    END;
}

/* ---- facets: of a hit's determinants is assumed what facet.h shows ---- */

void key(struct sph_ray ray, struct sph_facet_result r) {
    uint64_t divisions = 0;
    ASSUME(r.num > 0 && is_unsigned((sph_u128)r.num, 3 * W + 1));
    ASSUME(r.det > 0 && is_unsigned(r.det, 2 * W + WD + 1));
    ASSUME(is_unsigned(r.add, WD - 1) && is_unsigned(ray.a, 2 * WD));
    ASSUME((sph_u128)r.num * ray.a <= r.det << (W + WD + 1)); /* a t is at most that */
    ASSERT(is_unsigned(sph_facet_key(&ray, &r, &divisions), W + WD + 2));
    END;
}

/* ---- shares, refraction ---- */

void shares(struct sph_shares s, struct sph_shading shading, int depth, uint32_t weight,
            uint32_t kr, uint32_t kt, uint32_t ambient, uint32_t lights, uint32_t red,
            uint32_t green, uint32_t blue) {
    const uint32_t colour[3] = {red, green, blue};
    ASSUME(weight <= 65536 && kr <= 256 && kt <= 256 && shading.ka <= 256 && shading.kd <= 256);
    ASSUME(is_unsigned(ambient, 17) && is_unsigned(lights, 17) && depth >= 0);
    for (int i = 0; i < 3; i++) {
        ASSUME(is_unsigned(colour[i], 16));
        for (int f = 0; f < SPH_FRAMES; f++)
            ASSUME(is_unsigned(s.sum[f][i], 16));
    }
    ASSERT(is_unsigned(sph_shading_light(&shading, ambient, lights), 17));
    uint32_t own = sph_share(weight, sph_shading_own(&shading, kr, kt));
    ASSERT(own <= weight);
    sph_shares_add(&s, depth, weight, own, colour);
    for (int i = 0; i < 3; i++)
        for (int f = 0; f < SPH_FRAMES; f++)
            ASSERT(is_unsigned(s.sum[f][i], 16));
    END;
}

/* Vectors as shifted() makes them: with no shift left, as long as they can be. */
void refraction(struct sph_ray ray, struct sph_surface s, uint32_t from, uint32_t to) {
    ASSUME(is_unsigned(from, 12) && is_unsigned(to, 12));
    ASSUME(are_signed(ray.dir, WD) && is_unsigned(ray.a, 2 * WD) && ray.unit.h == 0);
    ASSUME(are_signed(s.normal, WD) && is_unsigned(s.nn, 2 * WD) && s.unit.h == 0);
    sph_refract_disc(&ray, &s, from, to);
    END;
}
