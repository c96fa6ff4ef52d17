# netlist.mk - netlists in the place of the RTL: frames of the core, a frame on a display
# SPDX-License-Identifier: Apache-2.0
#
# The machine asks for nothing but primary rays, so that both fit: spheres without a light. For
# cores with effects Verilator takes too long; tb/netlist simulates their cells: netlist-cells.

NETLIST    := $B/netlist
NETTED     := $(V_FILES) $(V_HEADS) $(wildcard tb/netlist/*.vh) synth/netlist.sh synth/folders.sh \
               $B/tools/yosys
net_core    = $$(sim/cores.py profile draft) $$(sim/cores.py parameters none)
net_top     = $(call top_tool,64) PROFILE=draft CORE=none OPT=-O0 BENCH=tb_show NAME=netlist \
                  RTL=$(NETLIST)/top/rtl MACHINES=$(NETLIST)/frame.sph SEED=

.PHONY: netlist
NETLISTS    = $(NETLIST)/core/rtl/rt_core.v $(NETLIST)/top/rtl/rt_top.v $(NETLIST)/frame.sph
netlist: $(NETLISTS) ## netlists of core and rt_top for ECP5, simulated: 8 processor minutes
	@mkdir -p $B/sim && ln -f $(MODEL) $(NETLIST)/
	$(Q)BUILD=$(NETLIST) RTL=$(NETLIST)/core/rtl EFFECTS=none OPT=-O0 \
	    sh sim/core.sh --machine $(NETLIST)/frame.sph --latency 5 --stall 20 --seed 7 --stop
	$(Q)$(net_top) top >$(NETLIST)/build.log 2>&1 || { cat $(NETLIST)/build.log; exit 1; }
	$(Q)$(net_top) run

$(NETLIST)/core/rtl/rt_core.v: $(NETTED)
	$(Q)sh synth/netlist.sh rt_core $(NETLIST)/core $(net_core) ENGINES=1 ROOT_STEP=1 \
	    QUOTIENT_STEP=2
$(NETLIST)/top/rtl/rt_top.v: $(NETTED)
	$(Q)sh synth/netlist.sh rt_top $(NETLIST)/top $(net_core) DATA=64 VIDEO=1

.PHONY: netlist-cells
netlist-cells: $(TOOL) ## cores as cells of ECP5 and series 7 draw frames: 10 processor minutes
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/top/test_cells.sh

.PHONY: toggles
toggles: $(TOOL) ## what switches in the cells of a core, of EFFECTS, that draws SCENE; 3 minutes
	$(Q)python3 -m lab toggles $(TOOL) $B $(call quoted,$(SCENE)) $(call quoted,$(PROFILE)) \
	    '$(EFFECTS)' $(if $(filter file,$(origin SIZE)),32x18,$(SIZE)) $(ACCEL)

$(NETLIST)/frame.sph: scenes/paper5.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)sed '/^l /d' $< >$(@:.sph=.nff)
	$(Q)$(TOOL) build $(@:.sph=.nff) --profile draft --size 16x12 --depth 0 -o $@ \
	    >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }
