# test.mk - what `make test` runs
# SPDX-License-Identifier: Apache-2.0
#
# A suite is a program or script that prints TAP lines, `ok ...` or `not ok ...`; run.sh counts.
#   tests/*/test_*.c  cmocka, linked with the model; runs plain and under gcc's sanitizers, those of
#                     CLANG_C under clang's too
#   tests/*/test_*.sh a script; finds the tool in $SPHAERA, its own empty folder in $TMP
#   SUITES += path    any other executable, with a rule that makes it
# `make test ONLY=PATTERN` runs the suites whose file name has the pattern in it, those under
# sanitizers with a dot in it alone (ONLY=test_x.sanitized, ONLY=test_x.). With ALL=1 those run,
# too, and suites that choose by themselves leave nothing out.

TEST_C  := $(sort $(wildcard tests/test_*.c tests/*/test_*.c))
TEST_SH := $(sort $(wildcard tests/test_*.sh tests/*/test_*.sh))
TEST_RUN := $(patsubst %.c,$B/test/%,$(notdir $(TEST_C)))
# The longest first: what runs beside them fills their gaps.
LONG    := tests/flow/test_benches.sh tests/core/test_effect_scenes.sh tests/core/test_core.sh \
           tests/flow/test_lint.sh tests/core/test_core_boxes.sh tests/flow/test_formal.sh \
           tests/flow/test_budget.sh tests/core/test_core_optics.sh tests/core/test_core_bih.sh \
           tests/core/test_core_texture.sh tests/core/test_parameters.sh \
           tests/core/test_own_core.sh tests/top/test_cells.sh \
           tests/faults/test_hard_rtl.sh tests/tool/test_profile.sh \
           tests/pixel/test_background.sh tests/faults/test_mutants.sh
# What is quick and goes through each part of the model: `make test ONLY=.clang`.
CLANG_C := bih bih_walk build cones facets_grid leaf_cases limits machine_bih machine_facets \
           model_optics motion reference_optics render_texture scene_make scene_optics scene_pdb
CLANG_RUN := $(CLANG_C:%=$B/test/test_%.clang)
# Under ThreadSanitizer: `make test ONLY=.threads`.
TSAN_C   := threads
TSAN_RUN := $(TSAN_C:%=$B/test/test_%.threads)
SUITES  += $(LONG) $(filter-out $(LONG),$(TEST_SH)) \
           $(TEST_RUN) $(TEST_RUN:%=%.sanitized) $(CLANG_RUN) $(TSAN_RUN) \
           $(if $(OIIO),$B/test/test_image)
chosen   = $(if $(findstring $(ONLY),$(notdir $(1))),$(1))
plain    = $(if $(findstring .,$(ONLY))$(ALL),$(SUITES),\
               $(filter-out %.sanitized %.clang %.threads,$(SUITES)))
RUN      = $(if $(ONLY),$(foreach s,$(plain),$(call chosen,$s)),$(SUITES))

test: ## every check; ends with `N passed, M failed`
	$(if $(strip $(RUN)),,@$(front) suites '$(ONLY)' $(notdir $(SUITES)))
	$(if $(filter $B/test/%,$(RUN)),$(if $(call exists,cmocka),,$(error cmocka is not installed: \
	    make setup test)))
	+@unbuilt=; $(MAKE) --no-print-directory -k suites || unbuilt=1; \
	    UNBUILT=$$unbuilt BUILD=$B JOBS=$(JOBS) sh tests/run.sh $(RUN)

.PHONY: gemmi-setup
gemmi-setup: ## installs gemmi (apt), which readers of molecules are checked against
	@sh sim/setup.sh python3-gemmi

.PHONY: suites budget
suites: $(if $(filter %.sh,$(RUN)),$(TOOL)) $(RUN)

budget: ## what cores take on ecp5, within synth/budget*.txt: with everything, nothing, the widest
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/flow/test_budget.sh

TEST_LIBS = $(call pkg,--libs cmocka) $(MODEL_LIBS)

vpath test_%.c $(sort $(dir $(TEST_C)))
$B/test/test_%.o: test_%.c $B/flags
	$(call progress,TEST,test_$*)
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) -O1 -Itests)

$B/test/test_%.sanitized.o: test_%.c $B/flags
	$(call progress,TEST,"test_$* sanitized")
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) -Itests $(SANITIZE))

$B/test/test_%.clang.o: test_%.c $B/flags
	$(call progress,TEST,"test_$* sanitized by clang")
	@mkdir -p $(@D)
	$(call compile_whole,$(CLANG_CC) $(CLANG_FLAGS) -Itests)

$B/test/test_%.threads.o: test_%.c $B/flags
	$(call progress,TEST,"test_$* for threads")
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) -Itests $(THREADED))

$(TEST_RUN): %: %.o $(MODEL)
	$(call make_whole,$(CC) $(LINKER) $(filter %.o,$^) $(filter %.a,$^) $(TEST_LIBS))

$(TEST_RUN:%=%.sanitized): %: %.o $B/asan/libsphaera.a
	$(call make_whole,$(CC) $(LINKER) $(SANITIZE) $(filter %.o,$^) $(filter %.a,$^) \
	    $(TEST_LIBS))

$(CLANG_RUN): %: %.o $B/clang/libsphaera.a
	$(call make_whole,$(CLANG_CC) $(CLANG_FLAGS) $^ $(TEST_LIBS))

$(TSAN_RUN): %: %.o $B/tsan/libsphaera.a
	$(call make_whole,$(CC) $(LINKER) $(THREADED) $(filter %.o,$^) $(filter %.a,$^) $(TEST_LIBS))

# Programs whose command lines a suite tries.
tests/tool/test_numbers.sh: | $B/test/hard $B/test/test_frustum $B/test/test_malformed \
    $B/fuzz/plain/fuzz_options $(PICTURES)

# The library's face, which the model's archive lacks.
FACE := $(wildcard cmodel/sphaera/*.c) $(IMAGE_C) $(LAZY_C)
FACED := library environment threads
$(FACED:%=$B/test/test_%): $(call objects,obj/,$(FACE))
$(FACED:%=$B/test/test_%.sanitized): $(call objects,asan/obj/,$(FACE))
$B/test/test_threads.threads: $(call objects,tsan/obj/,$(FACE))
$(foreach h,asan tsan,$B/$h/obj/cmodel/sphaera/version.o): \
    override CFLAGS += -DSPHAERA_RELEASE='"$(VERSION)"'

-include $(TEST_RUN:%=%.d) $(TEST_RUN:%=%.sanitized.d) $(CLANG_RUN:%=%.d) \
         $(TSAN_RUN:%=%.d)

# ---- the suite of images: it alone is linked with OpenImageIO ----
$B/test/test_image: $B/obj/tests/image/test_image.o $(IMAGE) $(MODEL)
	$(call say,LD,$(@F))
	@mkdir -p $(@D)
	$(call make_whole,$(CXX) $^ $(IMAGE_LIBS) $(MODEL_LIBS))

-include $B/obj/tests/image/test_image.d
