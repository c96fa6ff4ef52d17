/* tb_sdram_bus.cpp - readers and writers at one SDRAM: each read has what was written before it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Bursts of any length, of which one begins a bit of the address beside another, with stalls of
 * each channel; clocks of any ratio from 1:4 to 2:1, in any phase. Nobody writes what is read or
 * written at that time; what a write was answered for counts. While the display waits, no more than
 * QUEUE words of others and the few behind its own go before it. Now and then all is reset in the
 * middle of reads, and of writes, of which words may be in memory or not. A vector is a burst.
 */
#include <deque>
#include "Vrt_sdram_bus.h"
#include "bench.h"
#include "board/sdram_model.h"
#include "stimulus.h"

namespace {

typedef std::unordered_map<uint32_t, unsigned> Counts;

struct Reader {
    bool asked = false; /* AR is offered */
    uint32_t at = 0, words = 0;
    std::deque<uint32_t> owed; /* words, a bit more for the last of a burst */
    uint64_t before = 0;       /* words of all when its only burst was taken; 0: not looked at */
    uint32_t own = 0;
    unsigned deaf = 0; /* clocks for which it takes no answer */
};

struct Writer {
    bool address = false; /* AW is offered */
    uint32_t at = 0, words = 0, sent = 0;
    uint64_t data = 0;
    unsigned strobe = 0;
    bool beat = false, answer = false;
    uint32_t next_at = 0, next_words = 0; /* a burst whose AW is offered before this one ends */
};

constexpr uint32_t LAST = 1u << 31;
constexpr uint64_t POWERED = 300000000; /* ps from a reset until the part takes commands */

class Rig {
  public:
    explicit Rig(bench::Bench<Vrt_sdram_bus> &bench) : b(bench), dut(bench.dut) {}
    uint64_t longest = 0;                            /* ps from the display's AR to its last word */
    uint64_t reads[READS] = {}, writes[WRITES] = {}; /* bursts */

    bench::Stimulus driven;

    bool run() {
        dut.rst = dut.mem_rst = 1;
        for (unsigned edges = 0; b.more();) {
            if (clk_at_ <= mem_at_) {
                clk_at_ += clk_half_;
                dut.clk = !dut.clk;
                if (dut.clk)
                    core();
                else
                    dut.eval();
                if (++edges == 40) dut.rst = dut.mem_rst = 0;
                if (edges % 200000 == 96000) still_ = true;
                if (edges % 100000 == 99960) restart();
                if (edges % 100000 == 0) begin();
                if (edges % 4000 == 0) clk_half_ = 4000 + b.random.below(28000);
            } else {
                mem_at_ += 8000;
                dut.mem_clk = !dut.mem_clk;
                if (dut.mem_clk)
                    memory();
                else
                    dut.eval();
            }
            if (!part_.error().empty()) return b.fail(part_.error().c_str()), false;
            if (clk_at_ > 4000000000000) return b.fail("stuck"), false;
        }
        return true;
    }

  private:
    bench::Bench<Vrt_sdram_bus> &b;
    Vrt_sdram_bus &dut;
    Sdram part_{16.0};
    uint64_t clk_at_ = 0, mem_at_ = 500, clk_half_ = 20000, asked_at_ = 0;
    uint64_t powered_ = POWERED;
    uint16_t out_ = 0;
    Reader readers_[READS];
    Writer writers_[WRITES];
    std::unordered_map<uint32_t, uint64_t> words_;
    Counts reading_, writing_;
    bool still_ = false;           /* nobody begins to write */
    uint32_t at_ = 0;              /* the place before */
    std::deque<uint32_t> recent_;  /* words that may still be in the queue */
    std::vector<uint32_t> unsure_; /* words of writes that a reset cut off */
    bench::Points &read_at_ = driven.alone("address of a read", 22);
    bench::Points &write_at_ = driven.alone("address of a write", 22);
    bench::Points &words_of_ = driven.values("words of a read", {"1", "DEPTH", "40", "256"});
    bench::Points &met_ = driven.together("ports that move words at once", ports());

    void begin() {
        if (dut.rst) {
            part_.restart();
            powered_ = clk_at_ + POWERED;
            for (uint32_t at : unsure_)
                words_[at] = part_.word(at >> 7 & 3, at >> 9, (at & 127) * 4);
            unsure_.clear();
        }
        dut.rst = dut.mem_rst = still_ = false;
    }
    /* All is reset, and who asked gets no answer; words in the queue may not reach memory. */
    void restart() {
        dut.rst = dut.mem_rst = 1;
        unsigned events = 0;
        for (int i = 0; i < READS; i++)
            events |= !readers_[i].owed.empty() << i;
        for (int i = 0; i < WRITES; i++)
            events |= (writers_[i].answer || writers_[i].words != 0) << (READS + i);
        met_.clock(events | 1u << (READS + WRITES));
        for (const auto &[at, n] : writing_)
            if (n) unsure_.push_back(at);
        unsure_.insert(unsure_.end(), recent_.begin(), recent_.end());
        for (Reader &r : readers_)
            r = Reader();
        for (Writer &w : writers_)
            w = Writer();
        reading_.clear();
        writing_.clear();
    }

    void memory() {
        const SdramPins pins = {dut.cke_o != 0, dut.command_o,    dut.ba_o, dut.a_o,
                                dut.dqm_o,      dut.dq_oe_o != 0, dut.dq_o};
        dut.eval();
        part_.edge(pins);
        dut.dq_i = out_;
        out_ = part_.out();
        dut.eval();
    }
    uint64_t moved() const { return part_.commands(4) + part_.commands(5); }
    uint32_t place() {
        static const uint32_t rows[3] = {0, 0x1ffe, 0x0a51};
        const bool beside = b.random.percent(50);
        at_ = beside ? at_ ^ 1u << b.random.below(22)
                     : (rows[b.random.below(3)] << 9 | (uint32_t)b.random.below(512)) & 0x3fffff;
        return at_;
    }
    static bench::Stimulus::Names ports() {
        bench::Stimulus::Names all;
        for (int i = 0; i < READS; i++)
            all.push_back("reader " + std::to_string(i));
        for (int i = 0; i < WRITES; i++)
            all.push_back("writer " + std::to_string(i));
        all.push_back("a reset");
        return all;
    }
    bool none(const Counts &counts, uint32_t at, uint32_t n) const {
        for (uint32_t i = 0; i < n; i++) {
            const auto found = counts.find(at + i & 0x3fffff);
            if (found != counts.end() && found->second) return false;
        }
        return true;
    }
    /* What is offered in the clock that comes. */
    void offer() {
        dut.s_arvalid = dut.s_rready = dut.s_awvalid = dut.s_wvalid = dut.s_bready = 0;
        for (int i = 0; i < READS; i++) {
            Reader &r = readers_[i];
            const bool lone = i == 0 && r.owed.empty() && b.random.percent(50);
            const bool more =
                i ? b.random.percent(20) : b.random.percent(5) && r.owed.size() < 40 && !r.before;
            if (!r.asked && (lone || more)) {
                const uint32_t most = !i || b.random.percent(90) ? DEPTH
                                      : b.random.percent(90)     ? 40
                                                                 : 256;
                r.words = b.random.percent(25) ? most : 1 + (uint32_t)b.random.below(most);
                r.at = place();
                r.asked = none(writing_, r.at, r.words);
                for (uint32_t k = 0; r.asked && k < r.words; k++)
                    reading_[r.at + k & 0x3fffff]++;
            }
            if (r.asked) dut.s_arvalid |= 1 << i;
            bench::put(dut.s_araddr, 32 * i, 32, (bench::i128)r.at << 3);
            bench::put(dut.s_arlen, 8 * i, 8, r.words - 1);
            r.deaf = r.deaf ? r.deaf - 1 : b.random.below(2000) == 0 ? 200 : 0;
            if (i == 0 || (!r.deaf && b.random.percent(70))) dut.s_rready |= 1 << i;
        }
        for (int i = 0; i < WRITES; i++) {
            Writer &w = writers_[i];
            if (w.words && !w.address && !w.next_words && !still_ && b.random.percent(10)) {
                w.next_words = 1 + (uint32_t)b.random.below(5);
                w.next_at = place();
                if (!none(writing_, w.next_at, w.next_words) ||
                    !none(reading_, w.next_at, w.next_words))
                    w.next_words = 0;
                for (uint32_t k = 0; k < w.next_words; k++)
                    writing_[w.next_at + k & 0x3fffff]++;
            }
            if (!w.address && !w.words && !w.answer && !w.next_words && !still_ &&
                b.random.percent(30)) {
                w.words = 1 + (uint32_t)b.random.below(5);
                w.at = place();
                w.sent = 0;
                w.address = none(writing_, w.at, w.words) && none(reading_, w.at, w.words);
                for (uint32_t k = 0; w.address && k < w.words; k++)
                    writing_[w.at + k & 0x3fffff]++;
                if (!w.address) w.words = 0;
            }
            if (w.sent < w.words && !w.beat && b.random.percent(70)) {
                w.beat = true;
                w.data = b.random.next();
                w.strobe = b.random.percent(50) ? 255 : (unsigned)b.random.below(256);
            }
            if (w.address || w.next_words) dut.s_awvalid |= 1 << i;
            if (w.beat) dut.s_wvalid |= 1 << i;
            dut.s_wlast = (dut.s_wlast & ~(1 << i)) | (w.sent + 1 == w.words) << i;
            bench::put(dut.s_awaddr, 32 * i, 32,
                       (bench::i128)(w.next_words ? w.next_at : w.at) << 3);
            bench::put(dut.s_wdata, 64 * i, 64, (bench::i128)w.data);
            bench::put(dut.s_wstrb, 8 * i, 8, w.strobe);
            if (b.random.percent(70)) dut.s_bready |= 1 << i;
        }
    }
    void core() {
        dut.clk = 0;
        offer();
        dut.eval();
        const unsigned ar = dut.s_arvalid & dut.s_arready, aw = dut.s_awvalid & dut.s_awready;
        const unsigned w = dut.s_wvalid & dut.s_wready, bs = dut.s_bvalid & dut.s_bready;
        const unsigned r = dut.s_rvalid & dut.s_rready, last = dut.s_rlast;
        met_.clock(ar | aw << READS | r | w << READS);
        uint64_t data[READS];
        for (int i = 0; i < READS; i++)
            data[i] = (uint64_t)bench::get(dut.s_rdata, 64 * i, 64);
        dut.clk = 1;
        dut.eval();
        if (dut.rst) return;
        for (int i = 0; i < READS; i++)
            read(i, ar >> i & 1, r >> i & 1, data[i], last >> i & 1);
        for (int i = 0; i < WRITES; i++)
            written(i, aw >> i & 1, w >> i & 1, bs >> i & 1);
    }
    void read(int i, bool ar, bool r, uint64_t data, bool last) {
        Reader &me = readers_[i];
        if (r && me.owed.empty()) return b.fail("an answer to nothing");
        if (r) {
            const uint32_t at = me.owed.front() & ~LAST;
            b.expect("s_rdata", data, words_[at]);
            if (b.bad()) b.show("word", at, 22), b.show("reader", i, 3);
            b.expect("s_rlast", last, me.owed.front() >> 31);
            reading_[at]--;
            me.owed.pop_front();
            if (last) b.done(), reads[i]++;
            if (last && me.owed.empty() && me.before) {
                if (asked_at_ > powered_ && clk_at_ - asked_at_ > longest)
                    longest = clk_at_ - asked_at_;
                me.before = 0;
            }
        }
        /* others in the queue, in its output, and those behind its last word */
        if (me.before && moved() > me.before + me.own + QUEUE + 8) b.fail("the display waits");
        if (ar) {
            read_at_.word(me.at);
            words_of_.value(me.words == 1       ? 0
                            : me.words == DEPTH ? 1
                            : me.words == 40    ? 2
                            : me.words == 256   ? 3
                                                : -1);
        }
        if (!ar) return;
        me.before = me.owed.empty() ? moved() + 1 : 0;
        me.own = me.words;
        if (i == 0) asked_at_ = clk_at_;
        me.asked = false;
        for (uint32_t k = 0; k < me.words; k++)
            me.owed.push_back((me.at + k & 0x3fffff) | (k + 1 == me.words ? LAST : 0));
        if (i) me.before = 0;
    }
    void written(int i, bool aw, bool w, bool answered) {
        Writer &me = writers_[i];
        const bool next = aw && me.next_words;
        if (aw && !next) me.address = false, me.answer = true;
        if (aw) write_at_.word(next ? me.next_at : me.at);
        if (w) {
            recent_.push_back(me.at + me.sent & 0x3fffff);
            if (recent_.size() > QUEUE + 4) recent_.pop_front();
            uint64_t &was = words_[me.at + me.sent & 0x3fffff];
            for (int k = 0; k < 8; k++) {
                const uint64_t byte = me.strobe >> k & 1 ? 0xffull << 8 * k : 0;
                was = (was & ~byte) | (me.data & byte);
            }
            me.beat = false;
            me.sent++;
        }
        if (answered) {
            if (!me.answer || me.sent != me.words) return b.fail("an answer to a write that lasts");
            for (uint32_t k = 0; k < me.words; k++)
                writing_[me.at + k & 0x3fffff]--;
            me.words = 0;
            me.answer = false;
            b.done();
            writes[i]++;
        }
        if (!next) return;
        if (me.words) return b.fail("AW is taken while a burst lasts");
        me.at = me.next_at;
        me.words = me.next_words;
        me.sent = me.next_words = 0;
        me.beat = false;
        me.answer = true;
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_sdram_bus> b("tb_sdram_bus", argc, argv, 20000);
    Rig rig(b);
    rig.run();
    for (uint64_t bursts : rig.reads)
        if (!bursts && b.all_vectors) b.fail("a reader waits");
    for (uint64_t bursts : rig.writes)
        if (!bursts && b.all_vectors) b.fail("a writer waits");
    if (b.all_vectors && !b.mismatches && !rig.driven.whole()) b.fail("the list of stimulus");
    printf("# the display's longest wait for a burst of up to %d words: %.1f us\n", DEPTH,
           (double)rig.longest / 1e6);
    return b.finish();
}
