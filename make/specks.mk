# specks.mk - falsely dark pixels of triangles, counted by rules of where rays start
# SPDX-License-Identifier: Apache-2.0
#
#   make specks                the table of docs/model/facet.md; ten minutes
#   build/test/specks SCENE.nff PROFILE --show       one scene; each falsely dark pixel with its ray
SPECKS_C := $(sort $(wildcard tests/specks/*.c))

.PHONY: specks
specks: $B/test/specks $(TOOL) ## falsely dark pixels of triangles, into docs/model/facet.md
	$(Q)python3 -m lab.specks $(TOOL) $< $B/specks docs/model/facet.md

$B/test/specks: $(SPECKS_C:%.c=$B/test/obj/%.o) $(LIB)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(MODEL_LIBS))

-include $(SPECKS_C:%.c=$B/test/obj/%.d)
tests/specks/test_specks.sh: | $B/test/specks
