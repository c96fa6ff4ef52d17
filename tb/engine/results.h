/* results.h - results of exact tests, which come in any order, against those that slots wait for
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_ENGINE_RESULTS_H
#define TB_ENGINE_RESULTS_H

#include "engine/world.h"

namespace world {

/* Takes the bundle `result` at a port: one of its slot's, which has the ray and, in `wanted`, what
 * the model found for each of its tests under way. */
template <class Bench, class Slot, class Port>
void take_result(Bench &b, Slot *slots, const Port &port) {
    int at = (int)bench::get(port, RT_RESULT_SLOT);
    bool hit = bench::get(port, RT_RESULT_HIT) != 0;
    uint64_t key = (uint64_t)bench::get(port, RT_RESULT_KEY);
    uint32_t id = (uint32_t)bench::get(port, RT_RESULT_ID);
    int far = (int)bench::get(port, RT_RESULT_FAR);
    Slot &s = slots[at];
    for (size_t i = 0; i < s.wanted.size(); i++) {
        const struct sph_hit &w = s.wanted[i];
        bool shadow = s.ray.kind == SPH_SHADOW;
        if (hit != (w.key != 0) ||
            (hit && (w.key != key || w.id != id || (w.far != far && !shadow))))
            continue;
        s.wanted.erase(s.wanted.begin() + (long)i);
        b.done();
        return;
    }
    b.expect("a result that the slot waits for", 0, 1, 1);
    if (b.bad()) {
        b.show("slot", at, SLOTW), b.show("hit", hit, 1), b.show("far", far, 1);
        b.show("id", id, 24), b.show("key", (bench::i128)key, W + WD + 2);
        for (int i = 0; i < 3; i++)
            b.show("org", s.ray.org[i], W), b.show("dir", s.ray.dir[i], WD);
        for (const struct sph_hit &w : s.wanted)
            b.show("wanted: key", (bench::i128)w.key, W + WD + 2), b.show("id", w.id, 24);
    }
    if (!s.wanted.empty()) s.wanted.pop_back();
    b.done();
}

} // namespace world

#endif
