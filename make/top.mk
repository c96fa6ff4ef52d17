# top.mk - rt_top: what is checked of it by packages that are not needed elsewhere
# SPDX-License-Identifier: Apache-2.0

BUS_VENV := $B/venv/bus
BUS_PACKAGES := systemrdl-compiler==1.33.0 cocotb==2.1.0 cocotbext-axi==0.1.28
bus_python = $(BUS_VENV)/bin/python

.PHONY: bus-setup rdl
bus-setup: ## installs what `make rdl` and `make cocotb` need into build/venv/bus (PyPI)
	$(Q)python3 -m venv $(BUS_VENV)
	$(Q)$(bus_python) -m pip install -q $(BUS_PACKAGES)

rdl: ## reads the register list of rt_top with systemrdl-compiler, if `make bus-setup` ran
	$(Q)if [ -x $(bus_python) ]; then $(bus_python) -m lab.top.rdl docs/blocks/rt_top.rdl; \
	    else echo "rdl: not checked, systemrdl-compiler is absent: make bus-setup"; fi
