# package.mk - the core for FuseSoC
# SPDX-License-Identifier: Apache-2.0

FUSESOC := fusesoc==2.4

.PHONY: fusesoc
fusesoc: $(TOOL) $B/fusesoc/done ## the core by FuseSoC 2.4 (taken by pip), Verilator and Icarus
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/flow/test_minimal.sh

$B/fusesoc/done:
	$(call say,PIP,$(FUSESOC))
	$(Q)python3 -m venv $(@D)
	$(Q)$(@D)/bin/pip install --quiet --disable-pip-version-check $(FUSESOC)
	@touch $@
