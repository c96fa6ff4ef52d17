# common_mode.mk - the naive model's pictures; faults planted in model and RTL alike
# SPDX-License-Identifier: Apache-2.0
NAIVE := $B/test/naive-frame
$(NAIVE): $B/test/obj/tests/reference/naive_frame.o $(LIB)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(MODEL_LIBS))

tests/reference/test_hashes_naive.sh tests/mutants/test_common_mode.sh: | $(NAIVE)
tests/mutants/test_common_mode.sh: | $B/test/hard

common-mode: suites ## faults planted in model and RTL alike, and what notices them: all of the list
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/mutants/test_common_mode.sh

.PHONY: common-mode

# its name until 1.0.0
.PHONY: twins
twins: common-mode
