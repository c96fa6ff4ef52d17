# campaign.mk - `make campaign`: thousands of faults that Yosys puts into the RTL
# SPDX-License-Identifier: Apache-2.0
#
#   make campaign                  what is not run yet, and the tables of docs/results/mutants.md
#   make campaign FAULTS=10000     more of them, SEED=2 others
#   make campaign ENGINE=slurm     on a cluster: docs/guide/cluster.md
#   make campaign-c MINUTES=60     the same in the C model
# A fault meets its module's bench, then what is left another line of that bench's list, then a
# bench above, then the core: each is one list of jobs, and a job is one program with all faults
# that are tried in it (lab/mutants).
campaign_lists := 0 1 2 3
campaign_one = python3 -m lab.mutants plan $B $(FAULTS) $(SEED) $(1) $B/mutants/list$(1) && \
    $(call jobs_run,$B/mutants/list$(1))

campaign: $(LIB) $(TOOL) $B/test/libhard.a ## faults by Yosys in every module, and what notices them
	@mkdir -p $B/mutants
	@sh tb/run_bench.sh --tools && sh sim/core.sh --help >$B/mutants/harness.log
	$(Q)$(foreach n,$(campaign_lists),$(call campaign_one,$n) &&) true
	@python3 -m lab.mutants tell $B $(FAULTS) $(SEED)

# Faults in the arithmetic of the golden model, as many as are begun within MINUTES.
campaign_model = builder core fast machine math pixel prim reference shade texture trace
campaign_suite = $(patsubst %.c,$B/test/%.o, \
    $(notdir $(wildcard $(campaign_model:%=tests/%/test_*.c))))
campaign-c: $(campaign_suite:.o=.sanitized.o) $B/asan/libsphaera.a
campaign-c: $(LIB) $(campaign_suite) $B/test/hard ## faults in the model, and what notices them
	@JOBS=$(JOBS) python3 -m lab.mutants.model $B $(FAULTS) $(SEED) $(MINUTES) $(CC) $(CFLAGS)

# Branches and bits that the benches of small modules meet.
coverage: $(LIB) $B/test/libhard.a ## branches and bits of small modules that their benches meet
	@sh tb/run_bench.sh --tools
	$(Q)python3 -m lab.coverage $B

.PHONY: campaign campaign-c coverage
