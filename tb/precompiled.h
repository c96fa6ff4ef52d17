/* precompiled.h - what every harness of verilated code includes, read by clang once
 * SPDX-License-Identifier: Apache-2.0
 *
 * make/core.mk compiles it. Nothing needs it: each file includes what it uses.
 */
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <queue>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "verilated.h"
#include "verilated_syms.h"
