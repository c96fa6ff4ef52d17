# scenarios.mk - a BIH on the scenes of Aroxa 2014, beside other trees: docs/results/scenarios.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/scenarios/ holds scenes, machines and what measure.py reports of each. `make scenarios-rtl`
# adds the RTL's runs, which take an hour; without them the tables of cycles stay as they are.

SCN       := $B/scenarios
SCN_SHOWN := docs/pictures/bih
# picture: MAX_TREE_DEPTH and MAX_PRIMS of Scenario 1 with 64 spheres, as Figure 4.3 has them
SCN_DRAWN := depth1-1 depth3-1 depthinfinity-1 depthinfinity-64 depthinfinity-32 depthinfinity-2

.PHONY: scenarios scenarios-rtl
scenarios: ## a BIH on the scenes of its thesis: docs/results/scenarios.md
scenarios: $(TOOL) $(SCN_DRAWN:%=$(SCN_SHOWN)/%.png)
	$(Q)python3 -m lab scenarios --build $B
	@echo "tables and pictures in docs/results/scenarios.md"

scenarios-rtl: $(TOOL)
	$(Q)python3 -m lab scenarios-rtl --build $B

$(SCN)/drawn.nff: $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) gen scenario1 -n 64 -o $@ >$(SCN)/gen.log

$(SCN_SHOWN)/depth%.png: $(SCN)/drawn.nff
	@mkdir -p $(@D)
	$(Q)$(TOOL) render $< --profile standard --size 160x272 --depth 0 --shadow off --accel bih \
	    --max-tree-depth $(word 1,$(subst -, ,$*)) --max-prims $(word 2,$(subst -, ,$*)) \
	    --walk $@ >$(SCN)/draw.log
