/* setup.c - ray set-up, see ray.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/setup.h"

#include "machine/layout.h"
#include "math/fx.h"
#include "math/arith.h"

/* ---- across ---- */

struct sph_across sph_across(const int32_t u[3]) {
    int64_t mag[3];
    for (int k = 0; k < 3; k++)
        mag[k] = u[k] < 0 ? -u[k] : u[k];
    int m = mag[0] <= mag[1] && mag[0] <= mag[2] ? 0 : mag[1] <= mag[2] ? 1 : 2;
    int i = m == 0 ? 1 : 0, j = m == 2 ? 1 : 2;
    struct sph_across r = {.axis_a = i, .axis_b = j};
    /* 1 / sqrt(1 - u_m^2), shorter by what the length of u and roundings may be longer than 1 */
    uint32_t x = (uint32_t) ~(uint64_t)(mag[m] * mag[m]) >> 14; /* u0.18, above 1 - u_m^2 if +1 */
    int64_t scale = sph_rsqrt(x) - SPH_ACROSS_SHORT;            /* u1.16 */
    r.p_a = (int32_t)sph_round(scale * u[j], 15);
    r.p_b = (int32_t)sph_round(scale * u[i], 15);
    r.q[i] = (int32_t)sph_round((int64_t)u[m] * r.p_b, 16);
    r.q[j] = (int32_t)sph_round((int64_t)u[m] * r.p_a, 16);
    r.q[m] = (int32_t)sph_round(~((int64_t)u[i] * r.p_b + (int64_t)u[j] * r.p_a), 16);
    return r;
}

void sph_ray_setup(const struct sph_profile *p, struct sph_ray *ray) {
    const int64_t *d = ray->dir;
    int k = p->w - p->fw, saturated;
    ray->a = (uint64_t)d[0] * (uint64_t)d[0] + (uint64_t)d[1] * (uint64_t)d[1] +
             (uint64_t)d[2] * (uint64_t)d[2];
    ray->unit = sph_unit(d, ray->a, p->wd);
    ray->across = sph_across(ray->unit.u);
    for (int i = 0; i < 3; i++)
        ray->forg[i] = (int32_t)sph_saturate(sph_round(ray->org[i], k), p->fw, &saturated);

    uint32_t mag[3];
    for (int i = 0; i < 3; i++)
        mag[i] = (uint32_t)(ray->unit.u[i] < 0 ? -ray->unit.u[i] : ray->unit.u[i]);
    ray->axis = mag[0] >= mag[1] && mag[0] >= mag[2] ? 0 : mag[1] >= mag[2] ? 1 : 2;
    ray->negative = ray->unit.u[ray->axis] < 0;

    /* D = key * |d| / (a * 2^k), d along the axis. 1/|dir| <= (y+6) 2^(h-WD-16) and
     * |d| * 2^h * y <= (|u|+1/2) 2^WD, so D <= key (|u|+1/2) (y+6)^2/y * 2^(h-WD-32-k), and
     * (y+6)^2/y <= y + 13 for y >= 2^16: scale >= (|u|+1/2) (y+13) / 2^17, u1.15. */
    uint64_t y = (ray->unit.y >> 1) + SPH_RSQRT_ERROR + 2;
    ray->depth_scale = (uint32_t)((mag[ray->axis] + 1) * y >> 16) + 1;
    ray->depth_shift = 30 - p->fw - ray->unit.h;

    int64_t span = d[ray->axis] < 0 ? -d[ray->axis] : d[ray->axis];
    int32_t limit = sph_depth_limit(p);
    int64_t light = (span >> k) + 1;
    ray->depth_max = sph_ray_ends(ray) && light < limit ? (int32_t)light : limit;
}

int32_t sph_ray_depth(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key) {
    int32_t limit = sph_depth_limit(p);
    if (ray->depth_shift < 0) return limit;
    uint64_t top = (key >> (p->w + p->wd - 15)) + 1; /* u17, above the key's top bits */
    uint64_t depth = (top * ray->depth_scale >> ray->depth_shift) + 1;
    return depth < (uint64_t)limit ? (int32_t)depth : limit;
}
