# host.mk - random lives of cores under a host, a third simulator: docs/results/verification.md
# SPDX-License-Identifier: Apache-2.0

.PHONY: host host-page host-whole cxxrtl cxxrtl-setup
host: $(TOOL) ## TRIALS of what a host may do to a core, SEED; ten minutes of a processor
	$(Q)BUILD=$B SPHAERA=$(TOOL) SEED=$(SEED) TRIALS=$(TRIALS) sh sim/host.sh $(ONLY)

host-page: host-whole host ## the same, and what was met into docs/results/verification.md
	$(Q)python3 -m lab place docs/results/verification.md \
	    "make host-page SEED=$(SEED) TRIALS=$(TRIALS)" events $B/host/events.md

host-whole:
	$(if $(ONLY),$(error host-page: ONLY leaves out cores, and the page has them all))@:

cxxrtl-setup: ## installs Yosys's headers (apt), for SIM=cxxrtl
	@sh sim/setup.sh yosys-dev

# A small frame, and a life of the same core.
cxxrtl: $B/cxxrtl/scene.sph ## a core as Yosys's C++: a frame, and 20 trials of its life
	$(Q)BUILD=$B SIM=cxxrtl EFFECTS=auto OPT=-O0 sh sim/core.sh --machine $< --latency 5 \
	    --stall 20 --seed $(SEED)
	$(Q)BUILD=$B SIM=cxxrtl EFFECTS=auto OPT=-O0 sh sim/core.sh --machine $< --latency 5 \
	    --window 0,0,3,2 --seed $(SEED) --life --trials 20 | grep -v '^met'

$B/cxxrtl/scene.sph: scenes/paper5.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< --profile draft --size 12x9 --depth 1 -o $@ >$(@:.sph=.log) 2>&1 || \
	    { cat $(@:.sph=.log); exit 1; }
