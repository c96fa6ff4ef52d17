# bart.mk - Table I of the texture paper on the scenes that it names: docs/results/bart.md
# SPDX-License-Identifier: Apache-2.0
#
#   make bart BART=FOLDER      FOLDER has scene_kitchen, scene_museum and scene_robot as BART's
#                              authors pack them: aff/ and TextureFiles/ in each
# Nothing of the folder is kept but figures. $B/bart/ holds, for each scene NAME, frame AT of its
# animation and filter WAY (off, level, between):
#   NAME-AT.sph, .json, .png   machine with every light, and `sphaera render`: counters
#   NAME-AT-WAY.json           `sphaera texels`: levels, hits of caches; light rays fetch no texel
#   NAME-AT-WAY.core.json      the RTL on BT_WINDOW of the frame in the middle, memory BT_MEMORY
#   NAME-AT-pipesN.core.json   the RTL on that whole frame, a core of N pipes and BT_SIZES
#   NAME.levels.json           `sphaera accuracy` of a small frame: operations of a decision
#   NAME.sequence.json         frames one behind the other: P_b kept, times

BT        := $B/bart
BT_NAMES  := kitchen robot museum
BT_WAYS   := off level between
BT_SIZE   := 800x480
BT_SMALL  := 80x48
BT_WINDOW := 320,192,480,288
# one core for all of them
BT_CORE   := shadow+reflect2+lights6+facets+smooth+clear+turned+texture+boxes
BT_PIPES  := 1 2 4
# triangles take long, so more rays are on their way; and there are many of them
BT_SIZES  := slots=128,node_lines=1024,leaf_lines=1024
BT_MEMORY := ddr3x16
BT_MHZ    := 84
# the scene, eight frames of its animation, the one in the middle, and some in a row
BT_TOP_kitchen := scene_kitchen/aff/kitchen.aff
BT_TOP_robot   := scene_robot/aff/Robot.aff
BT_TOP_museum  := scene_museum/aff/museum5.aff
BT_AT_kitchen  := 50 150 250 350 400 550 650 750
BT_AT_robot    := $(BT_AT_kitchen)
BT_AT_museum   := 18 56 93 150 168 206 243 281
BT_MID_kitchen := 400
BT_MID_robot   := 400
BT_MID_museum  := 150
BT_ROW_robot   := 398..401
BT_ROW_museum  := 148..151
BT_PAGE   := docs/results/bart.md
BT_OF     = $(foreach n,$(BT_NAMES),$(BT_AT_$n:%=$n-%))
BT_DATA   = $(BT_OF:%=$(BT)/%.json) $(foreach w,$(BT_WAYS),$(BT_OF:%=$(BT)/%-$w.json)) \
            $(foreach n,$(BT_NAMES),$(BT)/$n.levels.json $(if $(BT_ROW_$n),$(BT)/$n.sequence.json) \
                $(foreach w,$(BT_WAYS),$(BT)/$n-$(BT_MID_$n)-$w.core.json) \
                $(foreach p,$(BT_PIPES),$(BT)/$n-$(BT_MID_$n)-pipes$p.core.json))

.PHONY: bart bart-page bart-folder
bart: bart-folder $(TOOL) ## the texture paper's own scenes, docs/results/bart.md; an hour
	+$(Q)$(MAKE) --no-print-directory $(BT_DATA)
	+$(Q)$(MAKE) --no-print-directory bart-page

bart-folder:
	$(Q)test -n '$(BART)' || { echo "bart: BART names no folder: make bart BART=FOLDER" >&2; exit 1; }
	$(Q)for top in $(foreach n,$(BT_NAMES),$(BT_TOP_$n)); do \
	    test -f '$(BART)'/$$top || { echo "bart: BART=$(BART) has no $$top" >&2; exit 1; }; done

bart-page: # from the results that are there
	$(Q)python3 -m lab bart-page $(BT_PAGE) $(BT) $(BT_SIZE) \
	    $(foreach n,kitchen robot museum,$n:$(BT_MID_$n):$(subst $(subst ,, ),$(comma),$(BT_AT_$n)))
	@echo "tables in $(BT_PAGE)"

# All frames of a scene have the profile that the middle one asks for, so one core draws them.
bt_profile = --profile $$$$(sed -n 's/^profile *\([a-z]*\).*/\1/p' $(BT)/$(1).profile)
define bt_scene
$(BT)/$(1).profile: $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $(BART)/$(BT_TOP_$(1)) --at $(BT_MID_$(1)) --size $(BT_SIZE) -o $$@.sph >$$@
	@rm $$@.sph

$(BT)/$(1).levels.json: $(BT)/$(1).profile
	$$(call say,LEVL,$(1))
	$$(Q)$(TOOL) accuracy $(BART)/$(BT_TOP_$(1)) --at $(BT_MID_$(1)) --size $(BT_SMALL) --json $$@ \
	    $(call bt_profile,$(1)) >$$(@:.json=.log)

$(BT)/$(1).sequence.json: $(BT)/$(1).profile
	$$(call say,ROW,$(1))
	$$(Q)$(TOOL) render $(BART)/$(BT_TOP_$(1)) --frames $(BT_ROW_$(1)) --size $(BT_SIZE) \
	    $(call bt_profile,$(1)) -o $(BT)/$(1)-row.png --json $$@ >$$(@:.json=.log)
endef
$(foreach n,$(BT_NAMES),$(eval $(call bt_scene,$n)))

# pipes, window unless it is the whole frame
define bt_sim
$$(call say,SIM,$$(@F))
	$$(Q)EFFECTS=$(BT_CORE) PIPES=$(1) SIZES=$(BT_SIZES) BUILD=$B JOBS=1 sh sim/core.sh \
	    --machine $$< --memory $(BT_MEMORY) --core-mhz $(BT_MHZ) $(2) --watchdog 10000000 \
	    --json $$@ >$$@.log || { cat $$@.log; exit 1; }
endef
define bt_frame
.PRECIOUS: $(foreach w,$(BT_WAYS),$(BT)/$(1)-$(2)-$w.sph)
$(foreach w,$(BT_WAYS),$(BT)/$(1)-$(2)-$w.sph): $(BT)/$(1)-$(2)-%.sph: $(BT)/$(1).profile
	$$(call say,BART,"$(1) $(2) $$*")
	$$(Q)$(TOOL) build $(BART)/$(BT_TOP_$(1)) --at $(2) --size $(BT_SIZE) -o $$@ \
	    --filter $$(TEX_$$*) $(call bt_profile,$(1)) >$$(@:.sph=.log)

$(BT)/$(1)-$(2).json: $(BT)/$(1)-$(2)-between.sph
	$$(call say,DRAW,"$(1) $(2)")
	$$(Q)$(TOOL) render $$< -o $(BT)/$(1)-$(2).png --json $$@ >$$(@:.json=.log)

$(foreach w,$(BT_WAYS),$(BT)/$(1)-$(2)-$w.json): $(BT)/$(1)-$(2)-%.json: $(BT)/$(1).profile
	$$(call say,TEXL,"$(1) $(2) $$*")
	$$(Q)$(TOOL) texels $(BART)/$(BT_TOP_$(1)) --at $(2) --size $(BT_SIZE) --shadow off \
	    --filter $$(TEX_$$*) $(call bt_profile,$(1)) --json $$@ >$$(@:.json=.texels)

$(foreach w,$(BT_WAYS),$(BT)/$(1)-$(2)-$w.core.json): %.core.json: %.sph $(V_FILES) $(V_HEADS)
	$(call bt_sim,1,--window $(BT_WINDOW))

$(BT_PIPES:%=$(BT)/$(1)-$(2)-pipes%.core.json): $(BT)/$(1)-$(2)-pipes%.core.json: \
    $(BT)/$(1)-$(2)-between.sph $(V_FILES) $(V_HEADS)
	$(call bt_sim,$$*)
endef
$(foreach n,$(BT_NAMES),$(foreach t,$(BT_AT_$n),$(eval $(call bt_frame,$n,$t))))
