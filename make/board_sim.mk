# board_sim.mk - builds the harness of a board's top; make/board.mk calls it
# SPDX-License-Identifier: Apache-2.0
#
#   build/sim/tb_TOP/tb_TOP; the ROMs of the board are read when it runs
B   ?= build
TOP ?= ulx3s_ram

include make/verilated.mk

K    := $S/tb_$(TOP)
LIB  := $B/libsphaera.a
RTL_FILES := $(shell find rtl tb/board -name '*.v' -o -name '*.vh')
RTL_DIRS  := $(sort $(dir $(RTL_FILES)))
VERILATE := verilator --cc --language 1364-2005 -Wall -O3 --x-assign unique --x-initial unique \
                --top-module rt_$(TOP) --prefix Vrt_$(TOP) $(BOARD_ROMS) \
                $(RTL_DIRS:%=-y %) $(RTL_DIRS:%=-I%) rtl/board/rt_$(TOP).v
VERILATED := $S/obj/bench_verilated.o $S/obj/bench_verilated_threads.o

.PHONY: top
top: $K/tb_$(TOP)

$K/flags: FORCE
	$(call stamp,$(VERILATE))

$K/all.cpp: $(RTL_FILES) $K/flags
	@rm -f $K/Vrt_*
	$(VERILATE) --Mdir $K
	@sh sim/at_once.sh $K tb/board/tb_$(TOP).cpp >$@

$K/top.o: $K/all.cpp $(PRECOMPILED)
	$(COMPILE) -isystem $K -Itb/board -MMD -MP -c $< -o $@

$K/tb_$(TOP): $K/top.o $(VERILATED) $(LIB)
	g++ -fopenmp $^ -lm -lpthread -o $@

-include $K/top.d
