/* check_texture.c - coordinates, texels and levels of images; see check.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * The naive model of texels is of this file alone: the definitions of docs/design/textures.md.
 */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "naive/texture.h"
#include "texture/coords.h"
#include "texture/texel.h"
#include "texture/lod.h"

static int64_t floor_of(int64_t x, int64_t by) {
    return x / by - (x % by < 0);
}

/* ---- longitude ---- */

/* Steps of 2^-18 turns between two angles, the shorter way. */
static double apart(long double a, long double b) {
    long double off = fabsl(a - b);
    return (double)(off > 0x1p17L ? 0x1p18L - off : off);
}

void check_around(struct job *j) {
    const int64_t *c = j->c->v;
    const int32_t v[3] = {(int32_t)c[0], (int32_t)c[1], (int32_t)c[2]};
    struct sph_longitude r = sph_longitude(v), same = sph_naive_longitude(c);
    struct hard_column *column = j->t->column;
    const long double steps = 0x1p18L / (2 * acosl(-1.0L));
    long double rho = hypotl((long double)v[0], (long double)v[2]);
    long double length = hypotl(rho, (long double)v[1]), around = 0x1p17L, down = 0x1p16L;
    j->t->naive++;
    if (r.around != same.around || r.down != same.down) job_wrong(j, HARD_NAIVE, "longitude");
    if (!length) return;
    j->t->hits++;
    if (rho > 0) around += steps * atan2l((long double)v[0], (long double)v[2]);
    down -= steps * atan2l((long double)v[1], rho);
    double off = apart((long double)r.around, around) * (double)(rho / length);
    double below = fabs((double)((long double)r.down - down));
    if (off >= 1 || below >= 1) job_wrong(j, HARD_TEXTURE, "longitude or latitude");
    column[HARD_OURS].worst = fmax(column[HARD_OURS].worst, fmax(off, below));
    float f32 = 0x1p17f + (float)steps * atan2f((float)v[0], (float)v[2]);
    double f64 = 0x1p17 + (double)steps * atan2((double)v[0], (double)v[2]);
    off = rho > 0 ? apart((long double)f32, around) * (double)(rho / length) : 0;
    column[SPH_F32_TEXTBOOK].worst = fmax(column[SPH_F32_TEXTBOOK].worst, off);
    off = rho > 0 ? apart((long double)f64, around) * (double)(rho / length) : 0;
    column[SPH_F64_TEXTBOOK].worst = fmax(column[SPH_F64_TEXTBOOK].worst, off);
}

/* ---- texels ---- */

/* Texel i of n, repeated or at the edge. */
static uint32_t placed(int64_t i, int64_t n, int clamp) {
    if (clamp) return (uint32_t)(i < 0 ? 0 : i >= n ? n - 1 : i);
    return (uint32_t)(i - n * floor_of(i, n));
}

static uint32_t channel(uint32_t texel, int c) {
    return texel >> 8 * c & 255;
}

static uint32_t nearest_float(const struct hard_case *c, int full) {
    double one = ldexp(1, SPH_ST_FRACTION), at = (double)c->texel.at / one;
    float low = (float)c->texel.at / (float)one;
    int64_t i = full ? (int64_t)floor((at - floor(at)) * c->texel.size)
                     : (int64_t)floorf((low - floorf(low)) * (float)c->texel.size);
    return (uint32_t)(i >= c->texel.size ? c->texel.size - 1 : i);
}

void check_texels(struct job *j) {
    const struct hard_case *c = j->c;
    const int64_t one = 1 << SPH_ST_FRACTION, size = c->texel.size;
    int clamp = c->texel.clamp;
    int64_t at = clamp ? c->texel.at < 0      ? 0
                         : c->texel.at >= one ? one - 1
                                              : c->texel.at
                       : c->texel.at - one * floor_of(c->texel.at, one);
    int64_t from = 256 * at * size - 128 * one; /* of the middle of texel 0, in 2^-28 */
    int64_t first = floor_of(from, 256 * one), weight = floor_of(from - 256 * one * first, one);
    struct sph_axis axis = sph_axis_at(c->texel.at, c->texel.size, clamp);
    j->t->hits++;
    if (axis.nearest != at * size / one) job_wrong(j, HARD_TEXTURE, "nearest texel");
    if (axis.texel[0] != placed(first, size, clamp) ||
        axis.texel[1] != placed(first + 1, size, clamp) || axis.weight != weight)
        job_wrong(j, HARD_TEXTURE, "texels on either side, or their weight");
    if (!clamp) {
        j->t->column[SPH_F32_TEXTBOOK].hit += nearest_float(c, 0) != axis.nearest;
        j->t->column[SPH_F64_TEXTBOOK].hit += nearest_float(c, 1) != axis.nearest;
    }
    uint32_t near[4], far[4], wx[2] = {256 - c->texel.wx, c->texel.wx};
    uint32_t wy[2] = {256 - c->texel.wy, c->texel.wy}, level = c->texel.between;
    sph_filter_bilinear(c->texel.near, c->texel.wx, c->texel.wy, near);
    sph_filter_bilinear(c->texel.far, c->texel.wx, c->texel.wy, far);
    uint32_t texel = sph_filter_levels(near, far, level);
    for (int i = 0; i < 4; i++) {
        uint32_t a = 128, b = 128; /* half up */
        for (int k = 0; k < 4; k++) {
            a += channel(c->texel.near[k], i) * wx[k & 1] * wy[k >> 1];
            b += channel(c->texel.far[k], i) * wx[k & 1] * wy[k >> 1];
        }
        uint32_t both = (a >> 8) * (256 - level) + (b >> 8) * level;
        if (near[i] != a >> 8 || far[i] != b >> 8 || channel(texel, i) != (both + 32768) >> 16)
            job_wrong(j, HARD_TEXTURE, "weighted mean");
    }
}

/* ---- levels ---- */

void check_levels(struct job *j) {
    uint32_t path = j->c->level.path;
    int32_t base = j->c->level.base;
    int levels = j->c->level.levels;
    int64_t got = sph_lod(path, base, levels), last = (levels - 1) * 256, lod = 0;
    j->t->naive++;
    if (path) lod = sph_naive_log2(path) - 1024 - base;
    if (got != (lod < 0 ? 0 : lod > last ? last : lod)) job_wrong(j, HARD_NAIVE, "level");
    if (path < UINT32_MAX && sph_lod(path + 1, base, levels) < got)
        job_wrong(j, HARD_TEXTURE, "a longer path has a lower level");
    if (!path) return;
    j->t->hits++;
    long double exact = 256 * log2l((long double)path / 16) - base;
    double most = (double)last, want = fmin(fmax((double)exact, 0), most);
    double f32 = 256 * (double)log2f((float)path / 16) - base;
    double f64 = 256 * log2((double)path / 16) - base;
    struct hard_column *column = j->t->column;
    if (fabs((double)got - want) >= 0.0048 * 256) job_wrong(j, HARD_TEXTURE, "level");
    column[HARD_OURS].worst = fmax(column[HARD_OURS].worst, fabs((double)got - want));
    f32 = fabs(fmin(fmax(f32, 0), most) - want);
    f64 = fabs(fmin(fmax(f64, 0), most) - want);
    column[SPH_F32_TEXTBOOK].worst = fmax(column[SPH_F32_TEXTBOOK].worst, f32);
    column[SPH_F64_TEXTBOOK].worst = fmax(column[SPH_F64_TEXTBOOK].worst, f64);
}
