# install.mk - make install: library, header, tool, man pages, completion
# SPDX-License-Identifier: Apache-2.0
#
# $B/dist holds what is installed; the libraries export what sphaera.h declares and nothing else.

D       := $B/dist
SOVERSION = $(firstword $(subst ., ,$(VERSION)))
SO      := libsphaera.so.$(VERSION)
to_prefix = $(call values,PREFIX DESTDIR VERSION) BUILD=$B \
            REQUIRES='$(if $(OIIO),OpenImageIO )$(MODEL_PACKAGES)'
LIBRARY_C := $(API_C) $(IMAGE_C) $(LIB_C)
# The shared one loads OpenImageIO when a picture is asked for; a static one is linked with it. Both
# load what reads meshes.
SHARED_O  := $(call objects,obj/,$(LIBRARY_C) $(LAZY_C))
STATIC_O  := $(call objects,obj/,$(LIBRARY_C) $(or $(IMAGE_CXX),$(LAZY_C)))
# Names of sphaera.h have its version: that of a program built with another one is not found.
$D/exports: cmodel/sphaera/sphaera.h VERSION
	@mkdir -p $D
	$(Q)printf 'SPHAERA_%s { global: sphaera_*; local: *; };\n' $(SOVERSION) >$@

$D/$(SO): $(SHARED_O) $D/exports $B/sources VERSION
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) -shared -Wl$(comma)-soname$(comma)libsphaera.so.$(SOVERSION) \
	    -Wl$(comma)--version-script=$D/exports -Wl$(comma)--no-undefined \
	    $(SHARED_O) $(MODEL_LIBS))

# One object, in which all names but those of sphaera.h are local.
$D/libsphaera.a: $(STATIC_O) $B/sources
	$(call say,AR,$(@F))
	@mkdir -p $D
	$(Q)$(beside) && ld -r $(STATIC_O) -o $$new/all.o && \
	    objcopy --wildcard --keep-global-symbol='sphaera_*' $$new/all.o $$new/sphaera.o && \
	    ar rcs $$new/new $$new/sphaera.o && mv $$new/new $@

$D/man/done: $(TOOL) sim/tool_help.py
	$(call say,MAN,"sphaera.1 and a page a command")
	$(Q)rm -rf $(@D) && mkdir -p $(@D)
	$(Q)sim/tool_help.py man $(TOOL) $(@D)
	@touch $@

$D/complete.%: $(TOOL) sim/tool_help.py
	@mkdir -p $D
	$(Q)$(beside) && sim/tool_help.py $* $(TOOL) >$$new/new && mv $$new/new $@

.PHONY: library install uninstall
library: $D/$(SO) $(PICTURE) $(MESHES) $D/libsphaera.a ## libsphaera, both kinds, in build/dist
	$(Q)$(to_prefix) sh sim/install.sh pc

install: library $(TOOL) $D/man/done $D/complete.bash $D/complete.zsh ## into PREFIX, below DESTDIR
	$(call say,INST,$(call quoted,$(DESTDIR)$(PREFIX)))
	$(Q)$(to_prefix) sh sim/install.sh install

uninstall: $D/man/done ## removes what install put there, and no folder but sphaera's own
	$(Q)$(to_prefix) sh sim/install.sh uninstall

.PHONY: dist
dist: ## tarball of the sources in build/dist; unpacked there, built and tested (ONLY: some suites)
	@ONLY=$(ONLY) JOBS=$(JOBS) sh sim/dist.sh $D

.PHONY: notebook-setup
notebook-setup: ## installs what examples/python/sweep.ipynb needs (apt)
	@sh sim/setup.sh python3-nbclient python3-ipykernel python3-matplotlib

# ---- the core for FuseSoC ----
FUSESOC := fusesoc==2.4

.PHONY: fusesoc
fusesoc: $(TOOL) $B/fusesoc/done ## the core by FuseSoC 2.4 (taken by pip), Verilator and Icarus
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/flow/test_minimal.sh

$B/fusesoc/done:
	$(call say,PIP,$(FUSESOC))
	$(Q)python3 -m venv $(@D)
	$(Q)$(@D)/bin/pip install --quiet --disable-pip-version-check $(FUSESOC)
	@touch $@
