# modes.py - the modes of rtl/video/modes.def, as a table
# SPDX-License-Identifier: Apache-2.0
from ..generate.modes import Modes


def modes():
    return Modes().table()
