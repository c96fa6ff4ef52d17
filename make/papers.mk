# papers.mk - the papers, claim by claim: docs/results/claims.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/papers holds what lab/papers/measure.py reports of each run, of model and RTL; the cells of
# cores are those that `make synth` left in $B/synth: SHAPES_CORE for ecp5, PARK_CORE for xc7.

PAPERS       := $B/papers
PAPERS_SHOWN := docs/pictures/papers

.PHONY: papers papers-setup
papers-setup: ## installs Valgrind (apt), with which `make papers` counts the model's instructions
	@sh sim/setup.sh sim/packages_papers.txt

papers: ## the three papers claim by claim: docs/results/claims.md; five minutes
papers: $(TOOL)
	$(Q)python3 -m lab.papers.measure $(TOOL) $(PAPERS)
	$(Q)python3 -m lab.papers.why $(TOOL) $(PAPERS)
	$(Q)python3 -m lab.papers.pictures $(PAPERS)/triple.ppm
	$(Q)mkdir -p $(PAPERS_SHOWN)
	$(Q)oiiotool $(PAPERS)/triple.ppm -o $(PAPERS_SHOWN)/triple.png
	$(Q)oiiotool $(PAPERS)/hidden-first.png $(PAPERS)/hidden-mended.png --mosaic 2x1 \
	    -o $(PAPERS_SHOWN)/hidden.png
	$(Q)oiiotool $(PAPERS)/paper5.png $(PAPERS)/paper100-mended.png --mosaic 2x1 \
	    -o $(PAPERS_SHOWN)/scenes.png
	$(Q)oiiotool $(PAPERS)/scenario1.png $(PAPERS)/scenario2.png $(PAPERS)/scenario3.png \
	    --mosaic:pad=4 3x1 -o $(PAPERS_SHOWN)/scenarios.png
	$(Q)oiiotool $(PAPERS)/levels-mended.exr $(PAPERS)/levels-rays.exr \
	    $(PAPERS)/levels-samples.exr --resize:filter=box 240x135 --mosaic:pad=4 3x1 --ch R,G,B \
	    --colorconvert linear sRGB -d uint8 -o $(PAPERS_SHOWN)/levels.png
	$(Q)python3 -m lab.papers.page docs/results/claims.md $(PAPERS) $B/synth
	@echo "tables and pictures in docs/results/claims.md"
