# objects.mk - how C and C++ files become objects, libraries and the tool
# SPDX-License-Identifier: Apache-2.0
#
# $B/obj holds the optimised objects, $B/asan/obj the same under the sanitizers of gcc, $B/clang/obj
# under those of clang, which see other faults.

include make/stamp.mk
# What is made gets its name when it is whole (make/stamp.mk). Dependencies name the build folder
# $(B): it may be given by another path.
make_whole    = $(Q)$(beside) && $(1) -o $$new/new && mv $$new/new $@
compile_whole = $(Q)$(beside) && $(1) -MMD -MP -MT '$(@:$B/%=$$(B)/%)' -MF $$new/d -c $< \
                    -o $$new/new && mv $$new/d $(@:.o=.d) && mv $$new/new $@
# 1: the archiver
archive_whole = $(Q)$(beside) && $(1) rcs $$new/new $(filter %.o,$^) && mv $$new/new $@
# taken here: a target's own options, of which CFLAGS has some, are none of these
COMPILED := $(CC) $(CFLAGS) $(SHARED) / $(CXX) $(CXXFLAGS) / $(SANITIZE) / \
            $(CLANG_CC) $(CLANG_SANITIZE)
COMPILERS := $(CC) $(CXX) $(CLANG_CC)
$B/flags: FORCE
	$(if $(call exists,$(MODEL_PACKAGES) jansson),,$(error not all of $(MODEL_PACKAGES) jansson are \
	    installed: make setup tool))
	$(call stamp,$(COMPILED),$(COMPILERS))
$B/sources: FORCE
	$(call stamp,$(LIB_C) / $(TOOL_C) / $(IMAGE_C) $(LAZY_C) / $(API_C))
# In `make clean sim` and the like all else waits for what removes the folder or makes headers.
FIRST := $(filter clean layout,$(MAKECMDGOALS))
# A rule without commands, as below, makes a target of any name: here files show that they are one.
FILES := $(strip $(foreach f,$(if $(FIRST),$(MAKECMDGOALS)),$(if $(findstring /,$f),$f)))
$(if $(FILES),$(if $(filter 2,$(shell $(MAKE) -q --no-print-directory \
    $(foreach v,$(GIVEN),$(call quoted,$v=$($v))) $(FILES) >/dev/null; echo $$?)),$(error \
    nothing is made)))
$B/flags $B/sources $(if $(FIRST),$(filter-out $(FIRST),$(MAKECMDGOALS))): | $(FIRST)

$B/obj/%.o: %.c $B/flags
	$(call progress,CC,$(<F))
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) $(SHARED))

$B/obj/%.o: %.cpp $B/flags
	$(call progress,CXX,$(<F))
	@mkdir -p $(@D)
	$(call compile_whole,$(CXX) $(CXXFLAGS) $(SHARED) \
	    $(if $(OIIO),$(call pkg,--cflags OpenImageIO | sed 's/-I/-isystem /g')))

$B/asan/obj/%.o: %.c $B/flags
	$(call progress,CC,"$(<F) sanitized")
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) $(SANITIZE))

$B/clang/obj/%.o: %.c $B/flags
	$(call progress,CC,"$(<F) sanitized by clang")
	@mkdir -p $(@D)
	$(call compile_whole,$(CLANG_CC) $(CLANG_FLAGS))

$B/tsan/obj/%.o: %.c $B/flags
	$(call progress,CC,"$(<F) for threads")
	@mkdir -p $(@D)
	$(call compile_whole,$(CC) $(CFLAGS) $(THREADED))

objects = $(patsubst %.c,$B/$(1)%.o,$(filter %.c,$(2))) \
          $(patsubst %.cpp,$B/$(1)%.o,$(filter %.cpp,$(2)))

$(MODEL): $(call objects,obj/,$(LIB_C)) $B/sources
$(IMAGE): $(call objects,obj/,$(IMAGE_CXX) $(IMAGE_C)) $B/sources
$B/asan/libsphaera.a: $(call objects,asan/obj/,$(LIB_C)) $B/sources
$B/tsan/libsphaera.a: $(call objects,tsan/obj/,$(LIB_C)) $B/sources
$B/clang/libsphaera.a: $(call objects,clang/obj/,$(LIB_C)) $B/sources
%.a:
	$(call say,AR,$(@F))
	$(call archive_whole,ar)

# One place has the version; what prints it is compiled anew when it changes.
VERSION := $(shell cat VERSION)
VERSION_O := $B/obj/cmodel/sphaera/version.o
$(VERSION_O): VERSION
$(VERSION_O): override CFLAGS += -DSPHAERA_RELEASE='"$(VERSION)"'

# Files that ask for more than every processor of its kind has; who calls them looks whether this
# one has it (cmodel/fast/decode.c).
AVX2 := $(if $(findstring x86_64,$(shell $(CC) -dumpmachine 2>/dev/null)),-mavx2)
$(foreach h,obj asan/obj tsan/obj,$B/$h/cmodel/fast/%_avx2.o): override CFLAGS += $(AVX2)
$B/clang/obj/cmodel/fast/%_avx2.o: override CLANG_FLAGS += $(AVX2)

# Floating point of which each operation rounds.
$(foreach h,obj asan/obj tsan/obj,$B/$h/cmodel/reference/floats.o): \
    override CFLAGS += -ffp-contract=off

# What the tool loads when a picture is asked for: cmodel/image/lazy.c.
$B/sphaera_image.so: $(call objects,obj/,$(IMAGE_CXX) cmodel/image/plain.c) $(MODEL) $B/sources
	$(call say,LD,$(@F))
	$(call make_whole,$(CXX) -shared -Wl$(comma)-Bsymbolic -Wl$(comma)--no-undefined \
	    $(filter %.o %.a,$^) $(IMAGE_LIBS) $(MODEL_LIBS))

$(TOOL): $(call objects,obj/,$(TOOL_C) $(IMAGE_C) $(LAZY_C)) $(VERSION_O) $(MODEL) \
         $(PICTURE) $(MESHES) $(VIEWER)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $(filter %.o %.a,$^) $(call pkg,--libs jansson) \
	    $(MODEL_LIBS) -ldl)

-include $(patsubst %.o,%.d,$(call objects,obj/,$(LIB_C) $(TOOL_C) $(IMAGE_CXX) $(IMAGE_C) \
                            $(LAZY_C) \
                            $(API_C)) \
                            $(call objects,asan/obj/,$(LIB_C)) \
                            $(call objects,tsan/obj/,$(LIB_C)) \
                            $(call objects,clang/obj/,$(LIB_C)))
