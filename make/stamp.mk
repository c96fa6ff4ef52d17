# stamp.mk - files that tell of commands and tools; what depends on one is made anew when it changes
# SPDX-License-Identifier: Apache-2.0
#
# (call stamp,TEXT,TOOLS): the recipe of such a file, which is written anew only when its text or
# the version of one of the tools does, words of commands among which sim/version.sh finds them.
# $B/tools/NAME is one of a tool alone.
# beside: a folder $$new of this command's own beside the target, removed at its end. What is made
# there gets its name when it is whole: calls of make in one folder, or containers that share it, do
# not meet each other's halves, and no link that stands there is followed.
beside = new=$$(mktemp -d $(@D)/.whole.XXXXXXXXXX) && trap 'rm -rf "$$new"' EXIT && \
             trap 'exit 1' HUP INT TERM
stamp = @mkdir -p $(@D) && $(beside) && \
            { printf '%s\n' '$(1)'; sh sim/version.sh $(2); } >$$new/new && \
            { cmp -s $$new/new $@ || mv $$new/new $@; }
.PHONY: FORCE
$B/tools/%: FORCE
	$(call stamp,$*,$*)
.PRECIOUS: $B/tools/%
