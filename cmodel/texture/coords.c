/* coords.c - see coords.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/coords.h"

#include "machine/machine.h"
#include "math/fx.h"

/* ---- longitude ---- */

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

enum { COMPONENT = SPH_MAP_S_Y_LSB - SPH_MAP_S_X_LSB };

/* The low SPH_ST_BITS bits, two's complement. */
static int64_t wrapped(uint64_t x) {
    return (int64_t)(x << (64 - SPH_ST_BITS)) >> (64 - SPH_ST_BITS);
}

/* One coordinate: lsb is that of s_x or t_x. */
static int64_t linear(const uint32_t *map, int lsb, const int64_t guarded[3]) {
    int e_lsb = lsb + SPH_MAP_S_E_LSB - SPH_MAP_S_X_LSB;
    int at_lsb = lsb + SPH_MAP_S_0_LSB - SPH_MAP_S_X_LSB;
    int e = sph_field_signed(map, e_lsb, SPH_MAP_S_E_BITS);
    uint64_t at = sph_field(map, at_lsb, 32);
    at |= (uint64_t)sph_field(map, at_lsb + 32, SPH_MAP_S_0_BITS - 32) << 32;
    int64_t dot = 0; /* s46 */
    for (int i = 0; i < 3; i++)
        dot += sph_field_signed(map, lsb + COMPONENT * i, SPH_MAP_S_X_BITS) * guarded[i];
    return wrapped(at + (e < 0 ? (uint64_t)dot << -e : (uint64_t)sph_round(dot, e)));
}

struct sph_st sph_coords_facet(const uint32_t *map, const int64_t guarded[3]) {
    return (struct sph_st){
        {linear(map, SPH_MAP_S_X_LSB, guarded), linear(map, SPH_MAP_T_X_LSB, guarded)}};
}

struct sph_st sph_coords_sphere(const uint32_t *map, const int32_t unit[3], int far) {
    int32_t v[3]; /* s1.16 */
    for (int i = 0; i < 3; i++) {
        int64_t dot = 0; /* s2.31 */
        for (int j = 0; j < 3; j++)
            dot += (int64_t)sph_field_signed(
                       map, SPH_MAP_TURN_LSB + SPH_MAP_TURN_BITS * (3 * i + j), SPH_MAP_TURN_BITS) *
                   unit[j];
        v[i] = (int32_t)sph_round(far ? -dot : dot, 15);
    }
    struct sph_longitude at = sph_longitude(v);
    int64_t scale_s = sph_field_signed(map, SPH_MAP_SCALE_S_LSB, SPH_MAP_SCALE_S_BITS); /* s7.8 */
    int64_t scale_t = sph_field_signed(map, SPH_MAP_SCALE_T_LSB, SPH_MAP_SCALE_T_BITS);
    int64_t plus_s = sph_field_signed(map, SPH_MAP_PLUS_S_LSB, SPH_MAP_PLUS_S_BITS); /* s3.12 */
    int64_t plus_t = sph_field_signed(map, SPH_MAP_PLUS_T_LSB, SPH_MAP_PLUS_T_BITS);
    return (struct sph_st){{plus_s * (1 << 8) + sph_round(scale_s * (int64_t)at.around, 6),
                            plus_t * (1 << 8) + sph_round(scale_t * (int64_t)at.down, 5)}};
}

struct sph_st sph_coords(const uint32_t *map, const struct sph_textured *where) {
    if (sph_field(map, SPH_MAP_KIND_LSB, 1)) return sph_coords_sphere(map, where->unit, where->far);
    return sph_coords_facet(map, where->guarded);
}
