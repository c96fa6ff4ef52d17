# cocotb_run.py - builds cocotb_top.v in Icarus and runs the tests of cocotb_top.py
# SPDX-License-Identifier: Apache-2.0
"""NAME=VALUE: parameters of the core. Exits with 1 if a test fails."""
from pathlib import Path

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner


def main(folder, machine, frame, data, *parameters):
    sources = sorted(path for path in Path("rtl").rglob("*.v") if "board" not in path.parts)
    runner = get_runner("icarus")
    core = ", ".join(".{}({})".format(*parameter.split("=")) for parameter in parameters)
    runner.build(sources=[*sources, Path("tb/top/cocotb_top.v")], hdl_toplevel="cocotb_top",
                 includes=sorted({path.parent for path in Path("rtl").rglob("*.vh")}),
                 build_args=["-g2005"], defines={"CORE_PARAMETERS": core},
                 parameters={"DATA": min(int(data), 128), "MEM_DATA": data}, build_dir=folder,
                 always=True)
    results = runner.test(test_module="lab.top.cocotb_top", hdl_toplevel="cocotb_top",
                          build_dir=folder, test_dir=folder, extra_env={
                              "MACHINE": str(Path(machine).resolve()),
                              "FRAME": str(Path(frame).resolve()),
                              "RDL": str(Path("docs/reference/rt_top.rdl").resolve()),
                              "PYTHONPATH": str(Path.cwd()), "COCOTB_LOG_LEVEL": "WARNING"})
    tests, failed = get_results(results)
    print(f"cocotb, {data} bits: {tests - failed} of {tests} tests passed")
    return failed > 0
