# verilated.mk - how C++ that Verilator wrote is compiled, for cores and benches of blocks
# SPDX-License-Identifier: Apache-2.0
#
# Included by core.mk; by itself called by tb/run_bench.sh, under the lock of core.mk's tools:
#   bench-tools  build/sim/obj/compile-OPT, the command that compiles, and all that it needs;
#                Verilator's library as build/sim/obj/bench_*.o

B   ?= build
OPT ?= -O1
# One name for one folder: it is a part of commands and of what the compiler says of dependencies.
override B := $(if $(filter /%,$B),$(B:$(CURDIR)/%=%),$B)
S   := $B/sim

# clang takes half of gcc's time, and the code runs faster; g++ links, for libgomp.
CCACHE := $(shell sh sim/ccache.sh)
LINKER := $(shell sh sim/linker.sh)
VERILATOR := $(strip $(shell sh sim/allocator.sh) verilator)
CLANG  := $(if $(shell command -v clang++),clang++)
ROOT   := $(shell verilator --getenv VERILATOR_ROOT)/include
HEADERS := -isystem $(ROOT) -isystem $(ROOT)/vltstd

# What all harnesses include is read once. clang asks that both sides optimise, or neither; ccache
# takes the text of NAME.pch.sum for it. With CCACHE_DEPEND the compiler tells what a file includes,
# and no preprocessor is run before it: by -MD, for what Verilator wrote counts as system headers.
EFFORT      := $(if $(filter -O0,$(OPT)),-O0,-O1)
PRECOMPILED := $(if $(CLANG),$S/obj/precompiled$(EFFORT).pch)
PRECOMPILE  := $(CLANG) -std=c++17 $(EFFORT) -x c++-header -Xclang -fno-pch-timestamp $(HEADERS)
REMEMBER    := env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1 \
                   CCACHE_BASEDIR=$(CURDIR) CCACHE_DEPEND=1 ccache
COMPILE     := $(if $(CLANG),$(CCACHE:ccache=$(REMEMBER)) $(CLANG) -include-pch $(PRECOMPILED), \
                   $(CCACHE) $(CXX)) \
                   -std=c++17 $(OPT) -Wall -Wextra -I. -Icmodel -Itb $(HEADERS)

# Written anew only when its text changes.
stamp = @mkdir -p $(@D); echo '$(1)' >$@.$$$$; cmp -s $@.$$$$ $@ && rm $@.$$$$ || mv $@.$$$$ $@

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: bench-tools FORCE
bench-tools: $S/obj/compile$(OPT) $S/obj/link $(PRECOMPILED) $S/obj/bench_verilated.o \
             $S/obj/bench_verilated_threads.o

$S/obj/compile$(OPT): FORCE
	$(call stamp,$(COMPILE))
$S/obj/link: FORCE
	$(call stamp,$(CXX) $(LINKER))
$(PRECOMPILED).sum: FORCE
	$(call stamp,$(PRECOMPILE) $(shell $(CLANG) --version | head -n 1) \
	    $(shell cat tb/precompiled.h $(ROOT)/verilated*.h | cksum))
$(PRECOMPILED): tb/precompiled.h $(PRECOMPILED).sum
	$(PRECOMPILE) $< -o $@

$S/obj/bench_%.o: $(ROOT)/%.cpp
	@mkdir -p $(@D)
	$(CCACHE) $(CXX) -std=c++17 -O2 -w $(HEADERS) -c $< -o $@
