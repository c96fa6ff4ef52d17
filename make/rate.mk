# rate.mk - what pipes gain, and frames a second: docs/results/pipes.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/rate/DIGEST/ holds what was measured of these sources; seven cores are built for them.

.PHONY: pipes pipes-cells board-rate
pipes: $(TOOL) ## cycles of 1 to 4 traversal pipes: docs/results/pipes.md; half an hour
	$(Q)python3 -m lab.rate.pipes $B docs/results/pipes.md

pipes-cells: ## cells of these cores: docs/results/pipes.md; Yosys, six minutes
	$(Q)python3 -m lab.rate.cells $B docs/results/pipes.md

board-rate: $(TOOL) ## frames a second of 1280x720, from cycles and the placed clock: pipes.md
	$(Q)python3 -m lab.rate.board $B docs/results/pipes.md
