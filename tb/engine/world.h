/* world.h - a machine, its memory and its rays, for benches of the groups of an engine
 * SPDX-License-Identifier: Apache-2.0
 *
 * A bench stands in for the other groups with the golden model's functions. The scene is named by
 * the line of the bench (SCENE=facets/mixed behind the /: tests/scenes or scenes), the widths by
 * its parameters.
 */
#ifndef SPH_WORLD_H
#define SPH_WORLD_H

#include <unistd.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "bench.h"
#include "bundles.h"
#include "engine/noise.h"
#include "engine/repeated.h"

extern "C" {
#include "builder/build.h"
#include "pixel/background.h"
#include "trace/leaf_unit.h"
#include "trace/traverse.h"
#include "trace/setup.h"
}

#ifndef W
#define W 16
#define WD 17
#endif
#ifndef FW
#define FW 14
#endif
#ifndef PQ
#define PQ 17
#endif
#ifndef NG
#define NG 2
#endif
#ifndef PR
#define PR 0
#endif
#ifndef ACCEL
#define ACCEL 0
#endif
#ifndef SCENE
#define SCENE paper100
#endif
#define WORLD_TEXT_OF(x) #x
#define WORLD_TEXT(x) WORLD_TEXT_OF(x)

namespace world {

using bench::i128;
using bench::u128;
enum { WIDTH = 32, HEIGHT = 18 }; /* of a frame, pixels */

inline u128 pack(const int64_t *v, int bits) {
    u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((u128)v[i], bits);
    return x;
}

inline u128 pack(const int32_t *v, int bits) {
    const int64_t wide[3] = {v[0], v[1], v[2]};
    return pack(wide, bits);
}

inline int first_bit(int lsb, int) {
    return lsb;
} /* of a field of bundles.h */

/* A scene of SCENE, built for the bench's widths. */
class World {
  public:
    struct sph_machine m = {};
    const struct sph_profile p = {PROFILE, W, WD, PQ, NG, FW, PR};

    explicit World(int first = 0, int depth = 3) {
        struct sph_scene scene;
        struct sph_error err = {{0}};
        struct sph_read_options read = {};
        struct sph_build_options o = {};
        struct sph_build_report report;
        for (int &asked : o.asked)
            asked = SPH_AUTO;
        o.widths = &p;
        o.tree = ACCEL == 2 ? SPH_TREE_BOX4 : ACCEL ? SPH_TREE_BIH : SPH_TREE_BALANCED;
        o.traverse = first ? SPH_BUILD_FIRST : SPH_BUILD_NEAREST;
        o.width = WIDTH;
        o.height = HEIGHT;
        o.max_depth = depth;
        const char *file = "tests/scenes/" WORLD_TEXT(SCENE) ".nff";
        if (access(file, R_OK)) file = "scenes/" WORLD_TEXT(SCENE) ".nff";
        if (sph_scene_read(file, &read, &scene, &err)) stop(err);
        Noise noise(scene.n_textures);
        o.mips = noise.mips.data();
        if (sph_build(&scene, &o, &m, &report, &err)) stop(err);
        sph_scene_free(&scene);
    }
    ~World() {
        if (everywhere) m.mem = nullptr;
        sph_machine_free(&m);
    }
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    int on(int effect) const { return sph_machine_effect(&m, effect); }
    const uint32_t *line(uint32_t number) const { return m.mem + (size_t)number * SPH_LINE_WORDS; }

    /* From now on memory ends nowhere: the scene is in each part of it, at the same place. */
    void repeat() {
        scene_lines = (uint32_t)m.lines;
        if (scene_lines > Repeated::ALIKE) stop({"a scene of too many lines"});
        everywhere = std::make_unique<Repeated>();
        std::copy(m.mem, m.mem + (size_t)m.lines * SPH_LINE_WORDS, everywhere->words);
        free(m.mem);
        m.mem = everywhere->words;
        m.lines = Repeated::MOST;
        m.regs[SPH_REG_MEM_LINES] = (int32_t)Repeated::MOST;
    }
    /* Lines to the beginning of any part, mostly of the first. */
    static uint32_t part(bench::Random &random) {
        return random.percent(70) ? 0
                                  : Repeated::ALIKE * (uint32_t)random.mixed(Repeated::PART_BITS);
    }
    /* With repeat(): the tree goes on in the part of memory that begins there. */
    void move(uint32_t begin) {
        int32_t by = (int32_t)(begin - begins);
        begins = begin;
        if (ACCEL != 1) move_node((uint32_t)m.regs[SPH_REG_ROOT], by);
        for (int reg : {SPH_REG_ROOT, SPH_REG_LEAF_BASE, SPH_REG_PRIM_BASE})
            m.regs[reg] += by;
    }
    /* Whether a line may be asked for; a visit that is refused asks for line 0. */
    bool there(uint32_t line) const {
        return !line || (line >= begins && line - begins < scene_lines);
    }
    /* The same line in the first part. */
    static uint32_t here(uint32_t line) { return line % Repeated::ALIKE; }

    /* The registers, as rt_core gives them. */
    template <class Port> void put_regs(Port &port) const {
        const int32_t *r = m.regs;
        auto put = [&](int lsb, int bits, int first, int count) {
            for (int i = 0; i < count; i++)
                bench::put(port, lsb + bits / count * i, bits / count, r[first + i]);
        };
#define PUT(name, first, count, built) put(RT_REGS_##name, SPH_REG_##first, count);
        RT_REGS_EACH(PUT)
#undef PUT
    }

    /* A primary ray of any pixel, or from anywhere in the grid: to a light, or reflected. */
    struct sph_ray ray(bench::Random &random, int kind) const {
        struct sph_ray r = {};
        r.kind = kind;
        r.skip.id = SPH_ID_NONE;
        r.inside = on(SPH_EFFECT_INSIDE);
        int light = (int)random.below((uint64_t)m.regs[SPH_REG_N_LIGHTS] + 1) - 1;
        for (int i = 0; i < 3; i++) {
            int64_t at = random.percent(90) ? random.sbits(W - 1) : random.smixed(W);
            r.org[i] = kind == SPH_PRIMARY ? m.regs[SPH_REG_EYE_X + i] : at;
            r.dir[i] = random.percent(50) ? random.sbits(W) : random.smixed(WD);
            if (kind != SPH_PRIMARY && light < 0 && random.percent(90))
                r.dir[i] = -at + random.sbits(W - 2); /* somewhere into the middle */
            if (kind == SPH_SHADOW && light >= 0)
                r.dir[i] = m.regs[SPH_REG_LIGHT0_X + light * SPH_LIGHT_STRIDE + i] - at;
        }
        if (kind == SPH_SHADOW && light >= 0 && random.percent(50)) at_corner(random, r, light);
        if (kind == SPH_PRIMARY)
            sph_primary_dir(&m, (int)random.below(WIDTH), (int)random.below(HEIGHT), r.dir);
        else if (random.percent(50))
            r.skip = {(uint32_t)random.below((uint64_t)m.regs[SPH_REG_N_PRIMS]),
                      random.percent(30)};
        for (int64_t &x : r.lift)
            x = random.between(-(1 << NG), 1 << NG);
        sph_ray_setup(&p, &r);
        return r;
    }

    /* What leaf record j of those from line base on says, as sph_traverse() would take it. */
    struct sph_hit leaf(const struct sph_ray &ray, uint32_t base, uint32_t j,
                        struct sph_counters *c, uint32_t *errors) const {
        struct sph_ray_query query = sph_ray_query_of(&m, &ray, c, errors);
        sph_leaf_visit(&query, sph_record(&m, query.whole, base, j));
        return query.best;
    }

    uint32_t scene_lines = 0; /* with repeat() */

  private:
    std::unique_ptr<Repeated> everywhere;
    uint32_t begins = 0; /* the part of memory that the tree is in */

    void move_node(uint32_t at, int32_t by) {
        uint32_t *node = sph_line(&m, at);
        uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
        uint32_t inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
        for (uint32_t i = 0; i < inner; i++)
            move_node(base + i, by);
        sph_field_set(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base + (uint32_t)by);
    }

    /* With triangles a ray to a light starts at a corner of one, where by how much its origin was
     * rounded decides what it meets. */
    void at_corner(bench::Random &random, struct sph_ray &r, int light) const {
        uint32_t from = (uint32_t)random.below(scene_lines ? scene_lines : m.lines);
        const uint32_t *record = line(from);
        if (!on(SPH_EFFECT_FACETS) ||
            sph_field(record, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS) != SPH_TRIANGLE)
            return;
        const int64_t edge = (int64_t)1 << (W - 1);
        for (int i = 0; i < 3; i++) {
            int64_t corner = sph_field_signed(
                record, SPH_TRIANGLE_V0_X_LSB + SPH_TRIANGLE_V0_X_BITS * i, SPH_TRIANGLE_V0_X_BITS);
            r.org[i] = std::clamp(corner + random.between(-1, 1), -edge, edge - 1);
            r.dir[i] = m.regs[SPH_REG_LIGHT0_X + light * SPH_LIGHT_STRIDE + i] - r.org[i];
        }
    }

    [[noreturn]] static void stop(const struct sph_error &err) {
        printf("# %s\n", err.text);
        exit(1);
    }
};

/* A ray as rt_setup gives it; VALID, NORMAL and LIGHT are the bench's own. */
template <class Port> void put_ray(Port &port, int slot, const struct sph_ray &r) {
    bench::put(port, RT_RAY_SLOT, slot);
    bench::put(port, RT_RAY_PRIMARY, r.kind == SPH_PRIMARY);
    bench::put(port, RT_RAY_SHADOW, r.kind == SPH_SHADOW);
    bench::put(port, RT_RAY_ORG, (i128)pack(r.org, W));
    bench::put(port, RT_RAY_DIR, (i128)pack(r.dir, WD));
    bench::put(port, RT_RAY_A, (i128)r.a);
    bench::put(port, RT_RAY_SKIP, r.skip.id);
    bench::put(port, RT_RAY_INSIDE, r.skip.inside);
    bench::put(port, RT_RAY_UNIT, (i128)pack(r.unit.u, 18));
    bench::put(port, RT_RAY_Y, r.unit.y);
    bench::put(port, RT_RAY_H, r.unit.h);
}

template <class Port> void put_filter(Port &port, const struct sph_ray &r) {
    bench::put(port, RT_FILTER_ORG, (i128)pack(r.forg, FW));
    bench::put(port, RT_FILTER_AXIS, r.axis);
    bench::put(port, RT_FILTER_NEGATIVE, r.negative);
    bench::put(port, RT_FILTER_SCALE, r.depth_scale);
    bench::put(port, RT_FILTER_SHIFT, r.depth_shift < 0 ? 63 : r.depth_shift);
    bench::put(port, RT_FILTER_DEPTH, r.depth_max);
}

template <class Port> void put_across(Port &port, int slot, const struct sph_across &a) {
    bench::put(port, RT_ACROSS_VALID, 1);
    bench::put(port, RT_ACROSS_LEAST, 3 - a.axis_a - a.axis_b);
    bench::put(port, RT_ACROSS_P_A, a.p_a);
    bench::put(port, RT_ACROSS_P_B, a.p_b);
    bench::put(port, RT_ACROSS_Q, (i128)pack(a.q, 18));
    bench::put(port, RT_ACROSS_SLOT, slot);
}

/* Answers readers of memory, late and in bursts; lines that are `spoilt` with an error, and with
 * data that are not theirs. Each reader gets its lines in the order in which it asked, a line a
 * clock comes. Once a clock: before() the clock, with all inputs set, settles them. */
template <class Top, int READERS = 1> class Memory {
  public:
    std::vector<bool> spoilt;             /* by line; empty: none */
    std::function<bool(uint32_t)> wanted; /* whether a line may be asked for; none: any may */
    int spoilt_for = -1;                  /* the reader who gets all lines with an error */
    uint64_t requests = 0;

    Memory(bench::Bench<Top> &bench, const World &w) : b(bench), world(w) {
        b.dut.mem_req_ready_i = b.dut.mem_rsp_valid_i = b.dut.mem_rsp_error_i = 0;
    }
    /* Behind a reset nobody waits. */
    void forget() {
        for (std::deque<Line> &lines : asked)
            lines.clear();
    }
    void before() {
        if (b.cycle % 512 == 0) {
            pace = b.random.percent(40) ? 100 : (unsigned)b.random.between(10, 60);
            latency = (unsigned)b.random.below(3) * 15;
        }
        unsigned ready = 0;
        for (int r = 0; r < READERS; r++)
            ready |= (unsigned)b.random.percent(pace) << r;
        b.dut.mem_req_ready_i = (uint8_t)ready;
        int to = READERS > 1 ? (int)b.random.below(READERS) : 0;
        std::deque<Line> &lines = asked[to];
        bool comes = !lines.empty() && lines.front().when <= b.cycle && b.random.percent(pace);
        b.dut.mem_rsp_valid_i = (uint8_t)(comes << to);
        if (!lines.empty()) {
            uint32_t line = lines.front().line;
            b.dut.mem_rsp_error_i =
                to == spoilt_for || (!spoilt.empty() && spoilt[World::here(line)]);
            for (int i = 0; i < 8; i++)
                b.dut.mem_rsp_data_i[i] = world.line(line)[i] ^ (b.dut.mem_rsp_error_i ? ~0u : 0u);
        }
        b.settle();
        if (comes && b.dut.mem_rsp_ready_o >> to & 1) lines.pop_front();
        for (int r = 0; r < READERS; r++)
            if (b.dut.mem_req_valid_o >> r & ready >> r & 1) take(r);
    }

  private:
    struct Line {
        uint32_t line;
        uint64_t when;
    };
    bench::Bench<Top> &b;
    const World &world;
    std::deque<Line> asked[READERS];
    unsigned pace = 100, latency = 0;

    void take(int reader) {
        uint32_t line =
            (uint32_t)bench::get(b.dut.mem_req_line_o, SPH_LINE_BITS * reader, SPH_LINE_BITS);
        requests++;
        if (line >= world.m.lines)
            b.fail("a line behind the end of memory is asked for");
        else if (wanted && !wanted(line))
            b.fail("a line that nobody wants is asked for");
        else
            asked[reader].push_back({line, b.cycle + latency});
    }
};

} // namespace world

#endif
