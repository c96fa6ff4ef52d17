# formal.mk - proofs of the RTL
# SPDX-License-Identifier: Apache-2.0

.PHONY: formal
formal: ## proofs of the RTL with yosys-smtbmc and z3, table at the end
	$(Q)BUILD=$B sh formal/prove.sh $(PROVE)
