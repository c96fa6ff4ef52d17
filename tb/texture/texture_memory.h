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

constexpr uint32_t MAPS = 64, IMAGES = 16, LINES_IN_MEMORY = 5999;

/* Maps in lines 1.., images behind them; some of both are broken. */
class Memory {
  public:
    struct sph_machine machine = {};
    std::vector<uint32_t> words = std::vector<uint32_t>(LINES_IN_MEMORY * SPH_LINE_WORDS);

    void fill(bench::Random &r) {
        for (uint32_t &word : words)
            word = (uint32_t)r.next();
        uint32_t line = 1 + MAPS, images[IMAGES];
        for (uint32_t &image : images)
            line = put_image(r, image = line);
        for (uint32_t i = 0; i < MAPS; i++)
            put_map(r, &words[(1 + i) * SPH_LINE_WORDS], images[r.below(IMAGES)]);
        machine.mem = words.data();
        machine.lines = LINES_IN_MEMORY;
        machine.regs[SPH_REG_MEM_LINES] = LINES_IN_MEMORY;
    }

  private:
    uint32_t put_image(bench::Random &r, uint32_t at) {
        uint32_t *header = &words[at * SPH_LINE_WORDS], lines = 0;
        uint32_t w = r.percent(20) ? 1 : 1 + (uint32_t)r.below(60);
        uint32_t h = r.percent(20) ? 1 : 1 + (uint32_t)r.below(60);
        uint32_t levels = 1;
        while (levels < SPH_TEXTURE_LEVELS && (w >> levels || h >> levels))
            levels++;
        if (r.percent(20)) levels = 1 + (uint32_t)r.below(levels);
        for (uint32_t l = 0; l < levels; l++) {
            if (l)
                sph_field_set(header, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * ((int)l - 1),
                              SPH_IMAGE_FIRST_BITS, lines);
            lines += sph_level_lines(sph_level_size(w, (int)l), sph_level_size(h, (int)l));
        }
        sph_field_set(header, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS, w - 1);
        sph_field_set(header, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS, h - 1);
        sph_field_set(header, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS, levels);
        if (r.percent(10)) /* levels that begin anywhere; none, too many */
            for (int i = 0; i < SPH_LINE_WORDS; i++)
                header[i] = (uint32_t)r.next();
        return at + 1 + lines < LINES_IN_MEMORY - 600 ? at + 1 + lines : 1 + MAPS;
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
};

} // namespace

#endif
