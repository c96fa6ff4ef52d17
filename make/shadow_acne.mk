# shadow_acne.mk - falsely dark pixels of triangles, counted by rules of where rays start
# SPDX-License-Identifier: Apache-2.0
#
#   make shadow-acne                the table of docs/design/facet.md; ten minutes
#   build/test/shadow_acne SCENE.nff PROFILE --show  one scene; each falsely dark pixel with its ray
ACNE_C := $(sort $(wildcard tests/shadow_acne/*.c))

.PHONY: shadow-acne
shadow-acne: $B/test/shadow_acne $(TOOL) ## falsely dark pixels of triangles: docs/design/facet.md
	$(Q)python3 -m lab shadow-acne-run $(TOOL) $< $B/shadow_acne docs/design/facet.md

$B/test/shadow_acne: $(ACNE_C:%.c=$B/test/obj/%.o) $(LIB)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(MODEL_LIBS))

-include $(ACNE_C:%.c=$B/test/obj/%.d)
tests/shadow_acne/test_shadow_acne.sh: | $B/test/shadow_acne

# its name until 1.0.0
.PHONY: specks
specks: shadow-acne
