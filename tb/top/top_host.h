/* top_host.h - the verilated rt_top, its memory, and a processor that runs the driver
 * SPDX-License-Identifier: Apache-2.0
 *
 * The driver's reads and writes go through AXI4-Lite, with random waits in every handshake; each
 * takes as many clocks as it needs, and the block works meanwhile.
 */
#ifndef TB_TOP_HOST_H
#define TB_TOP_HOST_H

#include "Vrt_top.h"
#ifndef ADDR
#define ADDR 32 /* bits of an address, as the block was built */
#endif
#include <functional>

#include "axi_memory.h"
#include "top_view.h"

extern "C" {
#include "../../driver/sphaera.h"
}

class TopHost {
  public:
    static constexpr uint32_t MEMORY = 1u << 26;
    Vrt_top dut;
    bench::Random random;
    std::vector<uint8_t> bytes;
    ReadSide scene, scan;
    WriteSide frame;
    struct sphaera driver;
    View view;
    uint64_t cycle = 0;
    uint64_t stood = 0;  /* clocks in which active_o was low and clk stood still */
    uint64_t irq_at = 0; /* the first clock with an interrupt since this was set to 0 */
    uint64_t scene_silent = 0, frame_silent = 0, scan_silent = 0; /* in that clock */
    unsigned take_in = 0; /* clocks until take_i is high for one, 0: never */
    unsigned stall = 0;   /* percent, of the registers' bus */
    int response = 0;     /* of the last access to a register */
    bool hangs = false;

    explicit TopHost(uint64_t seed)
        : random(seed), bytes(MEMORY), scene(bytes, random), scan(bytes, random),
          frame(bytes, random) {
        idle();
        reset();
    }
    ~TopHost() { dut.final(); }

    void clock() {
        if (take_in && --take_in == 0) dut.take_i = 1;
        scene.offer(READ_PORTS(dut, m_scene, dut.m_scene_arid, dut.m_scene_rid));
        scan.offer(READ_PORTS(dut, m_scan, no_id_, no_id_));
        no_id_ = 0;
        frame.offer(dut);
        dut.clk = 0;
        pixel_clock();
        dut.eval();
        if (!dut.rst) {
            scene.take(READ_PORTS(dut, m_scene, dut.m_scene_arid, dut.m_scene_rid));
            scan.take(READ_PORTS(dut, m_scan, no_id_, no_id_));
            frame.take(dut);
        }
        seen_ = {dut.s_axil_awvalid && dut.s_axil_awready,
                 dut.s_axil_wvalid && dut.s_axil_wready,
                 dut.s_axil_bvalid && dut.s_axil_bready,
                 dut.s_axil_arvalid && dut.s_axil_arready,
                 dut.s_axil_rvalid && dut.s_axil_rready,
                 dut.s_axil_rdata,
                 dut.s_axil_bresp,
                 dut.s_axil_rresp};
        if (dut.active_o || random.percent(50)) {
            view.look(dut, cycle);
            dut.clk = 1;
            dut.eval();
            view.edge();
        } else {
            stood++;
        }
        dut.take_i = 0;
        cycle++;
        if (!dut.irq_o || irq_at) return;
        irq_at = cycle;
        scene_silent = scene.silent;
        frame_silent = frame.silent;
        scan_silent = scan.silent;
    }
    void clocks(uint64_t n) {
        while (n--)
            clock();
    }
    /* Block and buses together. */
    void reset() {
        dut.rst = dut.pix_rst = 1;
        clocks(4 + random.below(4));
        scene.reset();
        scan.reset();
        frame.reset();
        dut.rst = dut.pix_rst = 0;
    }
    uint32_t read(uint32_t offset) {
        dut.s_axil_araddr = (uint16_t)offset;
        bool asked = false, done = false;
        uint32_t value = 0;
        for (unsigned i = 0; !done && !late(i); i++) {
            dut.s_axil_arvalid = !asked && (dut.s_axil_arvalid || !random.percent(stall));
            dut.s_axil_rready = !random.percent(stall);
            clock();
            asked = asked || seen_.ar;
            if (asked) dut.s_axil_arvalid = 0;
            if (!seen_.r) continue;
            done = true;
            value = seen_.data;
            response = seen_.rresp;
        }
        idle();
        return value;
    }
    void write(uint32_t offset, uint32_t value, unsigned strobe = 15) {
        dut.s_axil_awaddr = (uint16_t)offset;
        dut.s_axil_wdata = value;
        dut.s_axil_wstrb = (uint8_t)strobe;
        bool address = false, data = false, done = false;
        for (unsigned i = 0; !done && !late(i); i++) {
            dut.s_axil_awvalid = !address && (dut.s_axil_awvalid || !random.percent(stall));
            dut.s_axil_wvalid = !data && (dut.s_axil_wvalid || !random.percent(stall));
            dut.s_axil_bready = !random.percent(stall);
            clock();
            address = address || seen_.aw;
            data = data || seen_.w;
            if (address) dut.s_axil_awvalid = 0;
            if (data) dut.s_axil_wvalid = 0;
            if (!seen_.b) continue;
            done = true;
            response = seen_.bresp;
        }
        idle();
    }
    struct sphaera_bus bus() {
        struct sphaera_bus b;
        b.read = [](void *user, uint32_t offset) { return ((TopHost *)user)->read(offset); };
        b.write = [](void *user, uint32_t offset, uint32_t value) {
            ((TopHost *)user)->write(offset, value);
        };
        b.put = [](void *user, uint64_t address, const uint8_t *from, uint32_t count) {
            memcpy(&((TopHost *)user)->bytes[address % MEMORY], from, count);
        };
        b.user = this;
        return b;
    }

    /* Is called in every pixel clock, if there is one. */
    std::function<void(Vrt_top &)> pixel;
    unsigned pixel_every = 2; /* clocks */

  private:
    /* Between two edges of clk: a pixel clock of its own. */
    void pixel_clock() {
        if (cycle % pixel_every) return;
        if (dut.pix_rst) leaves_ = 16;
        if (!pixel && leaves_ == 0) return;
        leaves_ -= leaves_ > 0;
        dut.m_video_tready = 1;
        dut.pix_clk = 0;
        dut.eval();
        if (pixel) pixel(dut);
        dut.pix_clk = 1;
    }
    struct Seen {
        bool aw, w, b, ar, r;
        uint32_t data;
        int bresp, rresp;
    } seen_ = {};
    uint8_t no_id_ = 0; /* of the display */
    int leaves_ = 0;    /* edges of pix_clk until both its sides have left their reset */
    bool late(unsigned clocks) { return hangs = hangs || clocks > 5000; }
    void idle() {
        dut.s_axil_awvalid = dut.s_axil_wvalid = dut.s_axil_arvalid = 0;
        dut.s_axil_bready = dut.s_axil_rready = 0;
    }
};

#endif
