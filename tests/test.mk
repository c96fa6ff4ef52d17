# test.mk - what `make test` runs
# SPDX-License-Identifier: Apache-2.0
#
# A suite is a program or script that prints TAP lines, `ok ...` or `not ok ...`; run.sh counts.
#   tests/test_*.c    cmocka, linked with the model; runs plain and under the sanitizers
#   tests/test_*.sh   a script; finds the tool in $SPHAERA, its own empty folder in $TMP
#   SUITES += path    any other executable, with a rule that makes it
# `make test ONLY=PATTERN` runs the suites whose file name has the pattern in it.

TEST_C  := $(sort $(wildcard tests/test_*.c))
TEST_SH := $(sort $(wildcard tests/test_*.sh))
# The longest first: what runs beside them fills their gaps.
LONG    := tests/test_core.sh tests/test_mutants.sh tests/test_effect_scenes.sh \
           tests/test_background.sh tests/test_benches.sh tests/test_hard_rtl.sh
SUITES  += $(LONG) $(filter-out $(LONG),$(TEST_SH)) \
           $(TEST_C:tests/%.c=$B/test/%) $(TEST_C:tests/%.c=$B/test/%.sanitized) $B/test/test_image
ONLY    ?=
chosen   = $(if $(findstring $(ONLY),$(notdir $(1))),$(1))
RUN      = $(if $(ONLY),$(foreach s,$(SUITES),$(call chosen,$s)),$(SUITES))

test: | $(filter setup,$(MAKECMDGOALS)) ## every check; ends with `N passed, M failed`
	+@unbuilt=; $(MAKE) --no-print-directory -k -j$(JOBS) suites || unbuilt=1; \
	    UNBUILT=$$unbuilt SPHAERA=$(abspath $(TOOL)) BUILD=$(abspath $B) JOBS=$(JOBS) \
	    sh tests/run.sh $(RUN)

.PHONY: suites mutants
suites: $(TOOL) $(RUN)

mutants: suites ## faults put into the RTL and what notices them: all of tests/mutants
	@ALL=1 SPHAERA=$(abspath $(TOOL)) BUILD=$(abspath $B) JOBS=$(JOBS) \
	    sh tests/run.sh tests/test_mutants.sh

TEST_LIBS = $(call pkg,--libs cmocka) $(MODEL_LIBS)

$B/test/%.o: tests/%.c $B/flags
	$(call say,TEST,$(*F))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) -MMD -MP -c $< -o $@

$B/test/%.sanitized.o: tests/%.c $B/flags
	$(call say,TEST,"$(*F) sanitized")
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(SANITIZE) -MMD -MP -c $< -o $@

$(TEST_C:tests/%.c=$B/test/%): %: %.o $(LIB)
	$(Q)$(CC) -fopenmp $^ $(TEST_LIBS) -o $@

$(TEST_C:tests/%.c=$B/test/%.sanitized): %: %.o $B/asan/libsphaera.a
	$(Q)$(CC) -fopenmp $(SANITIZE) $^ $(TEST_LIBS) -o $@

-include $(TEST_C:tests/%.c=$B/test/%.d) $(TEST_C:tests/%.c=$B/test/%.sanitized.d)
