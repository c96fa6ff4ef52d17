# sim.mk - scenes through the golden model and the RTL
# SPDX-License-Identifier: Apache-2.0
#
# Every choice that shapes the machine is in the folder's name, so results never mix:
#   $(RUN_DIR)/scene.sph    machine file, read by the model and by the RTL benches
#   $(RUN_DIR)/model.frame  what the golden model makes of it

RUN_NAME := $(basename $(notdir $(SCENE)))-$(PROFILE)-$(or $(SIZE),file)-$(TREE)-$(DEPTH)-$(BACKGROUND)
RUN_DIR  := $B/run/$(RUN_NAME)
BUILD_OPTIONS := --profile $(PROFILE) --tree $(TREE) --depth $(DEPTH) --background $(BACKGROUND) \
                 $(if $(SIZE),--size $(SIZE))

$(RUN_DIR)/scene.sph: $(SCENE) $(TOOL)
	$(call say,MACH,$(RUN_NAME))
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< $(BUILD_OPTIONS) --json $(@D)/build.json -o $@ >$(@D)/build.log

$(RUN_DIR)/model.frame: $(RUN_DIR)/scene.sph
	$(call say,MODL,$(RUN_NAME))
	$(Q)$(TOOL) render $< --frame $@ --json $(@D)/model.json -o $(@D)/model.png >$(@D)/model.log

render: $(RUN_DIR)/model.frame ## SCENE through the golden model: picture, counters
	@cat $(RUN_DIR)/build.log $(RUN_DIR)/model.log
	@echo "picture $(RUN_DIR)/model.png"

sim: $(RUN_DIR)/model.frame ## SCENE through model and RTL, compared bit for bit
	@echo "sim: no RTL core to simulate yet" >&2; exit 1

bench: $(TOOL) ## time the golden model on SCENE
	$(Q)$(TOOL) build $(SCENE) $(BUILD_OPTIONS) -o $B/bench.sph
	$(Q)$(TOOL) render $B/bench.sph --threads 1
