/* tb_build.cpp - rt_build against the model: memory after a build, word by word
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_build [seed [builds]]
 *
 * A vector is one build: of drawn spheres (tests/drawn_spheres.h), from any line to any other, with
 * a memory that answers after any time and takes lines when it likes. No line is written but those
 * that the job has, and each once. Some jobs are too large or have too little room, some records
 * are wrong, some lines come or go with a bus error: then errors are told, and what is read was
 * wrong before anything is written. Now and then a build is cut off by a reset at any clock; the
 * next one is as good as any. At last a full build is timed: memory of 64 bits a clock and latency
 * 100.
 */
#include <deque>
#include <vector>
#include "Vrt_build.h"
#include "bench.h"
extern "C" {
#include "tests/drawn_spheres.h"
}

namespace {

struct Line {
    uint32_t line;
    uint64_t due;
};

class Build : public bench::Bench<Vrt_build> {
  public:
    Build(int argc, char **argv) : Bench("tb_build", argc, argv, 400) {
        job.kept = &kept;
        profile.w = W;
        profile.fw = FW;
        idle();
    }

    void draw(uint32_t most) {
        uint64_t how = random.below(40);
        n = how == 0 ? most : (uint32_t)random.log_bits(__builtin_ctz(COUNT));
        if (n > most) n = most;
        if (how == 1) n = COUNT + 1 + (uint32_t)random.below(9);
        uint64_t mode = random.below(100);
        job.mode = mode < 3    ? 3
                   : mode < 35 ? SPH_BUILD_PAPER
                   : mode < 60 ? SPH_BUILD_REFIT
                               : SPH_BUILD_CURVE;
        job.rounds = random.percent(60) ? 0 : (uint32_t)random.below(4);
        if (job.mode == SPH_BUILD_REFIT && kept.order && random.percent(90)) n = kept.n;
        fill(static_cast<drawn_kind>(random.below(DRAWN_KINDS)));
        if (n && random.percent(5)) spoil();
        job.lines = (uint32_t)sph_bt_lines(n) + (uint32_t)random.below(3);
        if (random.percent(n ? 4 : 50)) job.lines = (uint32_t)random.below(job.lines + 1);
        latency = (unsigned)random.below(random.percent(50) ? 4 : 150);
        reads = random.percent(40) ? 100 : (unsigned)random.between(5, 95);
        writes = random.percent(40) ? 100 : (unsigned)random.between(5, 95);
        read_error = n && random.percent(4) ? (int64_t)random.below(n) : -1;
        write_error = random.percent(4) ? (int64_t)random.below(2 * n + 1) : -1;
        pace = 1;
    }
    /* Every sphere that there is room for, in a memory as boards have it. */
    void draw_full(int mode, uint32_t rounds) {
        n = COUNT;
        fill(DRAWN_EVEN);
        job.mode = mode;
        job.rounds = rounds;
        job.lines = (uint32_t)sph_bt_lines(n);
        latency = 100, reads = writes = 100, pace = 256 / 64;
        read_error = write_error = -1;
    }

    /* A build that a reset cuts off, at any clock of it. */
    void cut() { run(1 + random.below(200 + 30 * (n + 1))); }

    /* A reset between two builds: there is no tree to refit. */
    void forget() {
        idle();
        reset(1);
        sph_bt_forget(&kept);
        job.mode = SPH_BUILD_REFIT;
        run(0);
    }

    /* One build; clocks until it is cut off by a reset, 0: it is not. Returns clocks. */
    uint64_t run(uint64_t cut) {
        std::vector<uint32_t> expected = memory;
        struct sph_error err;
        uint32_t written = 0;
        int errors = sph_bt_refused(&job, COUNT);
        if (!errors && read_error >= 0) /* what came with an error is not looked at */
            errors = wrong_beside(read_error) | SPH_BT_BUS;
        if (!errors) errors = sph_bt_words(expected.data(), &job, COUNT, &profile, &written, &err);
        bool void_write = !errors && write_error >= 0 && write_error < written;
        if (void_write) errors = SPH_BT_BUS;

        start();
        uint64_t clocks = 0, longest = 20000 + 400ull * (n + 1) * (1 + 10 * (reads + writes < 150));
        longest += 20ull * n * (100 / reads + 100 / writes) + 400ull * latency;
        while (!dut.done_o && !failed()) {
            clock();
            if (++clocks == cut) {
                idle();
                reset(1 + random.below(3));
                sph_bt_forget(&kept);
                way.clear(), waits.clear(), offered = NONE;
                if (dut.busy_o || dut.req_valid_o || dut.wr_valid_o) fail("busy behind a reset");
                if (dut.error_o) fail("an error behind a reset");
                return clocks;
            }
            if (clocks > longest) fail("the build does not end");
        }
        expect("error_o", dut.error_o, errors, 5);
        if (!errors || void_write) {
            expect("written_o", dut.written_o, written);
            expect("lines that were written", writes_made, written);
        } else {
            expect("lines that were written", writes_made, 0);
        }
        for (uint32_t i = 0; i < memory.size(); i++)
            if (!expect("a word of memory", memory[i], expected[i], 32)) {
                show("line", i / SPH_LINE_WORDS, 32);
                show("word", i % SPH_LINE_WORDS, 32);
                show("root", job.root, 32);
                show("spheres", n, 32);
                show("kind of scene", drawn, 32);
                show("mode", (uint32_t)job.mode, 2);
                break;
            }
        for (int i = 0; i < 3; i++) {
            clock();
            if (dut.busy_o || dut.done_o) fail("busy when it is done");
        }
        done();
        return clocks;
    }

  private:
    static uint64_t next(void *of) { return static_cast<bench::Random *>(of)->next(); }
    void idle() {
        dut.start_i = dut.req_ready_i = dut.rsp_valid_i = dut.wr_ready_i = dut.wr_error_i = 0;
        dut.wr_idle_i = 1;
    }

    /* Memory of a drawn scene: tree and records in any order, with lines between and around. */
    void fill(drawn_kind kind) {
        uint32_t gap[3], tree = 2 * n + 3;
        for (uint32_t &g : gap)
            g = (uint32_t)random.below(20);
        bool behind = random.percent(50);
        drawn = kind;
        job.n = n;
        job.root = gap[0] + (behind ? n + gap[1] : 0);
        job.prim_base = gap[0] + (behind ? 0 : tree + gap[1]);
        memory.assign((size_t)(gap[0] + gap[1] + gap[2] + n + tree) * SPH_LINE_WORDS, 0);
        for (uint32_t &word : memory)
            word = (uint32_t)random.next();
        std::vector<struct sph_bt_leaf> leaves(n + 1);
        drawn_spheres(kind, leaves.data(), n, &profile, next, &random);
        for (uint32_t id = 0; id < n; id++)
            drawn_record(record(id), id, &leaves[id], random.next());
    }
    uint32_t *record(uint32_t id) { return &memory[(size_t)(job.prim_base + id) * SPH_LINE_WORDS]; }
    /* One record that is no sphere of W bits. */
    void spoil() {
        uint32_t *line = record((uint32_t)random.below(n));
        int axis = SPH_LEAF_CTR_X_LSB + 24 * (int)random.below(3);
        switch (random.below(5)) {
        case 0:
            return sph_field_set(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, 0);
        case 1: /* a bit above W */
            if (W == 24) return;
            line = line + (SPH_LEAF_RAD_LSB + W) / 32;
            *line |= 1u << (SPH_LEAF_RAD_LSB + W) % 32;
            return;
        case 2:
            return sph_field_set(line, axis, 24, W == 24 ? 0 : 1u << (W - 1));
        case 3:
            return sph_field_set(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, n + 3);
        default:
            return sph_field_set(line, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS, SPH_TRIANGLE);
        }
    }
    /* SPH_BT_RECORD if a record is wrong that came whole. */
    int wrong_beside(int64_t id) {
        std::vector<uint32_t> copy = memory;
        struct sph_bt_leaf one = {{0, 0, 0}, 1};
        struct sph_error err;
        uint32_t written;
        struct sph_bt_job look = job;
        look.mode = SPH_BUILD_PAPER, look.kept = nullptr;
        drawn_record(&copy[(size_t)(job.prim_base + id) * SPH_LINE_WORDS], (uint32_t)id, &one, 0);
        return sph_bt_words(copy.data(), &look, COUNT, &profile, &written, &err);
    }

    void start() {
        came = asked = writes_made = 0;
        seen.assign(memory.size() / SPH_LINE_WORDS, false);
        dut.mode_i = (uint8_t)job.mode;
        dut.rounds_i = (uint8_t)job.rounds;
        dut.count_i = job.n;
        dut.prim_base_i = job.prim_base;
        dut.root_i = job.root;
        dut.lines_i = job.lines;
        dut.start_i = 1;
        clock();
        dut.start_i = 0;
    }

    void clock() {
        dut.req_ready_i = random.percent(reads);
        dut.wr_ready_i = random.percent(writes) && now >= free_at;
        dut.rsp_valid_i = !way.empty() && way.front().due <= now;
        dut.rsp_error_i = 0;
        dut.wr_error_i = 0;
        if (dut.rsp_valid_i) {
            uint32_t line = way.front().line;
            for (int i = 0; i < SPH_LINE_WORDS; i++)
                dut.rsp_data_i[i] = memory[(size_t)line * SPH_LINE_WORDS + (size_t)i];
            dut.rsp_error_i = came == read_error;
            for (int i = 0; dut.rsp_error_i && i < SPH_LINE_WORDS; i++)
                dut.rsp_data_i[i] = (uint32_t)random.next();
            way.pop_front();
            came++;
        }
        if (!waits.empty() && waits.front().due <= now) {
            dut.wr_error_i = waits.front().line == 1;
            waits.pop_front();
        }
        dut.wr_idle_i = waits.empty();
        settle();
        if (offered != NONE && (!dut.wr_valid_o || dut.wr_line_o != offered))
            fail("a line to be written was taken back");
        offered = dut.wr_valid_o && !dut.wr_ready_i ? dut.wr_line_o : NONE;
        if (dut.req_valid_o && dut.req_ready_i) ask(dut.req_line_o);
        if (dut.wr_valid_o && dut.wr_ready_i) write(dut.wr_line_o);
        tick();
        now++;
    }
    void ask(uint32_t line) {
        if (line != job.prim_base + asked) fail("a line is read that is not the next record");
        uint64_t due = now + latency + 1;
        if (!way.empty() && way.back().due + pace > due) due = way.back().due + pace;
        way.push_back({line, due});
        asked++;
    }
    void write(uint32_t line) {
        if (line < job.root || line - job.root >= job.lines) return fail("a line beyond the room");
        if (seen[line]) return fail("a line is written twice");
        seen[line] = true;
        for (int i = 0; i < SPH_LINE_WORDS; i++)
            memory[(size_t)line * SPH_LINE_WORDS + (size_t)i] = dut.wr_data_o[i];
        waits.push_back({writes_made == write_error, now + 1 + random.below(latency + 1)});
        if (waits.size() > 1 && waits.back().due < waits[waits.size() - 2].due)
            waits.back().due = waits[waits.size() - 2].due;
        writes_made++;
        free_at = now + pace;
    }

    static constexpr uint32_t NONE = UINT32_MAX;
    struct sph_profile profile = {};
    struct sph_bt_kept kept = {};
    struct sph_bt_job job = {};
    std::vector<uint32_t> memory;
    std::vector<bool> seen; /* lines that were written */
    std::deque<Line> way;   /* lines that were asked for */
    std::deque<Line> waits; /* that were written: 1, with an error */
    uint32_t n = 0, drawn = 0, asked = 0, offered = NONE;
    int64_t came = 0, writes_made = 0, read_error = -1, write_error = -1;
    unsigned latency = 0, reads = 100, writes = 100, pace = 1;
    uint64_t now = 0, free_at = 0;
};

} // namespace

int main(int argc, char **argv) {
    Build b(argc, argv);
    b.reset();
    while (b.more()) {
        b.draw(COUNT);
        if (b.random.percent(40))
            b.cut();
        else
            b.run(0);
        if (b.random.percent(5)) b.forget();
        b.cycle = 0; /* a build may take long */
    }
    if (b.all_vectors && !b.failed()) {
        static const struct {
            int mode;
            uint32_t rounds;
            const char *name;
        } full[] = {{SPH_BUILD_PAPER, 0, "paper"},
                    {SPH_BUILD_CURVE, 1, "curve, a round more"},
                    {SPH_BUILD_CURVE, 0, "curve"},
                    {SPH_BUILD_REFIT, 0, "refit"}};
        for (const auto &one : full) {
            b.draw_full(one.mode, one.rounds);
            printf("# %s: %.1f clocks a sphere of %d\n", one.name, (double)b.run(0) / COUNT, COUNT);
        }
    }
    return b.finish();
}
