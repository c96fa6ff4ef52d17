/* tb_pixel_scan.cpp - rt_pixel_scan, all ways of background separation, against a walk by columns
 * SPDX-License-Identifier: Apache-2.0
 *
 * Directions: sph_primary_dir(). Which pixels are traced: the contract's formula (tb/cone.h), for
 * spheres their discriminant and projection, evaluated at each pixel; and sph_is_background().
 * Tables come from a memory that answers in order, some time later, with and without a stall.
 */
#include "walk_memory.h"

#include "Vrt_pixel_scan.h"

namespace {

using bench::Run;
using bench::WalkMemory;

struct Pixel {
    int x, y;
};

/* Every pixel of the window, column by column. */
std::vector<Pixel> walk(const int win[4]) {
    std::vector<Pixel> pixels;
    for (int left = win[0]; left < win[2]; left += bench::COLUMN)
        for (int y = win[1]; y < win[3]; y++)
            for (int x = left; x < left + bench::COLUMN && x < win[2]; x++)
                pixels.push_back({x, y});
    return pixels;
}

/* The unit, its memory, and the run of the registers that it makes. */
class Walk {
  public:
    Walk(int argc, char **argv) : b("tb_pixel_scan", argc, argv) {
        b.dut.start_i = 0;
        b.dut.mem_rsp_valid_i = 0;
        b.reset();
    }
    bool next() { /* a run of the unit; false at the end */
        if (!b.more()) return false;
        long wrong = b.mismatches;
        start();
        size_t stop = b.random.percent(2) ? b.random.below(pixels.size() + 1) : pixels.size();
        for (size_t i = 0; i < stop && b.mismatches == wrong; i++) {
            pixel(i);
            done();
        }
        finish_run(stop == pixels.size() && b.mismatches == wrong);
        return true;
    }
    int finish() { return b.finish(); }

  private:
    bench::Bench<Vrt_pixel_scan> b;
    bench::Corners corners;
    WalkMemory mem{};
    Run r{};
    std::vector<Pixel> pixels;
    uint64_t first = 0;                       /* clock of the first pixel */
    unsigned ray_ready = 100, bg_ready = 100; /* percent of clocks */
    long bad_tables = 0, bus_errors = 0;

    /* Inputs of a clock. */
    void ready() {
        b.dut.ray_ready_i = b.random.percent(ray_ready);
        b.dut.bg_ready_i = b.random.percent(bg_ready);
        b.dut.mem_req_ready_i = b.random.percent(mem.ready);
        bool there = mem.there(b.cycle);
        b.dut.mem_rsp_valid_i = there;
        b.dut.mem_rsp_error_i = there && mem.error();
        for (uint32_t i = 0; i < 8; i++)
            b.dut.mem_rsp_data_i[i] = there && !b.dut.mem_rsp_error_i
                                          ? r.word(mem.way.front().line, i)
                                          : (uint32_t)b.random.next();
        b.settle();
    }

    /* What memory takes and gives in the clock. */
    void tick() {
        uint32_t line = b.dut.mem_req_valid_o ? (uint32_t)b.dut.mem_req_line_o : WalkMemory::NONE;
        const char *wrong = mem.ask(b.random, r, line, b.dut.mem_req_ready_i, b.cycle);
        if (wrong) b.fail(wrong);
        if (b.dut.mem_rsp_valid_i && b.dut.mem_rsp_ready_o) mem.way.pop_front();
        bad_tables += b.dut.bad_table_o;
        bus_errors += b.dut.bus_error_o;
        b.tick();
    }

    void done() {
        if (b.bad()) r.print();
        b.done();
    }

    void quiet(int busy) {
        b.expect("busy_o", b.dut.busy_o, busy);
        b.expect("ray_valid_o", b.dut.ray_valid_o, 0);
        b.expect("bg_valid_o", b.dut.bg_valid_o, 0);
    }

    /* Registers, and the clocks before the first pixel. */
    void start() {
        first = 0;
        r = corners.left() ? corners.next(b.random) : bench::make_run(b.random);
        ray_ready = (unsigned)b.random.below(3) * 45 + 10;
        bg_ready = (unsigned)b.random.below(3) * 45 + 10;
        mem.begin(b.random, r.table() && b.random.percent(5));
        bad_tables = bus_errors = 0;
        load(b.dut, r);
        bench::set(b.dut.dir_x0_i, WD, r.dir[0]);
        bench::set(b.dut.dir_y0_i, WD, r.dir[1]);
        bench::set(b.dut.dir_z_i, WD, r.dir[2]);
        b.dut.start_i = 1;
        ready();
        tick();
        b.dut.start_i = 0;
        pixels = walk(r.win);
        int seek = r.win[1] + (pixels.empty() ? 0 : r.win[0] + 2); /* clocks without a pixel */
        for (int i = 0; i <= seek; i++) {
            ready();
            quiet(1);
            tick();
        }
    }

    void pixel(size_t i) {
        int x = pixels[i].x, y = pixels[i].y;
        int64_t dir[3];
        sph_primary_dir(&r.m, x, y, dir);
        bool background = r.background(x, y), taken = false;
        b.expect("sph_is_background()", sph_is_background(&r.m, x, y), background);
        for (uint64_t since = b.cycle; !taken;) { /* what is offered stays until it is taken */
            ready();
            bool offered = b.dut.ray_valid_o || b.dut.bg_valid_o;
            b.expect("busy_o", b.dut.busy_o, 1);
            if (!offered && bench::TABLES && b.cycle - since < 20000) {
                tick();
                continue;
            }
            if (mem.error_at >= 0) background = b.dut.bg_valid_o; /* whatever picture */
            b.expect("ray_valid_o", b.dut.ray_valid_o, !background);
            b.expect("bg_valid_o", b.dut.bg_valid_o, background);
            b.expect("x_o", b.get(b.dut.x_o), x, 14);
            b.expect("y_o", b.get(b.dut.y_o), y, 14);
            b.expect("ray_dir_x_o", b.sget(b.dut.ray_dir_x_o, WD),
                     bench::sign((bench::u128)dir[0], WD), WD);
            b.expect("ray_dir_y_o", b.sget(b.dut.ray_dir_y_o, WD),
                     bench::sign((bench::u128)dir[1], WD), WD);
            b.expect("ray_dir_z_o", b.sget(b.dut.ray_dir_z_o, WD),
                     bench::sign((bench::u128)dir[2], WD), WD);
            if (i == 0) first = b.cycle;
            taken = (background ? b.dut.bg_ready_i : b.dut.ray_ready_i) || !offered;
            tick();
        }
    }

    void finish_run(bool whole) {
        if (whole && !pixels.empty() && ray_ready == 100 && bg_ready == 100 && r.fast(mem.latency))
            b.expect("clocks at most", b.cycle - first <= pixels.size() + r.pauses(), 1);
        for (uint64_t since = b.cycle; whole && b.dut.busy_o && b.cycle - since < 20000;) {
            ready(); /* an empty window ends when its cones are there */
            quiet(1);
            b.expect("pixels left", pixels.size(), 0);
            tick();
        }
        if (whole) {
            b.expect("lines on their way", (int)mem.way.size(), 0);
            b.expect("bad_table_o", bad_tables, r.bad());
            b.expect("bus_error_o", bus_errors, mem.error_at >= 0 && mem.lines > mem.error_at);
        } else { /* in the middle */
            mem.begin(b.random, false);
            b.dut.mem_rsp_valid_i = 0;
            b.reset();
        }
        for (uint64_t i = b.random.below(3); i > 0; i--) {
            ready();
            quiet(0);
            tick();
        }
        ready();
        quiet(0);
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Walk walk(argc, argv);
    while (walk.next())
        ;
    return walk.finish();
}
