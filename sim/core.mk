# core.mk - builds the harness of the core for one simulator and one set of parameters
# SPDX-License-Identifier: Apache-2.0
#
# Called by sim/core.sh, which holds a lock for each of these targets:
#   tools    build/sim/tb_core_icarus (every machine), objects that all harnesses share
#   core     build/sim/KEY/tb_core    (Verilator)
#   icarus   build/sim/KEY/tb_core.vvp
# KEY names every parameter that shapes the core (CORE: names of parameters.sh), so that builds
# never mix; what they are elaborated and compiled with stands in build/sim/KEY/flags and in
# build/sim/obj/flags, and a change of these builds anew.

B       ?= build
RTL     ?= rtl
# PROFILE: a name, alone or with widths of its own, as sim/profile.sh takes it
PROFILE ?= standard
CORE    ?= all
ENGINES ?= 1
# bits that a root and a quotient gain a clock; in KEY if they are not the core's own
ROOT_STEP     ?= 2
QUOTIENT_STEP ?= 2
WAVES   ?= 0
OPT     ?= -O3
JOBS    ?= 2

STEPS := $(if $(filter-out 2,$(ROOT_STEP)),-root$(ROOT_STEP))$(if $(filter-out \
             2,$(QUOTIENT_STEP)),-quotient$(QUOTIENT_STEP))
KEY := $(shell sh sim/profile.sh '$(PROFILE)' name)-$(CORE)-engines$(ENGINES)$(STEPS)$(OPT)$(if \
           $(filter 1,$(WAVES)),-waves)
S   := $B/sim
K   := $S/$(KEY)
LIB := $B/libsphaera.a

CXX      ?= g++
CXXFLAGS := -std=c++17 -O2 -Wall -Wextra -Icmodel -Itb/core
LIBS     := -fopenmp -pthread -ljansson -lm

RTL_FILES := $(shell find $(RTL) -name '*.v' -o -name '*.vh')
RTL_DIRS  := $(sort $(dir $(RTL_FILES)))
SOURCES   := $(RTL_DIRS:%=-I%) $(sort $(filter %.v,$(RTL_FILES)))
PARAMETERS := $(shell sh sim/profile.sh '$(PROFILE)') $(shell sh sim/parameters.sh '$(CORE)') \
              ENGINES=$(ENGINES) ROOT_STEP=$(ROOT_STEP) QUOTIENT_STEP=$(QUOTIENT_STEP)

SHARED := $(patsubst tb/core/%.cpp,$S/obj/%.o,$(filter-out tb/core/simulate_%.cpp, \
              $(wildcard tb/core/*.cpp)))

# Verilator's own library, the same for every core.
ROOT      := $(shell verilator --getenv VERILATOR_ROOT)/include
VERILATED := $(patsubst %,$S/obj/%.o,verilated verilated_threads verilated_fst_c)

# Written anew only when its text changes.
stamp = @mkdir -p $(@D); echo '$(1)' >$@.$$$$; cmp -s $@.$$$$ $@ && rm $@.$$$$ || mv $@.$$$$ $@
VERILATE := verilator --cc --language 1364-2005 -Wall -O3 --x-assign fast --top-module rt_core \
                --prefix Vrt_core $(PARAMETERS:%=-G%) --output-split 20000 \
                $(if $(filter 1,$(WAVES)),--trace-fst)
ELABORATE := iverilog -g2005 -Wall $(PARAMETERS:%=-Ptb_core_icarus.%) -s tb_core_icarus

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: tools core icarus FORCE
tools: $S/tb_core_icarus $(SHARED) $(VERILATED)
core: $K/tb_core
icarus: $K/tb_core.vvp

$S/obj/flags: FORCE
	$(call stamp,$(CXX) $(CXXFLAGS) $(ROOT))
$K/verilator.flags: FORCE
	$(call stamp,$(VERILATE) $(OPT) $(SOURCES))
$K/icarus.flags: FORCE
	$(call stamp,$(ELABORATE) $(SOURCES))

$S/obj/%.o: tb/core/%.cpp $S/obj/flags
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) -MMD -MP -c $< -o $@

$S/tb_core_icarus: $(SHARED) $S/obj/simulate_icarus.o $(LIB)
	$(CXX) $^ $(LIBS) -o $@

$K/tb_core.vvp: tb/core/tb_core_icarus.v $(RTL_FILES) $K/icarus.flags
	@mkdir -p $(@D)
	$(ELABORATE) -o $@ $< $(SOURCES) 2>$@.log || { cat $@.log >&2; exit 1; }
	@cat $@.log >&2

# Verilator's warnings are errors; none is waived.
$K/Vrt_core__ALL.a: $(RTL_FILES) $K/verilator.flags
	@mkdir -p $(@D)
	$(VERILATE) --Mdir $(@D) $(SOURCES)
	$(MAKE) -s -C $(@D) -f Vrt_core.mk -j$(JOBS) OPT_FAST=$(OPT) OPT_SLOW=$(OPT) Vrt_core__ALL.a \
	    >$(@D)/compile.log || { cat $(@D)/compile.log >&2; exit 1; }

$(VERILATED): $S/obj/%.o: $(ROOT)/%.cpp $S/obj/flags
	@mkdir -p $(@D)
	$(CXX) -std=c++17 -O2 -w -I$(ROOT) -I$(ROOT)/vltstd -DVM_TRACE=1 -DVM_TRACE_FST=1 \
	    -DVL_USER_FINISH -c $< -o $@

$K/simulate_verilator.o: tb/core/simulate_verilator.cpp $K/Vrt_core__ALL.a
	$(CXX) $(CXXFLAGS) -I$K -isystem $(ROOT) -isystem $(ROOT)/vltstd -DVM_TRACE=$(WAVES) \
	    -DVM_TRACE_FST=$(WAVES) -MMD -MP -c $< -o $@

$K/tb_core: $(SHARED) $K/simulate_verilator.o $K/Vrt_core__ALL.a $(VERILATED) $(LIB)
	$(CXX) $^ $(LIBS) -lz -o $@

-include $(wildcard $S/obj/*.d $K/simulate_verilator.d)
