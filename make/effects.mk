# effects.mk - what each scene calls for, and what that saves: docs/results/effects.md
# SPDX-License-Identifier: Apache-2.0
#
# make effects   builds the machine of every scene, then, each only where a source changed,
#   build/synth/KEY/          the core of each list, and everything but one effect, for ecp5
#   build/effects/NAME.json   the scene on its own core and on the whole one, in turn, in Verilator
# and puts tables and chart into docs/results/effects.md. Jobs run JOBS at once.

E := $B/effects
EFFECTS_SOURCES := $(shell find rtl tb/core -name '*.v' -o -name '*.vh' -o -name '*.cpp' -o \
                       -name '*.h') lab/effects/run.py sim/core.sh make/core.mk sim/cores.py
EFFECTS_RUNS = $(patsubst %.sph,%.json,$(filter-out %.forced.sph,$(wildcard $E/*.sph)))

.PHONY: effects effects-machines effects-runs
effects: ## docs/results/effects.md: each effect of each scene, cells and time it costs; 50 minutes
	+$(Q)$(MAKE) --no-print-directory effects-machines
	+$(Q)$(MAKE) --no-print-directory -f make/area.mk results B=$B V=$(V) \
	    EFFECTS="$$(cat $E/lists)"
	+$(Q)$(MAKE) --no-print-directory effects-runs
	$(Q)python3 -m lab effects effects.page --build $B

effects-machines: $(TOOL)
	$(Q)python3 -m lab effects effects.scenes --build $B

effects-runs: $(EFFECTS_RUNS)

$E/%.json: $E/%.sph $E/%.forced.sph $(EFFECTS_SOURCES)
	$(call say,SIM,$*)
	+$(Q)BUILD=$B python3 -m lab effects-run $(TOOL) $E $*
