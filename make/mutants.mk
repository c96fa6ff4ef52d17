# mutants.mk - faults: those of tests/faults, planted one by one, and those that are drawn
# SPDX-License-Identifier: Apache-2.0
#
#   python3 -m lab faults run NAME    one fault of tests/faults; --help
#   make campaign                  what is not run yet, and the tables of verification.md
#   make campaign FAULTS=10000     more of them, SEED=2 others
#   make campaign ENGINE=slurm     on a cluster: docs/guide/simulation.md
#   make campaign-c MINUTES=60     the same in the C model
#   make designed MUTANT=trace     those of tests/faults/designed whose name or file has the word

.PHONY: mutants hard-rtl common-mode twins campaign campaign-c designed coverage
planted = @ALL=1 BUILD=$B JOBS=$(JOBS) sh tests/run.sh tests/faults/test_$(1).sh
mutants: suites ## faults put into the RTL and what notices them: all of tests/faults
	$(call planted,mutants)
hard-rtl: suites ## faults in the RTL that the named cases notice: all of the list
	$(call planted,hard_rtl)
# its name until 1.0.0
twins: common-mode
common-mode: suites ## faults planted in model and RTL alike, and what notices them: all
	$(call planted,common_mode)

NAIVE := $B/test/naive-frame
$(NAIVE): $B/test/obj/tests/reference/naive_frame.o $(MODEL)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(MODEL_LIBS))
tests/reference/test_hashes_naive.sh: | $(NAIVE)
# what these and test_hard.sh ask lab.faults to make is there then
tests/faults/test_mutants.sh tests/faults/test_hard_rtl.sh: | $B/test/libhard.a
tests/faults/test_common_mode.sh: | $(NAIVE) $B/test/hard
tests/hard/test_hard.sh: | $B/test/test_limits.o

# A drawn fault meets its module's bench, then what is left another line of that bench's list, then
# a bench above, then the core: each is one list of jobs, and a job is one program with all faults
# that are tried in it (lab/faults/drawn).
campaign_lists := 0 1 2 3
campaign_one = python3 -m lab mutants plan $B $(FAULTS) $(SEED) $(1) $B/mutants/list$(1) && \
    $(call jobs_run,$B/mutants/list$(1))

campaign: $(TOOL) $B/test/libhard.a ## faults by Yosys in every module, and what notices them
	@mkdir -p $B/mutants
	@BENCH_BUILD=$B python3 -m lab benches --tools && sh sim/core.sh --help >$B/mutants/harness.log
	$(Q)$(foreach n,$(campaign_lists),$(call campaign_one,$n) &&) true
	@python3 -m lab mutants tell $B $(FAULTS) $(SEED)

# Faults in the arithmetic of the golden model, as many as are begun within MINUTES.
campaign_model = builder core fast machine math pixel prim reference shade texture trace
campaign_suite = $(patsubst %.c,$B/test/%.o, \
    $(notdir $(wildcard $(campaign_model:%=tests/%/test_*.c))))
campaign-c: $(campaign_suite:.o=.sanitized.o) $B/asan/libsphaera.a
campaign-c: $(MODEL) $(campaign_suite) $B/test/hard ## faults in the model, and what notices them
	@JOBS=$(JOBS) python3 -m lab mutants-c $B $(FAULTS) $(SEED) $(MINUTES) -- $(CC) $(CFLAGS)

designed: $(TOOL) $(MODEL) $B/test/libhard.a ## faults as designers make them, and who notices them
	@BENCH_BUILD=$B python3 -m lab benches --tools && sh sim/core.sh --help >$B/core-help.log
	$(Q)python3 -m lab designed --others $B $(MUTANT)
	$(Q)$(if $(MUTANT),true,python3 -m lab designed --told $B)

# What benches and frames meet of every module; a run that was ended goes on.
coverage: $(TOOL) $B/test/libhard.a ## lines, branches and bits of the RTL that checks meet, merged
	@BENCH_BUILD=$B python3 -m lab benches --tools && sh sim/core.sh --help >$B/core-help.log
	$(Q)python3 -m lab coverage $B
