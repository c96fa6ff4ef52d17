# moving.mk - the thesis's scenarios with all spheres moving: docs/results/moving.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/moving/ holds scenes and what measure.py reports of each sequence; some minutes.

.PHONY: moving
moving: $(TOOL) ## build, refit, upload and draw, frame by frame: docs/results/moving.md
	$(Q)python3 -m lab moving --build $B
