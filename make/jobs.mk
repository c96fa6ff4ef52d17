# jobs.mk - jobs of a list; ENGINE=slurm tried on a Slurm of this machine: docs/guide/simulation.md
# SPDX-License-Identifier: Apache-2.0

# + before it: the commands share the JOBS of this make
jobs_run = python3 -m lab jobs $(ENGINE) $(1)

.PHONY: slurm-setup slurm-test
slurm-setup: ## installs Slurm (apt), which `make slurm-test` needs
	@sh sim/setup.sh slurm-wlm munge

slurm-test: $(TOOL) ## jobs on a Slurm of two nodes here: one is killed, results damaged; 2 minutes
	@BUILD=$B sh tests/run.sh tests/jobs/slurm_real.sh
