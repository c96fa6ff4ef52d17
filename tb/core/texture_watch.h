/* texture_watch.h - the model's cache beside every texture cache of a verilated core
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each rt_texture shows what its cache is asked (cache_asked) and the cache's shape, its cache what
 * it does (seen); they are found by name, wherever they stand. The core's counter of misses must be
 * what they add up to.
 */
#ifndef TB_TEXTURE_WATCH_H
#define TB_TEXTURE_WATCH_H

#include <memory>
#include <string>
#include <vector>

#include "../cache_prediction.h"
#include "verilated.h"
#include "verilated_syms.h"

class TextureWatch {
  public:
    /* After the first clock of the core that was made in this context. */
    explicit TextureWatch(VerilatedContext &context) {
        for (const auto &scope : *context.scopeNameMap()) {
            const VerilatedVar *asked = scope.second->varFind("cache_asked");
            const VerilatedVar *shape = scope.second->varFind("cache_shape");
            if (!asked || !shape) continue;
            const VerilatedScope *cache =
                context.scopeFind((std::string(scope.first) + ".u_cache").c_str());
            units_.push_back({static_cast<const uint32_t *>(asked->datap()),
                              static_cast<const uint8_t *>(cache->varFind("seen")->datap()),
                              *static_cast<const uint32_t *>(shape->datap()), nullptr});
        }
        reset();
    }
    /* As after a reset of the core. */
    void reset() {
        for (Unit &unit : units_)
            unit.cache = std::make_unique<CachePrediction>(unit.shape >> 16, unit.shape >> 8 & 255,
                                                           unit.shape & 255);
    }
    /* Before every clock edge, when all has settled; not in reset. */
    void clock() {
        for (const Unit &unit : units_)
            unit.cache->texture(*unit.asked, *unit.seen);
    }
    /* So far. */
    uint64_t missed() const {
        uint64_t sum = 0;
        for (const Unit &unit : units_)
            sum += unit.cache->missed();
        return sum;
    }
    bool impossible() const {
        bool any = false;
        for (const Unit &unit : units_)
            any |= unit.cache->impossible();
        return any;
    }

  private:
    struct Unit {
        const uint32_t *asked;
        const uint8_t *seen;
        uint32_t shape;
        std::unique_ptr<CachePrediction> cache;
    };
    std::vector<Unit> units_;
};

#endif
