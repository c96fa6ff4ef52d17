/* tb_walk.cpp - rt_walk against a walk by columns, sph_primary_dir() and sph_is_background()
 * SPDX-License-Identifier: Apache-2.0
 */
#include <vector>

#include "Vrt_walk.h"
#include "bench.h"

extern "C" {
#include "pixel/walk.h"
}

namespace {

constexpr int COLUMN = 8, SIDE = 16383; /* pixels of a column's row; largest coordinate */

struct Run {
    int win[4], rect_on, rect[4]; /* x0, y0, x1, y1; the last two are one past the end */
    int64_t dir[2], pitch;
};

struct Pixel {
    int x, y;
};

constexpr int64_t MAX = ((int64_t)1 << (WD - 1)) - 1, MIN = -MAX - 1;
const Run corners[] = {
    {{0, 0, 1, 1}, 0, {0, 0, 0, 0}, {0, 0}, 0},         /* one pixel at 0: nothing to seek */
    {{SIDE - 1, 0, SIDE, 1}, 0, {0}, {0, 0}, 1},        /* the longest way right */
    {{0, SIDE - 1, 1, SIDE}, 0, {0}, {0, 0}, 1},        /* the longest way down */
    {{0, 0, 0, 0}, 0, {0, 0, 0, 0}, {0, 0}, 1},         /* empty: ends after set-up */
    {{5, 5, 5, 9}, 0, {0, 0, 0, 0}, {0, 0}, 1},         /* no column */
    {{5, 5, 9, 5}, 0, {0, 0, 0, 0}, {0, 0}, 1},         /* no row */
    {{9, 3, 5, 7}, 0, {0, 0, 0, 0}, {0, 0}, 1},         /* columns end before they begin */
    {{3, 9, 7, 5}, 0, {0, 0, 0, 0}, {0, 0}, 1},         /* rows end before they begin */
    {{0, 0, 8, 4}, 0, {0, 0, 0, 0}, {-28, 14}, 7},      /* one whole column */
    {{3, 5, 19, 9}, 0, {0, 0, 0, 0}, {-28, 14}, 7},     /* columns begin at the window's corner */
    {{0, 0, 9, 5}, 0, {0, 0, 0, 0}, {-28, 14}, 7},      /* a second column of one pixel */
    {{0, 0, 7, 3}, 0, {0, 0, 0, 0}, {-28, 14}, 7},      /* less than a column */
    {{0, 0, 1, 13}, 0, {0, 0, 0, 0}, {1, 1}, 3},        /* one pixel wide: down every cycle */
    {{0, 0, 25, 1}, 0, {0, 0, 0, 0}, {1, 1}, 3},        /* one row */
    {{1, 1, 25, 3}, 0, {0, 0, 0, 0}, {1, 1}, 3},        /* two rows: the last is not the first */
    {{0, 0, 24, 12}, 1, {0, 0, 24, 12}, {MIN, MAX}, 1}, /* rectangle is the window */
    {{0, 0, 24, 12}, 1, {8, 4, 16, 8}, {MAX, MIN}, 1},  /* inside a column; dir wraps */
    {{0, 0, 24, 12}, 1, {7, 3, 17, 9}, {0, 0}, 1},      /* one pixel into the columns around */
    {{0, 0, 24, 12}, 1, {10, 6, 11, 7}, {0, 0}, 1},     /* one pixel is traced */
    {{0, 0, 24, 12}, 1, {24, 0, 40, 12}, {0, 0}, 1},    /* rectangle just right of the window */
    {{8, 4, 24, 12}, 1, {0, 0, 8, 4}, {0, 0}, 1},       /* it ends where the window begins */
    {{0, 0, 24, 12}, 1, {12, 6, 12, 9}, {0, 0}, 1},     /* empty: all is background */
    {{0, 0, 24, 12}, 1, {12, 9, 20, 6}, {0, 0}, 1},     /* turned round: empty too */
    {{0, 0, 24, 12}, 1, {0, 0, SIDE, SIDE}, {0, 0}, 1}, /* larger than the window */
    {{0, 0, 24, 12}, 0, {8, 4, 16, 8}, {0, 0}, 1},      /* switched off: all is traced */
    {{0, 0, 24, 12}, 0, {0, 0, 0, 0}, {MIN, MAX}, 2 * MAX + 1}, /* widest pitch */
};

int length(bench::Random &random, int whole) {
    switch (random.below(4)) {
    case 0:
        return whole * (int)random.between(1, 4);
    case 1:
        return 1 + (int)random.below(4) * (int)random.below(2);
    default:
        return (int)random.between(1, 40);
    }
}

Run make(bench::Random &random) {
    Run r{};
    for (int i = 0; i < 2; i++) {
        int n = random.percent(2) ? -(int)random.below(3) : length(random, COLUMN);
        int first = (int)(random.percent(99) ? random.below(40) : random.mixed(14));
        r.win[i] = first > SIDE - 40 ? SIDE - 40 - n : first + 2;
        r.win[i + 2] = r.win[i] + n;
        r.rect[i] = r.win[i] + (int)random.between(-8, 30);
        r.rect[i + 2] = r.rect[i] + (int)random.between(-2, 40);
        for (int k = i; k < 4; k += 2)
            r.rect[k] = r.rect[k] < 0 ? 0 : r.rect[k] > SIDE ? SIDE : r.rect[k];
        if (random.percent(5)) r.rect[i] = (int)random.bits(14);
        if (random.percent(5)) r.rect[i + 2] = (int)random.bits(14);
        r.dir[i] = random.smixed(WD);
    }
    r.rect_on = !random.percent(25);
    r.pitch = (int64_t)random.mixed(random.percent(50) ? WD : WD / 2);
    return r;
}

/* Every pixel of the window, column by column. */
std::vector<Pixel> walk(const int win[4]) {
    std::vector<Pixel> pixels;
    for (int left = win[0]; left < win[2]; left += COLUMN)
        for (int y = win[1]; y < win[3]; y++)
            for (int x = left; x < left + COLUMN && x < win[2]; x++)
                pixels.push_back({x, y});
    return pixels;
}

void load(Vrt_walk &dut, struct sph_machine &m, const Run &r) {
    bench::set(dut.win_x0_i, 14, m.regs[SPH_REG_WIN_X0] = r.win[0]);
    bench::set(dut.win_y0_i, 14, m.regs[SPH_REG_WIN_Y0] = r.win[1]);
    bench::set(dut.win_x1_i, 14, m.regs[SPH_REG_WIN_X1] = r.win[2]);
    bench::set(dut.win_y1_i, 14, m.regs[SPH_REG_WIN_Y1] = r.win[3]);
    bench::set(dut.rect_on_i, 1, m.regs[SPH_REG_BG_MODE] = r.rect_on);
    bench::set(dut.rect_x0_i, 14, m.regs[SPH_REG_RECT_X0] = r.rect[0]);
    bench::set(dut.rect_y0_i, 14, m.regs[SPH_REG_RECT_Y0] = r.rect[1]);
    bench::set(dut.rect_x1_i, 14, m.regs[SPH_REG_RECT_X1] = r.rect[2]);
    bench::set(dut.rect_y1_i, 14, m.regs[SPH_REG_RECT_Y1] = r.rect[3]);
    bench::set(dut.dir_x0_i, WD, m.regs[SPH_REG_DIR_X0] = (int32_t)r.dir[0]);
    bench::set(dut.dir_y0_i, WD, m.regs[SPH_REG_DIR_Y0] = (int32_t)r.dir[1]);
    bench::set(dut.pitch_i, WD, m.regs[SPH_REG_PITCH] = (int32_t)r.pitch);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_walk> b("tb_walk", argc, argv);
    struct sph_machine m = {};
    size_t corner = 0;
    unsigned ray_ready = 100, bg_ready = 100; /* percent of clocks */
    Run r{};
    auto ready = [&] {
        b.dut.ray_ready_i = b.random.percent(ray_ready);
        b.dut.bg_ready_i = b.random.percent(bg_ready);
        b.settle();
    };
    auto done = [&] {
        if (b.bad()) {
            const char *const names[] = {"x0", "y0", "x1", "y1"};
            for (int i = 0; i < 4; i++)
                printf("#   win_%s %d  rect_%s %d\n", names[i], r.win[i], names[i], r.rect[i]);
            b.show("rect_on_i", r.rect_on, 1);
            b.show("dir_x0_i", r.dir[0], WD);
            b.show("dir_y0_i", r.dir[1], WD);
            b.show("pitch_i", r.pitch, WD);
        }
        b.done();
    };
    auto quiet = [&](int busy) {
        b.expect("busy_o", b.dut.busy_o, busy);
        b.expect("ray_valid_o", b.dut.ray_valid_o, 0);
        b.expect("bg_valid_o", b.dut.bg_valid_o, 0);
    };
    b.dut.start_i = 0;
    b.reset();
    while (b.more()) {
        long wrong = b.mismatches;
        r = corner < sizeof corners / sizeof *corners ? corners[corner++] : make(b.random);
        ray_ready = (unsigned)b.random.below(3) * 45 + 10;
        bg_ready = (unsigned)b.random.below(3) * 45 + 10;
        load(b.dut, m, r);
        b.dut.start_i = 1;
        b.tick();
        b.dut.start_i = 0;
        std::vector<Pixel> pixels = walk(r.win);
        int seek = r.win[1] + (pixels.empty() ? 0 : r.win[0] + 1); /* clocks without a pixel */
        for (int i = 0; i <= seek; i++) {
            ready();
            quiet(1);
            b.tick();
        }
        size_t stop = b.random.percent(2) ? b.random.below(pixels.size() + 1) : pixels.size();
        for (size_t i = 0; i < stop && b.mismatches == wrong; i++) {
            int64_t dir[3];
            sph_primary_dir(&m, pixels[i].x, pixels[i].y, dir);
            bool background = sph_is_background(&m, pixels[i].x, pixels[i].y), taken = false;
            while (!taken) { /* what is offered stays as it is until it is taken */
                ready();
                b.expect("busy_o", b.dut.busy_o, 1);
                b.expect("ray_valid_o", b.dut.ray_valid_o, !background);
                b.expect("bg_valid_o", b.dut.bg_valid_o, background);
                b.expect("x_o", b.get(b.dut.x_o), pixels[i].x, 14);
                b.expect("y_o", b.get(b.dut.y_o), pixels[i].y, 14);
                b.expect("ray_dir_x_o", b.sget(b.dut.ray_dir_x_o, WD),
                         bench::sign((bench::u128)dir[0], WD), WD);
                b.expect("ray_dir_y_o", b.sget(b.dut.ray_dir_y_o, WD),
                         bench::sign((bench::u128)dir[1], WD), WD);
                taken = background ? b.dut.bg_ready_i : b.dut.ray_ready_i;
                b.tick();
            }
            done();
        }
        if (stop < pixels.size() || b.mismatches != wrong) b.reset(); /* in the middle */
        for (uint64_t i = b.random.below(3); i > 0; i--) {
            ready();
            quiet(0);
            b.tick();
        }
        ready();
        quiet(0);
        done();
    }
    return b.finish();
}
