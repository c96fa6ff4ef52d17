/* test_texel.c - texels of a coordinate, their addresses, filters, whole lookups, cache predictor
 * SPDX-License-Identifier: Apache-2.0
 */
#include "vectors.h"

#include <math.h>
#include <string.h>

#include "memory/cache.h"
#include "texture/texel.h"
#include "texture/lookup.h"
#include "texture/order.h"

static int modulo(int64_t x, int64_t n) {
    return (int)((x % n + n) % n);
}

/* What a coordinate means, told another way: texel centres at i + 1/2, 256 places a texel. */
static void check_axis(int64_t at, int size, int clamp) {
    struct sph_axis axis = sph_axis_at(at, (uint32_t)size, clamp);
    double u = (double)at / (1 << SPH_ST_FRACTION);
    if (clamp) u = fmin(fmax(u, 0), 1 - 0x1p-20);
    double place = floor((u - floor(u)) * size * 256) / 256 - 0.5;
    int first = (int)floor(place), nearest = (int)floor(place + 0.5);
    int second = first + 1;
    if (clamp) {
        first = first < 0 ? 0 : first;
        second = second >= size ? size - 1 : second;
    }
    if (axis.texel[0] != (uint32_t)modulo(first, size) ||
        axis.texel[1] != (uint32_t)modulo(second, size) ||
        axis.weight != (uint32_t)((place - floor(place)) * 256) ||
        axis.nearest != (uint32_t)nearest)
        fail_msg("%f of %d texels, clamp %d: %u %u by %u, nearest %u", u, size, clamp,
                 axis.texel[0], axis.texel[1], axis.weight, axis.nearest);
}

static void axis_texels(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("axis_texels");
    for (int size = 1; size <= 4096; size += 1 + size / 16)
        for (int clamp = 0; clamp < 2; clamp++) {
            for (int i = 0; i < 300 / VEC_SHARE; i++)
                check_axis(vec_signed(&rng, SPH_ST_BITS), size, clamp);
            for (int i = 0; i < 300 / VEC_SHARE; i++) /* around edges of texels */
                check_axis(vec_pick(&rng, -2, 2 * size) * (1 << 20) / (2 * size) +
                               vec_pick(&rng, -2, 2),
                           size, clamp);
        }
    for (int clamp = 0; clamp < 2; clamp++) /* the widest image: a step is a part of a texel */
        for (int64_t at = -2; at <= 2; at++) {
            check_axis(at, 4096, clamp);
            check_axis(at + (1 << SPH_ST_FRACTION), 4096, clamp);
        }
}

static void level_sizes(void **state) {
    (void)state;
    assert_int_equal(sph_level_size(2048, 0), 2048);
    assert_int_equal(sph_level_size(2047, 1), 1023);
    assert_int_equal(sph_level_size(2048, 11), 1);
    assert_int_equal(sph_level_size(3, 1), 1);
    assert_int_equal(sph_level_size(3, 11), 1);
}

/* Every texel has a word of its own within the level's lines, and a tile has one line. */
static void addresses(void **state) {
    (void)state;
    static const uint32_t sizes[][2] = {{1, 1}, {2, 2},   {4, 2},   {5, 3},  {1, 9},
                                        {9, 1}, {64, 64}, {37, 21}, {33, 2}, {255, 6}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        uint32_t w = sizes[i][0], h = sizes[i][1], words = 8 * sph_level_lines(w, h);
        uint8_t *used = calloc(words, 1);
        assert_non_null(used);
        for (uint32_t y = 0; y < h; y++)
            for (uint32_t x = 0; x < w; x++) {
                uint32_t word = sph_texel_word(w, x, y);
                assert_in_range(word, 0, words - 1);
                assert_int_equal(used[word]++, 0);
                assert_int_equal(word / 8, sph_texel_word(w, x & ~3u, y & ~1u) / 8);
            }
        free(used);
    }
    assert_int_equal(sph_level_lines(2048, 2048), 1 << 19);
    assert_int_equal(sph_level_lines(5, 3), 4);
}

/* Every order has a word for each texel of all levels, within its lines; tiles are the machine's.
 */
static void orders(void **state) {
    (void)state;
    static const uint32_t sizes[][2] = {{1, 1}, {64, 64}, {37, 21}, {3, 130}, {200, 5}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int order = 0; order < SPH_ORDERS; order++) {
            uint32_t w = sizes[i][0], h = sizes[i][1], levels = 1, texels = 0, first = 0;
            while (w >> levels || h >> levels)
                levels++;
            uint32_t lines = sph_order_lines(order, w, h, levels);
            uint8_t *used = calloc(lines, 8);
            assert_non_null(used);
            for (uint32_t l = 0; l < levels; l++) {
                uint32_t wl = sph_level_size(w, (int)l), hl = sph_level_size(h, (int)l);
                for (uint32_t at = 0; at < wl * hl; at++, texels++) {
                    uint32_t word = sph_order_word(order, w, h, l, at % wl, at / wl);
                    assert_in_range(word, 0, 8 * lines - 1);
                    assert_int_equal(used[word]++, 0);
                    if (order == SPH_ORDER_TILES)
                        assert_int_equal(word, 8 * first + sph_texel_word(wl, at % wl, at / wl));
                }
                first += sph_level_lines(wl, hl);
            }
            assert_in_range(lines, (texels + 7) / 8, 4 * first);
            free(used);
        }
    /* rows begin anew in a line: seven texels and eight have one */
    for (uint32_t w = 1; w <= 17; w++)
        assert_int_equal(sph_order_lines(SPH_ORDER_ROWS, w, 3, 1), 3 * ((w + 7) / 8));
    /* along a Z curve four tiles of a square stand together, then four such squares */
    assert_int_equal(sph_order_word(SPH_ORDER_MORTON, 64, 64, 0, 4, 0), 8);
    assert_int_equal(sph_order_word(SPH_ORDER_MORTON, 64, 64, 0, 0, 2), 16);
    assert_int_equal(sph_order_word(SPH_ORDER_MORTON, 64, 64, 0, 7, 3), 24 + 7);
    assert_int_equal(sph_order_word(SPH_ORDER_MORTON, 64, 64, 0, 8, 0), 32);
    assert_int_equal(sph_order_word(SPH_ORDER_ROWS, 9, 4, 0, 8, 1), 24);
}

static void constant_stays(void **state) {
    (void)state;
    for (uint32_t c = 0; c<256; c += VEC_SHARE> 1 ? 51 : 5)
        for (uint32_t wx = 0; wx < 256; wx += 3)
            for (uint32_t wy = 0; wy < 256; wy += 15) {
                const uint32_t word = c | (255 - c) << 8 | (c ^ 0x55) << 16 | 0xff000000;
                const uint32_t texel[4] = {word, word, word, word};
                uint32_t out[4];
                sph_filter_bilinear(texel, wx, wy, out);
                for (int i = 0; i < 4; i++)
                    assert_int_equal(out[i], (word >> 8 * i & 255) << 8);
                assert_int_equal(sph_filter_levels(out, out, wx), word);
            }
}

/* Against real numbers: within the two roundings, never outside the texels. */
static void filters(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("filters");
    for (int i = 0; i < 300000 / VEC_SHARE; i++) {
        uint32_t texel[2][4], out[2][4], weight[3];
        for (int k = 0; k < 8; k++)
            texel[k / 4][k % 4] = (uint32_t)vec_unsigned(&rng, 32);
        for (int k = 0; k < 3; k++)
            weight[k] = (uint32_t)vec_unsigned(&rng, 8);
        double x = weight[0] / 256.0, y = weight[1] / 256.0, z = weight[2] / 256.0;
        for (int l = 0; l < 2; l++)
            sph_filter_bilinear(texel[l], weight[0], weight[1], out[l]);
        uint32_t word = sph_filter_levels(out[0], out[1], weight[2]);
        for (int c = 0; c < 4; c++) {
            double level[2];
            for (int l = 0; l < 2; l++) {
                const uint32_t *t = texel[l];
                double a = t[0] >> 8 * c & 255, b = t[1] >> 8 * c & 255;
                double d = t[2] >> 8 * c & 255, e = t[3] >> 8 * c & 255;
                level[l] = (1 - y) * ((1 - x) * a + x * b) + y * ((1 - x) * d + x * e);
                assert_int_equal(out[l][c], (uint32_t)floor(level[l] * 256 + 0.5));
            }
            double exact = (1 - z) * out[0][c] / 256 + z * out[1][c] / 256;
            assert_int_equal(word >> 8 * c & 255, (uint32_t)floor(exact + 0.5));
            assert_true(fabs((word >> 8 * c & 255) - (1 - z) * level[0] - z * level[1]) < 0.503);
        }
    }
}

static void albedo_every_pair(void **state) {
    (void)state;
    for (uint32_t c = 0; c < 256; c++)
        for (uint32_t t = 0; t < 256; t++) {
            assert_int_equal(sph_texture_albedo(c, t), (uint32_t)lround(c * t / 255.0));
            uint32_t x = c * t + 128; /* as hardware may do it */
            assert_int_equal(sph_texture_albedo(c, t), (x + (x >> 8)) >> 8);
        }
}

/* An image of 8 x 4 texels, 4 levels, each of one colour; its mapping in line 1. */
enum { MAP = 1, IMAGE = 2, LINES = IMAGE + 1 + 4 + 1 + 1 + 1 };
static const uint32_t flat[4] = {0xff0000c0, 0xff00a000, 0xff800000, 0xff404040};

static void small_machine(struct sph_machine *m, uint32_t mem[LINES * SPH_LINE_WORDS]) {
    static const uint32_t first[4] = {0, 4, 5, 6};
    memset(m, 0, sizeof *m);
    memset(mem, 0, LINES * SPH_LINE_WORDS * sizeof *mem);
    m->mem = mem;
    m->lines = LINES;
    m->regs[SPH_REG_MEM_LINES] = LINES;
    uint32_t *map = mem + MAP * SPH_LINE_WORDS, *image = mem + IMAGE * SPH_LINE_WORDS;
    sph_field_set(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, IMAGE);
    sph_field_set(image, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS, 7);
    sph_field_set(image, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS, 3);
    sph_field_set(image, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS, 4);
    for (int l = 0; l < 4; l++) {
        if (l) sph_field_set(image, SPH_IMAGE_FIRST_LSB + 20 * (l - 1), 20, first[l]);
        for (uint32_t i = 0; i < (l ? 1u : 4u) * SPH_LINE_WORDS; i++)
            image[SPH_LINE_WORDS * (1 + first[l]) + i] = flat[l];
    }
}

static uint32_t look(const struct sph_machine *m, int filter, uint64_t path,
                     struct sph_texture_work *work) {
    struct sph_machine copy = *m;
    struct sph_textured at = {.path = path};
    copy.regs[SPH_REG_TEX_FILTER] = filter;
    *work = (struct sph_texture_work){.lod = SPH_LOD_NONE};
    return sph_lookup(&copy, MAP, &at, work);
}

static void lookups(void **state) {
    (void)state;
    static const struct {
        int filter;
        uint64_t path;
        uint32_t texel, lod, texels, words;
    } cases[] = {
        {SPH_FILTER_NEAREST, 1 << 20, 0xff0000c0, 768, 1, 24}, /* word 0 of line 3 */
        {SPH_FILTER_OFF, 1 << 20, 0xff0000c0, 768, 4, 4 * 24 + 62},
        {SPH_FILTER_LEVEL, 16 * 2, 0xff00a000, 256, 4, 4 * 56 + 14},
        {SPH_FILTER_LEVEL, 22, 0xff0000c0, 118, 4, 4 * 24 + 62},
        {SPH_FILTER_LEVEL, 23, 0xff00a000, 134, 4, 4 * 56 + 14},
        {SPH_FILTER_BETWEEN, 16 * 4, 0xff800000, 512, 4, 4 * 64 + 2},
        {SPH_FILTER_BETWEEN, 16 * 3, 0xff4b4200, 406, 8, 4 * 56 + 14 + 4 * 64 + 2},
        {SPH_FILTER_BETWEEN, 1 << 20, 0xff404040, 768, 4, 72 * 4},
        {SPH_FILTER_BETWEEN, 0, 0xff0000c0, 0, 4, 4 * 24 + 62},
    };
    struct sph_machine m;
    uint32_t mem[LINES * SPH_LINE_WORDS];
    struct sph_texture_work work;
    small_machine(&m, mem);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        uint32_t texel = look(&m, cases[i].filter, cases[i].path, &work);
        printf("# case %zu: %08x lod %u texels %u words %u\n", i, texel, work.lod,
               (unsigned)work.texels, work.words);
        assert_int_equal(texel, cases[i].texel);
        assert_int_equal(work.lod, cases[i].lod);
        assert_int_equal(work.texels, cases[i].texels);
        assert_int_equal(work.words, cases[i].words);
        assert_int_equal(work.errors, 0);
    }
}

/* Each axis repeats or stays at the edge by its own bit: at 1.25, a quarter or the last texel. */
static void clamps(void **state) {
    (void)state;
    struct sph_machine m;
    uint32_t mem[LINES * SPH_LINE_WORDS], *map = mem + MAP * SPH_LINE_WORDS;
    struct sph_texture_work work;
    for (uint32_t s = 0; s < 2; s++)
        for (uint32_t t = 0; t < 2; t++) {
            small_machine(&m, mem);
            sph_field_set(map, SPH_MAP_CLAMP_S_LSB, SPH_MAP_CLAMP_S_BITS, s);
            sph_field_set(map, SPH_MAP_CLAMP_T_LSB, SPH_MAP_CLAMP_T_BITS, t);
            sph_field_set(map, SPH_MAP_S_0_LSB, 32, 5 << (SPH_ST_FRACTION - 2));
            sph_field_set(map, SPH_MAP_T_0_LSB, 32, 5 << (SPH_ST_FRACTION - 2));
            look(&m, SPH_FILTER_NEAREST, 0, &work);
            assert_int_equal(work.words, (IMAGE + 1) * SPH_LINE_WORDS +
                                             sph_texel_word(8, s ? 7 : 2, t ? 3 : 1));
        }
}

/* Records that point nowhere: a sticky error, a white or a good texel, never a word outside. */
static void damaged(void **state) {
    (void)state;
    struct sph_machine m;
    uint32_t mem[LINES * SPH_LINE_WORDS];
    struct sph_texture_work work;
    small_machine(&m, mem);
    m.regs[SPH_REG_MEM_LINES] = MAP; /* no record */
    assert_int_equal(look(&m, 3, 0, &work), 0xffffffff);
    assert_int_equal(work.errors, 1 << SPH_ERROR_BAD_NODE);
    m.regs[SPH_REG_MEM_LINES] = IMAGE; /* no header */
    assert_int_equal(look(&m, 3, 0, &work), 0xffffffff);
    assert_int_equal(work.errors, 1 << SPH_ERROR_BAD_NODE);
    m.regs[SPH_REG_MEM_LINES] = IMAGE + 1; /* no texels */
    assert_int_equal(look(&m, 3, 0, &work), 0xffffffff);
    assert_int_equal(work.errors, 1 << SPH_ERROR_BAD_NODE);
    assert_int_equal(work.texels, 4);
    m.regs[SPH_REG_MEM_LINES] = LINES;
    for (uint32_t levels = 0; levels < 16; levels++) {
        sph_field_set(mem + IMAGE * SPH_LINE_WORDS, SPH_IMAGE_LEVELS_LSB, 4, levels);
        look(&m, 3, 0, &work);
        assert_int_equal(work.errors != 0, levels < 1 || levels > 12);
    }
    struct sph_rng rng = vec_seed("damaged");
    for (int i = 0; i < 20000 / VEC_SHARE; i++) {
        for (int k = MAP * SPH_LINE_WORDS; k < LINES * SPH_LINE_WORDS; k++)
            mem[k] = (uint32_t)vec_unsigned(&rng, 32);
        if (i % 2) sph_field_set(mem + MAP * SPH_LINE_WORDS, SPH_MAP_IMAGE_LSB, 26, IMAGE);
        look(&m, i % SPH_FILTERS, vec_unsigned(&rng, 32), &work);
        assert_in_range(work.texels, 0, 8);
    }
}

static void cache(void **state) {
    (void)state;
    struct sph_cache c;
    struct sph_error err = {{0}};
    assert_int_equal(sph_cache_start(&c, 64, 8, 2, &err), 0); /* 4 sets of 2 */
    static const struct {
        uint32_t word;
        int missed;
    } asks[] = {{0, 1},  {7, 0},  {8, 1}, {32, 1}, {0, 0}, {64, 1}, /* 32 goes */
                {32, 1}, {64, 0}, {0, 1}, {8, 0},  {15, 0}};
    for (size_t i = 0; i < sizeof asks / sizeof *asks; i++)
        assert_int_equal(sph_cache_ask(&c, asks[i].word), asks[i].missed);
    assert_int_equal(c.asked, 11);
    assert_int_equal(c.missed, 6);
    sph_cache_end(&c);
    assert_int_equal(sph_cache_start(&c, 64, 8, 16, &err), -1);
    assert_non_null(strstr(err.text, "does not hold"));
    struct sph_error other = {{0}};
    assert_int_equal(sph_cache_start(&c, 96, 8, 2, &other), -1);
    assert_non_null(strstr(other.text, "not powers of two"));
}

/* Lines that come late: what is asked for while they are on their way, bus errors, a flush. */
static void cache_late(void **state) {
    (void)state;
    struct sph_cache c;
    struct sph_error err = {{0}};
    assert_int_equal(sph_cache_start(&c, 128, 16, 2, &err), 0); /* 4 sets of 2 lines of 16 */
    c.late = 1;
    assert_int_equal(sph_cache_ask(&c, 0), 1);
    assert_int_equal(sph_cache_ask(&c, 15), 0); /* on its way */
    assert_int_equal(sph_cache_ask(&c, 64), 1);
    assert_int_equal(sph_cache_ask(&c, 128), -1); /* both ways are */
    assert_int_equal(c.asked, 3);
    sph_cache_came(&c, 0);
    assert_int_equal(sph_cache_ask(&c, 0), 0);
    assert_int_equal(sph_cache_ask(&c, 128), 1); /* 0 was used last, but 64 is on its way */
    assert_int_equal(sph_cache_ask(&c, 0), -1);
    sph_cache_came(&c, 1);
    assert_int_equal(sph_cache_ask(&c, 64), 1); /* a bus error came with it */
    sph_cache_came(&c, 0);
    sph_cache_came(&c, 0);
    assert_int_equal(sph_cache_ask(&c, 79), 0);
    assert_int_equal(sph_cache_ask(&c, 16), 1); /* another set */
    sph_cache_forget(&c);
    sph_cache_came(&c, 1); /* of a line that is forgotten */
    assert_int_equal(sph_cache_ask(&c, 64), 1);
    assert_int_equal(c.missed, 6);
    sph_cache_end(&c);
}

/* Four ways: the first one not used since all were goes. */
static void cache_recency(void **state) {
    (void)state;
    struct sph_cache c;
    struct sph_error err = {{0}};
    assert_int_equal(sph_cache_start(&c, 32, 8, 4, &err), 0); /* one set */
    static const char asks[] = "abcd"                         /* all used: only d recent */
                               "e"                            /* a's place */
                               "b"                            /* stays; now d, e, b */
                               "f"   /* c's place: all used, only f recent */
                               "a"   /* e's place */
                               "bfd" /* there; now all but d: all used, only d recent */
                               "ce"; /* a's place, b's place */
    for (size_t i = 0; asks[i]; i++)
        assert_int_equal(sph_cache_ask(&c, 8u * (uint32_t)(asks[i] - 'a')),
                         i != 5 && (i < 8 || i > 10));
    sph_cache_end(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axis_texels),
        cmocka_unit_test(level_sizes),
        cmocka_unit_test(addresses),
        cmocka_unit_test(orders),
        cmocka_unit_test(constant_stays),
        cmocka_unit_test(filters),
        cmocka_unit_test(albedo_every_pair),
        cmocka_unit_test(lookups),
        cmocka_unit_test(clamps),
        cmocka_unit_test(damaged),
        cmocka_unit_test(cache),
        cmocka_unit_test(cache_late),
        cmocka_unit_test(cache_recency),
    };
    return cmocka_run_group_tests_name("texel", tests, NULL, NULL);
}
