# top.mk - rt_top: what is checked of it by packages that are not needed elsewhere
# SPDX-License-Identifier: Apache-2.0

BUS_VENV := $B/venv/bus
BUS_PACKAGES := systemrdl-compiler==1.33.0 cocotb==2.1.0 cocotbext-axi==0.1.28 \
                cffi==2.1.1 numpy==2.4.6 hatchling==1.33.0   # of the package sphaera
bus_python = $(BUS_VENV)/bin/python

# The harness of rt_top: two machines, each width of the buses.
TOP_CORE   := shadow+reflect2+lights2+inside+camera+rect+spans
TOP_SCENES := paper5 interpenetrating
TOP_RUNS   := $(TOP_SCENES:%=$B/top/%.sph)
top_tool    = flock $B/sim/.tools.lock env -u MAKEFLAGS -u MFLAGS $(MAKE) -s --no-print-directory \
                  -f make/rt_top.mk B=$B DATA=$(1) CORE=$(TOP_CORE) MACHINES='$(TOP_RUNS)' \
                  SEED=$(SEED)

# One frame of 1280x720 to decoded video, on a core that has what the scene asks for.
HD       := $B/top/hd.sph
hd_core   = $$($(TOOL) info $(HD) | sed -n 's/^core *//p')

.PHONY: top top-shell top-hd bus-setup rdl cocotb vip
top: $(TOP_RUNS) ## rt_top under its driver: frames, errors, resets, silent buses; a minute
	@mkdir -p $B/sim
	$(Q)for data in $(TOP_DATA); do \
	    $(call top_tool,$$data) top >$B/top/build.log 2>&1 || { cat $B/top/build.log; exit 1; }; \
	    $(call top_tool,$$data) run || exit 1; done

top-shell: $(TOP_RUNS)
	@echo "CORE=$(TOP_CORE)+cones16 MACHINES='$(TOP_RUNS:$B/%=build/%)'"

$B/top/%.sph: scenes/%.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< --profile draft --size 32x20 --depth 2 --interpenetrate off \
	    --background spans -o $@ >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }

top-hd: $(TOOL) ## a frame of 1280x720 from rt_top to decoded video; minutes of a processor
	@mkdir -p $B/sim $B/top
	$(Q)$(TOOL) build scenes/$(HD_SCENE).nff --profile standard --size 1280x720 --depth 2 -o $(HD) \
	    >$B/top/hd.log
	$(Q)$(call top_tool,64) BENCH=tb_show PROFILE=standard CORE=$(hd_core) top >$B/top/build.log \
	    2>&1 || { cat $B/top/build.log; exit 1; }
	$(Q)$(call top_tool,64) BENCH=tb_show PROFILE=standard CORE=$(hd_core) \
	    MACHINES=$(HD) SEED= run

bus-setup: ## installs what `make rdl`, `cocotb` and `vip` need into build/venv/bus (PyPI)
	$(Q)python3 -m venv $(BUS_VENV)
	$(Q)$(bus_python) -m pip install -q $(BUS_PACKAGES)

rdl: ## reads the register list of rt_top with systemrdl-compiler, if `make bus-setup` ran
	$(Q)if [ -x $(bus_python) ]; then $(bus_python) -m lab rdl docs/reference/rt_top.rdl; \
	    else echo "rdl: not checked, systemrdl-compiler is absent: make bus-setup"; fi

cocotb: $B/top/tiny.sph ## rt_top between masters and slaves of cocotbext-axi in Icarus; 2 minutes
	$(Q)$(TOOL) render $< --frame $B/top/tiny.frame >$B/top/tiny.log
	$(Q)if [ -x $(bus_python) ]; then for data in $(TOP_DATA); do \
	    PATH=$(call absolute,$(BUS_VENV))/bin:$$PATH $(bus_python) -m lab cocotb \
	    $(call absolute,$B)/top/cocotb-$$data $< $B/top/tiny.frame $$data \
	    $$(sim/cores.py profile draft) $$(sim/cores.py parameters $(TOP_CORE)) \
	    >$B/top/cocotb.log 2>&1 || \
	    { cat $B/top/cocotb.log; exit 1; }; tail -n 1 $B/top/cocotb.log; done; \
	    else echo "cocotb: nothing is run, it is absent: make bus-setup"; fi

vip: $(TOOL) library ## the verification IP: its examples, in Verilator and cocotb; 5 minutes
	@ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/core/test_vip.sh

$B/top/tiny.sph: scenes/interpenetrating.nff $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< --profile draft --size 12x8 --depth 1 --interpenetrate off \
	    --background spans -o $@ >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }

include make/netlist.mk

# ---- rt_top in a LiteX system: of a ULX3S, looked through; in LiteX's simulator, drawing ----
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
