# fuzz.mk - harnesses for fuzzers, and what runs them
# SPDX-License-Identifier: Apache-2.0
#
#   make fuzz MINUTES=60 [HARNESS=nff]   each harness so long: AFL++ if it is installed, else the
#                                        driver of the tree; then all that was found, sanitized
#   make fuzz MINUTES=2 INPUTS=10000000  then the driver changes what AFL++ kept, up to so many runs
#   make fuzz-setup                      installs AFL++
#   $B/fuzz/HOW/fuzz_NAME                plain: the driver alone; gcc, clang: under the sanitizers
#                                        of that compiler; afl: for AFL++
# `make test` runs those of gcc and clang for some seconds (tests/fuzz/test_fuzz.sh).

FUZZ       := $B/fuzz
FUZZ_NAMES := nff aff pdb machine frame options $(if $(OIIO),image) $(if $(ASSIMP),mesh)
FUZZ_C     := tests/fuzz/driver.c tests/fuzz/common.c tests/fuzz/driver.c tests/fuzz/scene.c
AFL_C      := tests/fuzz/afl.c tests/fuzz/common.c tests/fuzz/scene.c
# The harness of options has the tool in it, parted from glibc's argp, and no pictures.
FUZZ_WRAP  := -Wl,--wrap=argp_parse -Wl,--wrap=argp_error -Wl,--wrap=guard_start
FUZZ_TOOL  := $(filter-out cmodel/tool/main.c,$(TOOL_C)) $(LAZY_C) $(IMAGE_C)
FUZZ_IMAGE := $(IMAGE_CXX) cmodel/image/plain.c

# AFL++'s compiler is a clang.
AFL_CC    := AFL_QUIET=1 afl-clang-fast
AFL_CXX   := AFL_QUIET=1 afl-clang-fast++
AFL_FLAGS  = -std=c11 -D_GNU_SOURCE -Icmodel -O1

FUZZ_CC_plain = $(CC) $(CFLAGS)
FUZZ_CC_gcc   = $(CC) $(CFLAGS) $(SANITIZE)
FUZZ_CC_clang = $(CLANG_CC) $(CLANG_FLAGS)
FUZZ_CC_afl   = $(AFL_CC) $(AFL_FLAGS)
FUZZ_LD_plain = $(CXX)
FUZZ_LD_gcc   = $(CXX) $(SANITIZE)
FUZZ_LD_clang = clang++ $(CLANG_SANITIZE)
FUZZ_LD_afl   = $(AFL_CXX)
# where the model's objects are
FUZZ_OF_plain = $B
FUZZ_OF_gcc   = $B/asan
FUZZ_OF_clang = $B/clang
FUZZ_OF_afl   = $(FUZZ)/afl
FUZZ_C_afl    = $(AFL_C)
fuzz_c        = $(or $(FUZZ_C_$(1)),$(FUZZ_C))
fuzz_objects  = $(patsubst %.c,$(FUZZ_OF_$(1))/obj/%.o, \
                    $(patsubst %.cpp,$(FUZZ_OF_$(1))/obj/%.o,$(2)))

# AFL++ has a model of its own; pictures it takes as they are built for the tool.
$(FUZZ)/afl/obj/%.o: %.c $B/flags $B/tools/afl-clang-fast
	$(call say,AFL,$(<F))
	@mkdir -p $(@D)
	$(call compile_whole,$(AFL_CC) $(AFL_FLAGS))
$(FUZZ)/afl/libsphaera.a: $(patsubst %.c,$(FUZZ)/afl/obj/%.o,$(LIB_C)) $B/sources
$(FUZZ)/afl/obj/cmodel/fast/%_avx2.o: override AFL_FLAGS += $(AVX2)
$(patsubst %.cpp,$(FUZZ)/afl/obj/%.o,$(IMAGE_CXX)): $(FUZZ)/afl/obj/%.o: $B/obj/%.o
	@mkdir -p $(@D)
	@cp $< $@

$B/asan/obj/%.o: %.cpp $B/flags
	$(call progress,CXX,"$(<F) sanitized")
	@mkdir -p $(@D)
	$(call compile_whole,$(CXX) $(CXXFLAGS) $(SANITIZE) \
	    $(call pkg,--cflags OpenImageIO | sed 's/-I/-isystem /g'))
$B/clang/obj/%.o: %.cpp $B/flags
	$(call progress,CXX,"$(<F) sanitized by clang")
	@mkdir -p $(@D)
	$(call compile_whole,$(CCACHE) clang++ -std=c++17 -Icmodel $(CLANG_SANITIZE) \
	    $(call pkg,--cflags OpenImageIO | sed 's/-I/-isystem /g'))
$(foreach h,asan tsan clang fuzz/afl,$B/$h/obj/cmodel/sphaera/version.o): VERSION

# how
define fuzz_how
$(FUZZ)/$(1)/harness/%.o: tests/fuzz/%.c $B/flags
	$$(call say,FUZZ,"$$(<F) $(1)")
	@mkdir -p $$(@D)
	$$(call compile_whole,$$(FUZZ_CC_$(1)) -Itests -Itests/fuzz)
$(FUZZ)/$(1)/harness/tool.o: cmodel/tool/main.c $B/flags
	$$(call say,FUZZ,"$$(<F) $(1)")
	@mkdir -p $$(@D)
	$$(call compile_whole,$$(FUZZ_CC_$(1)) -Dmain=tool_main -DSPHAERA_RELEASE='"$(VERSION)"')
$(FUZZ)/$(1)/harness/version.o: cmodel/sphaera/version.c VERSION $B/flags
	@mkdir -p $$(@D)
	$$(call compile_whole,$$(FUZZ_CC_$(1)) -DSPHAERA_RELEASE='"$(VERSION)"')
$(FUZZ)/$(1)/fuzz_options: $(FUZZ)/$(1)/harness/tool.o $(FUZZ)/$(1)/harness/version.o \
    $$(call fuzz_objects,$(1),$(FUZZ_TOOL))
$(FUZZ)/$(1)/fuzz_options: FUZZ_MORE = $(FUZZ_WRAP) $$(call pkg,--libs jansson) -ldl
$(FUZZ)/$(1)/fuzz_mesh: $$(call fuzz_objects,$(1),$(MESH_C))
$(FUZZ)/$(1)/fuzz_mesh: FUZZ_MORE = -Wl,--wrap=sph_module_load \
    -Wl,--export-dynamic-symbol=sph_mesh_load $$(call pkg,--libs assimp jansson) -ldl
$(FUZZ)/$(1)/fuzz_image: $$(call fuzz_objects,$(1),$(FUZZ_IMAGE))
$(FUZZ)/$(1)/fuzz_image: FUZZ_MORE = $$(IMAGE_LIBS)
$(FUZZ_NAMES:%=$(FUZZ)/$(1)/fuzz_%): $(FUZZ)/$(1)/fuzz_%: $(FUZZ)/$(1)/harness/harness_%.o \
    $(patsubst tests/fuzz/%.c,$(FUZZ)/$(1)/harness/%.o,$(call fuzz_c,$(1))) \
    $(FUZZ_OF_$(1))/libsphaera.a
	$$(call say,LD,"$$(@F) $(1)")
	$$(call make_whole,$$(FUZZ_LD_$(1)) $$(filter %.o,$$^) $$(filter %.a,$$^) $$(FUZZ_MORE) \
	    $$(MODEL_LIBS))
endef
$(foreach h,plain gcc clang afl,$(eval $(call fuzz_how,$h)))

.PRECIOUS: $(FUZZ)/afl/obj/%.o $(FUZZ)/plain/harness/%.o $(FUZZ)/gcc/harness/%.o \
           $(FUZZ)/clang/harness/%.o $(FUZZ)/afl/harness/%.o
-include $(wildcard $(FUZZ)/*/harness/*.d) \
         $(patsubst %.c,$(FUZZ)/afl/obj/%.d,$(LIB_C)) \
         $(foreach h,asan clang,$(patsubst %.c,$B/$h/obj/%.d,$(FUZZ_TOOL)) \
             $(patsubst %.cpp,$B/$h/obj/%.d,$(IMAGE_CXX)))

FUZZ_TESTED := $(foreach h,gcc clang,$(patsubst %,$(FUZZ)/$h/fuzz_%,nff aff pdb machine frame \
                   $(if $(ASSIMP),mesh))) \
               $(patsubst %,$(FUZZ)/plain/fuzz_%,machine options $(if $(OIIO),image))
tests/fuzz/test_fuzz.sh: | $(FUZZ_TESTED)

FUZZ_ASKED := $(or $(HARNESS),$(FUZZ_NAMES))
FUZZ_AFL   := $(shell command -v afl-clang-fast)
.PHONY: fuzz fuzz-setup
fuzz-setup: ## installs AFL++ (apt), which make fuzz takes if it is there
	@sh sim/setup.sh afl++

fuzz: $(TOOL) $(foreach n,$(FUZZ_ASKED),$(FUZZ)/gcc/fuzz_$n $(FUZZ)/clang/fuzz_$n \
      $(if $(FUZZ_AFL),$(FUZZ)/afl/fuzz_$n) $(FUZZ)/plain/fuzz_$n)
fuzz: ## readers of files and options: MINUTES for each HARNESS; docs/results/verification.md
	$(Q)BUILD=$(call absolute,$B) SEED=$(SEED) MINUTES=$(MINUTES) INPUTS=$(INPUTS) \
	    sh tests/fuzz/fuzz.sh $(if $(FUZZ_AFL),afl,plain) $(FUZZ_ASKED)

.PHONY: fuzz-page
fuzz-page: ## what make fuzz has run, into docs/results/verification.md
	$(Q)python3 -m lab fuzz-page $(FUZZ)/runs.tsv docs/results/verification.md

# ---- faults on the way of files ----
.PHONY: faults
NO_MEMORY := $B/test/no_memory.so
$(NO_MEMORY): tests/tool/no_memory.c $B/flags
	$(call say,TEST,no_memory)
	@mkdir -p $(@D)
	$(call make_whole,$(CC) $(CFLAGS) -shared -fPIC $(filter %.c,$^))
tests/tool/test_faults.sh: | $(NO_MEMORY)
faults: $(TOOL) $(NO_MEMORY)
faults: ## every command while disks are full, signals come, two run at once; 30 minutes
	$(Q)mkdir -p $B/test
	$(Q)python3 tests/tool/faults.py $(TOOL) $B/test/faults | tee $B/test/faults.log
	@! grep -q '^not ok\|^Bail' $B/test/faults.log
