/* longitude.c - see longitude.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/longitude.h"

#include "math/fx.h"

enum {
    STEPS = 18,
    GUARD = 6,      /* bits below s1.16 */
    TURN = 1 << 24, /* of angles */
    GAIN = 107922   /* u1.16, what the steps multiply lengths by: product of sqrt(1 + 4^-i) */
};

/* atan(2^-i) in 2^-24 turns */
static const int32_t angle[STEPS] = {2097152, 1238021, 654136, 332050, 166669, 83416,
                                     41718,   20860,   10430,  5215,   2608,   1304,
                                     652,     326,     163,    81,     41,     20};

/* Turns (x, y), x >= 0, onto the x axis: the angle it had, within a quarter turn; *x is then GAIN
 * times the length. */
static int32_t turn(int32_t *x, int32_t y) {
    int32_t sum = 0;
    for (int i = 0; i < STEPS; i++) {
        int32_t dx = y >> i, dy = *x >> i;
        if (y >= 0) {
            *x += dx;
            y -= dy;
            sum += angle[i];
        } else {
            *x -= dx;
            y += dy;
            sum -= angle[i];
        }
    }
    return sum;
}

struct sph_longitude sph_longitude(const int32_t v[3]) {
    int back = v[2] < 0;
    int32_t x = v[0] * (1 << GUARD), z = v[2] * (1 << GUARD);
    if (back) x = -x, z = -z;
    int32_t around = back ? 0 : TURN / 2, far = z;
    if (x || z) around += turn(&far, x);
    int32_t y = (int32_t)sph_round((int64_t)v[1] * GAIN, 16 - GUARD);
    int32_t down = TURN / 4;
    if (far || y) down -= turn(&far, y);
    down = down < 0 ? 0 : down > TURN / 2 ? TURN / 2 : down;
    return (struct sph_longitude){(uint32_t)sph_round(around, 6) & ((1u << 18) - 1),
                                  (uint32_t)sph_round(down, 6)};
}
