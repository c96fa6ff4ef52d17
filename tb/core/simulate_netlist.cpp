/* simulate_netlist.cpp - the core as cells that it is mapped to; see simulate_host.cpp, netlist.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * --engine is the netlist as JSON, or, if its name ends with .so, a netlist of standard cells that
 * was compiled (netlist/gates.h). What has no initial value starts with noise. --toggles writes
 * what switched while the core was busy, and in IDLE clocks behind the frame; of a compiled netlist
 * as gates_write() has it, else a line an instance, tabs between: its path, then toggles,
 * flip-flops clocked, accesses of block RAM while busy, then the same while idle. The first line
 * has the clocks of both in the place of the path.
 */
#include <dlfcn.h>

#include "netlist/gates.h"
#include "netlist/netlist.h"

#include "host.h"

#include <cinttypes>
#include <cstdio>

#include "common/file.h"

const char *const simulator_name = "netlist";

std::string simulator_version() {
    return "netlist of Yosys";
}

namespace {

/* What simulates the cells. */
class Engine {
  public:
    virtual ~Engine() = default;
    virtual size_t bits(const char *port) const = 0;
    virtual void set(const char *port, uint64_t value, size_t lsb = 0) = 0;
    virtual uint64_t get(const char *port, size_t lsb = 0) const = 0;
    virtual void settle() = 0;
    virtual void edge() = 0;
    enum Phase { NONE = -1, BUSY, IDLE };
    virtual void count(Phase phase) = 0;
    virtual void write(std::FILE *f, uint64_t busy, int idle) = 0;
};

class Interpreted : public Engine {
  public:
    Interpreted(const std::string &file, std::string &error) : cells_(file, error) {}
    size_t bits(const char *port) const override { return cells_.bits(port); }
    void set(const char *port, uint64_t value, size_t lsb) override {
        cells_.set(port, value, lsb);
    }
    uint64_t get(const char *port, size_t lsb) const override { return cells_.get(port, lsb); }
    void settle() override { cells_.settle(); }
    void edge() override { cells_.edge(); }
    void count(Phase phase) override { cells_.tally(phase == NONE ? nullptr : &sums_[phase]); }
    void write(std::FILE *f, uint64_t busy, int idle) override {
        std::fprintf(f, "%" PRIu64 " %d\n", busy, idle);
        for (auto &sums : sums_)
            sums.resize(cells_.instances().size());
        for (size_t i = 0; i < cells_.instances().size(); i++) {
            std::fputs(cells_.instances()[i].c_str(), f);
            for (const Netlist::Switching &s : {sums_[BUSY][i], sums_[IDLE][i]})
                std::fprintf(f, "\t%" PRIu64 "\t%" PRIu64 "\t%" PRIu64, s.toggles, s.clocked,
                             s.accesses);
            std::fputc('\n', f);
        }
    }

  private:
    Netlist cells_;
    std::vector<Netlist::Switching> sums_[2];
};

/* A library that was compiled from the netlist: gates.h. */
class Compiled : public Engine {
  public:
    Compiled(const std::string &file, std::string &error) {
        void *library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library) {
            error = dlerror();
            return;
        }
        find(library, "gates_bits", bits_, error);
        find(library, "gates_set", set_, error);
        find(library, "gates_get", get_, error);
        find(library, "gates_settle", settle_, error);
        find(library, "gates_edge", edge_, error);
        find(library, "gates_count", count_, error);
        find(library, "gates_write", write_, error);
        decltype(&gates_start) start = nullptr;
        find(library, "gates_start", start, error);
        if (error.empty()) start(1);
    }
    size_t bits(const char *port) const override { return bits_(port); }
    void set(const char *port, uint64_t value, size_t lsb) override { set_(port, value, lsb); }
    uint64_t get(const char *port, size_t lsb) const override { return get_(port, lsb); }
    void settle() override { settle_(); }
    void edge() override { edge_(); }
    void count(Phase phase) override { count_(phase); }
    void write(std::FILE *f, uint64_t, int) override { write_(f); }

  private:
    template <class F>
    static void find(void *library, const char *name, F &function, std::string &error) {
        function = reinterpret_cast<F>(dlsym(library, name));
        if (!function) error = dlerror();
    }
    decltype(&gates_bits) bits_ = nullptr;
    decltype(&gates_set) set_ = nullptr;
    decltype(&gates_get) get_ = nullptr;
    decltype(&gates_settle) settle_ = nullptr;
    decltype(&gates_edge) edge_ = nullptr;
    decltype(&gates_count) count_ = nullptr;
    decltype(&gates_write) write_ = nullptr;
};

std::unique_ptr<Engine> engine(const std::string &file, std::string &error) {
    const std::string library = ".so";
    if (file.size() > library.size() &&
        file.compare(file.size() - library.size(), library.size(), library) == 0)
        return std::make_unique<Compiled>(file, error);
    return std::make_unique<Interpreted>(file, error);
}

class NetlistCore : public PortHost {
  public:
    NetlistCore(const Options &o, const sph_machine &machine, Run &run)
        : PortHost(o, machine, run), engine_(engine(o.engine, error_)), core_(*engine_) {
        if (!error_.empty()) {
            fail(run, "%s", error_.c_str());
            return;
        }
        memory().width(core_.bits("mem_rsp_data_i"));
        pins.rst = true;
        for (int i = 0; i < RESET; i++)
            clock();
        pins.rst = false;
        core_.count(Engine::NONE);
    }
    ~NetlistCore() override {
        if (o_.toggles.empty() || run_.failure[0]) return;
        idle_ = true;
        for (int i = 0; i < IDLE; i++)
            clock();
        sph_error err;
        sph_output out;
        bool failed = sph_output_open(&out, o_.toggles.c_str(), &err) != 0;
        if (!failed) {
            core_.write(out.file, busy_clocks_, IDLE);
            failed = sph_output_close(&out, std::ferror(out.file) ? 1 : 0, &err) != 0;
        }
        if (failed) fail(run_, "%s", err.text);
    }

  private:
    static const int RESET = 4; /* clocks */
    static const int IDLE = 1000;
    void step(const Inputs &in, Outputs &out) override {
        if (!error_.empty()) return;
        core_.set("rst", in.pins.rst);
        core_.set("start_i", in.pins.start);
        core_.set("keep_cache_i", in.pins.keep_cache);
        core_.set("cfg_valid_i", in.pins.cfg_valid);
        core_.set("cfg_addr_i", static_cast<uint64_t>(in.pins.cfg_addr));
        core_.set("cfg_data_i", in.pins.cfg_data);
        core_.set("count_addr_i", static_cast<uint64_t>(in.pins.count_addr));
        core_.set("mem_req_ready_i", in.memory.request_ready);
        core_.set("mem_rsp_valid_i", in.memory.response_valid);
        core_.set("mem_rsp_tag_i", in.memory.tag);
        for (size_t i = 0; i < in.memory.data.size(); i++)
            core_.set("mem_rsp_data_i", in.memory.data[i], 64 * i);
        core_.set("mem_rsp_error_i", in.memory.error);
        core_.set("pix_ready_i", in.pix_ready);
        core_.settle();
        const bool busy = core_.get("busy_o") != 0;
        if (!o_.toggles.empty()) {
            core_.count(busy ? Engine::BUSY : idle_ ? Engine::IDLE : Engine::NONE);
            busy_clocks_ += busy;
        }
        out.req_valid = core_.get("mem_req_valid_o") != 0;
        out.req_line = static_cast<uint32_t>(core_.get("mem_req_line_o"));
        out.req_tag = static_cast<uint32_t>(core_.get("mem_req_tag_o"));
        out.rsp_ready = core_.get("mem_rsp_ready_o") != 0;
        out.pix_valid = core_.get("pix_valid_o") != 0;
        out.x = static_cast<int>(core_.get("pix_x_o"));
        out.y = static_cast<int>(core_.get("pix_y_o"));
        out.pix_frame = static_cast<uint32_t>(core_.get("pix_frame_o"));
        const uint32_t colour[3] = {static_cast<uint32_t>(core_.get("pix_colour_o")),
                                    static_cast<uint32_t>(core_.get("pix_colour_o", 32)),
                                    static_cast<uint32_t>(core_.get("pix_colour_o", 64))};
        colours(colour, out.pixel);
        out.pixel.id = static_cast<uint32_t>(core_.get("pix_id_o"));
        out.pixel.key = core_.get("pix_key_o");
        out.pixel.visits = static_cast<uint32_t>(core_.get("pix_visits_o"));
        out.pixel.texture = static_cast<uint32_t>(core_.get("pix_texture_o"));
        if (!o_.gated || core_.get("active_o")) core_.edge();
        core_.settle();
        out.seen = {core_.get("busy_o") != 0, static_cast<uint32_t>(core_.get("errors_o")),
                    core_.get("count_data_o"), true};
    }

    std::string error_;
    std::unique_ptr<Engine> engine_;
    Engine &core_;
    uint64_t busy_clocks_ = 0;
    bool idle_ = false;
};

} // namespace

std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run) {
    return std::make_unique<NetlistCore>(o, machine, run);
}
