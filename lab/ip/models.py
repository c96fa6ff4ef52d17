# models.py - register models by PeakRDL, run with the python of `make ip-setup`
# SPDX-License-Identifier: Apache-2.0
import sys

from peakrdl_html import HTMLExporter
from peakrdl_uvm import UVMExporter
from systemrdl import RDLCompiler

if __name__ == "__main__":
    rdl, uvm, html = sys.argv[1:]
    compiler = RDLCompiler()
    compiler.compile_file(rdl)
    top = compiler.elaborate()
    UVMExporter().export(top, uvm)
    HTMLExporter().export(top, html)
