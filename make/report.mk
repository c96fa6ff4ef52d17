# report.mk - pages to look at: lab/report makes them, tests/lab/test_report.sh looks
# SPDX-License-Identifier: Apache-2.0
#
#   $B/gallery.html   all scenes of scenes/, one file; $B/gallery/ has what it is made of
GALLERY_SIZE := 256x144
GALLERY      := $(patsubst scenes/%.nff,$B/gallery/%.json,$(sort $(wildcard scenes/*.nff \
                    scenes/*/*.nff)))

.PHONY: gallery browser-setup
gallery: $B/gallery.html ## all scenes of scenes/ as the model draws them, on one page
	@echo "gallery in $<"

$B/gallery.html: $(GALLERY) $(wildcard lab/report/*)
	$(call say,PAGE,gallery.html)
	$(Q)python3 -m lab gallery $B/gallery $@

$B/gallery/%.json: scenes/%.nff $(TOOL)
	$(call say,DRAW,$*)
	@mkdir -p $(@D)
	$(Q)$(TOOL) render $< --size $(GALLERY_SIZE) --samples 2 -o $(@:.json=.png) --json $@ \
	    >$(@:.json=.log) 2>&1 || { cat $(@:.json=.log); exit 1; }

browser-setup: ## installs Chromium (apt), in which tests look at pages
	@sh sim/setup.sh chromium
