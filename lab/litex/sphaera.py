"""rt_top in a LiteX system: registers on its bus, masters at the SDRAM controller, an interrupt.

SPDX-License-Identifier: Apache-2.0
"""
from litedram.frontend.axi import LiteDRAMAXI2Native, LiteDRAMAXIPort
from litex.gen import ClockSignal, LiteXModule, ResetSignal, Signal
from litex.soc.integration.soc import SoCRegion
from litex.soc.interconnect import axi
from litex.soc.interconnect.csr_eventmanager import EventManager, EventSourceLevel
from migen import Cat, Constant, Instance

DATA = 64  # bits of the masters
READERS = 5  # bits of the IDs of scene reads
PAYLOAD = {"aw": ("addr", "len", "size", "burst"), "ar": ("addr", "len", "size", "burst"),
           "w": ("data", "strb", "last"), "r": ("data", "resp", "last"), "b": ("resp",)}
LITE = {"aw": ("addr",), "w": ("data", "strb"), "b": ("resp",), "ar": ("addr",),
        "r": ("data", "resp")}
UNSEEN = ("show_valid_o", "show_base_o", "m_video_tvalid", "m_video_tdata", "m_video_tuser",
          "m_video_tlast", "de_o", "hsync_o", "vsync_o", "active_o",
          *(f"m_{master}_{name}" for master, names in (
              ("scene", "arcache arprot arqos"), ("frame", "awid awcache awprot awqos"),
              ("scan", "arid arcache arprot arqos"))
            for name in names.split()))  # outputs that nothing looks at


def integer(value):
    """A parameter as wide as Verilog's own: W + WD of five bits each would lose one."""
    return Constant(value, (32, True))


def wires(prefix, bus, channels, master, payload):
    """Connections of some channels of an AXI bus, by the names of AXI."""
    ports = {}
    for name in channels:
        channel = getattr(bus, name)
        out = (name in ("aw", "w", "ar")) == master  # the block drives valid and the payload
        ports[f"{'o' if out else 'i'}_{prefix}_{name}valid"] = channel.valid
        ports[f"{'i' if out else 'o'}_{prefix}_{name}ready"] = channel.ready
        for field in payload[name]:
            signal = getattr(channel, field)
            signal = signal[:12] if payload is LITE and field == "addr" else signal
            ports[f"{'o' if out else 'i'}_{prefix}_{name}{field}"] = signal
    return ports


class Sphaera(LiteXModule):
    """The block; `core` has parameters of rt_top, gpdi the pads of a display or None."""

    def __init__(self, soc, core, files, gpdi=None, origin=0x90000000):
        soc.platform.add_sources("", *files)
        for folder in sorted({file.rpartition("/")[0] for file in files}):
            soc.platform.add_verilog_include_path(folder)
        self.registers = axi.AXILiteInterface(data_width=32, address_width=32)
        soc.bus.add_slave("sphaera", self.registers, SoCRegion(origin, 0x1000, cached=False))
        self.ev = EventManager()
        self.ev.block = EventSourceLevel()
        self.ev.finalize()
        memory = {}
        for name, channels in (("scene", ("ar", "r")), ("frame", ("aw", "w", "b")),
                               ("scan", ("ar", "r"))):
            bus = LiteDRAMAXIPort(DATA, address_width=32, id_width=READERS)
            port = soc.sdram.crossbar.get_port(data_width=DATA)
            self.add_module(f"{name}_port", LiteDRAMAXI2Native(
                bus, port, base_address=soc.bus.regions["main_ram"].origin))
            memory.update(wires(f"m_{name}", bus, channels, True, PAYLOAD))
            if name == "scene":
                memory.update(o_m_scene_arid=bus.ar.id, i_m_scene_rid=bus.r.id)
        symbols = [Signal(10, name=f"tmds{i}") for i in range(3)]
        self.specials += Instance(
            "rt_top", **{f"p_{name}": integer(value) for name, value in core.items()},
            p_DATA=integer(DATA), p_VIDEO=integer(1), i_clk=ClockSignal("sys"),
            i_rst=ResetSignal("sys"), o_irq_o=self.ev.block.trigger, i_take_i=0,
            i_pix_clk=ClockSignal("hdmi"), i_pix_rst=ResetSignal("hdmi"), i_m_video_tready=1,
            **memory,
            **wires("s_axil", self.registers, LITE, False, LITE),
            **{f"o_{name}": Signal() for name in UNSEEN},
            **{f"o_tmds{i}_o": symbols[i] for i in range(3)})
        if gpdi is not None:
            self.specials += Instance(
                "rt_serialise", i_pix_clk=ClockSignal("hdmi"), i_clk5=ClockSignal("hdmi5x"),
                i_symbol_i=Cat(*symbols, Constant(0b0000011111, 10)),
                o_pin_o=Cat(gpdi.data0_p, gpdi.data1_p, gpdi.data2_p, gpdi.clk_p))
