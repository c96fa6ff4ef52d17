# litex.mk - rt_top in a LiteX system: of a ULX3S, looked through; in LiteX's simulator, drawing
# SPDX-License-Identifier: Apache-2.0

LITEX_VENV     := $B/venv/litex
LITEX_PACKAGES := litex==2024.12 litedram==2024.12 litex-boards==2023.12 \
                  pythondata-cpu-vexriscv==1.0.1.post407 \
                  pythondata-software-picolibc==1.7.9.post181 \
                  pythondata-software-compiler-rt==0.0.post6206 \
                  pythondata-misc-tapcfg==0.0.post517
litex_python   = $(LITEX_VENV)/bin/python

LITEX_SIM  := $B/litex-sim
litex_core := shadow+reflect1+lights1+rect

.PHONY: litex litex-setup litex-sim
litex-setup: ## installs LiteX, VexRiscv into build/venv/litex (PyPI), what it links with (apt)
	@sh sim/setup.sh binutils-riscv64-unknown-elf libevent-dev libjson-c-dev
	$(Q)python3 -m venv $(LITEX_VENV)
	$(Q)$(litex_python) -m pip install -q $(LITEX_PACKAGES)

litex: ## a LiteX system of a ULX3S with rt_top: generated and linted, if `make litex-setup` ran
	$(Q)if [ -x $(litex_python) ]; then LITEX=$(litex_python) sh synth/litex.sh $B/litex; \
	    else echo "litex: nothing is made, it is absent: make litex-setup"; fi

litex-sim: $(LITEX_SIM)/frame.sph ## VexRiscv draws by rt_top in LiteX's simulator; 2 minutes
	$(Q)$(TOOL) render $< --frame $(LITEX_SIM)/frame.golden >$(LITEX_SIM)/golden.log
	$(Q)if [ -x $(litex_python) ] && command -v riscv64-unknown-elf-ld >$(LITEX_SIM)/ld; then \
	    LITEX=$(litex_python) sh synth/litex_sim.sh $(LITEX_SIM) $(litex_core); \
	    else echo "litex-sim: nothing is run, LiteX or the linker is absent: make litex-setup"; fi

$(LITEX_SIM)/frame.sph: scenes/paper5.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< --profile draft --size 32x20 --depth 1 --interpenetrate off \
	    --background rect -o $@ >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }
