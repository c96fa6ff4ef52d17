# component.py - component.xml: rt_top of one configuration in IP-XACT, IEEE 1685-2014
# SPDX-License-Identifier: Apache-2.0
"""Bus interfaces by the names of ports, registers from top.def and machine.def, files of the
folder. Elements stand in the order of the schema."""
import xml.etree.ElementTree as ET

SPACE = "http://www.accellera.org/XMLSchema/IPXACT/1685-2014"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
ET.register_namespace("ipxact", SPACE)
ET.register_namespace("xsi", INSTANCE)
# prefix of ports, bus of AMBA4, its release, part that rt_top plays, what it is
BUSES = (("s_axil", "AXI4-Lite", "r0p0_0", "slave", "registers"),
         ("m_scene", "AXI4", "r0p0_0", "master", "reads of the scene"),
         ("m_frame", "AXI4", "r0p0_0", "master", "writes to the frame store"),
         ("m_scan", "AXI4", "r0p0_0", "master", "reads of the frame that is shown"),
         ("m_video", "AXI4Stream", "r0p0_1", "master", "pixels of the display"))
ACCESS = {"ro": "read-only", "rw": "read-write", "wo": "write-only", "w1c": "read-write"}
TYPES = {"v": "verilogSource", "vh": "verilogSource", "sv": "systemVerilogSource", "c": "cSource",
         "h": "cSource", "sdc": "SDC", "xdc": "tclSource"}      # of a file, by its ending
BLOCK = 4096        # bytes of registers


def add(parent, tag, text=None, **attributes):
    found = ET.SubElement(parent, f"{{{SPACE}}}{tag}", attributes)
    if text is not None:
        found.text = str(text)
    return found


def group(parent, tag, entries):
    """A list, which the schema does not have empty."""
    if entries:
        whole = add(parent, tag)
        for entry in entries:
            entry(whole)


def bus_interface(prefix, bus, release, part, about, ports, address):
    def entry(parent):
        one = add(parent, "busInterface")
        add(one, "name", prefix)
        add(one, "description", about)
        name = {"vendor": "amba.com", "library": "AMBA4", "version": release}
        add(one, "busType", name=bus, **name)
        kind = add(add(one, "abstractionTypes"), "abstractionType")
        add(kind, "abstractionRef", name=f"{bus}_rtl", **name)
        maps = add(kind, "portMaps")
        for port in ports:
            if port.startswith(prefix + "_"):
                pair = add(maps, "portMap")
                add(add(pair, "logicalPort"), "name", port[len(prefix) + 1:].upper())
                add(add(pair, "physicalPort"), "name", port)
        mode = add(one, part)
        if part == "slave":
            add(mode, "memoryMapRef", memoryMapRef="registers")
        elif address:
            add(mode, "addressSpaceRef", addressSpaceRef="memory")
    return entry


def register(parent, name, offset, access, about, fields, number):
    """fields: (Field, value after reset or None)"""
    one = add(parent, "register")
    add(one, "name", name)
    add(one, "description", about)
    add(one, "addressOffset", f"'h{number(offset):x}")
    add(one, "size", 32)
    add(one, "volatile", str(access in ("ro", "w1c")).lower())
    add(one, "access", ACCESS[access])
    for field, reset in fields:
        part = add(one, "field")
        add(part, "name", field.name)
        add(part, "description", field.about)
        add(part, "bitOffset", field.lsb)
        if reset is not None:
            add(add(add(part, "resets"), "reset"), "value", f"'h{reset:x}")
        add(part, "bitWidth", field.width)
        add(part, "access", ACCESS[access])
        if access == "w1c":
            add(part, "modifiedWriteValue", "oneToClear")


def port(name, way, bits):
    def entry(parent):
        one = add(parent, "port")
        add(one, "name", name)
        wire = add(one, "wire")
        add(wire, "direction", {"input": "in", "output": "out"}[way])
        if bits > 1:
            vector = add(add(wire, "vectors"), "vector")
            add(vector, "left", bits - 1)
            add(vector, "right", 0)
    return entry


def file(name):
    def entry(parent):
        one = add(parent, "file")
        add(one, "name", name)
        add(one, "fileType", TYPES.get(name.rpartition(".")[2], "user"))
        if name.endswith(".vh"):
            add(one, "isIncludeFile", "true")
    return entry


def text(registers, ports, parameters, files, release, address_bits):
    """registers: generate.top.Registers; ports: {name: (way, bits)}; parameters: {name: (value,
    what it is)}; files: of the folder, by their paths in it."""
    root = ET.Element(f"{{{SPACE}}}component", {
        f"{{{INSTANCE}}}schemaLocation": f"{SPACE} {SPACE}/index.xsd"})
    for tag, value in (("vendor", "sphaera"), ("library", "graphics"), ("name", "rt_top"),
                       ("version", release)):
        add(root, tag, value)
    group(root, "busInterfaces", [bus_interface(*bus, ports, bus[1] == "AXI4") for bus in BUSES])
    space = add(add(root, "addressSpaces"), "addressSpace")
    for tag, value in (("name", "memory"), ("range", 1 << address_bits), ("width", 32)):
        add(space, tag, value)
    memory = add(add(root, "memoryMaps"), "memoryMap")
    add(memory, "name", "registers")
    block = add(memory, "addressBlock")
    for tag, value in (("name", "rt_top"), ("baseAddress", 0), ("range", BLOCK), ("width", 32)):
        add(block, tag, value)
    for row in registers.rows():
        register(block, *row, registers.number)
    add(memory, "addressUnitBits", 8)
    model = add(root, "model")
    view = add(add(model, "views"), "view")
    add(view, "name", "rtl")
    add(view, "componentInstantiationRef", "verilog")
    made = add(add(model, "instantiations"), "componentInstantiation")
    for tag, value in (("name", "verilog"), ("language", "verilog"), ("moduleName", "rt_top")):
        add(made, tag, value)

    def value_of(name, value, about, kind):
        def entry(parent):
            one = add(parent, kind, parameterId=name, type="int")
            add(one, "name", name)
            add(one, "description", about)
            add(one, "value", value)
        return entry
    group(made, "moduleParameters",
          [value_of(n, v, about, "moduleParameter") for n, (v, about) in parameters.items()])
    add(add(made, "fileSetRef"), "localName", "rtl")
    group(model, "ports", [port(n, *of) for n, of in ports.items()])
    sets = add(root, "fileSets")
    for name, own in (("rtl", [f for f in files if f.startswith("rtl/")]),
                      ("others", [f for f in files if not f.startswith("rtl/")])):
        one = add(sets, "fileSet")
        add(one, "name", name)
        for entry in map(file, own):
            entry(one)
    add(root, "description", "Ray tracer: AXI4-Lite registers, AXI4 masters, video")
    ET.indent(root)
    return ET.tostring(root, encoding="unicode", xml_declaration=True) + "\n"
