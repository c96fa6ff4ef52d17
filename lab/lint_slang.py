# lint_slang.py - Verilog files through slang as SystemVerilog
# SPDX-License-Identifier: Apache-2.0
"""Each FILE is a top, with modules from FOLDERS, words of one argument. Needs the Python package
pyslang (10 or later). Outputs left open and names of files in vectors are the habit of benches."""
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


def main(folders, *files):
    return not all([clean(name, folders.split()) for name in files])
