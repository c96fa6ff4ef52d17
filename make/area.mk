# area.mk - synthesises the core for some profiles and targets, and makes the report
# SPDX-License-Identifier: Apache-2.0
#
# usage: make -f make/area.mk report PROFILES=... TARGETS=... EFFECTS=...
#   PROFILES  draft standard fine reference, or all; each with widths of its own: sim/cores.py
#   TARGETS   families of synth/target.sh, or all
#   EFFECTS   what the cores are elaborated with: lists as sim/cores.py takes them
# KEY is what sim/cores.py says of a core, with -flat behind it if FLAT is 1. $B/synth/KEY/ holds
# what Yosys printed; it is made again when a source of the core, core.sh or Yosys changes. Results
# of YOSYS, another one than that of the PATH, lie in $B/synth-VERSION/KEY/.

B        ?= build
PROFILES ?= standard
TARGETS  ?= ecp5
EFFECTS  ?= all
ENGINES  ?= 1
PIPES    ?= 1
LEAF_UNITS   ?= 0
SHADES   ?= 0
# bits that a root and a quotient gain a clock
ROOT_STEP     ?= 1
QUOTIENT_STEP ?= 2
# others, as sim/cores.py takes them
SIZES    ?=
FLAT     ?= 0
YOSYS    ?= yosys
V        ?= 0
Q        := $(if $(filter 1,$(V)),,@)
DEF      := cmodel/machine/machine.def
S        := $B/synth$(if $(filter-out yosys,$(YOSYS)),-$(or $(word 2,$(shell '$(YOSYS)' -V)), \
                $(error synth: $(YOSYS) does not say its version)))

KNOWN_PROFILES := $(shell awk '$$1 == "profile" { print $$2 }' $(DEF))
KNOWN_TARGETS  := $(shell sed -n "s/^targets='\(.*\)'/\1/p" synth/target.sh)
profiles := $(if $(filter all,$(PROFILES)),$(KNOWN_PROFILES),$(PROFILES))
targets  := $(if $(filter all,$(TARGETS)),$(KNOWN_TARGETS),$(TARGETS))
$(foreach p,$(profiles),$(if $(shell sim/cores.py profile '$p'),,$(error synth: \
    no profile '$p'; there are $(KNOWN_PROFILES) and all)))
$(foreach t,$(targets),$(if $(filter $t,$(KNOWN_TARGETS)),,$(error synth: \
    no target '$t'; there are $(KNOWN_TARGETS) and all)))

$(foreach e,$(EFFECTS),$(if $(shell sim/cores.py parameters '$e'),,$(error synth: \
    no core is built with '$e')))
key = $(or $(shell ENGINES=$(ENGINES) PIPES=$(PIPES) LEAF_UNITS=$(LEAF_UNITS) SHADES=$(SHADES) \
          ROOT_STEP=$(ROOT_STEP) QUOTIENT_STEP=$(QUOTIENT_STEP) SIZES='$(SIZES)' \
          sim/cores.py key '$(1)' '$(2)' $(3)),$(error \
          synth: no such core))$(if $(filter 1,$(FLAT)),-flat)
KEYS := $(foreach p,$(profiles),$(foreach t,$(targets),$(foreach e,$(EFFECTS), \
            $(call key,$p,$e,$t))))

# What speed_and_area.md shows: everything on; the standard core for ecp5 with less, and flat.
FULL := -all-engines1
PAGE := $(foreach p,$(KNOWN_PROFILES),$(foreach t,ecp5 xc7 generic,$p-$t$(FULL))) \
    $(foreach e,none all-shadow all-reflect,standard-ecp5-$e-engines1) \
    standard-ecp5$(FULL)-flat

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: report results page
results: $(KEYS:%=$S/%/stat.json)

include make/stamp.mk
$S/%/stat.json: synth/core.sh synth/target.sh sim/cores.py sim/definition.py $(DEF) \
                      $(if $(filter yosys,$(YOSYS)),$B/tools/yosys)
	$(Q)YOSYS='$(YOSYS)' sh synth/core.sh $* $(@D)

report: results
	$(Q)python3 -m lab area $S $(KEYS)

page: $(PAGE:%=$S/%/stat.json)
	$(Q)python3 -m lab area-page docs/results/speed_and_area.md $S $(PAGE)

-include $(patsubst %,$S/%/sources.d,$(sort $(KEYS) $(PAGE))) \
    $(patsubst %/stat.json,%/sources.d,$(filter %/stat.json,$(MAKECMDGOALS)))
