# lint.mk - every source file through the tools that must stay silent
# SPDX-License-Identifier: Apache-2.0
#
# Files are checked again only when they or what they include changed ($B/lint/...). Verilator takes
# each module as a top of its own (waivers with reasons in sim/waivers.vlt); Icarus and Yosys take
# all files at once.

V_FILES  := $(sort $(shell find rtl -name '*.v'))
V_HEADS  := $(sort $(shell find rtl -name '*.vh'))
V_DIRS   := $(patsubst %/,%,$(sort $(dir $(V_FILES) $(V_HEADS))))
WAIVERS  := $(wildcard sim/waivers.vlt)
C_HEADS  := $(sort $(shell find cmodel tb tests -name '*.h'))
TIDY     := $(filter-out $(GENERATORS),$(C_FILES)) $(IMAGE_CXX) $(TEST_C)
LINTED   := $(V_FILES:%=$B/lint/%) $(TIDY:%=$B/lint/%) $(if $(V_FILES),$B/lint/iverilog $B/lint/yosys)

lint: ## silent tools: verilator, iverilog, yosys, clang-tidy, clang-format, text rules
	+$(Q)$(MAKE) --no-print-directory -k -j$(JOBS) run-lint
	@echo "lint: $(words $(V_FILES)) Verilog and $(words $(TIDY)) C files are clean"

.PHONY: run-lint lint-text lint-format
run-lint: $(LINTED) lint-text lint-format

$B/lint/%.v: %.v $(V_FILES) $(V_HEADS) $(WAIVERS)
	$(call say,LINT,$(<F))
	@mkdir -p $(@D)
	$(Q)verilator --lint-only -Wall --language 1364-2005 $(V_DIRS:%=-y %) $(V_DIRS:%=-I%) \
	    --top-module $(*F) $(WAIVERS) $<
	@touch $@

$B/lint/iverilog: $(V_FILES) $(V_HEADS)
	$(call say,LINT,iverilog)
	@mkdir -p $(@D)
	$(Q)iverilog -g2005 -Wall -t null $(V_DIRS:%=-I%) $(V_FILES) >$@.log 2>&1; rc=$$?; \
	    cat $@.log; [ $$rc = 0 ] && [ ! -s $@.log ]
	@touch $@

$B/lint/yosys: $(V_FILES) $(V_HEADS)
	$(call say,LINT,"yosys check")
	@mkdir -p $(@D)
	$(Q)yosys -q -e '.*' -p 'read_verilog $(V_DIRS:%=-I%) $(V_FILES); hierarchy -check; \
	    proc; check -assert'
	@touch $@

$B/lint/%.c: %.c $(C_HEADS) .clang-tidy
	$(call say,TIDY,$(<F))
	@mkdir -p $(@D)
	$(Q)clang-tidy --quiet $< -- -std=c11 -D_GNU_SOURCE -Icmodel -fopenmp 2>$@.log || \
	    { cat $@.log; exit 1; }
	@touch $@

$B/lint/%.cpp: %.cpp $(C_HEADS) .clang-tidy
	$(call say,TIDY,$(<F))
	@mkdir -p $(@D)
	$(Q)clang-tidy --quiet $< -- -std=c++17 -Icmodel 2>$@.log || { cat $@.log; exit 1; }
	@touch $@

lint-format:
	$(call say,LINT,clang-format)
	$(Q)find cmodel tb tests synth \( -name '*.c' -o -name '*.h' -o -name '*.cpp' \) \
	    ! -name '*_table.h' ! -name layout.h -exec clang-format --dry-run -Werror {} +

lint-text:
	$(call say,LINT,"text rules")
	$(Q)sh sim/lint_text.sh
