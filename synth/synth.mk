# synth.mk - areas with Yosys
# SPDX-License-Identifier: Apache-2.0

synth: ## area of every module with Yosys
	@echo "synth: no synthesis targets yet" >&2; exit 1
