# litex.mk - rt_top in a LiteX system of a ULX3S, generated and looked through
# SPDX-License-Identifier: Apache-2.0

LITEX_VENV     := $B/venv/litex
LITEX_PACKAGES := litex==2024.12 litedram==2024.12 litex-boards==2023.12 \
                  pythondata-cpu-vexriscv==1.0.1.post407 \
                  pythondata-software-picolibc==1.7.9.post181 \
                  pythondata-software-compiler-rt==0.0.post6206
litex_python   = $(LITEX_VENV)/bin/python

.PHONY: litex litex-setup
litex-setup: ## installs LiteX and VexRiscv into build/venv/litex (PyPI)
	$(Q)python3 -m venv $(LITEX_VENV)
	$(Q)$(litex_python) -m pip install -q $(LITEX_PACKAGES)

litex: ## a LiteX system of a ULX3S with rt_top: generated and linted, if `make litex-setup` ran
	$(Q)if [ -x $(litex_python) ]; then LITEX=$(litex_python) sh synth/litex.sh $B/litex; \
	    else echo "litex: nothing is made, it is absent: make litex-setup"; fi
