# wheel.py - what `pip install .` adds to the Python files: the library, and what it declares
# SPDX-License-Identifier: Apache-2.0
"""make compiles the library; cffi turns the one public header into a module of declarations. The
machine that installs a finished wheel needs neither compiler nor header. B names the build
folder, build if it is not in the environment."""
import os
import re
import subprocess
import sysconfig
from pathlib import Path

import cffi
from hatchling.builders.hooks.plugin.interface import BuildHookInterface

HEADER = "cmodel/sphaera/sphaera.h"


def declarations(text):
    """The header's text as cffi takes it: no preprocessor but `#define NAME number`."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.S)
    lines = [line for line in text.splitlines()
             if not line.startswith("#") or re.match(r"#define \w+ -?\w+$", line)]
    return "\n".join(lines).replace("SPHAERA_API ", "")


def declare(header, module):
    """Writes the module: `ffi` with all that the header declares."""
    ffi = cffi.FFI()
    ffi.set_source("sphaera._declared", None)
    ffi.cdef(declarations(Path(header).read_text(encoding="utf-8")))
    ffi.emit_python_code(str(module))


class Hook(BuildHookInterface):
    """Compiles, declares, and says which platform the wheel is of."""

    def initialize(self, version, build_data):
        build = os.environ.get("B", "build")
        release = Path(self.root, "VERSION").read_text(encoding="utf-8").strip()
        made = {f"{build}/dist/libsphaera.so.{release}": "sphaera/libsphaera.so"}
        clean = {k: v for k, v in os.environ.items()
                 if k not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "SPHAERA_JOBS")}
        subprocess.run(["make", "-s", f"B={build}", "library"], cwd=self.root, env=clean,
                       check=True)
        for part in "image", "mesh":        # each may be missing
            name = f"sphaera_{part}.so"
            if Path(self.root, build, name).exists():
                made[f"{build}/{name}"] = f"sphaera/{name}"
        module = Path(self.root, build, "dist/_declared.py")
        declare(Path(self.root, HEADER), module)
        made[str(module)] = "sphaera/_declared.py"
        build_data["force_include"].update(
            {str(Path(self.root, name)): place for name, place in made.items()})
        platform = re.sub("[-.]", "_", sysconfig.get_platform())
        build_data.update(pure_python=False, tag=f"py3-none-{platform}")
