/* tb_frames.cpp - frames of a moving scene, one behind the other on one rt_top, without a reset
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_frames LATENCY STALL SEED TREE FOLDER MACHINE.sph...
 *
 * FOLDER gets frames.tsv, the clocks of each frame, and what the frame store held: shown-0000.ppm,
 * of an rt_top with layers each of them too: rendering-0000.ppm, l1-0000.ppm, l2-0000.ppm.
 *
 * While a frame is drawn the driver writes the next machine to the other half of memory, a beat a
 * clock, and its registers. Every frame is compared with what the golden model draws of that
 * machine alone.
 *
 * To an rt_top with BUILD it writes lines of records that moved, and has the tree built meanwhile;
 * the machines are of that TREE, hw, hw1 or hw2, and what their frames count must be the same,
 * too.
 */
#include "top_checks.h"

#include <cmath>
#include <memory>
extern "C" {
#include "build/build_tree.h"
#include "tests/number.h"
}

static const uint32_t HALF[2] = {0, 0x01000000};

static const char *const LAYERS[SPH_FRAMES] = {"rendering", "l1", "l2"};

/* Memory as a processor writes it: a beat in each clock. */
static void put(void *user, uint64_t address, const uint8_t *from, uint32_t count) {
    auto &top = *static_cast<TopHost *>(user);
    for (uint32_t at = 0; at < count; at += DATA / 8) {
        uint32_t n = count - at < DATA / 8 ? count - at : DATA / 8;
        memcpy(&top.bytes[(address + at) % TopHost::MEMORY], from + at, n);
        top.clock();
    }
}

/* A byte of linear light as people see it (IEC 61966-2-1). */
static uint8_t coded(uint32_t byte) {
    double light = byte / 255.0;
    double code = light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
    return (uint8_t)lround(255 * code);
}

/* A frame of the store, as a picture. */
static bool picture(Checks &c, const sph_frame &size, uint64_t store, const std::string &path) {
    FILE *to = fopen(path.c_str(), "wb");
    if (!to) return false;
    fprintf(to, "P6 %d %d 255\n", size.width, size.height);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++) {
            const uint8_t *p = &c.top.bytes[(store + (uint32_t)y * c.stride) % TopHost::MEMORY];
            for (int channel = 2; channel >= 0; channel--)
                fputc(coded(p[4 * x + channel]), to);
        }
    return fclose(to) == 0;
}

/* What is shown of the newest frame, and its layers. */
static void pictures(Checks &c, const Golden &golden, const std::string &folder, int number) {
    const unsigned newest = c.newest();
    const auto write = [&](const char *what, uint32_t place) {
        char name[32];
        snprintf(name, sizeof name, "/%s-%04d.ppm", what, number);
        c.note("a picture is written", picture(c, golden.frame, place, folder + name));
    };
    write("shown", c.place(golden, newest));
    for (uint32_t layer = 0; c.layers && layer < std::size(LAYERS); layer++)
        write(LAYERS[layer], c.stores[newest] + layer * c.apart);
}

/* Machines whose trees rt_top builds: where in memory a frame's records lie, in turn. Lines:
 *     0 noise | PRIM_BASE records, more | lines: tree | tree | records | background, as in the file
 */
class Moving {
  public:
    Moving(Checks &c, std::shared_ptr<Golden> first, const std::string &tree)
        : c_(c), n_(reg(*first, SPH_REG_N_PRIMS)), prims_(reg(*first, SPH_REG_PRIM_BASE)),
          lines_(first->machine.lines), all_(first), lies_{first, nullptr} {
        const bool tables = reg(*first, SPH_REG_BG_MODE) >= 2; /* spans, cones */
        const uint32_t room = (uint32_t)sph_bt_lines(n_);
        ground_ = tables ? reg(*first, SPH_REG_BG_BASE) : lines_;
        records_[0] = prims_, records_[1] = lines_ + 2 * room;
        grounds_[0] = ground_, grounds_[1] = records_[1] + n_;
        trees_ = {n_, 0, {lines_, lines_ + room}, room, 0, 0};
        if (tree.size() == 3) trees_.rounds = (unsigned)(tree[2] - '0');
    }
    /* Loads the first machine; its own tree is gone. */
    uint32_t first(uint32_t base) {
        base_ = HIGH_SCENE + base;
        c_.equals("load", (uint64_t)c_.load(*all_, base), SPHAERA_OK);
        for (uint32_t i = 0; i < 32 * prims_; i++)
            c_.top.bytes[(base_ + i) % TopHost::MEMORY] = (uint8_t)c_.top.random.next();
        registers(*all_, 0);
        return 32 * lines_;
    }
    /* Writes what is new of the machine of frame `number`; returns bytes. */
    uint32_t move(std::shared_ptr<Golden> to, int number) {
        const int at = number % 2;
        uint32_t put = 0;
        c_.note("a moving machine has the same size, textures and spheres",
                to->machine.lines == lines_ && reg(*to, SPH_REG_N_PRIMS) == n_ &&
                    reg(*to, SPH_REG_PRIM_BASE) == prims_ &&
                    !memcmp(bytes(*to, prims_ + n_), bytes(*all_, prims_ + n_),
                            32 * (ground_ - prims_ - n_)));
        part(at, *to, prims_, n_, records_[at], &put);
        part(at, *to, ground_, lines_ - ground_, grounds_[at], &put);
        lies_[at] = to;
        registers(*to, at);
        return 32 * put;
    }
    /* The tree of what was written; clocks that it took. */
    uint32_t build() {
        c_.equals("build", (uint64_t)sphaera_build(&c_.top.driver, 0), SPHAERA_OK);
        c_.equals("built", (uint64_t)sphaera_build_wait(&c_.top.driver, LIMIT), SPHAERA_OK);
        return c_.top.read(SPHAERA_BUILD_CLOCKS);
    }
    /* Whether all of it is below that many bytes. */
    bool fits(uint32_t room) const { return 32ull * all_lines() <= room; }

  private:
    static uint32_t reg(const Golden &of, int number) { return (uint32_t)of.machine.regs[number]; }
    static const uint8_t *bytes(const Golden &of, uint32_t line) {
        return (const uint8_t *)of.machine.mem + 32 * (size_t)line;
    }
    uint32_t all_lines() const { return grounds_[1] + lines_ - ground_; }
    void part(int at, const Golden &to, uint32_t from, uint32_t count, uint32_t place,
              uint32_t *put) {
        const uint64_t address = base_ + 32 * (uint64_t)place;
        if (lies_[at])
            return sphaera_move(&c_.top.driver, bytes(*lies_[at], from), bytes(to, from), count,
                                address, put);
        c_.top.driver.bus.put(&c_.top, address, bytes(to, from), 32 * count);
        *put += count;
    }
    void registers(const Golden &to, int at) {
        for (uint32_t i = 0; i < SPHAERA_MACHINE_REGISTERS; i++) {
            uint32_t value = reg(to, (int)i);
            if (i == SPH_REG_PRIM_BASE) value = records_[at];
            if (i == SPH_REG_BG_BASE && ground_ < lines_) value = grounds_[at];
            if (i == SPH_REG_MEM_LINES) value = all_lines();
            if (set_ && value == set_values_[i]) continue;
            sphaera_set(&c_.top.driver, i, set_values_[i] = value);
        }
        set_ = true;
        trees_.records = records_[at];
        c_.equals("trees", (uint64_t)sphaera_trees(&c_.top.driver, &trees_), SPHAERA_OK);
    }
    Checks &c_;
    uint32_t n_, prims_, lines_, ground_, records_[2], grounds_[2];
    struct sphaera_trees trees_;
    uint64_t base_ = 0;
    std::shared_ptr<Golden> all_, lies_[2]; /* whose records lie there */
    bool set_ = false;
    uint32_t set_values_[SPHAERA_MACHINE_REGISTERS] = {};
};

/* What a machine costs before its frame: clocks of its upload, bytes; clocks of its tree. */
struct Given {
    uint64_t clocks;
    uint32_t bytes, build;
};

/* Gives rt_top the machine of frame `number`. */
static Given give(Checks &c, Moving *moving, const std::shared_ptr<Golden> &to, int number) {
    Given given = {c.top.cycle, 32 * to->machine.lines, 0};
    if (moving)
        given.bytes = number ? moving->move(to, number) : moving->first(HALF[0]);
    else
        c.equals("load", (uint64_t)c.load(*to, HALF[number % 2]), SPHAERA_OK);
    given.clocks = c.top.cycle - given.clocks;
    if (moving) given.build = moving->build();
    return given;
}

/* A frame that is complete, against its machine; its row of the table. */
static void frame(Checks &c, const Golden &now, const Given &given, uint64_t clocks, FILE *table) {
    uint64_t n[SPHAERA_COUNTS];
    c.equals("errors", sphaera_errors(&c.top.driver), 0);
    sphaera_counters(&c.top.driver, n);
    c.same(now, c.newest(), Checks::depth(now));
    for (int k = 0; c.builds() && k < SPH_COUNTERS; k++)
        if (sph_counter_both(k)) c.equals("a counter", n[k], now.counters.count[k]);
    fprintf(table, "%u\t%llu\t%llu\t%llu\t%.2f\t", 32 * now.machine.lines,
            (unsigned long long)given.clocks, (unsigned long long)n[SPHAERA_COUNT_CYCLES],
            (unsigned long long)clocks,
            (double)n[SPHAERA_COUNT_WRITE_PIXELS] / (double)n[SPHAERA_COUNT_WRITE_BURSTS]);
    if (c.builds()) fprintf(table, "%u\t%u", given.bytes, given.build);
    fprintf(table, c.builds() ? "\n" : "\t\n");
}

int main(int argc, char **argv) {
    if (argc < 7) {
        fprintf(stderr, "usage: tb_frames LATENCY STALL SEED TREE FOLDER MACHINE.sph...\n");
        return 2;
    }
    auto c = std::make_unique<Checks>(test_number(argv[3], "argument 3", 0));
    TopHost &t = c->top;
    t.driver.bus.put = put;
    Manner manner;
    manner.latency = (unsigned)test_number(argv[1], "argument", 0);
    manner.stall = (unsigned)test_number(argv[2], "argument", 0);
    t.write(SPHAERA_WATCHDOG, 0);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_FRAME_DONE);
    const int first = 6; /* of the machines */
    const std::string folder = argv[first - 1];
    FILE *table = fopen((folder + "/frames.tsv").c_str(), "w");
    if (!table) {
        fprintf(stderr, "%s: cannot write\n", folder.c_str());
        return 2;
    }
    fprintf(table, "bytes\tupload\tdraw\twritten\tpixels_a_burst\tmoved\tbuild\n");
    auto now = std::make_shared<Golden>(argv[first]);
    bool fits = c->place(*now) && now->file.size() <= HALF[1];
    std::unique_ptr<Moving> moving;
    if (c->builds()) {
        moving = std::make_unique<Moving>(*c, now, argv[4]);
        fits = fits && moving->fits(STORE);
    }
    Given given = {}, next_given = {};
    if (fits) given = give(*c, moving.get(), now, 0);
    for (int i = first; fits && i < argc; i++) {
        t.scene.behave(manner);
        t.frame.behave(manner);
        sphaera_handle(&t.driver);
        t.irq_at = 0;
        uint64_t begin = t.cycle;
        c->equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
        std::shared_ptr<Golden> next;
        if (i + 1 < argc) {
            next = std::make_shared<Golden>(argv[i + 1]);
            fits = next->file.size() <= HALF[1];
            next_given = give(*c, moving.get(), next, i + 1 - first);
        }
        frame(*c, *now, given, c->finish_frame() - begin, table);
        pictures(*c, *now, folder, i - first);
        given = next_given;
        now = std::move(next);
    }
    c->note("the table is written", fclose(table) == 0);
    c->note("frames and machines fit into 64 MB", fits);
    c->done(c->layers ? "Rendering, L1 and L2 of every frame equal those of its machine alone"
                      : "every frame equals that of its machine alone");
    return c->finish();
}
