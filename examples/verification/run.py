# run.py - an example of cocotb in Icarus
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 examples/verification/run.py core|top MACHINE.sph FOLDER [RTL]

In the repository's root. Builds rt_core or rt_top for what the machine asks for, of the sources in
rtl or RTL, in FOLDER, and runs cocotb_core.py or cocotb_top.py. Exits with 1 if a test fails."""
import sys
from pathlib import Path

import sphaera
from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

sys.path += [str(Path(name).resolve()) for name in (".", "tb/vip")]  # cocotb hands them on
from lab.top.cocotb_run import wrapper  # noqa: E402  pylint: disable=wrong-import-position


def main(which, machine, folder, rtl="rtl"):
    sources = sorted(path for path in Path(rtl).rglob("*.v") if "board" not in path.parts)
    parameters, top = sphaera.Machine.read(machine).parameters, "rt_core"
    if which == "top":
        sources.append(Path(folder, "cocotb_top.v"))
        sources[-1].parent.mkdir(parents=True, exist_ok=True)
        sources[-1].write_text(wrapper([("DATA", "DATA"), ("MEM_DATA", "MEM_DATA"),
                                        ("ADDR", "ADDR"), *parameters.items()]), encoding="utf-8")
        parameters, top = {}, "cocotb_top"
    runner = get_runner("icarus")
    runner.build(sources=sources, hdl_toplevel=top, build_args=["-g2005"], build_dir=folder,
                 includes=sorted({path.parent for path in Path(rtl).rglob("*.vh")}),
                 parameters=parameters, always=True)
    results = runner.test(test_module=f"cocotb_{which}", hdl_toplevel=top, build_dir=folder,
                          test_dir=folder, extra_env={
                              "MACHINE": str(Path(machine).resolve()),
                              "RDL": str(Path("docs/reference/rt_top.rdl").resolve()),
                              "COCOTB_LOG_LEVEL": "WARNING"})
    tests, failed = get_results(results)
    print(f"cocotb, {which}: {tests - failed} of {tests} tests passed")
    return failed > 0


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
