# board_sim.mk - builds the harness of a board's top; make/board.mk calls it
# SPDX-License-Identifier: Apache-2.0
#
#   build/sim/tb_TOP/tb_TOP; the ROMs of the board are read when it runs. MODULE is what a bench
#   sees; SETS are parameters of it
B      ?= build
TOP    ?= ulx3s_ram
MODULE ?= rt_$(TOP)

include make/verilated.mk

K    := $S/tb_$(TOP)
MODEL := $B/libsphaera.a
RTL_FILES := $(shell find rtl tb/board -name '*.v' -o -name '*.vh')
RTL_DIRS  := $(sort $(dir $(RTL_FILES)))
VERILATE := $(VERILATOR) --cc --language 1364-2005 -Wall -O3 --x-assign unique --x-initial unique \
                --top-module $(MODULE) --prefix V$(MODULE) $(SETS:%=-G%) $(BOARD_ROMS) \
                $(RTL_DIRS:%=-y %) $(RTL_DIRS:%=-I%) $(filter %/$(MODULE).v,$(RTL_FILES))
DRIVER := $S/obj/board_driver.o $S/obj/board_tool.o
VERILATED := $S/obj/bench_verilated.o $S/obj/bench_verilated_threads.o

.PHONY: top
top: $K/tb_$(TOP)

$K/flags: FORCE
	$(call stamp,$(VERILATE),verilator $(HOST))

$K/all.cpp: $(RTL_FILES) $K/flags
	@rm -f $K/V$(MODULE)*
	$(VERILATE) --Mdir $K
	@sh sim/at_once.sh $K tb/board/tb_$(TOP).cpp >$@

$K/top.o: $K/all.cpp $(PRECOMPILED)
	$(COMPILE) $(SETS:%=-D%) -isystem $K -Itb/board -MD -MP -c $< -o $@

$S/obj/board_driver.o: $(wildcard driver/*)
	@mkdir -p $(@D)
	gcc -std=c99 -O2 -c driver/sphaera.c -o $@

$S/obj/board_tool.o: cmodel/tool/board.c cmodel/tool/board.h $(wildcard driver/*)
	@mkdir -p $(@D)
	gcc -std=c11 -D_GNU_SOURCE -O2 -Icmodel -c $< -o $@

$K/tb_$(TOP): $K/top.o $(DRIVER) $(VERILATED) $(MODEL)
	g++ $^ -lm -lpthread -o $@

-include $K/top.d
