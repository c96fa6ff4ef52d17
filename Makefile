# Makefile - Sphaera: golden model, tool, simulations, tests; `make` alone prints help
# SPDX-License-Identifier: Apache-2.0

# What somebody gives is text: make expands none of it, and a shell gets it in quotes, or after
# sim/front.py found that it is a plain word. What neither could do ends here.
define newline


endef
odd      = $$ ' " ` \ ; & | < > ( ) { } [ ] * ? ! ~ \# % : =
has_odd  = $(strip $(foreach c,$(odd),$(findstring $c,$(1)))$(if $(findstring $(newline),$(1)),x))
as_text  = $(foreach v,$(1),$(if $(findstring $$,$(value $v))$(findstring $(newline),$(value $v)), \
    $(error $v=$(value $v): has a $$ or a new line, of which make would make something else)))
quoted   = '$(subst ','\'',$(1))'
# a file by its whole name, as a command has it: $(abspath) takes a blank for an end
absolute = "$$(realpath -ms -- $(1))"
GIVEN   := $(strip $(foreach v,$(.VARIABLES),$(if $(filter command,$(origin $v)),$v)))
$(call as_text,$(GIVEN))
# Of NAME:=VALUE make has expanded the value before it reads this file.
$(foreach v,$(GIVEN),$(if $(filter simple,$(flavor $v)),$(error $v:=: only NAME=VALUE is text)))
override SHELL := /bin/sh
$(foreach v,$(filter CURDIR MAKE MAKECMDGOALS MAKEFILE_LIST,$(GIVEN)),$(error $v is make's own))
$(if $(call has_odd,$(MAKECMDGOALS)),$(error there is no target $(MAKECMDGOALS)))

# Called as make -f elsewhere/Makefile: make goes to where this file is, and builds there; a
# relative SCENE is looked for where it was called.
override HERE := $(if $(filter-out Makefile,$(MAKEFILE_LIST)),$(shell \
    file=$(call quoted,$(MAKEFILE_LIST)); file=$${file# }; [ -e "$$file" ] || file=$${file##* }; \
    here=$$PWD; cd -- "$$(dirname -- "$$file")" && [ . -ef "$$here" ] || pwd))
ifneq ($(HERE),)
.DEFAULT_GOAL := elsewhere
.PHONY: elsewhere $(MAKECMDGOALS)
export FROM := $(CURDIR)
elsewhere:
	+@$(MAKE) -C $(call quoted,$(HERE)) $(MAKECMDGOALS)
$(MAKECMDGOALS): elsewhere ; @:
else

include make/variables.mk

# Names in make/variables.mk; the names' values before a command.
VARIABLES := $(shell sed -n 's/^\#\# \([A-Z_][A-Z_]*\) .*/\1/p' make/variables.mk)
values = $(foreach v,$(1),$v=$(call quoted,$($v)))
# What the command line or the environment has is checked, and whether goals have the programs
# that they need. In the environment BUILD is the folder of scripts and tests.
SURROUND := $(filter-out BUILD,$(VARIABLES))
CHECK := $(strip $(foreach v,$(VARIABLES),$(if $(filter command \
             $(if $(filter $v,$(SURROUND)),environment),$(origin $v)),$v)))
$(call as_text,$(CHECK))
# All else that the environment has is text to whoever names it, and not what make makes of it.
$(foreach v,$(filter-out $(SURROUND) MAKE%,$(.VARIABLES)),\
    $(if $(filter environment,$(origin $v)),$(eval $v := $$(value $v))))
# That is Python's work; the system's own starts at once.
front := $(or $(wildcard /usr/bin/python3),$(shell command -v python3))
ifneq ($(front),)
front += -ES sim/front.py
else
$(if $(filter setup,$(MAKECMDGOALS)),,$(error there is no python3 here: make setup installs it))
endif
ask = $(if $(front),$(if $(shell $(1) $(front) $(2) || echo wrong),$(error nothing is made)))
ifneq ($(GIVEN)$(CHECK)$(filter sim synth price,$(MAKECMDGOALS)),)
$(call ask,$(call values,$(VARIABLES)),values $(call quoted,$(GIVEN)) '$(MAKECMDGOALS)' $(CHECK))
endif
# What is asked for besides setup is made by a make that finds what was installed.
OTHERS := $(filter-out setup,$(MAKECMDGOALS))
ifneq ($(and $(OTHERS),$(filter setup,$(MAKECMDGOALS))),)
$(call ask,,goals '$(OTHERS)' Makefile $(wildcard make/*.mk))
.PHONY: setup installed $(OTHERS)
setup:
	@sh sim/setup.sh --for $(OTHERS)
installed: setup
	+@$(MAKE) --no-print-directory $(OTHERS)
$(OTHERS): installed ; @:
else

# Make has no words with blanks: a folder of such a name is called by a link.
ifneq ($(call has_odd,$B)$(word 2,$B),)
override B := $(shell sh sim/folder.sh $(call quoted,$B))
endif

# JOBS commands at once; a make that is called by this one, or by a script of it, shares them.
ifndef SPHAERA_JOBS
export SPHAERA_JOBS := $(JOBS)
MAKEFLAGS += -j$(JOBS)
endif

comma := ,
Q := $(if $(filter 1,$(V)),,@)
# On a terminal hundreds of files share one line, with their number, which what is said next takes.
shown    = $(if $(filter 1,$(V)),,@form='  %-4s %s\n'; [ ! -t 1 ] || form='\033[K  $(1)'; \
               printf "$$form" $(2) $(3))
say      = $(call shown,%-4s %s\n,$(1),$(2))
progress = $(eval files += x)$(call shown,%-4s $(words $(files)) %s\r,$(1),$(2))
files   :=

# A compiler cache, if there is one: `make setup` installs it. The compiler tells it what a file
# includes, which saves a preprocessor before each; the list of packages stands for their headers.
CCACHE   := $(shell sh sim/ccache.sh)
export CCACHE_DEPEND     := 1
export CCACHE_EXTRAFILES := $(wildcard /var/lib/dpkg/status)
CC       := $(CCACHE) gcc
CXX      := $(CCACHE) g++
# Of another compiler or library a warning ends no build but that of .ci/run.
WARN     := -Wall -Wextra -Wconversion -Wshadow $(if $(CI),-Werror)
CFLAGS   := -std=c11 -D_GNU_SOURCE -O3 $(WARN) -Icmodel
CXXFLAGS := -std=c++17 -O2 $(WARN) -Icmodel
# The same objects serve the tool and the shared library, which exports what sphaera.h has.
SHARED   := -fPIC -fvisibility=hidden
SANITIZE := -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all
THREADED := -O1 -g1 -fsanitize=thread
CLANG_CC := $(CCACHE) clang
# of programs that tests run
LINKER   := $(shell sh sim/linker.sh)
# __SANITIZE_ADDRESS__ as gcc defines it
CLANG_SANITIZE := -O0 -gline-tables-only -fsanitize=address,undefined -fno-sanitize-recover=all \
                  -D__SANITIZE_ADDRESS__
CLANG_FLAGS    = -std=c11 -D_GNU_SOURCE -Icmodel $(CLANG_SANITIZE)
# Looked up when used.
pkg         = $(shell pkg-config $(1))
MODEL_LIBS  = -Wl,--as-needed $(call pkg,--libs $(MODEL_PACKAGES)) -lm
IMAGE_LIBS  = $(call pkg,--libs OpenImageIO)
# What the model library itself asks of pkg-config.
MODEL_PACKAGES := expat gmp libpng mpfr zlib
# 1 if there is OpenImageIO, which reads textures; assimp, which reads meshes: make/mesh.mk; if the
# live view can have a window: make/view.mk
exists      = $(shell pkg-config --exists $(1) 2>/dev/null && echo 1)
OIIO       := $(call exists,OpenImageIO)
ASSIMP     := $(call exists,assimp jansson)
SDL        := $(call exists,sdl2)

# Programs that make a table, run by hand; never part of the library.
GENERATORS := cmodel/math/gen_rsqrt.c cmodel/math/gen_reciprocal.c cmodel/texture/gen_log2.c \
              cmodel/shade/gen_power.c cmodel/shade/gen_power_rom.c
C_FILES    := $(sort $(shell find cmodel -name '*.c'))
MESH_C     := $(filter cmodel/scene/assimp/%,$(C_FILES))
LIB_C      := $(filter-out cmodel/tool/% cmodel/image/% cmodel/sphaera/% cmodel/view/% \
                $(GENERATORS) $(MESH_C),$(C_FILES))
SDL_C      := $(filter cmodel/view/sdl/%,$(C_FILES))
VIEW_C     := $(filter-out $(SDL_C),$(filter cmodel/view/%,$(C_FILES)))
TOOL_C     := $(filter cmodel/tool/%,$(C_FILES)) $(VIEW_C) driver/sphaera.c
IMAGE_CXX  := $(if $(OIIO),$(sort $(wildcard cmodel/image/*.cpp)))
LAZY_C     := cmodel/image/lazy.c
IMAGE_C    := $(filter-out $(LAZY_C),$(filter cmodel/image/%,$(C_FILES)))
API_C      := $(filter cmodel/sphaera/%,$(C_FILES))

MODEL := $B/libsphaera.a
IMAGE  := $B/libsphaera_image.a
PICTURE := $(if $(OIIO),$B/sphaera_image.so)
MESHES := $(if $(ASSIMP),$B/sphaera_mesh.so)
VIEWER := $(if $(SDL),$B/sphaera_view.so)
TOOL   := $B/sphaera

.DELETE_ON_ERROR:
.SUFFIXES:
# What `make` alone prints: targets and variables that most need.
USUAL := help-all setup tool render sim film synth test bench gallery pages install clean \
         SCENE SIZE PROFILE DEPTH EFFECTS PIPES SEED LATENCY SIM WAVES JOBS

.PHONY: help help-all setup all tool layout render sim test synth lint bench clean FORCE
.DEFAULT_GOAL := help

help = @$(call values,$(VARIABLES)) $(front) help '$(1)' $(MAKEFILE_LIST)
help:
	$(call help,$(USUAL))
help-all: ## every target and variable
	$(call help)

.PHONY: images-setup
setup: ## install packages (apt) that the goals beside it need, or all: sim/packages.txt
	@sh sim/setup.sh --for
images-setup: ## installs OpenImageIO (apt): textures of other kinds than PPM, pictures than PNG
	@sh sim/setup.sh --for $@

all: tool ## everything that is built without simulators
tool: $(TOOL) ## the command-line tool build/sphaera

include make/objects.mk make/sim.mk make/bench.mk make/lab.mk make/lint.mk \
        make/synth.mk make/ip.mk make/install.mk make/test.mk make/hard.mk make/formal.mk \
        make/top.mk make/board.mk make/view.mk make/mesh.mk make/host.mk make/mutants.mk \
        make/fuzz.mk make/neon.mk

# Checked here, since make/objects.mk may make a target of any goal.
ifneq ($(MAKECMDGOALS),)
$(call ask,,goals '$(MAKECMDGOALS)' $(MAKEFILE_LIST))
endif

layout: ## what follows from machine.def, top.def, bundles.def, modes.def, VERSION, files of rtl
	$(call say,GEN,"layout.h rt_layout.vh rt_effects*.vh rt_core_*.vh rt_top.vh sphaera_regs.h")
	$(call say,GEN,"rt_modes.vh sphaera_modes.h rt_bundles.vh bundles.h and fields beside ports")
	$(call say,GEN,"sphaera.f sphaera.core")
	$(Q)python3 -m lab layout

clean: ## remove build/
	$(Q)[ ! -L $B ] || rm -rf -- "$$(realpath -- $B)"; rm -rf $B

endif # setup with others
endif # elsewhere
