# sim.mk - scenes through the golden model and the RTL
# SPDX-License-Identifier: Apache-2.0
#
# PROFILE may be NAME:key=value,...; in names of files without : , and =.
# Every choice that shapes the machine is in the folder's name, so results never mix:
#   $(RUN_DIR)/scene.sph    machine file, read by the model and by the RTL benches
#   $(RUN_DIR)/model.frame  what the golden model makes of it
#   $(OUT_DIR)/             what `make sim` leaves: pictures, report.json, frames
#
# SCENE is a file, the name of one in scenes/, or KIND:N of `sphaera gen`: levels of a sphereflake,
# number of spheres of random and the scenarios, else the seed.

## WINDOW      pixels to simulate, x0,y0,x1,y1 (empty: the whole frame)
WINDOW ?=
## WARM        1: render twice and count the second pass with warm caches
WARM ?= 0
ifeq ($(origin SIZE),file)
SIZE := 320x180
endif

SCENE_KIND := $(word 1,$(subst :, ,$(SCENE)))
SCENE_ARG  := $(word 2,$(subst :, ,$(SCENE)))
SCENE_FILE := $(if $(SCENE_ARG),$B/scenes/$(SCENE_KIND)-$(SCENE_ARG)-$(SEED).nff,$(or \
                  $(wildcard $(SCENE)),scenes/$(SCENE).nff))
GEN_OPTION := $(if $(filter sphereflake,$(SCENE_KIND)),--size $(SCENE_ARG),$(if $(filter \
                  random scenario%,$(SCENE_KIND)),--spheres $(SCENE_ARG) --seed $(SEED),--seed \
                  $(SCENE_ARG)))

comma := ,
file_name = $(subst =,,$(subst $(comma),_,$(subst :,_,$(1))))
PROFILE_NAME := $(call file_name,$(PROFILE))
SCENE_NAME := $(basename $(notdir $(SCENE_FILE)))
space    := $() $()
# Options of `sphaera build` that differ from its own defaults, as words; the same as a file name.
BUILD_EXTRA := $(if $(filter-out nearest,$(TRAVERSE)),--traverse $(TRAVERSE)) \
               $(if $(LEVELS),--bg-levels $(LEVELS)) $(if $(AT),--at $(AT)) $(BUILD_MORE)
# What does not belong together is passed on all the same: the tool refuses it by name.
GIVEN_TREE  := $(if $(filter-out file,$(origin TREE)),$(TREE))
BUILD_TREE  := $(if $(filter bvh4,$(ACCEL)),$(TREE),$(ACCEL)$(GIVEN_TREE))$(MAX_PRIMS)$(addprefix \
                   x,$(MAX_TREE_DEPTH))
BUILD_MODE  := $(BUILD_TREE)-$(DEPTH)-$(BACKGROUND)
BUILD_NAME  := $(BUILD_MODE)$(subst /,_,$(subst $(space),,$(strip $(BUILD_EXTRA))))
RUN_NAME := $(SCENE_NAME)-$(PROFILE_NAME)-$(or $(SIZE),file)-$(BUILD_NAME)
RUN_DIR  := $B/run/$(RUN_NAME)
OUT_DIR  := $B/out/$(SCENE_NAME)-$(PROFILE_NAME)
BUILD_OPTIONS := --profile $(PROFILE) --depth $(DEPTH) --background $(BACKGROUND) \
                 $(if $(filter bvh4,$(ACCEL)),--tree $(TREE),--accel $(ACCEL) \
                     $(if $(GIVEN_TREE),--tree $(GIVEN_TREE))) \
                 $(if $(MAX_PRIMS),--max-prims $(MAX_PRIMS)) \
                 $(if $(MAX_TREE_DEPTH),--max-tree-depth $(MAX_TREE_DEPTH)) \
                 $(if $(SIZE),--size $(SIZE)) $(BUILD_EXTRA)

ifneq ($(SCENE_ARG),)
$(SCENE_FILE): $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) gen $(SCENE_KIND) $(GEN_OPTION) -o $@
endif

$(RUN_DIR)/scene.sph: $(SCENE_FILE) $(TOOL)
	$(call say,MACH,$(RUN_NAME))
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< $(BUILD_OPTIONS) --json $(@D)/build.json -o $@ >$(@D)/build.log

$(RUN_DIR)/model.frame: $(RUN_DIR)/scene.sph
	$(call say,MODL,$(RUN_NAME))
	$(Q)$(TOOL) render $< --frame $@ --json $(@D)/model.json -o $(@D)/model.png >$(@D)/model.log

render: $(RUN_DIR)/model.frame ## SCENE through the golden model: picture, counters
	@cat $(RUN_DIR)/build.log $(RUN_DIR)/model.log
	@echo "picture $(RUN_DIR)/model.png"

PICTURES := $B/sim/pictures
$(PICTURES): $B/obj/sim/pictures.o $(IMAGE) $(LIB)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(call make_whole,$(CXX) -fopenmp $^ $(IMAGE_LIBS) $(MODEL_LIBS))
-include $B/obj/sim/pictures.d

SIM_OPTIONS = --machine $(RUN_DIR)/scene.sph --latency $(LATENCY) --stall $(STALL) --seed $(SEED) \
    --processes $(JOBS) --progress --frame $(OUT_DIR)/rtl.frame --json $(OUT_DIR)/report.json \
    --model-frame $(OUT_DIR)/model.frame $(if $(WINDOW),--window $(WINDOW)) \
    $(if $(filter 1,$(WARM)),--warm) $(if $(filter 1,$(WAVES)),--trace $(OUT_DIR)/core.fst)

sim: $(RUN_DIR)/scene.sph $(PICTURES) ## SCENE through model and RTL, compared bit for bit
	@mkdir -p $(OUT_DIR)
	$(call say,SIM,"$(SCENE_NAME) $(PROFILE) $(SIZE) in $(SIM)")
	+$(Q)rm -f $(OUT_DIR)/rtl.frame; \
	    EFFECTS='$(EFFECTS)' ENGINES=$(ENGINES) ROOT_STEP=$(ROOT_STEP) \
	    QUOTIENT_STEP=$(QUOTIENT_STEP) SIM=$(SIM) BUILD=$B JOBS=$(JOBS) \
	        sh sim/core.sh $(SIM_OPTIONS) >$(OUT_DIR)/log; rc=$$?; \
	    cat $(OUT_DIR)/log; [ -f $(OUT_DIR)/rtl.frame ] || exit $$rc; \
	    $(PICTURES) $(OUT_DIR)/model.frame $(OUT_DIR)/rtl.frame $(OUT_DIR) || exit 1; \
	    echo "pictures and report in $(OUT_DIR)/"; \
	    sed -n '$$s/^core \(.*mismatches\),.*/sim \1/p' $(OUT_DIR)/log; exit $$rc
