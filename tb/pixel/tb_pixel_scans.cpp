/* tb_pixel_scans.cpp - rt_pixel_scans, one walk or two, against walks of the window's halves
 * SPDX-License-Identifier: Apache-2.0
 *
 * Pixels of a walk come in its order, traced ones apart from those of the background, and each has
 * the direction that sph_primary_dir() says; whose is next is left to the unit, but where all
 * pixels of a window are of one kind and no table is read, walks take turns. A vector is a clock.
 */
#include "walk_memory.h"

#include "Vrt_pixel_scans.h"
#include "bundles.h"

namespace {

using bench::Run;
using bench::WalkMemory;

struct Pixel {
    int x, y;
};

constexpr uint64_t STARTED = 30; /* clocks to the first pixel, besides those to its place */
constexpr int IN_A_ROW = 8;      /* pixels of a walk while the other one has some, at most */

/* The unit, its memories, and the run of the registers that it makes. */
class Walks {
  public:
    Walks(int argc, char **argv) : b("tb_pixel_scans", argc, argv, 200000), t(b.dut) {
        t.start_i = t.mem_rsp_valid_i = 0;
        b.reset();
    }
    bool next() { /* a run of the unit; false at the end */
        if (!b.more()) return false;
        long wrong = b.mismatches;
        start();
        uint64_t since = b.cycle;
        while ((left() || t.busy_o) && b.mismatches == wrong) {
            size_t before = left();
            clock();
            if (left() < before) since = b.cycle;
            if (b.cycle - since > 40000) b.fail("a pixel that never comes");
            done();
        }
        for (int i = 0; i < WALKS && b.mismatches == wrong; i++)
            b.expect("lines on their way", (int)mem[i].way.size(), 0);
        b.expect("bad_table_o", tables, r.bad());
        if (b.mismatches != wrong) b.reset();
        done();
        return true;
    }
    int finish() { return b.finish(); }

  private:
    bench::Bench<Vrt_pixel_scans> b;
    Vrt_pixel_scans &t;
    bench::Corners corners;
    WalkMemory mem[WALKS]{};
    Run r{};
    std::deque<Pixel> traced[WALKS], background[WALKS];
    unsigned ray_ready = 100, bg_ready = 100; /* percent of clocks */
    int tables = 0;                           /* clocks with bad_table_o */
    uint64_t turns = 0;                       /* the cycle from which on walks take turns */
    int latest = 0, row = 0;                  /* the walk of the latest pixel; so many of it */

    size_t left() const {
        size_t n = 0;
        for (int i = 0; i < WALKS; i++)
            n += traced[i].size() + background[i].size();
        return n;
    }

    void done() {
        if (b.bad()) r.print();
        b.done();
    }

    void start() {
        r = corners.left() ? corners.next(b.random) : bench::make_run(b.random);
        ray_ready = (unsigned)b.random.below(3) * 45 + 10;
        bg_ready = (unsigned)b.random.below(3) * 45 + 10;
        load(t, r);
        for (int i = 0; i < 3; i++)
            bench::put(t.dir_i, i * WD, WD, (bench::i128)r.dir[i]);
        for (int i = 0; i < WALKS; i++) {
            mem[i].begin(b.random, false);
            traced[i].clear();
            background[i].clear();
        }
        const int middle = (r.win[0] + r.win[2] + 1) / 2, ends[3] = {r.win[0], middle, r.win[2]};
        for (int i = 0; i < WALKS; i++)
            for (int left = ends[i], end = WALKS == 1 ? r.win[2] : ends[i + 1]; left < end;
                 left += bench::COLUMN)
                for (int y = r.win[1]; y < r.win[3]; y++)
                    for (int x = left; x < end && x < left + bench::COLUMN; x++)
                        (r.background(x, y) ? background : traced)[i].push_back({x, y});
        tables = 0, row = 0;
        bool mixed = WALKS == 1;
        for (const auto &a : traced)
            for (const auto &c : background)
                mixed = mixed || (!a.empty() && !c.empty());
        turns =
            mixed || r.mode > 1 ? UINT64_MAX : b.cycle + (uint64_t)(r.win[1] + r.win[2]) + STARTED;
        t.start_i = 1;
        clock();
        t.start_i = 0;
    }

    void clock() {
        t.ray_ready_i = b.random.percent(ray_ready);
        t.bg_ready_i = b.random.percent(bg_ready);
        t.mem_req_ready_i = t.mem_rsp_valid_i = 0;
        int from = (int)b.random.below(WALKS); /* one answer a clock */
        for (int k = 0; k < WALKS; k++) {
            int i = (from + k) % WALKS;
            bench::put(t.mem_req_ready_i, i, 1, b.random.percent(mem[i].ready));
            if (t.mem_rsp_valid_i || !mem[i].there(b.cycle)) continue;
            bench::put(t.mem_rsp_valid_i, i, 1, 1);
            for (uint32_t w = 0; w < 8; w++)
                t.mem_rsp_data_i[w] = r.word(mem[i].way.front().line, w);
        }
        t.mem_rsp_error_i = 0;
        b.settle();
        if (t.ray_valid_o && t.ray_ready_i) take_ray();
        if (t.bg_valid_o && t.bg_ready_i)
            take(background, (int)t.bg_place_o & 0x3fff, (int)t.bg_place_o >> 14 & 0x3fff);
        if ((t.ray_valid_o || t.bg_valid_o) && !t.busy_o) b.fail("a pixel of an idle unit");
        tables += t.bad_table_o;
        b.expect("bus_error_o", t.bus_error_o, 0);
        for (int i = 0; i < WALKS; i++) {
            bool asks = bench::get(t.mem_req_valid_o, i, 1) != 0;
            uint32_t line =
                asks ? (uint32_t)bench::get(t.mem_req_line_o, 26 * i, 26) : WalkMemory::NONE;
            const char *wrong =
                mem[i].ask(b.random, r, line, bench::get(t.mem_req_ready_i, i, 1) != 0, b.cycle);
            if (wrong) b.fail(wrong);
            if (bench::get(t.mem_rsp_valid_i, i, 1) && bench::get(t.mem_rsp_ready_o, i, 1))
                mem[i].way.pop_front();
        }
        b.tick();
    }

    /* The next pixel of a walk. */
    void take(std::deque<Pixel> *of, int x, int y) {
        for (int i = 0; i < WALKS; i++) {
            if (of[i].empty() || of[i].front().x != x || of[i].front().y != y) continue;
            row = i == latest && b.cycle > turns ? row + 1 : 1;
            latest = i;
            of[i].pop_front();
            if (row > IN_A_ROW && !of[WALKS - 1 - i].empty())
                b.fail("a walk waits for longer than its turn");
            return;
        }
        b.fail("a pixel that is not the next one of a walk");
    }

    void take_ray() {
        int x = (int)bench::get(t.ray_o, RT_START_X), y = (int)bench::get(t.ray_o, RT_START_Y);
        take(traced, x, y);
        int64_t dir[3];
        sph_primary_dir(&r.m, x, y, dir);
        for (int i = 0; i < 3; i++)
            b.expect("DIR of ray_o", bench::get(t.ray_o, 28 + i * WD, WD),
                     (bench::i128)bench::low((bench::u128)dir[i], WD), WD);
    }
};

} // namespace

int main(int argc, char **argv) {
    Walks walks(argc, argv);
    while (walks.next())
        ;
    return walks.finish();
}
