# lab.mk - experiments, one row of lab/table.py each, and pages: what `python3 -m lab` runs
# SPDX-License-Identifier: Apache-2.0
#
# Results lie in $B/NAME; one that is younger than what it is made of is kept.

EXPERIMENTS := $(shell sed -n '/^EXPERIMENTS/,/^.]/s/^    ."\([a-z-]*\)".*/\1/p' lab/table.py)

.PHONY: $(EXPERIMENTS) pages pages-age papers-setup truth-setup specks
$(EXPERIMENTS): $(TOOL)
	$(Q)$(call values,JOBS V ENGINE BART KINDS RESULTS ROUTE SEEDS \
	    SEEDS_CORE) python3 -m lab $@ --build $B

pages-age: ## of each measured table: commit, day, how many commits changed sources since
	$(Q)python3 -m lab age

pages: ## tables and figures of README and docs; synthesises cores whose RTL changed, 90 s each
	$(Q)BUILD=$B python3 -m lab cores
	$(Q)python3 -m lab pages

truth-setup: ## installs POV-Ray (apt), which `make truth` needs
	@sh sim/setup.sh povray

papers-setup: ## installs Valgrind (apt), with which `make papers` counts the model's instructions
	@sh sim/setup.sh valgrind

.PHONY: matrix matrix-setup
matrix: ## sets up, simulates, installs, tests in roots of other releases: verification.md; an hour
	$(Q)python3 -m lab matrix $B/matrix docs/results/verification.md

matrix-setup: ## installs debootstrap (apt), which `make matrix` needs
	@sh sim/setup.sh debootstrap

# falsely dark pixels: build/test/shadow_acne SCENE.nff PROFILE --show tells each, with its ray
ACNE_C := $(sort $(wildcard tests/shadow_acne/*.c))
$B/test/shadow_acne: $(ACNE_C:%.c=$B/test/obj/%.o) $(MODEL)
	$(call say,LD,$(@F))
	$(call make_whole,$(CC) $^ $(MODEL_LIBS))

-include $(ACNE_C:%.c=$B/test/obj/%.d)
shadow-acne tests/shadow_acne/test_shadow_acne.sh: | $B/test/shadow_acne

# its name until 1.0.0
specks: shadow-acne

# ---- jobs of a list; ENGINE=slurm tried on a Slurm of this machine: docs/guide/simulation.md ----
# + before it: the commands share the JOBS of this make
jobs_run = python3 -m lab jobs $(ENGINE) $(1)

.PHONY: slurm-setup slurm-test
slurm-setup: ## installs Slurm (apt), which `make slurm-test` needs
	@sh sim/setup.sh slurm-wlm munge

slurm-test: $(TOOL) ## jobs on a Slurm of two nodes here: one is killed, results damaged; 2 minutes
	@BUILD=$B sh tests/run.sh tests/jobs/slurm_real.sh
