/* parts.h - bundles of several units side by side, as rt_pipes, rt_leaf_units and rt_shades have
 * them SPDX-License-Identifier: Apache-2.0
 *
 * The top bits of a slot name the unit that serves it, so the bundle of a unit lacks them; with one
 * unit it is the whole bundle. A port with the bundles of all units has the first one lowest.
 */
#ifndef TB_ENGINE_PARTS_H
#define TB_ENGINE_PARTS_H

#include <deque>

#include "engine/world.h"

#ifndef PIPES
#define PIPES 1
#endif
#ifndef LEAF_UNITS
#define LEAF_UNITS 1
#endif
#ifndef SHADES
#define SHADES 1
#endif
#ifndef SETUPS
#define SETUPS 1
#endif

namespace parts {

constexpr int clog2(int n) {
    return n <= 1 ? 0 : 1 + clog2((n + 1) / 2);
}

/* Units of which each serves a share of the slots; bundles of BITS with the whole slot on top. */
struct Units {
    int count;

    int top() const { return clog2(count); } /* bits of a slot that name its unit */
    int own() const { return SLOTW - top(); }
    int of(int slot) const { return slot >> own(); }
    /* Low bit of the field of a unit at lsb. */
    int at(int unit, int bits, int lsb) const { return unit * (bits - top()) + lsb; }

    template <class Port>
    bench::u128 get(const Port &port, int unit, int bits, int lsb, int width) const {
        return bench::get(port, at(unit, bits, lsb), width);
    }
    template <class Port>
    void put(Port &port, int unit, int bits, int lsb, int width, bench::i128 value) const {
        bench::put(port, at(unit, bits, lsb), width, value);
    }
    /* The slot, whole. */
    template <class Port> int slot(const Port &port, int unit, int bits, int lsb, int) const {
        return unit << own() | (own() ? (int)bench::get(port, at(unit, bits, lsb), own()) : 0);
    }
    template <class Port>
    void put_slot(Port &port, int unit, int bits, int lsb, int, int slot) const {
        bench::put(port, at(unit, bits, lsb), own(), slot);
    }
};

constexpr Units pipes{PIPES}, leaf_units{LEAF_UNITS}, shades{SHADES}, setups{SETUPS};

/* A ray of `slot` at its set-up unit, nothing at the others. */
template <class Port> void put_ray(Port &port, int slot, const struct sph_ray &ray) {
    const int bits = RT_RAY_BITS - setups.top();
    uint32_t whole[(RT_RAY_BITS + 31) / 32] = {};
    world::put_ray(whole, slot, ray);
    for (int i = 0; i < bits; i++)
        bench::put(port, setups.of(slot) * bits + i, 1, (bench::i128)bench::get(whole, i, 1));
}
template <class Port> void put_in_ray(Port &port, int slot, int lsb, int bits, bool value) {
    setups.put(port, setups.of(slot), RT_RAY_BITS, lsb, bits, value);
}
template <class Port> void put_filter(Port &port, int slot, const struct sph_ray &ray) {
    uint32_t whole[(RT_FILTER_BITS + 31) / 32] = {};
    world::put_filter(whole, ray);
    for (int i = 0; i < RT_FILTER_BITS; i++)
        bench::put(port, setups.of(slot) * RT_FILTER_BITS + i, 1,
                   (bench::i128)bench::get(whole, i, 1));
}
/* Axes across rays, so many clocks behind them: at each set-up unit those that are due. */
class Axes {
  public:
    void send(int slot, const struct sph_ray &ray, uint64_t at) {
        waits.push_back({slot, ray.across, at});
    }
    template <class Port> void put(Port &port, uint64_t now) {
        const int bits = RT_ACROSS_BITS - setups.top();
        for (int unit = 0; unit < SETUPS; unit++)
            setups.put(port, unit, RT_ACROSS_BITS, RT_ACROSS_VALID, 0);
        for (; !waits.empty() && waits.front().at <= now; waits.pop_front()) {
            const Wait &w = waits.front();
            uint32_t whole[(RT_ACROSS_BITS + 31) / 32] = {};
            world::put_across(whole, w.slot, w.across);
            for (int i = 0; i < bits; i++)
                bench::put(port, setups.of(w.slot) * bits + i, 1,
                           (bench::i128)bench::get(whole, i, 1));
        }
    }

  private:
    struct Wait {
        int slot;
        struct sph_across across;
        uint64_t at;
    };
    std::deque<Wait> waits;
};
template <class Port> void no_ray(Port &port) {
    for (int unit = 0; unit < SETUPS; unit++) {
        setups.put(port, unit, RT_RAY_BITS, RT_RAY_VALID, 0);
        setups.put(port, unit, RT_RAY_BITS, RT_RAY_NORMAL, 0);
        setups.put(port, unit, RT_RAY_BITS, RT_RAY_LIGHT, 0);
    }
}

/* Of numbers for four pipes three may have slots. */
inline bool there(int slot) {
    return pipes.of(slot) < PIPES;
}

/* Any slot of a unit that is there. */
inline int any_slot(bench::Random &random, const Units &units, int unit) {
    int slot = (unit << units.own()) + (int)random.below(1u << units.own());
    return there(slot) ? slot : unit << units.own();
}

} // namespace parts

#endif
