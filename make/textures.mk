# textures.mk - the experiments of the texture paper: docs/results/texture_results.md
# SPDX-License-Identifier: Apache-2.0
#
# $B/textures/ holds, for each scene NAME and filter WAY (nearest, off, level, between):
#   NAME-WAY.png, .rms         picture of the model, and how far it is from NAME-truth.tif
#   NAME-WAY.json              `sphaera texels`: texels of each level, hits of caches
#   NAME-WAY-rtl.json          the same at the size of the RTL's frames
#   NAME-WAY.core.json         report of the RTL's run; robot-WAY-slow: memory latency TEX_SLOW
#   NAME-small-WAY-STALL.core.json  of a small frame, memory not ready in STALL percent of clocks
#   NAME-fine-WAY-MEMORY.core.json  of a part of a frame of the paper's size, memory MEMORY
#   NAME-fine-WAY.info.json    what that machine is; NAME-fine-WAY.json: its texels, whole frame
#   NAME-walk.json             P_b of the first frames
#   NAME-lodN.png, .rms        with N bits of fraction in the level
#   NAME.levels.json           `sphaera accuracy`: arithmetic of the ways to choose a level
#   slant-N.json               levels against the angle, views of slant.nff; slant-ball.json
# NAME-truth.tif: TEX_TRUTH x TEX_TRUTH samples a pixel without MIP-mapping, the mean of them.

TEX        := $B/textures
TEX_NAMES  := kitchen robot museum
TEX_WAYS   := nearest off level between
TEX_DRAWN  := off level between
TEX_nearest := nearest
TEX_off    := bilinear
TEX_level  := level
TEX_between := between
TEX_WIDTH  := 480
TEX_HEIGHT := 270
TEX_TRUTH  := 8
TEX_SIZE   := $(TEX_WIDTH)x$(TEX_HEIGHT)
TEX_RTL    := 160x90
TEX_SLOW   := 200
TEX_CORE   := shadow+reflect2+lights2+inside+facets+texture+spread+turned+boxes
# memory that is slow in bytes
TEX_SMALL  := 80x45
TEX_STALLS := 0 50 90
TEX_STALLED := robot hall kitchen
# the paper's pixels, and what may have been its memory: a part of its frame
TEX_FINE_SIZE := 800x480
TEX_FINE_WINDOW := 360,216,440,264
# a part, and the core's clock beside it, MHz; eight times the paper's: what one of eight cores gets
TEX_MEMORIES  := ideal_84 ddr3x16_84 sdram16_84 sdram16_672
TEX_LODS   := 0 1 2 3 4 5 6 7 8
TEX_PAGE   := docs/results/texture_results.md
TEX_SHOWN  := docs/pictures/textures
# what of a picture is shown: width x height + left + top
TEX_CROP_kitchen := 150x100+10+95
TEX_CROP_robot   := 150x100+320+85
TEX_CROP_museum  := 190x120+160+55
# degrees of view below the horizon; the ball fills a wider view
TEX_SLANTS := 89 75 60 45 30 16 5

TEX_BOTH := $(foreach n,$(TEX_NAMES),$(TEX_WAYS:%=$n-%))
TEX_MACHINES := $(foreach n,$(TEX_STALLED),$(TEX_DRAWN:%=$n-small-%))
TEX_STALL_RUNS := $(foreach m,$(TEX_MACHINES),$(TEX_STALLS:%=$m-%))
TEX_FINE := $(foreach n,$(TEX_STALLED),$(TEX_DRAWN:%=$n-fine-%))
TEX_FINE_RUNS := $(foreach m,$(TEX_FINE),$(TEX_MEMORIES:%=$m-%))
TEX_LOD_BOTH := $(foreach n,$(TEX_NAMES),$(TEX_LODS:%=$n-lod%))
TEX_DATA := $(TEX_BOTH:%=$(TEX)/%.rms) $(TEX_BOTH:%=$(TEX)/%.json) \
            $(TEX_BOTH:%=$(TEX)/%-rtl.json) $(TEX_BOTH:%=$(TEX)/%.core.json) \
            $(TEX_DRAWN:%=$(TEX)/robot-%-slow.core.json) $(TEX)/robot-walk.json \
            $(TEX_STALL_RUNS:%=$(TEX)/%.core.json) $(TEX_FINE_RUNS:%=$(TEX)/%.core.json) \
            $(TEX_FINE:%=$(TEX)/%.json) $(TEX_FINE:%=$(TEX)/%.info.json) \
            $(TEX_LOD_BOTH:%=$(TEX)/%.rms) $(TEX_NAMES:%=$(TEX)/%.levels.json) \
            $(TEX_SLANTS:%=$(TEX)/slant-%.json) $(TEX)/slant-ball.json

.PHONY: textures textures-page
textures: $(TOOL) ## experiments of the texture paper: docs/results/texture_results.md; ten minutes
ifeq ($(ENGINE),slurm)
# On a cluster what the data are made of, then the data; here pictures and page.
	+$(Q)$(call tex_jobs,first,$(TEX_FIRST)) && $(call tex_jobs,data,$(TEX_DATA)) && \
	    $(MAKE) --no-print-directory textures ENGINE=make
else
textures: $(TEX_DATA) $(TEX_NAMES:%=$(TEX_SHOWN)/%.png) $(TEX_SHOWN)/scenes.png
	+$(Q)$(MAKE) --no-print-directory textures-page
endif

TEX_FIRST = $(TEX_NAMES:%=$(TEX)/%-truth.tif) $(TEX_BOTH:%=$(TEX)/%.png) \
            $(TEX_LOD_BOTH:%=$(TEX)/%.png) $(TEX_BOTH:%=$(TEX)/%.sph) $(TEX_MACHINES:%=$(TEX)/%.sph)
TEX_OF    := cmodel/**/*.[ch],cmodel/**/*.cpp,cmodel/machine/*.def,rtl/*/*.v,rtl/*/*.vh,$\
             scenes/texture/*,make/textures.mk
tex_jobs   = python3 -m lab target-plan textures $B $(TEX)/results $(TEX)/$(1) \
                 '$(TEX_OF)' $(2) && $(call jobs_run,$(TEX)/$(1))

textures-page: # from the results that are there
	@mkdir -p $(TEX) $(TEX_SHOWN)
	$(Q)python3 -m lab textures-page $(TEX_PAGE) docs/results/accuracy.md $(TEX) $(TEX_SHOWN) \
	    $(TEX_SIZE) $(TEX_RTL) $(TEX_NAMES)
	@echo "tables in $(TEX_PAGE) and docs/results/accuracy.md, plot in $(TEX_SHOWN)"

TEX_IMAGES := $(wildcard scenes/texture/*.png)
tex_way     = $(TEX_$(lastword $(subst -, ,$(1))))

define tex_scene
.PRECIOUS: $(TEX)/$(1)-truth.tif
$(TEX)/$(1)-truth.tif: scenes/texture/$(1).nff $(TEX_IMAGES) $(TOOL)
	$$(call say,TRUE,$(1))
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) render $$< --profile standard --filter bilinear --transfer linear \
	    -o $(TEX)/$(1)-large.png --size \
	    $$$$(($(TEX_WIDTH) * $(TEX_TRUTH)))x$$$$(($(TEX_HEIGHT) * $(TEX_TRUTH))) >$$(@:.tif=.log)
	$$(Q)oiiotool $(TEX)/$(1)-large.png --resize:filter=box $(TEX_SIZE) -d float -o $$@
	@rm $(TEX)/$(1)-large.png

$(TEX)/$(1).levels.json: scenes/texture/$(1).nff $(TEX_IMAGES) $(TOOL)
	$$(call say,LEVL,$(1))
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) accuracy $$< --profile standard --size $(TEX_SIZE) --json $$@ >$$(@:.json=.log)

$(TEX)/$(1)-lod%.png: scenes/texture/$(1).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) render $$< --profile standard --size $(TEX_SIZE) --lod-bits $$* \
	    --transfer linear -o $$@ >$$(@:.png=.log)

# seen, in this order: without, nearest level, two levels, the truth
$(TEX_SHOWN)/$(1).png: $(TEX_DRAWN:%=$(TEX)/$(1)-%.png) $(TEX)/$(1)-truth.tif
	@mkdir -p $$(@D)
	$$(Q)oiiotool $$(foreach p,$$^,$$p --cut $(TEX_CROP_$(1))) --mosaic:pad=2 4x1 -d uint8 -o $$@
endef
$(foreach n,$(TEX_NAMES),$(eval $(call tex_scene,$n)))

define tex_both
$(TEX)/$(1).png: scenes/texture/$(firstword $(subst -, ,$(1))).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) render $$< --profile standard --size $(TEX_SIZE) --transfer linear \
	    --filter $(call tex_way,$(1)) -o $$@ \
	    >$$(@:.png=.log)

$(TEX)/$(1).json: scenes/texture/$(firstword $(subst -, ,$(1))).nff $(TEX_IMAGES) $(TOOL)
	$$(call say,TEXL,$(1))
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) texels $$< --profile standard --size $(TEX_SIZE) --filter $(call tex_way,$(1)) \
	    --json $$@ >/dev/null

$(TEX)/$(1)-rtl.json: scenes/texture/$(firstword $(subst -, ,$(1))).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) texels $$< --profile standard --size $(TEX_RTL) --filter $(call tex_way,$(1)) \
	    --json $$@ >/dev/null

.PRECIOUS: $(TEX)/$(1).sph
$(TEX)/$(1).sph: scenes/texture/$(firstword $(subst -, ,$(1))).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $$< --profile standard --size $(TEX_RTL) --filter $(call tex_way,$(1)) \
	    -o $$@ >$$@.log

$(TEX)/$(1).core.json: $(TEX)/$(1).sph $(V_FILES) $(V_HEADS)
	$$(call say,SIM,$(1))
	$$(Q)EFFECTS=$(TEX_CORE) BUILD=$B JOBS=1 sh sim/core.sh --machine $$< \
	    --json $$@ >$$@.log || { cat $$@.log; exit 1; }

$(TEX)/$(1)-slow.core.json: $(TEX)/$(1).sph $(V_FILES) $(V_HEADS)
	$$(call say,SIM,"$(1) with slow memory")
	$$(Q)EFFECTS=$(TEX_CORE) BUILD=$B JOBS=1 sh sim/core.sh --machine $$< \
	    --latency $(TEX_SLOW) --json $$@ >$$@.log || { cat $$@.log; exit 1; }
endef
$(foreach b,$(TEX_BOTH),$(eval $(call tex_both,$b)))

tex_word = $(word $(2),$(subst -, ,$(1)))
define tex_small
.PRECIOUS: $(TEX)/$(1).sph
$(TEX)/$(1).sph: scenes/texture/$(call tex_word,$(1),1).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $$< --profile standard --accel box4 --size $(TEX_SMALL) \
	    --filter $(call tex_way,$(1)) -o $$@ >$$@.log
endef
$(foreach m,$(TEX_MACHINES),$(eval $(call tex_small,$m)))

define tex_stalled
$(TEX)/$(1).core.json: $(TEX)/$(1:%-$(call tex_word,$(1),4)=%).sph $(V_FILES) $(V_HEADS)
	$$(call say,SIM,$(1))
	$$(Q)EFFECTS=$(TEX_CORE) BUILD=$B JOBS=1 sh sim/core.sh --machine $$< \
	    --stall $(call tex_word,$(1),4) --json $$@ >$$@.log || { cat $$@.log; exit 1; }
endef
$(foreach r,$(TEX_STALL_RUNS),$(eval $(call tex_stalled,$r)))

define tex_fine
.PRECIOUS: $(TEX)/$(1).sph
$(TEX)/$(1).sph: scenes/texture/$(call tex_word,$(1),1).nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $$(@D)
	$$(Q)$(TOOL) build $$< --profile standard --accel box4 --size $(TEX_FINE_SIZE) \
	    --filter $(call tex_way,$(1)) -o $$@ >$$@.log
$(TEX)/$(1).info.json: $(TEX)/$(1).sph
	$$(Q)$(TOOL) info $$< --json $$@
$(TEX)/$(1).json: $(TEX)/$(1).sph
	$$(call say,TEXL,$(1))
	$$(Q)$(TOOL) texels $$< --json $$@ >/dev/null
$(foreach m,$(TEX_MEMORIES),$(TEX)/$(1)-$m.core.json): $(TEX)/$(1)-%.core.json: $(TEX)/$(1).sph \
        $(V_FILES) $(V_HEADS)
	$$(call say,SIM,"$(1) $$*")
	$$(Q)m=$$* && EFFECTS=$(TEX_CORE) BUILD=$B JOBS=1 sh sim/core.sh --machine $$< \
	    --memory $$$${m%_*} --core-mhz $$$${m#*_} --window $(TEX_FINE_WINDOW) \
	    --json $$@ >$$@.log || { cat $$@.log; exit 1; }
endef
$(foreach m,$(TEX_FINE),$(eval $(call tex_fine,$m)))

define tex_rms
$(TEX)/$(1).rms: $(TEX)/$(1).png $(TEX)/$(firstword $(subst -, ,$(1)))-truth.tif
	$$(Q)oiiotool --diff --fail 1 --hardfail 2 $$^ >$$@
endef
$(foreach b,$(TEX_BOTH) $(TEX_LOD_BOTH),$(eval $(call tex_rms,$b)))

$(TEX)/%-walk.json: scenes/texture/%.nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $(TEX)/views
	$(Q)$(TOOL) build $< --profile standard --size $(TEX_SIZE) --frames 0..2 \
	    -o $(TEX)/views/$*.sph --json $@ >/dev/null

# narrow views of the floor: `at` is 1 away from the eye, 2 above it; one of the ball
$(TEX)/slant-%.json: scenes/texture/slant.nff $(TEX_IMAGES) $(TOOL)
	@mkdir -p $(TEX)/views
	@ln -sf $(call absolute,scenes/texture/ground.png) $(TEX)/views/ground.png
	$(Q)awk -v view=$* '$$1 == "at" && view == "ball" { print "at -1.4 0.7 -1.3"; next } \
	    $$1 == "at" { a = view * atan2(0, -1) / 180; print "at 0", 2 - sin(a), -cos(a); next } \
	    $$1 == "angle" { print "angle", view == "ball" ? 40 : 16; next } { print }' $< \
	    >$(TEX)/views/slant-$*.nff
	$(Q)$(TOOL) accuracy $(TEX)/views/slant-$*.nff --profile standard --json $@ \
	    --size $(if $(filter ball,$*),192x108,96x54) >$(@:.json=.log)

$(TEX_SHOWN)/scenes.png: $(TEX_NAMES:%=$(TEX)/%-between.png)
	@mkdir -p $(@D)
	$(Q)oiiotool $(foreach p,$^,$p --resize 256x144) --mosaic:pad=2 3x1 -d uint8 -o $@
