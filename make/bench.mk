# bench.mk - ways of the golden model against each other, and against renderers of others
# SPDX-License-Identifier: Apache-2.0
#
#   make bench-setup    installs Embree
#   make bench          ratios of ways, and speed_and_area.md; without Embree or POV-Ray it says
#                       so, and what they would tell stays as it is

.PHONY: bench bench-setup hashes
# Embree's C interface, if it is installed; looked for when it is used.
EMBREE = $(if $(wildcard /usr/include/embree3/rtcore.h),$B/sim/embree)

$B/sim/embree: $B/obj/sim/embree.o $(MODEL)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(call make_whole,$(CC) $^ -lembree3 $(MODEL_LIBS))
-include $B/obj/sim/embree.d

bench-setup: ## installs Embree (apt), which make bench sets the model beside
	@sh sim/setup.sh libembree-dev

bench: $(TOOL) $(EMBREE) ## one way of the golden model against another, and Embree, as ratios
	$(Q)python3 -m lab ratios $(TOOL) $B/bench
	$(Q)python3 -m lab speed $(TOOL) $B/bench docs/results/speed_and_area.md $(EMBREE)

hashes: $(TOOL) $B/test/naive-frame ## write scenes/hashes*.txt: what both models draw now
	$(Q)SPHAERA=$(TOOL) sh sim/hashes.sh >$B/hashes.txt
	$(Q)mv $B/hashes.txt scenes/hashes.txt
	$(Q)SPHAERA=$(TOOL) sh sim/hashes.sh --naive $B/test/naive-frame >$B/hashes.txt
	$(Q)mv $B/hashes.txt scenes/hashes_naive.txt
