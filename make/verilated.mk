# verilated.mk - how C++ that Verilator wrote is compiled, for cores and benches of blocks
# SPDX-License-Identifier: Apache-2.0
#
# Included by core.mk; by itself called by lab/benches, under the lock of core.mk's tools:
#   bench-tools  build/sim/obj/compile-OPT, the command that compiles, and all that it needs;
#                Verilator's library as build/sim/obj/bench_*.o; build/sim/obj/versions, of all

B   ?= build
OPT ?= -O1
# One name for one folder: it is a part of commands and of what the compiler says of dependencies.
override B := $(if $(filter /%,$B),$(shell sh sim/folder.sh '$B'),$B)
S   := $B/sim

# clang takes half of gcc's time, and the code runs faster; g++ links.
CCACHE := $(shell sh sim/ccache.sh)
LINKER := $(shell sh sim/linker.sh)
# Of another Verilator a new warning ends no run but those of .ci/run.
VERILATOR := $(strip $(shell sh sim/allocator.sh) verilator) $(if $(CI),,-Wno-fatal)
CLANG  := $(if $(shell command -v clang++),clang++)
ROOT   := $(shell verilator --getenv VERILATOR_ROOT)/include
HEADERS := -isystem $(ROOT) -isystem $(ROOT)/vltstd

# What all harnesses include is read once. clang asks that both sides optimise, or neither; how
# ccache is to take that, and which folder it leaves out of what it compares, says sim/ccache.sh.
EFFORT      := $(if $(filter -O0,$(OPT)),-O0,-O1)
PRECOMPILED := $(if $(CLANG),$S/obj/precompiled$(EFFORT).pch)
PRECOMPILE  := $(CLANG) -std=c++17 $(EFFORT) -x c++-header -Xclang -fno-pch-timestamp $(HEADERS)
COMPILE     := $(if $(CLANG),$(CCACHE:ccache=sh sim/ccache.sh) $(CLANG) -include-pch \
                   $(PRECOMPILED),$(CCACHE) $(CXX)) \
                   -std=c++17 $(OPT) -Wall -Wextra -I. -Icmodel -Itb $(HEADERS)

include make/stamp.mk
# what a harness is made with, besides Verilator
HOST := $(CXX) $(CLANG)

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: bench-tools FORCE
bench-tools: $S/obj/compile$(OPT) $S/obj/link $S/obj/versions $(PRECOMPILED) \
             $S/obj/bench_verilated.o $S/obj/bench_verilated_threads.o

$S/obj/compile$(OPT): FORCE
	$(call stamp,$(COMPILE))
$S/obj/link: FORCE
	$(call stamp,$(CXX) $(LINKER))
$S/obj/versions: FORCE
	$(call stamp,,verilator $(HOST))
$(PRECOMPILED).sum: FORCE
	$(call stamp,$(PRECOMPILE) \
	    $(shell cat tb/precompiled.h $(ROOT)/verilated*.h | cksum),$(CLANG))
$(PRECOMPILED): tb/precompiled.h $(PRECOMPILED).sum
	$(PRECOMPILE) $< -o $@

$S/obj/bench_%.o: $(ROOT)/%.cpp $S/obj/versions
	@mkdir -p $(@D)
	$(CCACHE) $(CXX) -std=c++17 -O2 -w $(HEADERS) -c $< -o $@
