# core.mk - builds the harness of the core for one simulator and one set of parameters
# SPDX-License-Identifier: Apache-2.0
#
# Called by sim/core.sh, which holds a lock for each of these targets:
#   tools    build/sim/tb_core_icarus (every machine), objects that all harnesses share
#   core     build/sim/KEY/tb_core    (Verilator)
#   icarus   build/sim/KEY/tb_core.vvp
#   cxxrtl   build/sim/KEY/tb_core_cxxrtl
#   ecp5, xc7  build/sim/KEY/FAMILY.json, the netlist
#   silicon  build/sim/KEY/core.so, cells of the library LIBERTY as a program; memories of MACROS
#   netlist  build/sim/tb_core_netlist, which simulates any of these
# KEY, which sim/core.sh gives, names every parameter that shapes the core; what it is elaborated
# and compiled with stands, with the versions of these tools, in files `flags` of build/sim/KEY and
# build/sim/obj, and a change of these builds anew.

B       ?= build
RTL     ?= rtl
# PROFILE: a name, alone or with widths of its own, as sim/cores.py takes it
PROFILE ?= standard
CORE    ?= all
ENGINES ?= 1
PIPES   ?= 1
LEAF_UNITS  ?= 0
SHADES  ?= 0
# bits that a root and a quotient gain a clock
ROOT_STEP     ?= 1
QUOTIENT_STEP ?= 2
# others, as sim/cores.py takes them
SIZES   ?=
WAVES   ?= 0
# 1: a pixel can be followed through its stages
STAGES  ?= 0

include make/verilated.mk

K   := $S/$(KEY)
MODEL := $B/libsphaera.a

CXXFLAGS := -std=c++17 -O2 -Wall -Wextra -Icmodel -Itb/core
LIBS     := -pthread -ljansson -lm

# what stands around a core is no part of it
RTL_FILES := $(shell find $(RTL) \( -path $(RTL)/board -o -path $(RTL)/bus -o -path $(RTL)/top \
                 -o -path $(RTL)/video \) -prune -o \( -name '*.v' -o -name '*.vh' \) -print)
RTL_DIRS  := $(sort $(dir $(RTL_FILES)))
SOURCES   := $(RTL_DIRS:%=-I%) $(sort $(filter %.v,$(RTL_FILES)))
OTHERS    := $(shell sim/cores.py sizes '$(SIZES)')
replaced  := $(foreach size,$(OTHERS),$(firstword $(subst =, ,$(size)))=%)
PARAMETERS := $(filter-out $(replaced),$(shell sim/cores.py profile '$(PROFILE)')) $(OTHERS) \
              $(shell sim/cores.py parameters '$(CORE)') \
              ENGINES=$(ENGINES) PIPES=$(PIPES) LEAF_UNITS=$(LEAF_UNITS) SHADES=$(SHADES) \
              ROOT_STEP=$(ROOT_STEP) QUOTIENT_STEP=$(QUOTIENT_STEP)

# What both simulators' harnesses share; but for tb_core.cpp a tb_ is the bench of a block.
SHARED := $(patsubst tb/core/%.cpp,$S/obj/%.o,tb/core/tb_core.cpp \
              $(filter-out tb/core/simulate_%.cpp tb/core/tb_%.cpp,$(wildcard tb/core/*.cpp)))

# Verilator's own library, the same for every core; waveforms only where one is written.
VERILATED := $(patsubst %,$S/obj/%.o,verilated verilated_threads)
TRACED    := $(if $(filter 1,$(WAVES)),$S/obj/verilated_fst_c.o)

VERILATE := $(VERILATOR) --cc --language 1364-2005 -Wall -O3 --x-assign fast --top-module rt_core \
                --prefix Vrt_core $(PARAMETERS:%=-G%) $(if $(TRACED),--trace-fst) \
                $(if $(filter 1,$(STAGES)),tb/core/stages.vlt)
ELABORATE := iverilog -g2005 -Wall -Wno-timescale -Itb/core \
                 $(PARAMETERS:%=-Ptb_core_icarus.%) -s tb_core_icarus
COMPILE_CORE := $(if $(TRACED),$(subst $(PRECOMPILED:%=-include-pch %),,$(COMPILE)),$(COMPILE)) \
                    -isystem $K -DVM_TRACE=$(WAVES) -DVM_TRACE_FST=$(WAVES)

.PHONY: tools core icarus cxxrtl ecp5 xc7 silicon netlist
tools: $S/tb_core_icarus $(SHARED) $S/obj/simulate_stages.o $(VERILATED) $(TRACED) $(PRECOMPILED)
core: $K/tb_core
icarus: $K/tb_core.vvp
cxxrtl: $K/tb_core_cxxrtl
ecp5: $K/ecp5.json
xc7: $K/xc7.json
silicon: $K/core.so
netlist: $S/tb_core_netlist

$S/obj/flags: FORCE
	$(call stamp,$(CXX) $(CXXFLAGS) $(ROOT),verilator $(HOST))
$K/verilator.flags: FORCE
	$(call stamp,$(VERILATE) $(COMPILE_CORE) $(SOURCES),verilator $(HOST))
$K/icarus.flags: FORCE
	$(call stamp,$(ELABORATE) $(SOURCES),iverilog)

$S/obj/%.o: tb/core/%.cpp $S/obj/flags
	@mkdir -p $(@D)
	$(CCACHE) $(CXX) $(CXXFLAGS) -MMD -MP -c $< -o $@

$S/tb_core_icarus: $(SHARED) $S/obj/simulate_icarus.o $(MODEL)
	$(CXX) $(LINKER) $^ $(LIBS) -o $@

# Nobody reads the sinks of unused signals (`wire unused = ...`), but Icarus would spend a fifth of
# its time on them: they become empty lines. `make lint` takes the files as they are.
$K/rtl.v: $(RTL_FILES) $K/icarus.flags
	@mkdir -p $(@D)
	@awk 'FNR == 1 { printf "`line 1 \"%s\" 0\n", FILENAME } \
	    /^ *wire unused.*= &/ { sink = 1 } { print sink ? "" : $$0 } /;/ { sink = 0 }' \
	    $(filter %.v,$(SOURCES)) >$@

$K/tb_core.vvp: tb/core/tb_core_icarus.v $K/rtl.v tb/core/icarus_pins.vh
	$(ELABORATE) $(filter -I%,$(SOURCES)) -o $@ $(filter %.v,$^) 2>$@.log || \
	    { cat $@.log >&2; exit 1; }
	@cat $@.log >&2

# None of Verilator's warnings is waived.
$K/core.cpp: $(RTL_FILES) tb/core/stages.vlt $K/verilator.flags
	@mkdir -p $(@D)
	@rm -f $K/Vrt_core*
	$(VERILATE) --Mdir $K $(SOURCES)
	@sh sim/at_once.sh $K tb/core/simulate_verilator.cpp >$@

$K/core.o: $K/core.cpp $(PRECOMPILED)
	$(COMPILE_CORE) -MD -MP -c $< -o $@

# Yosys's C++. A compiler that optimises takes many minutes for it.
$K/core_cxxrtl/core.cpp: $(RTL_FILES) synth/cxxrtl.sh synth/folders.sh $K/icarus.flags \
                           $B/tools/yosys
	@mkdir -p $(@D)
	RTL=$(RTL) sh synth/cxxrtl.sh $@ $(PARAMETERS)

$K/core_cxxrtl.o: tb/core/simulate_cxxrtl.cpp $K/core_cxxrtl/core.cpp
	$(CCACHE) $(or $(CLANG),$(CXX)) -std=c++17 -O0 -w -Icmodel -Itb/core -I$(<D) \
	    -I$(dir $(word 2,$^)) -isystem $$(yosys-config --datdir)/include \
	    -DYOSYS_VERSION='"$(shell yosys -V)"' -MMD -MP -c $< -o $@

$K/tb_core_cxxrtl: $(SHARED) $K/core_cxxrtl.o $S/obj/simulate_host.o $(MODEL)
	$(CXX) $(LINKER) $^ $(LIBS) -o $@

# The core as cells of a family, and what simulates them.
$K/ecp5.json $K/xc7.json: $K/%.json: $(RTL_FILES) synth/cells.sh synth/folders.sh $K/icarus.flags \
                              $B/tools/yosys
	@mkdir -p $(@D)
	RTL=$(RTL) sh synth/cells.sh $* $@ $(PARAMETERS)

# The core as cells of a library: what Yosys maps, then areas, times, energies and the program.
$K/silicon.flags: FORCE
	$(call stamp,$(PARAMETERS) $(CLOCK_GATES),$(YOSYS))
$K/silicon.json: $(RTL_FILES) synth/silicon.sh synth/folders.sh $K/silicon.flags
	YOSYS='$(YOSYS)' CLOCK_GATES=$(CLOCK_GATES) RTL=$(RTL) sh synth/silicon.sh '$(LIBERTY)' \
	    rt_core $@ $(PARAMETERS)
SILICON := $(addprefix lab/silicon/,core.py energy.py function.py liberty.py liberty_text.py \
               macros.py netlist.py program.py timing.py)
$K/core.so: $K/silicon.json $(SILICON) tb/netlist/gates.c tb/netlist/gates.h
	python3 -m lab silicon-core $< '$(LIBERTY)' '$(MACROS)' $(@D)

NETLIST := $(patsubst tb/netlist/%.cpp,$S/obj/netlist_%.o,$(wildcard tb/netlist/*.cpp))
$(NETLIST): $S/obj/netlist_%.o: tb/netlist/%.cpp $S/obj/flags
	@mkdir -p $(@D)
	$(CCACHE) $(CXX) $(CXXFLAGS) -MMD -MP -c $< -o $@

$S/obj/simulate_netlist.o: CXXFLAGS += -Itb
$S/tb_core_netlist: $(SHARED) $S/obj/simulate_netlist.o $S/obj/simulate_host.o $(NETLIST) $(MODEL)
	$(CXX) $(LINKER) $^ $(LIBS) -o $@

$(VERILATED) $(TRACED): $S/obj/%.o: $(ROOT)/%.cpp $S/obj/flags
	@mkdir -p $(@D)
	$(CCACHE) $(CXX) -std=c++17 -O2 -w $(HEADERS) -DVL_USER_FINISH \
	    $(if $(filter %fst_c.cpp,$<),-DVM_TRACE=1 -DVM_TRACE_FST=1) -c $< -o $@

$S/obj/simulate_stages.o: CXXFLAGS += $(HEADERS)
$K/tb_core: $(SHARED) $K/core.o $S/obj/simulate_stages.o $(VERILATED) $(TRACED) $(MODEL)
	$(CXX) $(LINKER) $^ $(LIBS) $(if $(TRACED),-lz) -o $@

-include $(wildcard $S/obj/*.d $K/core.d $K/core_cxxrtl.d)
