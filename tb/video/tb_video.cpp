/* tb_video.cpp - rt_video: every picture that a display decodes is a frame of the store, or black
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_video [seed] [vectors]
 *
 * A vector is a small mode with parts of any length, odd widths and strides, in one of the formats,
 * doubled or not, at a ratio of clocks from 1:4 to 4:1, with a bus that stalls at random. Some
 * frames go by; then one of these happens:
 *     nothing: every picture is its frame, and no underrun is told
 *     the bus dies for a while: underruns are told, one for each picture that misses pixels; these
 *         are black from there on; the first that begins after the bus is back, or was reset by
 *         itself, is right again
 *     the bus is reset by itself in mid-frame: the rest of that frame is not asked for
 *     a reset of either side or both, of a clock or more, in mid-frame
 *     off and on again, at once or later, with another mode
 *     no frame is complete: black, and no underrun
 *     beats with errors: each is told
 * With PRESETS the modes of modes.def are shown instead, a whole picture of each.
 */
#include "bench.h"
#include "stimulus.h"
#include "video/rig.h"

#ifndef DATA
#define DATA 64
#endif
#ifndef BURST
#define BURST 16
#endif
#ifndef DEPTH
#define DEPTH 512
#endif

namespace {

using video::Mode;
using video::Rig;
using video::Shape;

enum Event { NOTHING, BUS_DIES, BUS_RESET, RESET, OFF_AND_ON, NO_FRAME, ERRORS, EVENTS };
const char *const EVENT[] = {"nothing",    "bus dies", "bus reset", "reset",
                             "off and on", "no frame", "errors"};

/* A mode of which the bus can keep up: rows and blanking are long enough for their beats. What the
 * queue cannot hold of a row must come while its pixels are shown. With a bit, of the 13 of each of
 * eight lengths, that one alone is set in its length. */
Mode make_mode(bench::Random &random, const Rig &rig, Shape &s, int bit) {
    Mode m{};
    const auto part = [&](unsigned most) { return 1 + (unsigned)random.below(most); };
    m = {part(random.percent(30) ? 100 : 30),
         part(5),
         part(6),
         part(5),
         part(12),
         part(3),
         part(3),
         part(3),
         (unsigned)random.below(2),
         (unsigned)random.below(2)};
    unsigned *const parts[] = {&m.h_active, &m.h_front, &m.h_sync, &m.h_back,
                               &m.v_active, &m.v_front, &m.v_sync, &m.v_back};
    if (bit >= 0) { /* the others are short, for the picture's sake */
        for (unsigned *other : parts)
            *other = part(3);
        *parts[bit / 13] = 1u << bit % 13;
    } else if (random.percent(2)) { /* one part of any length that there may be */
        *parts[random.below(8)] = part(8191);
    }
    s = {m.h_active, m.v_active, random.percent(50), random.percent(50), 0};
    s.stride = (s.row_bytes() + 15) / 16 * 16 + 16 * (unsigned)random.below(3);
    const unsigned far = 16u << random.below(12); /* with each bit, if the rows are few */
    if (random.percent(30) && far >= s.stride && far * m.v_active < 1u << 18) s.stride = far;
    const unsigned beats = s.row_bytes() / (DATA / 8) + 1, bursts = beats / BURST + 2;
    const double slow = 1e4 / ((100 - rig.store.stalls) * (100 - rig.store.stalls));
    const double clk = (double)rig.clk_period / (double)rig.pix_period;
    const unsigned row = (unsigned)((beats + 3 * bursts) * slow * clk * 1.3) + 1;
    const bool slower = m.h_active < row && beats + BURST > DEPTH;
    if (m.h_total() < row) m.h_back += row - m.h_total();
    const double start = (DEPTH + (DEPTH + 60 + 2 * rig.store.latency) * slow) * clk + DEPTH + 60;
    m.v_back += (unsigned)(start / m.h_total()) + 1;
    return m.h_back < 8192 && m.v_back < 8192 && !slower ? m : make_mode(random, rig, s, bit);
}

class Check {
  public:
    explicit Check(bench::Bench<Vrt_video> &bench)
        : b(bench), rig(bench.dut, bench.random, DATA / 8) {
        rig.store.room = DEPTH;
    }
    bench::Stimulus driven;

    void vector(Event event) {
        bench::Random &random = b.random;
        const unsigned ratio = 1 + (unsigned)random.below(4);
        rig.clk_period = 997 * (random.percent(50) ? ratio : 1);
        rig.pix_period = 1000 * (rig.clk_period > 1000 ? 1 : ratio) + random.below(3);
        rig.store.stalls = random.percent(50) ? (int)random.below(50) : 0;
        rig.store.latency = (unsigned)random.below(20);
        rig.waits = random.percent(25) ? 40 : 0;
        rig.must_be_right = 0;
        if (const unsigned n = vectors_++;
            n % 2 && n / 2 < LENGTHS * 13) { /* of a bus that is fast */
            rig.clk_period = rig.pix_period;
            rig.store.stalls = 0;
            bit_ = (int)(n / 2);
        } else {
            bit_ = -1;
            if (event == RESET || event == BUS_RESET) rig.store.stalls += 10;
        }
        const uint64_t underruns = rig.underruns, wrong = rig.pictures - rig.right;
        begin();
        rig.run_pictures(1 + random.below(3));
        happens(event);
        rig.run_pictures(2);
        rig.enable(false);
        rig.run_clocks(40 + DEPTH / 2);
        const uint64_t told = rig.underruns - underruns, black = rig.pictures - rig.right - wrong;
        /* the last picture may have missed pixels and have been cut off */
        if (event != RESET && told != black && told != black + 1)
            rig.fail("underruns: " + std::to_string(told) +
                     " told, wrong pictures: " + std::to_string(black));
        if (event != BUS_DIES && event != BUS_RESET && told)
            rig.fail("an underrun with a bus that is fast enough");
        if (rig.errors != rig.store.error_beats) rig.fail("errors of the bus are not told");
        if (rig.wrong) report(event);
        count[event]++;
    }
    void presets() {
        struct Named {
            const char *name;
            unsigned khz;
            Mode mode;
        };
#define MODE_NAMED(name, khz, ...) {name, khz, {__VA_ARGS__}},
        const Named modes[] = {SPHAERA_MODES(MODE_NAMED)};
        for (const Named &n : modes) {
            rig.clk_period = rig.pix_period = 1000;
            rig.store.stalls = 0;
            rig.store.latency = 20;
            const uint64_t underruns = rig.underruns;
            const Shape s = {n.mode.h_active, n.mode.v_active, false, false, n.mode.h_active * 4};
            rig.set(n.mode, s);
            rig.enable(true);
            rig.run_pictures(1);
            rig.enable(false);
            rig.run_clocks(40 + DEPTH);
            if (rig.underruns != underruns) rig.fail("an underrun");
            printf("# %s: %u x %u clocks a frame, %.2f Hz\n", n.name, n.mode.h_total(),
                   n.mode.v_total(), n.khz * 1e3 / n.mode.h_total() / n.mode.v_total());
            if (rig.wrong) report(NOTHING);
            b.done();
            if (rig.wrong) return;
        }
    }
    void summary() const {
        printf("# %llu pictures, %llu of them right, %llu underruns, %llu bursts, up to %u on "
               "their way, %llu beats, %llu with errors\n",
               (unsigned long long)rig.pictures, (unsigned long long)rig.right,
               (unsigned long long)rig.underruns, (unsigned long long)rig.store.bursts,
               rig.store.depth, (unsigned long long)rig.store.beats,
               (unsigned long long)rig.store.error_beats);
    }
    void begin() {
        Shape s{};
        const Mode m = make_mode(b.random, rig, s, bit_);
        lengths_.value(bit_);
        shapes_.value(m.h_pol + 2 * m.v_pol);
        shapes_.value(s.twice ? 4 + m.h_active % 2 : -1);
        shapes_.value(s.row_bytes() <= DATA / 8 ? 6 : s.row_bytes() <= DATA / 8 * BURST ? 7 : 8);
        for (int i = 4; i < 16; i++)
            stride_.value(s.stride >> i & 1 ? i - 4 : -1);
        rig.set(m, s);
        b.settle();
        rig.enable(true);
    }

  private:
    bench::Bench<Vrt_video> &b;
    enum { LENGTHS = 8 };
    static bench::Stimulus::Names every(const bench::Stimulus::Names &first,
                                        const bench::Stimulus::Names &then) {
        bench::Stimulus::Names all;
        for (const std::string &a : first)
            for (const std::string &z : then)
                all.push_back(a + ", " + z);
        return all;
    }
    static bench::Stimulus::Names bits(int from, int to) {
        bench::Stimulus::Names all;
        for (int i = from; i < to; i++)
            all.push_back("bit " + std::to_string(i));
        return all;
    }
    bench::Points &events_ =
        driven.values("event", every({EVENT, EVENT + EVENTS},
                                     {"XRGB8888", "RGB565", "XRGB8888 doubled", "RGB565 doubled"}));
    bench::Points &resets_ =
        driven.values("reset", every({"clk", "pix_clk", "both", "the bus"},
                                     {"nothing is owed", "an address waits", "beats are owed"}));
    bench::Points &lengths_ =
        driven.values("alone in its length", every({"h_active", "h_front", "h_sync", "h_back",
                                                    "v_active", "v_front", "v_sync", "v_back"},
                                                   bits(0, 13)));
    bench::Points &shapes_ =
        driven.values("mode", {"both syncs low", "hsync high", "vsync high", "both syncs high",
                               "an even width doubled", "an odd width doubled", "rows of a beat",
                               "rows of a burst", "rows of more"});
    bench::Points &stride_ = driven.values("stride", bits(4, 16));
    unsigned count[EVENTS] = {0}, vectors_ = 0;
    int bit_ = -1; /* of the lengths of a mode: make_mode() */

  public:
    Rig rig;

  private:
    /* At any clock of a frame. */
    void anywhere() {
        const uint64_t frame = (uint64_t)rig.mode.h_total() * rig.mode.v_total();
        rig.run_clocks((unsigned)b.random.below(frame * rig.pix_period / rig.clk_period + 1));
    }
    /* Until the bus is in one of its states, if it comes to that within two frames; addresses wait
     * for a bus that stalls alone. */
    void in_state() {
        const int state = rig.store.stalls && b.random.percent(70) ? 1 : 2 * (int)b.random.below(2);
        const uint64_t frame = (uint64_t)rig.mode.h_total() * rig.mode.v_total();
        for (uint64_t n = 2 * frame * rig.pix_period / rig.clk_period;
             n && rig.store.state() != state; n--)
            rig.run_clocks(1);
    }
    void happens(Event event) {
        bench::Random &random = b.random;
        const uint64_t underruns = rig.underruns;
        anywhere();
        events_.value(4 * event + 2 * rig.shape.twice + rig.shape.rgb565);
        switch (event) {
        case BUS_DIES:
            rig.must_be_right = ~0ull;
            rig.store.dead = true;
            rig.run_pictures(3); /* two may be on their way */
            anywhere();
            if (random.percent(50)) rig.reset_bus();
            rig.store.dead = false;
            rig.must_be_right = rig.takes;
            if (rig.underruns == underruns) rig.fail("no underrun, and the bus is dead");
            break;
        case BUS_RESET:
            in_state();
            rig.must_be_right = ~0ull;
            resets_.value(9 + rig.store.state());
            rig.reset_bus();
            rig.must_be_right = rig.takes;
            break;
        case RESET: {
            const unsigned how = count[RESET] % 3;
            in_state();
            resets_.value(3 * (int)how + rig.store.state());
            rig.reset(how != 1 ? 1 + (unsigned)random.below(5) : 0,
                      how != 0 ? 1 + (unsigned)random.below(5) : 0);
            break;
        }
        case OFF_AND_ON:
            rig.enable(false, 1 + (unsigned)random.below(3));
            if (random.percent(50)) rig.run_clocks((unsigned)random.below(400));
            if (random.percent(50)) { /* on for so short that nobody may have seen it */
                rig.enable(true);
                rig.run_clocks((unsigned)random.below(24));
                rig.enable(false, 1 + (unsigned)random.below(3));
            }
            begin();
            break;
        case NO_FRAME:
            rig.store.nothing = true;
            rig.run_pictures(2);
            anywhere();
            rig.store.nothing = false;
            break;
        case ERRORS:
            rig.store.errors = 100;
            rig.run_pictures(1);
            rig.store.errors = 0;
            break;
        default:
            break;
        }
    }
    void report(Event event) {
        if (!b.expect(rig.what.c_str(), 1, 0)) {
            const Mode &m = rig.mode;
            printf("#   event %s, clk:pix %llu:%llu, stalls %d %%, latency %u, waits %d %%\n",
                   EVENT[event], (unsigned long long)rig.clk_period,
                   (unsigned long long)rig.pix_period, rig.store.stalls, rig.store.latency,
                   rig.waits);
            printf("#   mode %u %u %u %u, %u %u %u %u, polarity %u %u; %s%s, stride %u\n",
                   m.h_active, m.h_front, m.h_sync, m.h_back, m.v_active, m.v_front, m.v_sync,
                   m.v_back, m.h_pol, m.v_pol, rig.shape.rgb565 ? "RGB565" : "XRGB8888",
                   rig.shape.twice ? ", doubled" : "", rig.shape.stride);
        }
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_video> b("tb_video", argc, argv, 240);
    Check check(b);
    b.dut.enable_i = 0;
    check.rig.reset(4, 4);
    if (check.rig.wrong) b.fail(check.rig.what.c_str());
#ifdef PRESETS
    check.presets();
#else
    for (unsigned i = 0; b.more() && !check.rig.wrong; i++, b.cycle = 0) {
        check.vector((Event)(i % EVENTS));
        b.done();
    }
    if (b.all_vectors && !b.mismatches && !check.driven.whole()) b.fail("the list of stimulus");
    if (b.all_vectors && check.rig.store.depth != DEPTH - BURST + 1)
        b.fail("rows of a beat have not as many bursts on their way as the page says");
#endif
    check.summary();
    return b.finish();
}
