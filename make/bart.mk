# bart.mk - Table I of the texture paper on the scenes that it names: docs/results/bart.md
# SPDX-License-Identifier: Apache-2.0
#
#   make bart BART=FOLDER      FOLDER has scene_kitchen, scene_museum and scene_robot as BART's
#                              authors pack them: aff/ and TextureFiles/ in each
# Nothing of the folder is kept but figures. $B/bart/ holds, for each scene NAME and filter WAY
# (off, level, between):
#   NAME-WAY.sph, .json        machine of one frame; `sphaera texels`: levels, hits of caches
#   NAME.json, NAME.png        `sphaera render` with trilinear textures: counters
#   NAME.levels.json           `sphaera accuracy` of a small frame: operations of a decision

BT        := $B/bart
BT_NAMES  := kitchen robot museum
BT_WAYS   := off level between
BT_SIZE   := 800x480
BT_SMALL  := 80x48
# the scene, and the frame in the middle of its animation
BT_TOP_kitchen := scene_kitchen/aff/kitchen.aff
BT_TOP_robot   := scene_robot/aff/Robot.aff
BT_TOP_museum  := scene_museum/aff/museum5.aff
BT_AT_kitchen  := 400
BT_AT_robot    := 400
BT_AT_museum   := 150
BT_PAGE   := docs/results/bart.md
BT_DATA   := $(foreach n,$(BT_NAMES),$(BT_WAYS:%=$(BT)/$n-%.json) $(BT)/$n.json \
                 $(BT)/$n.levels.json)

.PHONY: bart bart-page bart-folder
bart: bart-folder $(TOOL) ## the texture paper's own scenes, docs/results/bart.md
	+$(Q)$(MAKE) --no-print-directory $(BT_DATA)
	+$(Q)$(MAKE) --no-print-directory bart-page

bart-folder:
	$(Q)test -n '$(BART)' || { echo "bart: BART names no folder: make bart BART=FOLDER" >&2; exit 1; }
	$(Q)for top in $(foreach n,$(BT_NAMES),$(BT_TOP_$n)); do \
	    test -f '$(BART)'/$$top || { echo "bart: BART=$(BART) has no $$top" >&2; exit 1; }; done

bart-page: # from the results that are there
	$(Q)python3 -m lab.bart $(BT_PAGE) $(BT) $(BT_SIZE) -- $(BT_NAMES)
	$(Q)python3 -m lab.pages.measured $(BT_PAGE) "make bart"
	@echo "tables in $(BT_PAGE)"

# the profile that the frame asks for, found once
define bt_scene
.PRECIOUS: $(BT)/$(1)-between.sph
$(BT)/$(1)-between.sph: $(TOOL)
	$$(call say,BART,$(1))
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $(BART)/$(BT_TOP_$(1)) --at $(BT_AT_$(1)) --size $(BT_SIZE) -o $$@ \
	    >$$(@:.sph=.log)

$(foreach w,off level,$(BT)/$(1)-$w.sph): $(BT)/$(1)-%.sph: $(BT)/$(1)-between.sph
	$$(Q)$(TOOL) build $(BART)/$(BT_TOP_$(1)) --at $(BT_AT_$(1)) --size $(BT_SIZE) -o $$@ \
	    --filter $$(TEX_$$*) \
	    --profile $$$$(sed -n 's/^profile *\([a-z]*\).*/\1/p' $$(<:.sph=.log)) \
	    >$$(@:.sph=.log)

$(BT)/$(1).json: $(BT)/$(1)-between.sph
	$$(Q)$(TOOL) render $$< -o $(BT)/$(1).png --json $$@

$(BT)/$(1).levels.json: $(BT)/$(1)-between.sph
	$$(Q)$(TOOL) accuracy $(BART)/$(BT_TOP_$(1)) --at $(BT_AT_$(1)) --size $(BT_SMALL) --json $$@ \
	    --profile $$$$(sed -n 's/^profile *\([a-z]*\).*/\1/p' $$(<:.sph=.log)) \
	    >$$(@:.json=.log)

$(foreach w,$(BT_WAYS),$(BT)/$(1)-$w.json): %.json: %.sph
	$$(Q)$(TOOL) texels $$< --json $$@ >$$(@:.json=.texels)
endef
$(foreach n,$(BT_NAMES),$(eval $(call bt_scene,$n)))
