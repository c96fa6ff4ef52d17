/* test_box_frame.c - planes in a node's frame bound a ray as exact fractions do, and closely; a box
 * is met from every point of it on, by rays of all profiles and of a small one
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_box_frame; SEED=n
 */
#include "vectors.h"

#include "math/fx.h"
#include "trace/bih.h"

enum { RAYS = 40000 / VEC_SHARE, PARTS = 256, BEYOND = SPH_BIH_NO_BOUND + 1 };

static const struct sph_profile small = {"small", 8, 9, 9, 2, 8, 0};

static const struct sph_profile *profile_of(int n) {
    return n % 5 == 4 ? &small : &sph_profiles[n % 5];
}

/* A ray, and a frame of any step; most hold a point of it, k / PARTS of its direction away. */
static void choose(struct sph_rng *rng, const struct sph_profile *p, struct sph_ray *ray,
                   struct sph_box_frame *frame, int64_t *k) {
    int step = (int)vec_pick(rng, 0, 15), up = sph_frame_org_shift(p);
    int32_t end = 1 << (SPH_FRAME_ORG_X_BITS - 1);
    vec_ray(rng, p, ray);
    ray->a = 0;
    for (int i = 0; i < 3; i++)
        ray->a += (uint64_t)(ray->dir[i] * ray->dir[i]);
    *k = (int64_t)vec_unsigned(rng, p->w + 8);
    for (int i = 0; i < 3; i++) /* to where it is on the grid */
        while (llabs(ray->org[i] + ray->dir[i] * *k / PARTS) > 1ll << (p->w - 1))
            *k >>= 1;
    for (int i = 0; i < 3; i++) {
        int own = vec_pick(rng, 0, 3) ? step : (int)vec_pick(rng, 0, 15);
        int64_t at = ray->org[i] + ray->dir[i] * *k / PARTS;
        at = (at - (vec_pick(rng, 0, SPH_BOX_CODES - 1) << (own + sph_frame_step_shift(p)))) >> up;
        if (at < -end || at >= end) at = vec_signed(rng, SPH_FRAME_ORG_X_BITS);
        frame->org[i] = (int32_t)at * (1 << up);
        frame->step[i] = (uint8_t)(own + sph_frame_step_shift(p));
    }
}

/* Where the ray comes into the frame, along its way; 0 if that leaves the bits that there are. */
static int begin_of(const struct sph_profile *p, const struct sph_ray *ray,
                    const struct sph_box_frame *frame, int i, int64_t *from) {
    *from = frame->org[i] - ray->org[i];
    if (ray->dir[i] < 0) *from = -*from - ((int64_t)SPH_BOX_CODES << frame->step[i]);
    return *from >= -(2ll << p->w) && *from < 2ll << p->w;
}

static sph_i128 floor_of(sph_i128 a, sph_i128 b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/* Every plane of a frame: its word as one to enter by is not above the exact one, and as one to
 * leave by above it, or no bound. */
static void planes(void **state) {
    struct sph_rng rng = vec_seed("planes");
    long bounds = 0, open = 0;
    (void)state;
    for (int run = 0; run < RAYS; run++) {
        const struct sph_profile *p = profile_of(run);
        struct sph_ray ray;
        struct sph_box_frame frame;
        struct sph_bih_ray bih;
        struct sph_box_axis axes[3];
        int64_t k;
        choose(&rng, p, &ray, &frame, &k);
        sph_bih_setup(p, &ray, &bih);
        sph_box_axes(p, &bih, &ray, &frame, axes);
        for (int i = 0; i < 3; i++) {
            const struct sph_box_axis *x = &axes[i];
            int64_t size = ray.dir[i] < 0 ? -ray.dir[i] : ray.dir[i], step = 1ll << frame.step[i];
            int64_t from;
            if (!begin_of(p, &ray, &frame, i, &from)) continue;
            for (int n = 0; n <= SPH_BOX_CODES; n += n ? 1 + (int)vec_pick(&rng, 0, 30) : 1) {
                int64_t v = from + n * step;
                int32_t enter = x->enter + (n * x->step >> x->fine);
                int32_t leave = x->leave + ((n - 1) * (x->step + 2) >> x->fine);
                if (n < SPH_BOX_CODES && enter >= 0) assert_true(v >= 0 && (!x->flat || v > 0));
                if (n && v >= 0) assert_true(leave > 0);
                if (x->flat) continue;
                sph_i128 exact = floor_of((sph_i128)ray.a * v, (sph_i128)size << bih.t_shift);
                if (n < SPH_BOX_CODES && enter > 0) assert_true(enter <= exact);
                if (n && !x->open && leave < BEYOND) assert_true(leave > exact);
                if (x->open || exact >= BEYOND || exact < -BEYOND) continue;
                sph_i128 first = floor_of((sph_i128)ray.a * from, (sph_i128)size << bih.t_shift);
                if (first < 0) first = -first;
                int limited = first >= BEYOND;
                assert_true(limited ||
                            leave - enter <= (2 * n >> x->fine) + 8 + (int32_t)(first >> 14));
                bounds++;
            }
            open += x->open;
        }
    }
    assert_true(bounds > RAYS && open > RAYS / 10 && open < 2 * RAYS);
}

/* The planes of a child around a point of the ray: it is met, and not behind that point. */
static void boxes(void **state) {
    struct sph_rng rng = vec_seed("boxes");
    long met = 0, missed = 0;
    (void)state;
    for (int run = 0; run < RAYS; run++) {
        const struct sph_profile *p = profile_of(run);
        struct sph_ray ray;
        struct sph_box_frame frame;
        struct sph_bih_ray bih;
        struct sph_box_axis axes[3];
        struct sph_box_planes box, beside;
        int64_t k;
        int32_t near;
        choose(&rng, p, &ray, &frame, &k);
        sph_bih_setup(p, &ray, &bih);
        sph_box_axes(p, &bih, &ray, &frame, axes);
        int inside = 1, size = (int)vec_pick(&rng, 1, SPH_BOX_LO_X_BITS);
        for (int i = 0; i < 3; i++) {
            int64_t at = (ray.org[i] - frame.org[i]) * PARTS + ray.dir[i] * k;
            int64_t step = (int64_t)PARTS << frame.step[i], from;
            inside &= begin_of(p, &ray, &frame, i, &from) && at >= 0 && at <= SPH_BOX_CODES * step;
            if (!inside) break;
            int64_t cell = at / step;
            if (cell && (cell == SPH_BOX_CODES || (at % step == 0 && run & 1))) cell--;
            int64_t lo = cell - (int64_t)vec_unsigned(&rng, size);
            int64_t hi = cell + (int64_t)vec_unsigned(&rng, size);
            box.lo[i] = (uint8_t)(lo > 0 ? lo : 0);
            box.hi[i] = (uint8_t)(hi < SPH_BOX_CODES ? hi : SPH_BOX_CODES - 1);
            beside.lo[i] = (uint8_t)vec_pick(&rng, 0, SPH_BOX_CODES - 1);
            beside.hi[i] = beside.lo[i];
        }
        sph_u128 time = (sph_u128)ray.a * (sph_u128)k / PARTS >> bih.t_shift;
        if (!inside || time >= SPH_BIH_NO_BOUND) continue;
        assert_int_equal(sph_box_meets(axes, &ray, &box, sph_box_depth((uint32_t)time), &near), 1);
        assert_true(near <= sph_box_depth((uint32_t)time));
        if (near) assert_int_equal(sph_box_meets(axes, &ray, &box, near - 1, &near), 0);
        met++;
        missed += !sph_box_meets(axes, &ray, &beside, INT16_MAX, &near);
    }
    assert_true(met > RAYS / 8 && 2 * missed > met);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(planes), cmocka_unit_test(boxes)};
    return cmocka_run_group_tests_name("boxes in a frame", tests, NULL, NULL);
}
