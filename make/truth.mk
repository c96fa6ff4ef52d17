# truth.mk - scenes drawn by POV-Ray, by the double reference and by the model, compared
# SPDX-License-Identifier: Apache-2.0
#
#   make truth-setup           installs POV-Ray
#   make truth                 every scene of lab/truth/scenes.py, docs/results/accuracy.md
# $B/truth/ holds scenes, pictures and results; one that is younger than the tool is not made again.

TRUTH       := $B/truth
TRUTH_SHOWN := docs/pictures/truth

.PHONY: truth truth-setup
truth-setup: ## installs POV-Ray (apt), which `make truth` needs
	@sh sim/setup.sh povray

truth: $(TOOL) ## docs/results/accuracy.md: the model against POV-Ray, scene by scene
	$(Q)python3 -m lab truth-scenes $(TOOL) $(TRUTH)
	$(Q)rm -f $(TRUTH)/scale.txt
	$(Q)TMP=$$(mktemp -d) SPHAERA=$(call absolute,$(TOOL)) SCALE=$(call absolute,$(TRUTH))/scale.txt \
	    sh tests/tool/test_scale.sh >/dev/null
	$(Q)python3 -m lab truth-page docs/results/accuracy.md $(TRUTH) $(TRUTH_SHOWN)
