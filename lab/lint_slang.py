"""lint_slang.py - Verilog files through slang as SystemVerilog
SPDX-License-Identifier: Apache-2.0

python3 -m lab.lint_slang RTL_FOLDER... -- FILE...    each file a top, modules from the folders

Needs the Python package pyslang (10 or later). Outputs left open and names of files in vectors are
the habit of benches."""
import sys

from pyslang import driver


def clean(name, folders):
    """True if the file and all that it instantiates give no error and no warning."""
    run = driver.Driver()
    run.addStandardArgs()
    words = ["slang", "--relax-string-conversions", "-Wno-unconnected-output-port",
             "--libext", ".v"] + [w for f in folders for w in ("-y", f, "-I", f)] + [name]
    if not (run.parseCommandLine(" ".join(words)) and run.processOptions()
            and run.parseAllSources()):
        return False
    run.reportCompilation(run.createCompilation(), True)
    return run.diagEngine.numErrors == 0 and run.diagEngine.numWarnings == 0


split = sys.argv.index("--")
sys.exit(not all([clean(f, sys.argv[1:split]) for f in sys.argv[split + 1:]]))
