# rate.mk - cycles of scenes, what pipes gain, clocks of whole frames: summary.md, pipes.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/rate/DIGEST/ holds what was measured of these sources; seven cores are built for them.

.PHONY: pipes pipes-cells board-rate summary
summary: $(TOOL) ## cycles a pixel of scenes at the profile that auto takes: summary.md
	$(Q)python3 -m lab summary --build $B

pipes: $(TOOL) ## cycles of 1 to 4 traversal pipes: docs/results/pipes.md; half an hour
	$(Q)python3 -m lab pipes --build $B

pipes-cells: ## cells of these cores: docs/results/pipes.md; Yosys, six minutes
	$(Q)python3 -m lab pipes-cells --build $B

board-rate: $(TOOL) ## clocks of frames of 1280x720, that frames a second follow from: pipes.md
	$(Q)python3 -m lab board-rate --build $B
