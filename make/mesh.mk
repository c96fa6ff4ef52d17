# mesh.mk - meshes of other programs, by assimp, which may be missing
# SPDX-License-Identifier: Apache-2.0
#
# $B/sphaera_mesh.so is what the tool loads to read one: cmodel/scene/mesh_read.c. trimesh, another
# reader, stands beside for tests/scene/test_mesh_others.sh.

MESH_VENV := $B/venv/mesh

.PHONY: mesh-setup mesh-time
mesh-setup: ## installs assimp (apt) for meshes, and trimesh (pip) for their tests; makes the tool
	@sh sim/setup.sh libassimp-dev libjansson-dev python3-venv
	$(Q)python3 -m venv $(MESH_VENV)
	$(Q)$(MESH_VENV)/bin/pip install --quiet --disable-pip-version-check trimesh==4.5.3
	+$(Q)$(MAKE) --no-print-directory tool

mesh-time: $(TOOL) ## what a mesh of a million triangles takes, into docs/reference/scene_format.md
	$(Q)python3 -m lab mesh-time $(TOOL) $B/mesh-time docs/reference/scene_format.md

MESH_FLAGS = $(call pkg,--cflags assimp jansson | sed 's/-I/-isystem /g')
$(MESH_C:%.c=$B/obj/%.o): override CFLAGS += $(MESH_FLAGS)
$(MESH_C:%.c=$B/asan/obj/%.o): override CFLAGS += $(MESH_FLAGS)

$B/sphaera_mesh.so: $(call objects,obj/,$(MESH_C)) $(MODEL) $B/sources
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) -shared -Wl$(comma)-Bsymbolic -Wl$(comma)--no-undefined \
	    $(filter %.o %.a,$^) $(call pkg,--libs assimp jansson) $(MODEL_LIBS))

# Suites that read meshes.
$(foreach s,ledger mesh,$B/test/test_$s $B/test/test_$s.sanitized): | $(MESHES)

-include $(patsubst %.o,%.d,$(call objects,obj/,$(MESH_C)) $(call objects,asan/obj/,$(MESH_C)))
