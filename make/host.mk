# host.mk - random lives of cores under a host, each frame compared
# SPDX-License-Identifier: Apache-2.0

.PHONY: host
host: $(TOOL) ## TRIALS of what a host may do to a core, SEED; ten minutes of a processor
	$(Q)BUILD=$B SPHAERA=$(TOOL) SEED=$(SEED) TRIALS=$(TRIALS) sh sim/host.sh $(ONLY)
