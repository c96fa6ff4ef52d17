/* noise.h - images of noise in place of those that a scene names
 * SPDX-License-Identifier: Apache-2.0
 *
 * A bench reads no image files.
 */
#ifndef SPH_NOISE_H
#define SPH_NOISE_H

#include <vector>

#include "bench.h"

extern "C" {
#include "texture/texel.h"
}

namespace world {

/* `images` of them, each of its own size. */
class Noise {
  public:
    std::vector<struct sph_mip> mips;

    explicit Noise(uint32_t images) : texels(images) {
        bench::Random random(1);
        for (std::vector<uint32_t> &t : texels) {
            int w = (int)random.between(5, 60), h = (int)random.between(5, 60);
            struct sph_mip mip = {w, h, sph_mip_levels(w, h), 0, nullptr};
            t.resize(sph_mip_at(&mip, mip.levels));
            for (uint32_t &texel : t)
                texel = (uint32_t)random.next();
            mip.texels = t.data();
            mips.push_back(mip);
        }
    }

  private:
    std::vector<std::vector<uint32_t>> texels;
};

} // namespace world

#endif
