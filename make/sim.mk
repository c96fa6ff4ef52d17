# sim.mk - scenes through the golden model and the RTL
# SPDX-License-Identifier: Apache-2.0
#
# sim/run.sh finds SCENE and makes a folder for each run, whose name has a digest of everything
# that shapes the run. $B/out/SCENE-PROFILE-SIZE-DIGEST/ holds what render and sim leave.

# Options of `sphaera build`. The tool refuses by name what does not belong together.
# The tree that rt_top builds, if the command line says so: of the environment BUILD is a folder.
GIVEN_TREE    := $(if $(filter-out file,$(origin TREE)),$(TREE))
CHIP_BUILDS   := $(if $(filter hw,$(if $(filter command,$(origin BUILD)),$(BUILD))),\
                     $(or $(GIVEN_TREE),hw))
GIVEN_TREE    := $(or $(GIVEN_TREE),$(CHIP_BUILDS))
BUILD_PROFILE := $(if $(filter all,$(PROFILE)),reference,$(PROFILE))
# A core of one's own words that has no `camera` takes machines alone that lack nothing.
WHOLE         := $(filter-out auto all all+% $(if $(findstring camera,$(EFFECTS:all-%=)),%),\
                     $(EFFECTS))
BUILD_OPTIONS := --profile $(BUILD_PROFILE) --depth $(DEPTH) --background $(BACKGROUND) \
                 --traverse $(TRAVERSE) \
                 $(if $(filter bvh4,$(ACCEL)),--accel bvh4 --tree $(or $(GIVEN_TREE),$(TREE)),\
                     --accel $(ACCEL) \
                     $(if $(GIVEN_TREE),--tree $(GIVEN_TREE))) \
                 $(if $(MAX_PRIMS),--max-prims $(MAX_PRIMS)) \
                 $(if $(MAX_TREE_DEPTH),--max-tree-depth $(MAX_TREE_DEPTH)) \
                 $(if $(WHOLE),--effects all) \
                 $(if $(SIZE),--size $(SIZE)) $(if $(ERROR),--error $(ERROR)) \
                 $(if $(filter-out 1,$(SAMPLES)),--samples $(SAMPLES)) \
                 $(if $(LEVELS),--bg-levels $(LEVELS)) $(if $(AT),--at $(AT)) $(BUILD_MORE)
# What shapes a machine, and its run on a core.
MACHINE_KEY := SCENE SEED BUILD_OPTIONS LITERAL
SIM_KEY     := $(MACHINE_KEY) EFFECTS ENGINES PIPES LEAF_UNITS SHADES ROOT_STEP QUOTIENT_STEP \
               SIZES SIM LIB CLOCK_GATES LATENCY STALL MEMORY CORE_MHZ WINDOW PIXEL WARM WAVES \
               WATCHDOG
# (call run,GOAL,KEY): the names of its folder and how it speaks are passed besides.
run = $(call values,$(2) PROFILE SIZE SAMPLES V) BUILD=$B sh sim/run.sh $(1) $(2)
# In make/core.mk RTL is a folder: what make case was given does not get there.
# The command that repeats a run, for its report: what was given to make.
repeated = make sim $(call values,$(filter-out V CSV RTL CELLS,$(CHECK)))

render: $(TOOL) ## SCENE through the golden model: picture, counters
	$(Q)$(call run,render,$(MACHINE_KEY))

price: $(TOOL) ## what accuracy costs SCENE in time: table, picture; MORE=1, RTL=1, CELLS=1
	$(Q)$(call values,B MORE RTL CELLS LATENCY SEED DEPTH ACCEL SCENE SIZE ERROR) $(call run,price,\
	    $(MACHINE_KEY) MORE RTL LATENCY)

PICTURES := $B/sim/pictures
$(PICTURES): $B/obj/sim/pictures.o $(call objects,obj/,$(IMAGE_C) $(LAZY_C)) $(MODEL)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(call make_whole,$(CXX) $^ $(MODEL_LIBS) -ldl)
-include $B/obj/sim/pictures.d

top_run = test $(MEMORY) = ideal || { echo 'MEMORY=$(MEMORY): not with TOP=1' >&2; exit 2; }; \
          test -z '$(PIXEL)' || { echo 'PIXEL=$(PIXEL): not with TOP=1' >&2; exit 2; }; \
          mkdir -p $B/sim && $(call values,SCENE FRAMES BUILD_OPTIONS LATENCY STALL SEED PROFILE \
              LAYERS MOVIE CHIP_BUILDS CORE_MHZ) BUILD=$B sh sim/top.sh
sim: $(TOOL) $(PICTURES) ## SCENE through model and RTL, compared bit for bit; TOP=1: in rt_top
	$(Q)test $(TOP)$(LAYERS) != 01 || { echo 'LAYERS=1: with TOP=1 alone' >&2; exit 2; }
	$(Q)test '$(TOP)$(if $(CHIP_BUILDS),hw)' != 0hw || \
	    { echo 'BUILD=hw: with TOP=1 alone' >&2; exit 2; }
	$(Q)test -z '$(filter-out hw hw1 hw2,$(CHIP_BUILDS))' || \
	    { echo 'BUILD=hw: with TREE=hw, hw1 or hw2' >&2; exit 2; }
	$(Q)$(if $(filter 1,$(RTL)),unset RTL MAKEFLAGS; )export REPEATED=$(call quoted,$(repeated)); \
	    $(if $(filter 1,$(TOP)),$(top_run),\
	    $(call values,CSV) $(call run,sim,$(SIM_KEY)))

.PHONY: case
case: sim ## a page of SCENE: what accuracy costs, hard tests, own core, limit; CELLS=1
	$(Q)folder=$$($(call run,--folder sim,$(SIM_KEY))) && \
	    $(call values,RTL CELLS DEPTH) BUILD=$B python3 -m lab case $$folder

.PHONY: silicon silicon-run silicon-setup
silicon: $(TOOL) ## area, MHz and energy of SCENE's core in cells of LIB, which draw 32x18 or SIZE
	+$(Q)$(MAKE) --no-print-directory silicon-run SIM=silicon \
	    $(if $(filter file,$(origin SIZE)),SIZE=32x18)
silicon-run:
	$(Q)$(call values,MACROS YOSYS) $(call run,silicon,$(SIM_KEY) MACROS)

.PHONY: silicon-folder
silicon-folder: # prints where such a run, with SIM=silicon, leaves what it makes
	@$(call run,--folder silicon,$(SIM_KEY) MACROS)

silicon-setup: yosys-setup ## installs cells, OpenSTA (apt), Yosys (PyPI), for make silicon
	@sh sim/setup.sh qflow-tech-osu018 opensta

.PHONY: movie-setup
movie-setup: ## installs ffmpeg (apt), which films in .mp4 need
	@sh sim/setup.sh ffmpeg

.PHONY: sim-folder
sim-folder: # prints where such a run leaves what it makes
	@$(call run,--folder sim,$(SIM_KEY))
