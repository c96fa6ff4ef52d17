# formal.mk - proofs of the RTL
# SPDX-License-Identifier: Apache-2.0
#
#   make formal                proofs of formal/proofs.txt, and the reset of each module
#   make formal PROVE=fifo     those with that in their name; PROVE=reset: the reset alone
#   make cbmc-setup            for the proofs of the model in C: CBMC, which Debian 12 does not have

.PHONY: formal cbmc-setup
formal: ## proofs of the RTL with yosys-smtbmc and z3, and of its reset, table at the end
	$(if $(filter-out reset,$(PROVE))$(if $(PROVE),,all),$(Q)BUILD=$B sh formal/prove.sh $(PROVE))
	$(if $(filter-out reset,$(PROVE)),,$(Q)python3 -m lab reset $B)

cbmc-setup: ## CBMC 5.12, which Debian 11 had, into the build folder, for make formal
	@sh sim/setup.sh minisat
	@sh formal/cbmc_setup.sh $B/cbmc
