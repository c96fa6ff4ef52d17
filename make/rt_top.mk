# rt_top.mk - builds a harness of rt_top for one set of parameters; make/top.mk calls it
# SPDX-License-Identifier: Apache-2.0
#
#   build/sim/BENCH-NAME/BENCH      tb_shell has the golden model as its core
B       ?= build
# another source folder, with a name for what is built of it
RTL     ?= rtl
NAME    ?= $(PROFILE)-$(CORE)-$(DATA)$(if $(filter 1,$(LAYERS)),-layers)$(of_trees)
PROFILE ?= draft
CORE    ?= all
# bits of the scene's data; of frame store and display too, up to 128
DATA    ?= 64
LAYERS  ?= 0
# spheres that it builds trees of, 0: it builds none
TREES   ?= 0
of_trees = $(if $(TREES:0=),-trees$(TREES))
# bits of an address: more with one of the widths
ADDR    ?= $(if $(filter 128,$(DATA)),40,32)
BENCH   ?= tb_top

include make/verilated.mk

K    := $S/$(BENCH)-$(NAME)
MODEL := $B/libsphaera.a
RTL_FILES := $(shell find $(RTL) -name '*.v' -o -name '*.vh')
RTL_DIRS  := $(sort $(dir $(RTL_FILES)))
FRAME_DATA := $(if $(filter 256,$(DATA)),128,$(DATA))
PARAMETERS := $(shell sim/cores.py profile '$(PROFILE)') \
              $(shell sim/cores.py parameters '$(CORE)') \
              DATA=$(FRAME_DATA) MEM_DATA=$(DATA) VIDEO=1 LAYERS=$(LAYERS) BUILD=$(TREES) \
              ADDR=$(ADDR)
VERILATE := $(VERILATOR) --cc --language 1364-2005 -O3 --x-assign unique --x-initial unique \
                --top-module rt_top --prefix Vrt_top $(PARAMETERS:%=-G%) \
                $(RTL_DIRS:%=-y %) $(RTL_DIRS:%=-I%)
VERILATE += +1800-2017ext+sv -Iformal -Itb/top tb/top/rt_top_rules.sv \
            $(if $(filter tb_shell,$(BENCH)),+define+TOP_VIEW $K/rt_core.sv,-Wall) \
            $(filter %/rt_top.v %/cells.v,$(RTL_FILES))
DRIVER   := $S/obj/driver.o
VERILATED := $S/obj/bench_verilated.o $S/obj/bench_verilated_threads.o

.PHONY: top run
top: $K/$(BENCH)
run: top
	@$K/$(BENCH) $(MACHINES) $(SEED)

$K/flags: FORCE
	$(call stamp,$(VERILATE),verilator $(HOST))

# Its head is rt_core's.
$K/rt_core.sv: rtl/core/rt_core.v tb/top/golden_core.svh
	@mkdir -p $K
	sed '/^);/q' $< | cat - tb/top/golden_core.svh >$@

$K/all.cpp: $(RTL_FILES) $(wildcard formal/axi_rules.vh tb/*/*_rules.sv) $K/flags \
		$(if $(filter tb_shell,$(BENCH)),$K/rt_core.sv)
	@rm -f $K/Vrt_top*
	$(VERILATE) --Mdir $K
	@sh sim/at_once.sh $K tb/top/$(BENCH).cpp >$@

$K/top.o: $K/all.cpp $(PRECOMPILED)
	$(COMPILE) $(PARAMETERS:%=-DTOP_%) -DDATA=$(FRAME_DATA) -DADDR=$(ADDR) -isystem $K -MD -MP -c \
		$< -o $@

# As for a board: no library, no warnings.
$(DRIVER): $(wildcard driver/*)
	@mkdir -p $(@D)
	gcc -std=c99 -ffreestanding -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -O2 \
	    -c driver/sphaera.c -o $@

$K/$(BENCH): $K/top.o $(DRIVER) $(VERILATED) $(MODEL)
	g++ $^ -lm -lpthread -o $@

-include $K/top.d
