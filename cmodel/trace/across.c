/* across.c - see across.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/across.h"

#include "machine/layout.h"
#include "math/fx.h"
#include "math/rsqrt.h"

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
