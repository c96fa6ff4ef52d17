# objects.mk - how C and C++ files become objects, libraries and the tool
# SPDX-License-Identifier: Apache-2.0
#
# $B/obj holds the optimised objects, $B/asan/obj the same under the sanitizers of gcc, $B/clang/obj
# under those of clang, which see other faults.

# Written anew only when its text changes: what depends on it follows the command line.
define stamp
$B/$(1): FORCE
	@mkdir -p $$(@D)
	@printf '%s\n' '$(2)' | cmp -s - $$@ || printf '%s\n' '$(2)' >$$@
endef
$(eval $(call stamp,flags,$(CC) $(CFLAGS) / $(CXX) $(CXXFLAGS) / $(SANITIZE) / \
      $(CLANG_CC) $(CLANG_SANITIZE)))
$(eval $(call stamp,sources,$(LIB_C) / $(TOOL_C)))

$B/obj/%.o: %.c $B/flags
	$(call say,CC,$(<F))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) -MMD -MP -c $< -o $@

$B/obj/%.o: %.cpp $B/flags
	$(call say,CXX,$(<F))
	@mkdir -p $(@D)
	$(Q)$(CXX) $(CXXFLAGS) $(call pkg,--cflags OpenImageIO | sed 's/-I/-isystem /g') \
	    -MMD -MP -c $< -o $@

$B/asan/obj/%.o: %.c $B/flags
	$(call say,CC,"$(<F) sanitized")
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(SANITIZE) -MMD -MP -c $< -o $@

$B/clang/obj/%.o: %.c $B/flags
	$(call say,CC,"$(<F) sanitized by clang")
	@mkdir -p $(@D)
	$(Q)$(CLANG_CC) $(CLANG_FLAGS) -MMD -MP -c $< -o $@

objects = $(patsubst %.c,$B/$(1)%.o,$(filter %.c,$(2))) \
          $(patsubst %.cpp,$B/$(1)%.o,$(filter %.cpp,$(2)))

$(LIB): $(call objects,obj/,$(LIB_C)) $B/sources
$(IMAGE): $(call objects,obj/,$(IMAGE_CXX)) $B/sources
$B/asan/libsphaera.a: $(call objects,asan/obj/,$(LIB_C)) $B/sources
$B/clang/libsphaera.a: $(call objects,clang/obj/,$(LIB_C)) $B/sources
%.a:
	$(call say,AR,$(@F))
	@rm -f $@
	$(Q)ar rcs $@ $(filter %.o,$^)

$(TOOL): $(call objects,obj/,$(TOOL_C)) $(IMAGE) $(LIB)
	$(call say,LD,$(@F))
	$(Q)$(CXX) -fopenmp $(filter %.o %.a,$^) $(call pkg,--libs jansson) $(IMAGE_LIBS) \
	    $(MODEL_LIBS) -o $@

-include $(patsubst %.o,%.d,$(call objects,obj/,$(LIB_C) $(TOOL_C) $(IMAGE_CXX)) \
                            $(call objects,asan/obj/,$(LIB_C)) \
                            $(call objects,clang/obj/,$(LIB_C)))
