/* coords.c - see coords.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/coords.h"

#include "machine/machine.h"
#include "math/fx.h"
#include "texture/longitude.h"

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
