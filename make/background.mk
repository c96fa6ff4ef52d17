# background.mk - the ways of background separation compared, into docs/results/background.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/background/ holds, for each scene, NAME.json of `sphaera background`, and for each way
# NAME-WAY.sph and NAME-WAY.core.json, the report of the RTL's run. Every way runs on one core, the
# plain one with what that way needs; make/area.mk keeps its cells in $B/synth.

BG        := $B/background
BG_SCENES := $(sort $(wildcard scenes/views/*.nff)) scenes/interpenetrating.nff scenes/paper5.nff
BG_NAMES  := $(basename $(notdir $(BG_SCENES)))
BG_SIZE   := 160x90
BG_PLAIN  := shadow+reflect2+lights1
BG_CORE   := $(BG_PLAIN)+inside
BG_PAGE   := docs/results/background.md
# way: options of build, core
BG_WAYS   := none rect spans exact0 exact1 exact2
BG_none   := none
BG_rect   := rect
BG_spans  := spans
BG_exact0 := exact --bg-levels 0
BG_exact1 := exact --bg-levels 1
BG_exact2 := exact --bg-levels 2
BG_CORE_none   :=
BG_CORE_rect   := +rect
BG_CORE_spans  := +spans
BG_CORE_exact0 := +cones1
BG_CORE_exact1 := +cones4
BG_CORE_exact2 := +cones16
BG_RUNS   := $(foreach w,$(BG_WAYS),$(BG_NAMES:%=$(BG)/%-$w.core.json))
BG_KEY     = $(shell sim/cores.py key standard '$(BG_PLAIN)$(BG_CORE_$(1))' ecp5)
# asked for where it is needed: it takes a moment
BG_SYNTH  := $(if $(filter background,$(MAKECMDGOALS)),$(foreach \
                 w,$(BG_WAYS),$B/synth/$(call BG_KEY,$w)))
# picture in docs: view, what `sphaera background` calls it
BG_DRAWN  := centred-points centred-rows centred-outline centred-square off_axis-way_rect_literal \
             off_axis-way_rect centred-way_spans wide-way_exact0 wide-way_exact1
BG_VIEWS  := $(sort $(foreach d,$(BG_DRAWN),$(word 1,$(subst -, ,$d))))
BG_SHOWN  := docs/pictures/background

vpath %.nff scenes/views scenes

.PHONY: background
background: $(TOOL) ## ways of background separation compared: docs/results/background.md
background: $(BG_NAMES:%=$(BG)/%.json) $(BG_RUNS) $(BG_SYNTH:%=%/stat.json) \
    $(BG_DRAWN:%=$(BG_SHOWN)/%.png)
	$(Q)python3 -m lab background-page $(BG_PAGE) $(BG) $B/synth \
	    '$(BG_SYNTH:$B/synth/%=%)' $(BG_NAMES)
	@echo "tables and pictures in $(BG_PAGE)"

$(BG)/%.json: %.nff $(TOOL)
	$(call say,WAYS,$*)
	@mkdir -p $(@D)
	$(Q)$(TOOL) background $< --profile standard --size $(BG_SIZE) --json $@ >$(BG)/$*.log

define bg_way
.PRECIOUS: $(BG)/%-$(1).sph
$(BG)/%-$(1).sph: %.nff $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $$< --profile standard --size $(BG_SIZE) --background $(BG_$(1)) -o $$@ \
	    >$(BG)/$$*-$(1).log

$(BG)/%-$(1).core.json: $(BG)/%-$(1).sph $(V_FILES) $(V_HEADS)
	$$(call say,SIM,"$$* $(1)")
	$$(Q)EFFECTS=$(BG_CORE)$(BG_CORE_$(1)) BUILD=$B JOBS=1 sh sim/core.sh --machine $$< \
	    --json $$@ >$(BG)/$$*-$(1).core.log || { cat $(BG)/$$*-$(1).core.log; exit 1; }
endef
$(foreach w,$(BG_WAYS),$(eval $(call bg_way,$w)))

$(BG_SYNTH:%=%/stat.json): $B/synth/standard-ecp5-%-engines1/stat.json: $(V_FILES) $(V_HEADS) \
    $B/tools/yosys
	+$(Q)$(MAKE) --no-print-directory -f make/area.mk results B=$B PROFILES=standard \
	    TARGETS=ecp5 EFFECTS=$*
	@touch $@

.PRECIOUS: $(BG)/drawn-%
$(BG)/drawn-%: %.nff $(TOOL)
	@rm -rf $@
	@mkdir -p $@
	$(Q)$(TOOL) background $< --profile standard --size 80x45 --pictures $@ >$@/log

define bg_picture
$(BG_SHOWN)/$(1).png: $(BG)/drawn-$(word 1,$(subst -, ,$(1)))
	@mkdir -p $$(@D)
	$$(Q)cp $$</$(word 2,$(subst -, ,$(1))).png $$@
endef
$(foreach d,$(BG_DRAWN),$(eval $(call bg_picture,$d)))
