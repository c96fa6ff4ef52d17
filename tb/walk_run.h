/* walk_run.h - windows, rectangles, spans and cones for tb_pixel_scan, and what they mean
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TB_WALK_RUN_H
#define SPH_TB_WALK_RUN_H

#include <algorithm>
#include <vector>

#include "bench.h"
#include "cone.h"

extern "C" {
#include "pixel/background.h"
}

namespace bench {

constexpr int COLUMN = 8, SIDE = 16383; /* pixels of a column's row; largest coordinate */
constexpr int FB = 2 * W + 2 * WD + 4, BB = W + WD + 4;
constexpr bool TABLES = SPANS || CONES;
constexpr int64_t MAX = ((int64_t)1 << (WD - 1)) - 1, MIN = -MAX - 1;

struct Run {
    int win[4], mode, rect[4]; /* x0, y0, x1, y1; the last two are one past the end */
    int64_t dir[3], pitch;
    int32_t turned[9];           /* TURNED: first, across, down; x, y, z each */
    uint32_t base, lines;        /* first line of the table; lines of memory */
    std::vector<uint32_t> words; /* of the table */
    std::vector<Ball> balls;     /* of cones; without: the record alone says what is hit */
    std::vector<Cone> cones;
    std::vector<uint32_t> image; /* a line, then the table: memory for the model */
    sph_machine m;

    uint32_t span_first() const { return base + (uint32_t)win[1] / 8; }
    bool table() const { return (SPANS && mode == 2) || (CONES && mode == 3); }
    uint32_t table_lines() const {
        return mode == 2 ? ((uint32_t)win[3] + 7) / 8 : 4 * (uint32_t)cones.size();
    }
    bool bad() const { return table() && (uint64_t)base + table_lines() > lines; }
    bool in_table(uint32_t line) const {
        return table() && !bad() && line >= (mode == 2 ? span_first() : base) &&
               line < base + table_lines();
    }
    uint32_t word(uint32_t line, uint32_t i) const {
        size_t at = 8 * (size_t)(line - base) + i;
        return at < words.size() ? words[at] : 0;
    }

    /* Not traced? By the contract, without the model. */
    bool background(int x, int y) const {
        if (mode == 1) return x < rect[0] || x >= rect[2] || y < rect[1] || y >= rect[3];
        if (mode == 0 || bad()) return false;
        if (mode == 2) {
            uint32_t span = words[(size_t)y];
            return (uint32_t)x < (span & 0xffff) || (uint32_t)x >= span >> 16;
        }
        for (size_t i = 0; i < cones.size(); i++) {
            bool hit = i < balls.size()
                           ? balls[i].f(x, y) > 0 && (balls[i].b(x, y) > 0 || balls[i].k > 0)
                           : cones[i].hit(x, y, FB, BB);
            if (hit) return false;
        }
        return true;
    }
    /* Whether memory is fast enough for a pixel a clock; clocks without one, at most. */
    bool fast(unsigned latency) const {
        bool whole = (win[2] - win[0]) % COLUMN == 0 && (win[1] | win[3]) % 8 == 0;
        return mode != 2 || !SPANS || bad() || (whole && latency < 40);
    }
    size_t pauses() const {
        size_t columns = (size_t)(win[2] - win[0] + COLUMN - 1) / COLUMN;
        return CONES ? 3 * columns : 0;
    }
    void print() const {
        const char *const names[] = {"x0", "y0", "x1", "y1"};
        for (int i = 0; i < 4; i++)
            printf("#   win_%s %d  rect_%s %d\n", names[i], win[i], names[i], rect[i]);
        printf("#   mode %d, %zu cones, %zu of spheres, table at %u of %u lines%s\n", mode,
               cones.size(), balls.size(), base, lines, bad() ? ": bad" : "");
        print_value("dir_x0_i", dir[0], WD);
        print_value("dir_y0_i", dir[1], WD);
        print_value("dir_z_i", dir[2], WD);
        for (int i = 0; TURNED && i < 9; i++)
            printf("#   %s[%d] %d\n",
                   i < 3   ? "first"
                   : i < 6 ? "across"
                           : "down",
                   i % 3, turned[i]);
        print_value("pitch_i", pitch, WD);
    }
    /* Registers and memory for the model, when all the rest is set. */
    void finish() {
        m = sph_machine();
        int32_t *g = m.regs;
        for (int i = 0; i < SPH_PROFILES; i++)
            if (sph_profiles[i].w == W && sph_profiles[i].wd == WD)
                sph_machine_set_profile(&m, &sph_profiles[i]);
        for (int i = 0; i < 4; i++)
            g[SPH_REG_WIN_X0 + i] = win[i], g[SPH_REG_RECT_X0 + i] = rect[i];
        for (int i = 0; i < 3; i++)
            g[SPH_REG_DIR_X0 + i] = TURNED ? turned[i] : (int32_t)dir[i];
        for (int i = 3; TURNED && i < 9; i++)
            g[SPH_REG_ACROSS_X + i - 3] = turned[i];
        g[SPH_REG_EFFECTS] = TURNED << SPH_EFFECT_TURNED;
        g[SPH_REG_PITCH] = (int32_t)pitch;
        g[SPH_REG_BG_MODE] = mode, g[SPH_REG_BG_COUNT] = (int32_t)cones.size();
        g[SPH_REG_BG_BASE] = 1, g[SPH_REG_MEM_LINES] = (int32_t)table_lines() + !bad();
        image.assign(8, 0);
        image.insert(image.end(), words.begin(), words.end());
        m.mem = image.data();
    }
};

/* Spans of the rows of a window: any, none, all, one pixel, around the middle. */
inline void make_spans(Random &random, Run &r) {
    int width = r.win[2] - r.win[0];
    r.words.resize(8 * (size_t)r.table_lines());
    for (uint32_t &word : r.words) {
        int x0 = r.win[0] + (int)random.between(-3, width + 3), x1 = x0 + (int)random.below(30);
        if (random.percent(10)) x1 = x0 - (int)random.below(3);
        if (random.percent(10))
            x0 = 0, x1 = random.percent(50) ? 0xffff : 1 << random.between(8, 15);
        if (random.percent(3)) x0 = (int)random.bits(16), x1 = (int)random.bits(16);
        word = (uint32_t)std::clamp(x1, 0, 0xffff) << 16 | (uint32_t)std::clamp(x0, 0, 0xffff);
    }
}

inline void make_cones(Random &random, Run &r) {
    bool real = random.percent(60) && r.win[2] <= 400 && r.win[3] <= 400;
    size_t count = random.percent(5) ? 0 : 1 + random.below(CONES ? CONES : 1);
    if (random.percent(50)) count = std::min(count, (size_t)2);
    int side = std::max(2, std::max(r.win[2], r.win[3]));
    for (size_t i = 0; i < count; i++) {
        if (real) r.balls.push_back(ball(random, W, WD, side));
        r.cones.push_back(real ? Cone::of(r.balls[i]) : Cone::any(random, FB, BB));
    }
    r.words.resize(32 * count);
    for (size_t i = 0; i < count; i++)
        r.cones[i].store(&r.words[32 * i]);
}

/* What a run's way needs besides its window; memory ends just behind the table, or in it. */
inline void make_table(Random &random, Run &r) {
    r.balls.clear();
    r.cones.clear();
    r.words.clear();
    r.base = (uint32_t)random.below(1 << 20);
    if (r.mode == 2) make_spans(random, r);
    if (r.mode == 3) make_cones(random, r);
    r.lines = r.base + r.table_lines() + (uint32_t)random.below(2);
    if (random.percent(5)) r.lines = r.base + r.table_lines() - 1;
    if (random.percent(5)) r.lines = (1u << 26) - 1, r.base = r.lines - r.table_lines();
    r.finish();
}

inline int make_mode(Random &random) {
    const bool built[4] = {true, RECT != 0, SPANS != 0, CONES != 0};
    int mode = (int)random.below(4);
    return built[mode] ? mode : RECT + SPANS + CONES == 0 ? 0 : make_mode(random);
}

inline int length(Random &random) {
    switch (random.below(4)) {
    case 0:
        return COLUMN * (int)random.between(1, 4);
    case 1:
        return 1 + (int)random.below(4) * (int)random.below(2);
    default:
        return (int)random.between(1, 40);
    }
}

inline Run make_run(Random &random) {
    Run r{};
    for (int i = 0; i < 2; i++) {
        int n = random.percent(2) ? -(int)random.below(3) : length(random);
        int first = (int)(random.percent(99) ? random.below(40) : random.mixed(14));
        if (random.percent(20)) first &= ~7;
        r.win[i] = std::max(first > SIDE - 40 ? SIDE - 40 - n : first, n < 0 ? -n : 0);
        r.win[i + 2] = r.win[i] + n;
        r.rect[i] = r.win[i] + (int)random.between(-8, 30);
        r.rect[i + 2] = r.rect[i] + (int)random.between(-2, 40);
        for (int k = i; k < 4; k += 2)
            r.rect[k] = std::clamp(r.rect[k], 0, SIDE);
        if (random.percent(5)) r.rect[i] = (int)random.bits(14);
        if (random.percent(5)) r.rect[i + 2] = (int)random.bits(14);
        r.dir[i] = random.smixed(WD);
    }
    r.dir[2] = random.smixed(WD);
    for (int32_t &word : r.turned)
        word = (int32_t)random.smixed(32);
    r.pitch = (int64_t)random.mixed(random.percent(50) ? WD : WD / 2);
    r.mode = make_mode(random);
    make_table(random, r);
    return r;
}

/* Windows and rectangles that tell right from nearly right; other ways take the windows. */
class Corners {
  public:
    bool left() const { return at < 4 * sizeof list / sizeof *list; }
    Run next(Random &random) {
        const Corner &c = list[at / 4];
        int mode = (int)(at++ % 4);
        const bool built[4] = {true, RECT != 0, SPANS != 0, CONES != 0};
        Run r{};
        std::copy(c.win, c.win + 4, r.win);
        std::copy(c.rect, c.rect + 4, r.rect);
        std::copy(c.dir, c.dir + 2, r.dir);
        r.pitch = c.pitch;
        r.mode = built[mode] ? mode : 0;
        make_table(random, r);
        return r;
    }

  private:
    struct Corner {
        int win[4], rect[4];
        int64_t dir[2], pitch;
    };
    static constexpr Corner list[] = {
        {{0, 0, 1, 1}, {0, 0, 0, 0}, {0, 0}, 0},         /* one pixel at 0: nothing to seek */
        {{SIDE - 1, 0, SIDE, 1}, {0}, {0, 0}, 1},        /* the longest way right */
        {{0, SIDE - 1, 1, SIDE}, {0}, {0, 0}, 1},        /* the longest way down */
        {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0}, 1},         /* empty: ends after set-up */
        {{5, 5, 5, 9}, {0, 0, 0, 0}, {0, 0}, 1},         /* no column */
        {{5, 5, 9, 5}, {0, 0, 0, 0}, {0, 0}, 1},         /* no row */
        {{9, 3, 5, 7}, {0, 0, 0, 0}, {0, 0}, 1},         /* columns end before they begin */
        {{3, 9, 7, 5}, {0, 0, 0, 0}, {0, 0}, 1},         /* rows end before they begin */
        {{0, 0, 8, 4}, {0, 0, 8, 4}, {-28, 14}, 7},      /* one whole column */
        {{3, 5, 19, 9}, {4, 6, 18, 8}, {-28, 14}, 7},    /* columns begin at the corner */
        {{0, 0, 9, 5}, {1, 1, 8, 4}, {-28, 14}, 7},      /* a second column of one pixel */
        {{0, 0, 7, 3}, {0, 0, 0, 0}, {-28, 14}, 7},      /* less than a column */
        {{0, 0, 1, 13}, {0, 2, 1, 3}, {1, 1}, 3},        /* one pixel wide: down every cycle */
        {{0, 0, 25, 1}, {8, 0, 9, 1}, {1, 1}, 3},        /* one row */
        {{1, 1, 25, 3}, {8, 1, 9, 2}, {1, 1}, 3},        /* two: the last is not the first */
        {{0, 6, 16, 9}, {0, 8, 16, 9}, {1, 1}, 3},       /* rows of two lines of spans */
        {{0, 0, 24, 12}, {0, 0, 24, 12}, {MIN, MAX}, 1}, /* rectangle is the window */
        {{0, 0, 24, 12}, {8, 4, 16, 8}, {MAX, MIN}, 1},  /* inside a column; dir wraps */
        {{0, 0, 24, 12}, {7, 3, 17, 9}, {0, 0}, 1},      /* one pixel into those around */
        {{0, 0, 24, 12}, {10, 6, 11, 7}, {0, 0}, 1},     /* one pixel is traced */
        {{0, 0, 24, 12}, {24, 0, 40, 12}, {0, 0}, 1},    /* just right of the window */
        {{8, 4, 24, 12}, {0, 0, 8, 4}, {0, 0}, 1},       /* ends where the window begins */
        {{0, 0, 24, 12}, {12, 6, 12, 9}, {0, 0}, 1},     /* empty: all is background */
        {{0, 0, 24, 12}, {12, 9, 20, 6}, {0, 0}, 1},     /* turned round: empty too */
        {{0, 0, 24, 12}, {0, 0, SIDE, SIDE}, {0, 0}, 1}, /* larger than the window */
        {{0, 0, 24, 90}, {0, 0, 0, 0}, {MIN, MAX}, 2 * MAX + 1}, /* widest pitch; many spans */
    };
    size_t at = 0;
};

} // namespace bench

#endif
