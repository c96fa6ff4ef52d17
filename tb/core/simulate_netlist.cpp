/* simulate_netlist.cpp - the core as cells that it is mapped to; see simulate_host.cpp, netlist.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * --engine is the netlist as JSON. What has no initial value starts with noise. --toggles writes a
 * line an instance, tabs between: its path, then what switched in it while the core was busy
 * (toggles, flip-flops clocked, accesses of block RAM), then the same of IDLE clocks behind the
 * frame. The first line has the clocks of both in the place of the path.
 */
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

class NetlistCore : public PortHost {
  public:
    NetlistCore(const Options &o, const sph_machine &machine, Run &run)
        : PortHost(o, machine, run), core_(o.engine, error_) {
        if (!error_.empty()) {
            fail(run, "%s", error_.c_str());
            return;
        }
        memory().width(core_.bits("mem_rsp_data_i"));
        pins.rst = true;
        for (int i = 0; i < RESET; i++)
            clock();
        pins.rst = false;
        core_.tally(nullptr);
    }
    ~NetlistCore() override {
        if (o_.toggles.empty() || run_.failure[0]) return;
        idle_ = true;
        for (int i = 0; i < IDLE; i++)
            clock();
        sph_error err;
        sph_output out;
        bool failed = sph_output_open(&out, o_.toggles.c_str(), &err) != 0;
        if (!failed) failed = sph_output_close(&out, write(out.file) ? 0 : 1, &err) != 0;
        if (failed) fail(run_, "%s", err.text);
    }

  private:
    static const int RESET = 4; /* clocks */
    static const int IDLE = 1000;
    using Switching = Netlist::Switching;
    bool write(std::FILE *f) {
        std::fprintf(f, "%" PRIu64 " %d\n", busy_clocks_, IDLE);
        for (auto &sums : sums_)
            sums.resize(core_.instances().size());
        for (size_t i = 0; i < core_.instances().size(); i++) {
            std::fputs(core_.instances()[i].c_str(), f);
            for (const Switching &s : {sums_[0][i], sums_[1][i]})
                std::fprintf(f, "\t%" PRIu64 "\t%" PRIu64 "\t%" PRIu64, s.toggles, s.clocked,
                             s.accesses);
            std::fputc('\n', f);
        }
        return !std::ferror(f);
    }
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
            core_.tally(busy ? &sums_[0] : idle_ ? &sums_[1] : nullptr);
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
    Netlist core_;
    std::vector<Switching> sums_[2]; /* busy, idle */
    uint64_t busy_clocks_ = 0;
    bool idle_ = false;
};

} // namespace

std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run) {
    return std::make_unique<NetlistCore>(o, machine, run);
}
