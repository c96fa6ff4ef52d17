# neon.mk - the golden model of a processor with NEON, run by QEMU
# SPDX-License-Identifier: Apache-2.0
#
#   make neon-setup    installs a compiler for aarch64, QEMU
#   make neon          the fast walks of aarch64 against the literal one, scene by scene

# The model without builder and reader of scenes, which need libraries of that processor.
NEON_C := $(sort $(wildcard $(patsubst %,cmodel/%/*.c,common core engine fast machine math memory \
            pixel prim shade texture trace)))
NEON   := $B/neon
NEON_CC := aarch64-linux-gnu-gcc
NEON_RUN := qemu-aarch64-static -L /usr/aarch64-linux-gnu
NEON_MACHINES := $(foreach s,inside interpenetrating paper100 sphereflake2,\
                   $(foreach t,bvh4 box4 bih,$(NEON)/$s.$t.sph))

.PHONY: neon neon-setup
neon-setup: ## installs a compiler for aarch64 and QEMU (apt), which `make neon` needs
	@sh sim/setup.sh gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user-static

neon: ## the fast walks of aarch64, NEON and plain C, against the literal one
	$(Q)command -v $(NEON_CC) >/dev/null && command -v $(firstword $(NEON_RUN)) >/dev/null || \
	    { echo "neon: no compiler for aarch64 or no QEMU here: make neon-setup installs them" >&2; \
	      exit 1; }
	$(Q)$(MAKE) --no-print-directory $(NEON)/walks $(NEON_MACHINES)
	$(Q)$(NEON_RUN) $(NEON)/walks $(NEON_MACHINES)

$(NEON)/obj/%.o: %.c $B/flags $B/tools/$(NEON_CC)
	$(call progress,CC,"$(<F) for aarch64")
	@mkdir -p $(@D)
	$(call compile_whole,$(NEON_CC) $(filter-out -m%,$(CFLAGS)) -Itests)

$(NEON)/libsphaera.a: $(call objects,neon/obj/,$(NEON_C)) $B/sources
	$(call say,AR,"$(@F) for aarch64")
	$(call archive_whole,aarch64-linux-gnu-ar)

$(NEON)/walks: $(NEON)/obj/sim/walks.o $(NEON)/libsphaera.a
	$(call say,LD,$(@F))
	$(call make_whole,$(NEON_CC) $^ -lm)

$(NEON)/%.sph: $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build scenes/$(basename $*).nff --accel $(subst .,,$(suffix $*)) -o $@ >/dev/null 2>&1

-include $(patsubst %.o,%.d,$(call objects,neon/obj/,$(NEON_C) sim/walks.c))
