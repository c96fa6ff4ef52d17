/* near.c - the error of hit points, and two spheres against it; see near.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/near.h"

/* last: the last rounding, along an axis. */
static int64_t error(const struct sph_profile *p, int64_t last) {
    /* along each axis: quotient 2^(W+2-PQ), root 2^(W+1-PR), roundings 2^-(NG+1) and the last */
    int quotient = p->w + 2 - p->pq + sph_error_bits(p),
        root = p->w + 1 - p->pr + sph_error_bits(p);
    int64_t axis = (1ll << (quotient > 0 ? quotient : 0)) + last + 1;
    if (p->pr) axis += 1ll << (root > 0 ? root : 0);
    return sph_ceil_sqrt(3 * axis * axis);
}

int64_t sph_point_error(const struct sph_profile *p) {
    return error(p, 1ll << p->ng); /* 1/2 */
}

int64_t sph_facet_error(const struct sph_profile *p) {
    return error(p, 2ll << p->ng); /* 1 */
}

static int64_t square(const struct sph_ball *ball, const int32_t at[3]) {
    int64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        int64_t d = (int64_t)ball->c[i] - at[i];
        sum += d * d;
    }
    return sum;
}

int sph_ball_side(const struct sph_ball *ball, const int32_t at[3]) {
    int64_t room = (int64_t)ball->r * ball->r - square(ball, at);
    return room > 0 ? 1 : room < 0 ? -1 : 0;
}

int sph_nearness(const struct sph_ball *a, const struct sph_ball *b, const struct sph_profile *p) {
    int64_t sum = (int64_t)a->r + b->r, less = (int64_t)a->r - b->r, apart = 0;
    for (int i = 0; i < 3; i++) {
        int64_t d = (int64_t)a->c[i] - b->c[i];
        apart += d * d;
    }
    if (apart <= less * less) return SPH_NESTED;
    if (apart < sum * sum) return SPH_OVERLAP;
    if (apart == sum * sum) return SPH_TOUCH;
    int64_t unit = 1ll << sph_error_bits(p), reach = sum * unit + sph_point_error(p);
    return apart * unit * unit <= reach * reach ? SPH_NEARLY : SPH_APART;
}
