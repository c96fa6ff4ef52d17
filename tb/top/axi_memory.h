/* axi_memory.h - memory behind the masters of rt_top: late, unwilling, faulty or deaf, as asked
 * SPDX-License-Identifier: Apache-2.0
 *
 * In every clock: offer() sets the inputs of the block, the block settles, take() looks at the
 * handshakes. take() checks the rules of AXI4 besides: what is offered stays until it is taken, no
 * burst crosses 4 KiB, beats are as many as AWLEN says, addresses are aligned to a beat.
 */
#ifndef TB_AXI_MEMORY_H
#define TB_AXI_MEMORY_H

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "bench.h"

enum { OKAY, SLVERR = 2, DECERR = 3 };

/* How a bus behaves. */
struct Manner {
    unsigned stall = 0;      /* percent of clocks in which a ready or a valid is low */
    unsigned latency = 4;    /* clocks at least from a request to its answer */
    int64_t error_at = -1;   /* which answer has an error, counted from the start of the manner */
    int error = OKAY;        /* which one */
    int64_t deaf_after = -1; /* takes so many requests, and answers no later one */
    bool refuses = false;    /* when deaf it takes no request either */
    bool aw_last = false;    /* it takes the address of a write behind its beats */
};

/* What is common to both directions: what was offered and not taken must stand. */
class Channel {
  public:
    std::string broken;          /* the first rule that was broken */
    bool in_reset = false;       /* the bus takes and gives nothing, and looks at nothing */
    uint64_t silent = 0;         /* clocks up to now in which it owed something and did nothing */
    std::vector<uint64_t> above; /* address bits from 26 up that bursts may have; none: any */

    void stable(const char *name, unsigned which, bool valid, bool ready, uint64_t payload) {
        Held &h = held_[which];
        if (h.waits && (!valid || payload != h.payload)) fault(name, "changed before ready");
        h = {valid && !ready, payload};
    }
    void burst(const char *name, uint64_t address, unsigned beats, unsigned bytes) {
        if ((address & 0xfff) + beats * bytes > 0x1000) fault(name, "crosses 4 KiB");
        if (address % bytes) fault(name, "is not aligned to a beat");
        if (!above.empty() && std::find(above.begin(), above.end(), address >> 26) == above.end())
            fault(name, "has another address");
    }
    void fault(const char *name, const char *what) {
        if (broken.empty()) broken = std::string(name) + " " + what;
    }
    void forget() { held_[0] = held_[1] = {false, 0}; }

  private:
    struct Held {
        bool waits;
        uint64_t payload;
    } held_[2] = {{false, 0}, {false, 0}};
};

template <class Data> uint64_t word64(const Data &data, int i) {
    return (uint64_t)(bench::get(data) >> 64 * i);
}

/* The ports of a master that reads, by their names; its IDs may be variables, if it has none. */
template <class Bit, class Word, class Byte, class Data> struct ReadPorts {
    Byte &arid, &rid;
    Bit &arvalid, &arready;
    Word &araddr;
    Byte &arlen;
    Bit &rvalid, &rready;
    Data &rdata;
    Byte &rresp;
    Bit &rlast;
};
#define READ_PORTS(dut, name, arid, rid)                                                           \
    ReadPorts<decltype(dut.name##_arvalid), decltype(dut.name##_araddr),                           \
              decltype(dut.name##_arlen), decltype(dut.name##_rdata)> {                            \
        arid, rid, dut.name##_arvalid, dut.name##_arready, dut.name##_araddr, dut.name##_arlen,    \
            dut.name##_rvalid, dut.name##_rready, dut.name##_rdata, dut.name##_rresp,              \
            dut.name##_rlast                                                                       \
    }

/* Bursts of one ID are answered in their order. With stalls, beats are of any burst that is the
 * first of its ID. */
class ReadSide : public Channel {
  public:
    Manner manner;
    uint64_t requests = 0, answers = 0; /* since the manner was set */

    ReadSide(std::vector<uint8_t> &bytes, bench::Random &random) : bytes_(bytes), random_(random) {}
    void behave(const Manner &m) {
        manner = m;
        requests = answers = 0;
    }
    bool deaf() const { return manner.deaf_after >= 0 && (int64_t)requests >= manner.deaf_after; }
    size_t waiting() const { return queue_.size(); }
    /* The bus was reset. */
    void reset() {
        queue_.clear();
        offered_ = false;
        forget();
    }
    template <class Ports> void offer(const Ports &t) {
        clock_++;
        t.arready = !in_reset && !(deaf() && manner.refuses) && !random_.percent(manner.stall);
        if (!offered_ && !queue_.empty()) {
            shown_ = choose();
            const Burst &b = queue_[shown_];
            offered_ = b.due <= clock_ && !b.never && !random_.percent(manner.stall);
        }
        t.rvalid = offered_;
        t.rid = (uint8_t)random_.next(); /* noise where it must not matter */
        t.rresp = (uint8_t)random_.below(4);
        t.rlast = random_.percent(50);
        const unsigned bytes = sizeof t.rdata;
        auto *data = (uint8_t *)&t.rdata;
        for (unsigned i = 0; i < bytes; i++)
            data[i] = (uint8_t)random_.next();
        if (!offered_) return;
        const Burst &b = queue_[shown_];
        memcpy(data, &bytes_[(b.address + b.sent * bytes) % bytes_.size()], bytes);
        t.rid = b.id;
        t.rlast = b.sent + 1 == b.beats;
        t.rresp = (uint8_t)((int64_t)answers == manner.error_at ? manner.error : (int)OKAY);
    }
    template <class Ports> void take(const Ports &t) {
        if (in_reset) return;
        const bool moves = t.rvalid || (t.arvalid && t.arready);
        silent = (t.arvalid || !queue_.empty()) && !moves ? silent + 1 : 0;
        stable("AR", 0, t.arvalid, t.arready,
               (uint64_t)t.arid << 56 | (uint64_t)t.araddr << 8 | t.arlen);
        if (t.arvalid && t.arready) {
            unsigned beats = t.arlen + 1u;
            burst("AR", t.araddr, beats, sizeof t.rdata);
            uint64_t late =
                manner.latency + (random_.percent(manner.stall) ? random_.below(60) : 0);
            queue_.push_back({t.arid, t.araddr, beats, 0, clock_ + late, deaf()});
            requests++;
        }
        if (!offered_ || !t.rready) return;
        offered_ = false;
        answers++;
        Burst &b = queue_[shown_];
        if (++b.sent == b.beats) queue_.erase(queue_.begin() + (ptrdiff_t)shown_);
    }
    /* From now on what was never to be answered is. */
    void revive() {
        behave({});
        for (Burst &b : queue_)
            b.never = false;
    }

  private:
    struct Burst {
        uint8_t id;
        uint64_t address;
        unsigned beats, sent;
        uint64_t due;
        bool never;
    };
    size_t choose() {
        size_t i = 0;
        if (!random_.percent(manner.stall)) return i;
        const uint8_t id = queue_[random_.below(queue_.size())].id;
        while (queue_[i].id != id)
            i++;
        return i;
    }
    std::vector<uint8_t> &bytes_;
    bench::Random &random_;
    std::deque<Burst> queue_;
    bool offered_ = false;
    size_t shown_ = 0; /* the burst whose beat is offered */
    uint64_t clock_ = 0;
};

class WriteSide : public Channel {
  public:
    Manner manner;
    uint64_t requests = 0, answers = 0, beats = 0;
    std::map<uint64_t, uint8_t> *log = nullptr; /* takes what is written, in place of memory */

    WriteSide(std::vector<uint8_t> &bytes, bench::Random &random)
        : bytes_(bytes), random_(random) {}
    void behave(const Manner &m) {
        manner = m;
        requests = answers = beats = 0;
    }
    bool deaf() const { return manner.deaf_after >= 0 && (int64_t)requests >= manner.deaf_after; }
    void reset() {
        addresses_.clear();
        data_.clear();
        owed_.clear();
        offered_ = false;
        forget();
    }
    void revive() { behave({}); }
    template <class Top> void offer(Top &t) {
        clock_++;
        bool open = !in_reset && !(deaf() && manner.refuses);
        t.m_frame_awready =
            open && !(manner.aw_last && t.m_frame_wvalid) && !random_.percent(manner.stall);
        t.m_frame_wready = open && !random_.percent(manner.stall);
        bool may = !owed_.empty() && owed_.front() <= clock_ && !deaf();
        if (may && !offered_) offered_ = !random_.percent(manner.stall);
        t.m_frame_bvalid = offered_;
        t.m_frame_bresp = (uint8_t)(!offered_                             ? random_.below(4)
                                    : (int64_t)answers == manner.error_at ? (uint64_t)manner.error
                                                                          : (uint64_t)OKAY);
    }
    template <class Top> void take(Top &t) {
        if (in_reset) return;
        const bool w = t.m_frame_wvalid && t.m_frame_wready;
        const bool moves = t.m_frame_bvalid || w || (t.m_frame_awvalid && t.m_frame_awready);
        const bool owes =
            t.m_frame_awvalid || t.m_frame_wvalid || !addresses_.empty() || !owed_.empty();
        silent = owes && !moves ? silent + 1 : 0;
        stable("AW", 0, t.m_frame_awvalid, t.m_frame_awready,
               (uint64_t)t.m_frame_awaddr << 8 | t.m_frame_awlen);
        stable("W", 1, t.m_frame_wvalid, t.m_frame_wready,
               word64(t.m_frame_wdata, 0) ^ word64(t.m_frame_wdata, DATA / 64 - 1) << 1 ^
                   (uint64_t)t.m_frame_wstrb << 7 ^ t.m_frame_wlast);
        if (t.m_frame_awvalid && t.m_frame_awready) {
            burst("AW", t.m_frame_awaddr, t.m_frame_awlen + 1u, DATA / 8);
            addresses_.push_back({t.m_frame_awaddr, t.m_frame_awlen + 1u});
            requests++;
        }
        if (t.m_frame_wvalid && t.m_frame_wready) {
            data_.push_back({bench::get(t.m_frame_wdata), t.m_frame_wstrb, t.m_frame_wlast != 0});
            beats++;
        }
        if (offered_ && t.m_frame_bready) {
            offered_ = false;
            owed_.pop_front();
            answers++;
        }
        store();
    }

  private:
    struct Address {
        uint64_t address;
        unsigned beats;
    };
    struct Beat {
        bench::u128 data;
        uint32_t strobe;
        bool last;
    };
    /* Writes what has both its address and its data. */
    void store() {
        while (!addresses_.empty() && !data_.empty()) {
            Address &a = addresses_.front();
            const Beat &b = data_.front();
            for (unsigned i = 0; i < DATA / 8; i++)
                if (b.strobe >> i & 1)
                    (log ? (*log)[a.address + i] : bytes_[(a.address + i) % bytes_.size()]) =
                        (uint8_t)(b.data >> 8 * i);
            a.address += DATA / 8;
            a.beats--;
            if (b.last != (a.beats == 0)) fault("W", "has another number of beats than AWLEN");
            if (a.beats == 0) {
                addresses_.pop_front();
                uint64_t late = random_.percent(manner.stall) ? random_.below(60) : 0;
                owed_.push_back(clock_ + manner.latency + late);
            }
            data_.pop_front();
        }
    }
    std::vector<uint8_t> &bytes_;
    bench::Random &random_;
    std::deque<Address> addresses_;
    std::deque<Beat> data_;
    std::deque<uint64_t> owed_; /* clocks from which answers may come */
    bool offered_ = false;
    uint64_t clock_ = 0;
};

#endif
