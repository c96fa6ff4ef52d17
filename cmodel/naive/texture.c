/* texture.c - see texture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "naive/texture.h"

#include <math.h>

#include "naive/math.h"

static const uint32_t white = 0xffffffff;

static int on(const struct sph_machine *m, int effect) {
    return m->regs[SPH_REG_EFFECTS] & 1 << effect ? 1 : 0;
}

static int64_t floor_of(int64_t x, int64_t by) {
    return x / by - (x % by < 0);
}

int64_t sph_naive_log2(uint64_t x) {
    int top = ilogbl((long double)x);
    long double nine = floorl(ldexpl((long double)x, 8 - top) + 0.5L);
    return 256ll * top + llroundl(256 * log2l(nine / 256));
}

void sph_naive_path_add(const struct sph_machine *m, const struct sph_ray *ray, uint64_t key,
                        struct sph_naive_path *path) {
    const struct sph_profile *p = sph_machine_profile(m);
    mpz_t x;
    int h;
    if (path->length && path->bend) { /* 2^k + 4 path / radius, each term a power of two */
        int64_t curved = floor_of(sph_naive_log2(path->length) - 128ll * path->bend, 256);
        int sum = ilogb(ldexp(1, path->spread) + ldexp(1, (int)curved));
        path->spread = sum < 12 ? sum : 12;
    }
    mpz_init_set_ui(x, key);
    mpz_mul_ui(x, x, sph_naive_inverse_length(ray->dir, p->wd, &h));
    sph_naive_round(x, p->wd + 12 - h - path->spread);
    mpz_add_ui(x, x, path->length);
    path->length =
        mpz_sizeinbase(x, 2) > (size_t)p->w + 8 ? (1ull << (p->w + 8)) - 1 : mpz_get_ui(x);
    mpz_clear(x);
}

/* ---- coordinates, s19.20 ---- */

/* One rotation of 18 steps: the angle, in 2^-24 turns; *x grows to the length. */
static int64_t rotated(int64_t *x, int64_t y) {
    int64_t sum = 0;
    for (int i = 0; i < 18; i++) {
        int64_t sign = y >= 0 ? 1 : -1, dx = floor_of(y, 1ll << i), dy = floor_of(*x, 1ll << i);
        *x += sign * dx;
        y -= sign * dy;
        sum += sign * llround(ldexp(atan(ldexp(1, -i)), 24) / (2 * acos(-1)));
    }
    return sum;
}

struct sph_longitude sph_naive_longitude(const int64_t v[3]) {
    int64_t sign = v[2] < 0 ? -1 : 1, z = 64 * sign * v[2], x = 64 * sign * v[0], turn = 1 << 24;
    int64_t around = v[2] < 0 ? 0 : turn / 2, down = turn / 4;
    int64_t y = floor_of(v[1] * 107922 + 512, 1024); /* 107922: what 18 steps multiply by */
    if (x || z) around += rotated(&z, x);
    if (z || y) down -= rotated(&z, y);
    down = down < 0 ? 0 : down > turn / 2 ? turn / 2 : down;
    around = floor_of(around + 32, 64) & ((1 << 18) - 1);
    return (struct sph_longitude){(uint32_t)around, (uint32_t)floor_of(down + 32, 64)};
}

/* s or t of a facet: the dot product of the gradient and the point, and where it begins. The fields
 * of t stand 100 bits above those of s. */
static int64_t linear(const uint32_t *map, int lsb, const int64_t guarded[3]) {
    mpz_t sum, x;
    mpz_inits(sum, x, NULL);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(x, sph_field_signed(map, lsb + 18 * i, 18));
        mpz_mul_si(x, x, guarded[i]);
        mpz_add(sum, sum, x);
    }
    sph_naive_round(sum, sph_field_signed(map, lsb + 54, 6));
    mpz_set_si(x, sph_field_signed(map, lsb + 92, 8));
    mpz_mul_2exp(x, x, 32);
    mpz_add(sum, sum, x);
    mpz_add_ui(sum, sum, sph_field(map, lsb + 60, 32));
    mpz_fdiv_r_2exp(sum, sum, 40);
    int64_t at = (int64_t)mpz_get_ui(sum), half = 1ll << 39;
    mpz_clears(sum, x, NULL);
    return at < half ? at : at - 2 * half;
}

static void coordinates(const uint32_t *map, const struct sph_naive_found *f,
                        const struct sph_naive_point *s, int64_t at[2]) {
    int64_t v[3];
    if (!sph_field(map, 0, 1)) {
        at[0] = linear(map, 48, s->guarded);
        at[1] = linear(map, 148, s->guarded);
        return;
    }
    for (int i = 0; i < 3; i++) {
        v[i] = 0;
        for (int j = 0; j < 3; j++)
            v[i] += sph_field_signed(map, 48 + 16 * (3 * i + j), 16) * s->unit[j];
        v[i] = sph_naive_round64(f->how.far ? -v[i] : v[i], 15);
    }
    struct sph_longitude l = sph_naive_longitude(v);
    at[0] = sph_field_signed(map, 224, 16) * 256ll +
            sph_naive_round64(sph_field_signed(map, 192, 16) * (int64_t)l.around, 6);
    at[1] = sph_field_signed(map, 240, 16) * 256ll +
            sph_naive_round64(sph_field_signed(map, 208, 16) * (int64_t)l.down, 5);
}

/* ---- texels ---- */

struct image {
    const struct sph_machine *m;
    const uint32_t *header;
    uint32_t line;
    int clamp[2];
    int64_t at[2];
    uint32_t *seen;
};

static int64_t side(const struct image *im, int axis, int level) {
    int64_t n = 1 + (int64_t)sph_field(im->header, 12 * axis, 12);
    for (int i = 0; i < level; i++)
        n /= 2;
    return n ? n : 1;
}

/* Texel i of n, repeated or at the edge. */
static int64_t placed(int64_t i, int64_t n, int clamp) {
    if (clamp) return i < 0 ? 0 : i >= n ? n - 1 : i;
    return i - n * floor_of(i, n);
}

/* The coordinate within one repeat, in 2^-20. */
static int64_t within(const struct image *im, int axis) {
    const int64_t one = 1 << 20;
    int64_t at = im->at[axis];
    if (im->clamp[axis]) return at < 0 ? 0 : at >= one ? one - 1 : at;
    return at - one * floor_of(at, one);
}

static uint32_t fetch(const struct image *im, int level, int64_t x, int64_t y) {
    int64_t tile = y / 2 * ((side(im, 0, level) + 3) / 4) + x / 4;
    int64_t line = im->line + 1 + tile, word = y % 2 * 4 + x % 4;
    if (level) line += sph_field(im->header, 28 + 20 * (level - 1), 20);
    *im->seen =
        *im->seen / (1 << 20) * (1 << 20) + (uint32_t)((*im->seen + line * 8 + word) % (1 << 20));
    return line < im->m->regs[SPH_REG_MEM_LINES] ? im->m->mem[line * 8 + word] : white;
}

/* The mean of the four texels around the place, u8.8 a channel. */
static void mean(const struct image *im, int level, int64_t out[4]) {
    int64_t first[2], weight[2][2];
    for (int i = 0; i < 2; i++) { /* from the middle of texel 0, in 2^-8 */
        int64_t from = floor_of(256 * within(im, i) * side(im, i, level), 1 << 20) - 128;
        first[i] = floor_of(from, 256);
        weight[i][1] = from - 256 * first[i];
        weight[i][0] = 256 - weight[i][1];
    }
    for (int c = 0; c < 4; c++)
        out[c] = 128;
    for (int k = 0; k < 4; k++) {
        int64_t x = placed(first[0] + k % 2, side(im, 0, level), im->clamp[0]);
        int64_t y = placed(first[1] + k / 2, side(im, 1, level), im->clamp[1]);
        uint32_t texel = fetch(im, level, x, y);
        for (int c = 0; c < 4; c++)
            out[c] += (texel >> 8 * c & 255) * weight[0][k % 2] * weight[1][k / 2];
    }
    for (int c = 0; c < 4; c++)
        out[c] /= 256;
}

static uint32_t filtered(const struct image *im, int64_t lod) {
    int64_t near[4], far[4] = {0}, level = 0, weight = 0;
    uint32_t texel = 0;
    switch (im->m->regs[SPH_REG_TEX_FILTER]) {
    case 0:
        return fetch(im, 0, within(im, 0) * side(im, 0, 0) >> 20,
                     within(im, 1) * side(im, 1, 0) >> 20);
    case 2:
        level = (lod + 128) / 256;
        break;
    case 3:
        level = lod / 256, weight = lod % 256;
        break;
    default:
        break;
    }
    mean(im, (int)level, near);
    if (weight) mean(im, (int)level + 1, far);
    for (int c = 0; c < 4; c++) {
        int64_t both = near[c] * (256 - weight) + far[c] * weight;
        texel |= (uint32_t)sph_naive_round64(both, 16) << 8 * c;
    }
    return texel;
}

uint32_t sph_naive_texel(const struct sph_machine *m, const struct sph_naive_found *f,
                         const struct sph_naive_point *s, uint64_t length, uint32_t *seen) {
    int64_t lines = m->regs[SPH_REG_MEM_LINES], step = 1ll << m->regs[SPH_REG_COARSE];
    if (!on(m, SPH_EFFECT_TEXTURE) || !f->prim.tex || f->prim.tex >= lines) return white;
    const uint32_t *map = m->mem + (size_t)SPH_LINE_WORDS * f->prim.tex;
    struct image im = {.m = m,
                       .line = sph_field(map, 20, 26),
                       .clamp = {(int)sph_field(map, 2, 1), (int)sph_field(map, 3, 1)},
                       .seen = seen};
    if (im.line >= lines) return white;
    im.header = m->mem + (size_t)SPH_LINE_WORDS * im.line;
    int64_t levels = sph_field(im.header, 24, 4), lod = 0;
    if (levels < 1 || levels > 12) return white;
    if (length) lod = sph_naive_log2(length) - 1024 - sph_field_signed(map, 4, 16);
    lod = lod < 0 ? 0 : lod > 256 * (levels - 1) ? 256 * (levels - 1) : lod;
    lod = (lod + step / 2) / step * step;
    if (*seen >> 20 == SPH_LOD_NONE) *seen = (uint32_t)lod << 20 | *seen % (1 << 20);
    coordinates(map, f, s, im.at);
    return filtered(&im, lod);
}
