# install.mk - make install: library, header, tool, man pages, completion
# SPDX-License-Identifier: Apache-2.0
#
# $B/dist holds what is installed; the libraries export what sphaera.h declares and nothing else.

D       := $B/dist
SOVERSION = $(firstword $(subst ., ,$(VERSION)))
SO      := libsphaera.so.$(VERSION)
LIBRARY_C := $(API_C) $(IMAGE_C) $(LIB_C)
# The shared one loads OpenImageIO when a picture is asked for; a static one is linked with it.
SHARED_O  := $(call objects,obj/,$(LIBRARY_C) $(LAZY_C))
STATIC_O  := $(call objects,obj/,$(LIBRARY_C) $(IMAGE_CXX))
BASH_TO := $(PREFIX)/share/bash-completion/completions
ZSH_TO  := $(PREFIX)/share/zsh/site-functions
INSTALLED := $(PREFIX)/bin/sphaera $(PREFIX)/lib/sphaera/image.so $(PREFIX)/lib/sphaera/view.so \
             $(PREFIX)/include/sphaera/sphaera.h \
             $(PREFIX)/lib/$(SO) $(PREFIX)/lib/libsphaera.so.$(SOVERSION) \
             $(PREFIX)/lib/libsphaera.so $(PREFIX)/lib/libsphaera.a \
             $(PREFIX)/lib/pkgconfig/sphaera.pc $(BASH_TO)/sphaera $(ZSH_TO)/_sphaera

$D/exports: cmodel/sphaera/sphaera.h
	@mkdir -p $D
	$(Q)printf '{ global: sphaera_*; local: *; };\n' >$@

# It stays when a program unloads it: its threads, of libgomp, would wake up in nothing.
$D/$(SO): $(SHARED_O) $D/exports $B/sources VERSION
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) -shared -fopenmp -Wl$(comma)-soname$(comma)libsphaera.so.$(SOVERSION) \
	    -Wl$(comma)--version-script=$D/exports -Wl$(comma)--no-undefined \
	    -Wl$(comma)-z$(comma)nodelete $(SHARED_O) \
	    $(MODEL_LIBS))

# One object, in which all names but those of sphaera.h are local.
$D/libsphaera.a: $(STATIC_O) $B/sources
	$(call say,AR,$(@F))
	@mkdir -p $D
	$(Q)ld -r $(STATIC_O) -o $D/sphaera.o.$$$$ && \
	    objcopy --wildcard --keep-global-symbol='sphaera_*' $D/sphaera.o.$$$$ $D/sphaera.o && \
	    rm -f $@ $D/sphaera.o.$$$$ && ar rcs $@ $D/sphaera.o && rm $D/sphaera.o

$D/sphaera.pc: FORCE
	@mkdir -p $D
	@printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$${prefix}/lib' 'includedir=$${prefix}/include' '' \
	    'Name: sphaera' 'Description: golden model of a ray tracer in hardware' \
	    'Version: $(VERSION)' 'Cflags: -I$${includedir}' 'Libs: -L$${libdir} -lsphaera' \
	    'Requires.private: OpenImageIO $(MODEL_PACKAGES)' \
	    'Libs.private: -lgomp -lstdc++ -lm' >$@

$D/man/done: $(TOOL) sim/man.sh sim/man.awk
	$(call say,MAN,"sphaera.1 and a page a command")
	$(Q)rm -rf $(@D) && mkdir -p $(@D)
	$(Q)SPHAERA=$(TOOL) sh sim/man.sh $(@D)
	@touch $@

$D/complete.%: $(TOOL) sim/complete.sh
	@mkdir -p $D
	$(Q)SPHAERA=$(TOOL) sh sim/complete.sh $* >$@.$$$$ && mv $@.$$$$ $@

.PHONY: library install uninstall
library: $D/$(SO) $(PICTURE) $D/libsphaera.a $D/sphaera.pc ## libsphaera, both kinds, in build/dist

install: library $(TOOL) $D/man/done $D/complete.bash $D/complete.zsh ## into PREFIX, below DESTDIR
	$(call say,INST,'$(DESTDIR)$(PREFIX)')
	$(Q)to='$(DESTDIR)$(PREFIX)'; set -e; \
	    install -d "$$to/bin" "$$to/include/sphaera" "$$to/lib/sphaera" "$$to/lib/pkgconfig" \
	        "$$to/share/man/man1" \
	        '$(DESTDIR)$(BASH_TO)' '$(DESTDIR)$(ZSH_TO)'; \
	    install -m 755 $(TOOL) "$$to/bin/sphaera"; \
	    install -m 755 $(PICTURE) "$$to/lib/sphaera/image.so"; \
	    $(if $(VIEWER),install -m 755 $(VIEWER) "$$to/lib/sphaera/view.so";) \
	    install -m 644 cmodel/sphaera/sphaera.h "$$to/include/sphaera"; \
	    install -m 755 $D/$(SO) "$$to/lib"; \
	    ln -sf $(SO) "$$to/lib/libsphaera.so.$(SOVERSION)"; \
	    ln -sf $(SO) "$$to/lib/libsphaera.so"; \
	    install -m 644 $D/libsphaera.a "$$to/lib"; \
	    install -m 644 $D/sphaera.pc "$$to/lib/pkgconfig"; \
	    install -m 644 $D/man/*.1 "$$to/share/man/man1"; \
	    install -m 644 $D/complete.bash '$(DESTDIR)$(BASH_TO)/sphaera'; \
	    install -m 644 $D/complete.zsh '$(DESTDIR)$(ZSH_TO)/_sphaera'

uninstall: $D/man/done ## removes what install put there, and no folder but sphaera's own
	$(Q)set -e; for file in $(INSTALLED:%='$(DESTDIR)%'); do rm -f "$$file"; done; \
	    for page in $D/man/*.1; do \
	        rm -f '$(DESTDIR)$(PREFIX)/share/man/man1'/"$${page##*/}"; done; \
	    rmdir '$(DESTDIR)$(PREFIX)/include/sphaera' '$(DESTDIR)$(PREFIX)/lib/sphaera' \
	        2>/dev/null || :

.PHONY: dist
dist: ## tarball of the sources in build/dist; unpacked there, built and tested (ONLY: some suites)
	@ONLY='$(ONLY)' JOBS=$(JOBS) sh sim/dist.sh $D
