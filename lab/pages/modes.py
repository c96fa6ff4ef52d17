# modes.py - the modes of rtl/video/modes.def, as a table
# SPDX-License-Identifier: Apache-2.0
import subprocess


def modes():
    """What sim/modes.awk makes of the list for pages."""
    return subprocess.run(["awk", "-v", "lang=md", "-f", "sim/modes.awk", "rtl/video/modes.def"],
                          check=True, capture_output=True, text=True).stdout.rstrip("\n")
