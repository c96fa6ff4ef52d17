# Makefile - Sphaera: golden model, tool, simulations, tests; `make` alone prints help
# SPDX-License-Identifier: Apache-2.0

# Variables, shown by `make help`: name, what it is.
## SCENE       scene file (.nff) to render or simulate
SCENE ?= scenes/sphereflake2.nff
## PROFILE     draft, standard, fine or reference; widths of its own: NAME:w=14,wd=15,pr=20,...
PROFILE ?= standard
## SIZE        frame, pixels (empty: as the scene file says)
SIZE ?= 320x180
## TREE        balanced or paper
TREE ?= balanced
## ACCEL       bvh4 (spheres around four children, by TREE), bih or brute
ACCEL ?= bvh4
## MAX_PRIMS   of bih: a leaf of no more primitives is not cut (empty: 4)
MAX_PRIMS ?=
## MAX_TREE_DEPTH of bih: its levels (empty: as many as the stack has)
MAX_TREE_DEPTH ?=
## DEPTH       reflections, 0 to 5
DEPTH ?= 2
## BACKGROUND  pixels that are never traced: none, rect, spans or exact
BACKGROUND ?= none
## TRAVERSE    which hit a primary ray takes: nearest or first (the paper's)
TRAVERSE ?= nearest
## LEVELS      exact background: 0 the root sphere, 1 its children, 2 theirs (empty: 0)
LEVELS ?=
## AT          frame that moving primitives are moved to (empty: 0)
AT ?=
## BUILD_MORE  other options of `sphaera build`, such as --inside off
BUILD_MORE ?=
## EFFECTS     of the core: auto (as the scene asks), all, all-NAME, none, or joined by + of
##             {words}; all leaves out {not in all}
EFFECTS ?= auto
## ENGINES     tracing engines in the core
ENGINES ?= 1
## ROOT_STEP   bits that a root of the core gains a clock
ROOT_STEP ?= 2
## QUOTIENT_STEP bits that a quotient of the core gains a clock
QUOTIENT_STEP ?= 2
## SEED        of generated scenes and of random stalls
SEED ?= 1
## LATENCY     of the simulated memory, clocks
LATENCY ?= 20
## STALL       percent of clocks in which the simulated memory is not ready
STALL ?= 0
## SIM         verilator or icarus
SIM ?= verilator
## WAVES       1: write a waveform
WAVES ?= 0
## JOBS        commands run at once
JOBS ?= $(shell nproc)
## V           1: print whole commands
V ?= 0

B := build
Q := $(if $(filter 1,$(V)),,@)
say = $(if $(filter 1,$(V)),,@printf '  %-4s %s\n' $(1) $(2))

# A compiler cache, if there is one: `make setup` installs it.
CCACHE   := $(shell sh sim/ccache.sh)
CC       := $(CCACHE) gcc
CXX      := $(CCACHE) g++
WARN     := -Wall -Wextra -Wconversion -Wshadow -Werror
CFLAGS   := -std=c11 -D_GNU_SOURCE -O3 $(WARN) -Icmodel -fopenmp
CXXFLAGS := -std=c++17 -O2 $(WARN) -Icmodel
SANITIZE := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all
CLANG_CC := $(CCACHE) clang
# gcc's omp.h, whose malloc attribute clang does not know; __SANITIZE_ADDRESS__ as gcc defines it
CLANG_OMP      = -idirafter $(dir $(shell $(CC) -print-file-name=include/omp.h)) '-D__malloc__(x)='
CLANG_SANITIZE := -O0 -gline-tables-only -fsanitize=address,undefined -fno-sanitize-recover=all \
                  -D__SANITIZE_ADDRESS__
# without threads: the loops of OpenMP run one after another
CLANG_FLAGS    = -std=c11 -D_GNU_SOURCE -Icmodel -fopenmp=libgomp $(CLANG_OMP) $(CLANG_SANITIZE)
# Looked up when used, so that `make setup` may install them first.
pkg         = $(shell pkg-config $(1))
MODEL_LIBS  = -Wl,--as-needed $(call pkg,--libs $(MODEL_PACKAGES)) -lm
IMAGE_LIBS  = $(call pkg,--libs OpenImageIO)
# What the model library itself asks of pkg-config.
MODEL_PACKAGES := expat gmp mpfr

# Programs that make a table, run by hand; never part of the library.
GENERATORS := cmodel/math/gen_rsqrt.c cmodel/texture/gen_log2.c cmodel/shade/gen_power.c \
              cmodel/shade/gen_power_rom.c
C_FILES    := $(sort $(shell find cmodel -name '*.c'))
LIB_C      := $(filter-out cmodel/tool/% $(GENERATORS),$(C_FILES))
TOOL_C     := $(filter cmodel/tool/%,$(C_FILES))
IMAGE_CXX  := $(sort $(wildcard cmodel/image/*.cpp))

LIB    := $B/libsphaera.a
IMAGE  := $B/libsphaera_image.a
TOOL   := $B/sphaera

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: help setup all tool layout render sim test synth lint bench clean FORCE
.DEFAULT_GOAL := help

help: export HELP_VALUES = $(foreach v,SCENE PROFILE SIZE TREE ACCEL MAX_PRIMS MAX_TREE_DEPTH \
                           DEPTH BACKGROUND TRAVERSE LEVELS AT BUILD_MORE EFFECTS ENGINES \
                           ROOT_STEP QUOTIENT_STEP SEED LATENCY STALL SIM WINDOW WARM TARGET FLAT \
                           WAVES JOBS V,$(v)=$($(v));)
help: ## this text
	@awk -f cmodel/machine/effects.awk -f sim/help.awk cmodel/machine/machine.def $(MAKEFILE_LIST)

setup: ## install missing packages (apt), see sim/packages.txt
	@sh sim/setup.sh

all: tool ## everything that is built without simulators
tool: $(TOOL) ## the command-line tool build/sphaera

include make/objects.mk make/sim.mk make/pages.mk make/bench.mk make/lint.mk make/background.mk \
        make/textures.mk make/scenarios.mk make/study.mk make/synth.mk \
        make/effects.mk make/test.mk make/image.mk make/hard.mk make/formal.mk

layout: ## headers and parameters of the core from machine.def, of its bundles from bundles.def
	$(call say,GEN,"layout.h rt_layout.vh rt_bundles.vh bundles.h")
	$(Q)sh sim/layout.sh
	$(Q)sh sim/bundles.sh rtl/engine/rt_bundles.vh tb/bundles.h

clean: ## remove build/
	$(Q)rm -rf $B
