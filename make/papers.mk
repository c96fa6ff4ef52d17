# papers.mk - the papers, claim by claim: docs/results/claims.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/papers holds what lab/papers/measure.py reports of each run, of model and RTL; the cells of
# cores are those that `make synth` left in $B/synth: SHAPES_CORE for ecp5, PARK_CORE for xc7.

.PHONY: papers papers-setup
papers-setup: ## installs Valgrind (apt), with which `make papers` counts the model's instructions
	@sh sim/setup.sh sim/packages_papers.txt

papers: ## the three papers claim by claim: docs/results/claims.md; five minutes
papers: $(TOOL)
	$(Q)python3 -m lab papers --build $B
	@echo "tables and pictures in docs/results/claims.md"
