# run.py - an example of cocotb in Icarus
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 examples/verification/run.py core|top MACHINE.sph FOLDER [RTL]

In the repository's root. Builds rt_core or rt_top for what the machine asks for, of the sources in
rtl or RTL, in FOLDER, and runs cocotb_core.py or cocotb_top.py. Exits with 1 if a test fails."""
import sys
from pathlib import Path

import sphaera

sys.path += [str(Path(name).resolve()) for name in (".", "tb/vip")]  # cocotb hands them on
from lab.top.cocotb_run import SIZES, simulate  # noqa: E402  pylint: disable=wrong-import-position


def main(which, machine, folder, rtl="rtl"):
    parameters, wrapped = sphaera.Machine.read(machine).parameters, None
    if which == "top":
        parameters, wrapped = {}, [*SIZES, *parameters.items()]
    return simulate(which, folder, f"cocotb_{which}", {"MACHINE": machine}, parameters, wrapped,
                    rtl)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
