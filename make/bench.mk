# bench.mk - ways of the golden model against each other
# SPDX-License-Identifier: Apache-2.0
.PHONY: bench hashes trees
bench: $(TOOL) ## one way of the golden model against another, as ratios
	$(Q)python3 -m lab.bench $(TOOL) $B/bench

hashes: $(TOOL) ## write scenes/hashes.txt: what the golden model draws now
	$(Q)SPHAERA=$(TOOL) sh sim/hashes.sh >$B/hashes.txt
	$(Q)mv $B/hashes.txt scenes/hashes.txt

trees: $(TOOL) ## table of visits in each tree, against a bound; a minute
	$(Q)python3 -m lab.trees $(TOOL) $B/trees
