/* texture_memory.h - a memory of mapping records, images and texels, sound and broken, for
 * tb_texture SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TEXTURE_MEMORY_H
#define TB_TEXTURE_MEMORY_H

#include <vector>

#include "bench.h"

extern "C" {
#include "machine/machine.h"
#include "texture/texel.h"
}

namespace {

constexpr uint32_t MAPS = 104, FLAT = 40, IMAGES = 16, LARGE = 8;
constexpr uint32_t LINES_IN_MEMORY = (1 << 20) - 49;

/* Maps in lines 1.., images behind them or far away; some of both are broken. Images may be larger
 * than memory, and stand one in the other: texels are any words, no two alike. */
class Memory {
  public:
    struct sph_machine machine = {};
    std::vector<uint32_t> words = std::vector<uint32_t>(LINES_IN_MEMORY * SPH_LINE_WORDS);

    void fill(bench::Random &r) {
        uint32_t text = (uint32_t)r.next();
        for (uint32_t &word : words)
            word = text += 0x9e3779b1;
        for (uint32_t i = 0; i < (1 + MAPS) * SPH_LINE_WORDS; i++)
            words[i] = (uint32_t)r.next();
        uint32_t line = 1 + MAPS, images[IMAGES];
        for (uint32_t i = 0; i < IMAGES; i++) {
            images[i] = i % 4 == 3 ? 1u << 19 | (uint32_t)r.below(1 << 18) : line;
            put_image(r, images[i], i < LARGE);
            if (i == LARGE) /* one level too many */
                sph_field_set(&words[images[i] * SPH_LINE_WORDS], SPH_IMAGE_LEVELS_LSB,
                              SPH_IMAGE_LEVELS_BITS, SPH_TEXTURE_LEVELS + 1);
            line += 1 + (uint32_t)r.below(400);
        }
        for (uint32_t i = 0; i < MAPS; i++)
            put_map(r, &words[(1 + i) * SPH_LINE_WORDS], images[r.below(IMAGES)]);
        for (uint32_t i = 0; i < FLAT; i++)
            flatten(r, &words[(1 + i) * SPH_LINE_WORDS], images[i % LARGE], i);
        machine.mem = words.data();
        machine.lines = LINES_IN_MEMORY;
        machine.regs[SPH_REG_MEM_LINES] = LINES_IN_MEMORY;
    }

  private:
    void put_image(bench::Random &r, uint32_t at, bool large) {
        uint32_t *header = &words[at * SPH_LINE_WORDS], lines = 0;
        uint32_t w = r.percent(20) ? 1 : 1 + (uint32_t)r.below(60);
        uint32_t h = r.percent(20) ? 1 : 1 + (uint32_t)r.below(60);
        if (large) w = 4096 - (uint32_t)r.below(3000), h = 4096 - (uint32_t)r.below(3000);
        uint32_t levels = 1;
        while (levels < SPH_TEXTURE_LEVELS && (w >> levels || h >> levels))
            levels++;
        if (!large && r.percent(20)) levels = 1 + (uint32_t)r.below(levels);
        for (uint32_t l = 0; l < levels; l++) {
            if (l)
                sph_field_set(header, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * ((int)l - 1),
                              SPH_IMAGE_FIRST_BITS, lines);
            lines = large ? (uint32_t)r.bits(SPH_IMAGE_FIRST_BITS)
                          : lines + sph_level_lines(sph_level_size(w, (int)l),
                                                    sph_level_size(h, (int)l));
        }
        sph_field_set(header, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS, w - 1);
        sph_field_set(header, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS, h - 1);
        sph_field_set(header, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS, levels);
        if (!large && r.percent(10)) /* levels that begin anywhere; none, too many */
            for (int i = 0; i < SPH_LINE_WORDS; i++)
                header[i] = (uint32_t)r.next();
    }
    void put_map(bench::Random &r, uint32_t *map, uint32_t image) {
        int base = (int)r.between(-2, W + 4) * 256 + (int)r.below(256);
        sph_field_set(map, SPH_MAP_KIND_LSB, 2, (uint32_t)r.below(2));
        sph_field_set(map, SPH_MAP_BASE_LSB, SPH_MAP_BASE_BITS, (uint32_t)base);
        if (r.percent(95)) sph_field_set(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, image);
        if (r.percent(50)) return;
        sph_field_set(map, SPH_MAP_S_E_LSB, SPH_MAP_S_E_BITS, (uint32_t)r.between(-3, 20));
        sph_field_set(map, SPH_MAP_T_E_LSB, SPH_MAP_T_E_BITS, (uint32_t)r.between(-3, 20));
        for (int i = 0; i < 9 && sph_field(map, SPH_MAP_KIND_LSB, 1); i++)
            sph_field_set(map, SPH_MAP_TURN_LSB + 16 * i, 16, (uint32_t)r.between(-18000, 18000));
    }
    /* The same coordinates all over a facet, clamped: of each of the first ones one bit before the
     * point is 1. From far away level i % SPH_TEXTURE_LEVELS is seen, or one beside it. */
    static void flatten(bench::Random &r, uint32_t *map, uint32_t image, uint32_t i) {
        int base = (W + 3 - (int)(i % SPH_TEXTURE_LEVELS)) * 256 + (int)r.below(256);
        for (int lsb = SPH_MAP_S_X_LSB; lsb < SPH_MAP_T_0_LSB + SPH_MAP_T_0_BITS; lsb += 20)
            sph_field_set(map, lsb, 20, 0);
        sph_field_set(map, SPH_MAP_KIND_LSB, 4, 3 << SPH_MAP_CLAMP_S_LSB);
        sph_field_set(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, image);
        sph_field_set(map, SPH_MAP_BASE_LSB, SPH_MAP_BASE_BITS, (uint32_t)base);
        sph_field_set(map, SPH_MAP_S_0_LSB, 20, (uint32_t)r.bits(20));
        sph_field_set(map, SPH_MAP_T_0_LSB, 20, (uint32_t)r.bits(20));
        sph_field_set(map, SPH_MAP_S_0_LSB + 20, 20, i < 20 ? 1u << i : 0);
        sph_field_set(map, SPH_MAP_T_0_LSB + 20, 20, i < 20 ? 1u << 19 >> i : 0);
    }
};

} // namespace

#endif
