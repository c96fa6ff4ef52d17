# netlist.mk - netlists for ECP5 in the place of the RTL: a frame of the core, a frame on a display
# SPDX-License-Identifier: Apache-2.0
#
# The machine asks for nothing but primary rays, so that both fit: spheres without a light.
# netlist-standard is the core in the widths of that profile, netlist-xc7 one of cells of Xilinx.

NETLIST    := $B/netlist
NETTED     := $(V_FILES) $(V_HEADS) $(wildcard tb/netlist/*.vh) synth/netlist.sh
net_core    = $$(sh sim/profile.sh draft) $$(sh sim/parameters.sh none)
net_top     = $(call top_tool,64) PROFILE=draft CORE=none OPT=-O0 BENCH=tb_show NAME=netlist \
                  RTL=$(NETLIST)/top/rtl MACHINES=$(NETLIST)/frame.sph SEED=

.PHONY: netlist
NETLISTS    = $(NETLIST)/core/rtl/rt_core.v $(NETLIST)/top/rtl/rt_top.v $(NETLIST)/frame.sph
netlist: $(NETLISTS) ## netlists of core and rt_top for ECP5, simulated: 8 processor minutes
	@mkdir -p $B/sim && ln -f $(LIB) $(NETLIST)/
	$(Q)BUILD=$(NETLIST) RTL=$(NETLIST)/core/rtl EFFECTS=none OPT=-O0 \
	    sh sim/core.sh --machine $(NETLIST)/frame.sph --latency 5 --stall 20 --seed 7 --stop
	$(Q)$(net_top) top >$(NETLIST)/build.log 2>&1 || { cat $(NETLIST)/build.log; exit 1; }
	$(Q)$(net_top) run

$(NETLIST)/core/rtl/rt_core.v: $(NETTED)
	$(Q)sh synth/netlist.sh rt_core $(NETLIST)/core $(net_core) ENGINES=1 ROOT_STEP=2 \
	    QUOTIENT_STEP=2
$(NETLIST)/top/rtl/rt_top.v: $(NETTED)
	$(Q)sh synth/netlist.sh rt_top $(NETLIST)/top $(net_core) DATA=64 VIDEO=1

# name, profile, family
define netlist_core
netlist-$(1): $(NETLIST)/$(1)/core/rtl/rt_core.v $(NETLIST)/$(1)/frame.sph
	@mkdir -p $(NETLIST)/$(1)/sim && ln -f $(LIB) $(NETLIST)/$(1)/
	$$(Q)BUILD=$(NETLIST)/$(1) RTL=$$(<D) EFFECTS=none OPT=-O0 sh sim/core.sh \
	    --machine $$(word 2,$$^) --latency 5 --stall 20 --seed 7 --stop
$(NETLIST)/$(1)/core/rtl/rt_core.v: $(NETTED)
	$$(Q)FAMILY=$(3) sh synth/netlist.sh rt_core $(NETLIST)/$(1)/core \
	    $$$$(sh sim/profile.sh $(2)) $$$$(sh sim/parameters.sh none) ENGINES=1 ROOT_STEP=2 \
	    QUOTIENT_STEP=2
$(NETLIST)/$(1)/frame.sph: NETLIST_PROFILE = $(2)
endef
.PHONY: netlist-standard netlist-xc7
netlist-standard: ## netlist of the core in widths of profile standard, simulated
netlist-xc7: ## netlist of the draft core for Xilinx, simulated
$(eval $(call netlist_core,standard,standard,ecp5))
$(eval $(call netlist_core,xc7,draft,xc7))

NETLIST_PROFILE = draft
$(NETLIST)/frame.sph $(NETLIST)/standard/frame.sph $(NETLIST)/xc7/frame.sph: \
    scenes/paper5.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)sed '/^l /d' $< >$(@:.sph=.nff)
	$(Q)$(TOOL) build $(@:.sph=.nff) --profile $(NETLIST_PROFILE) --size 16x12 --depth 0 -o $@ \
	    >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }
