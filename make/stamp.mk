# stamp.mk - files that tell of commands and tools; what depends on one is made anew when it changes
# SPDX-License-Identifier: Apache-2.0
#
# (call stamp,TEXT,TOOLS): the recipe of such a file, which is written anew only when its text or
# the version of one of the tools does, words of commands among which sim/version.sh finds them.
# $B/tools/NAME is one of a tool alone.
stamp = @mkdir -p $(@D); new=$@.$$$$; { printf '%s\n' '$(1)'; sh sim/version.sh $(2); } >$$new; \
            cmp -s $$new $@ && rm $$new || mv $$new $@
.PHONY: FORCE
$B/tools/%: FORCE
	$(call stamp,$*,$*)
.PRECIOUS: $B/tools/%
