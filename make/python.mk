# python.mk - what `import sphaera` needs; `pip install .` is pyproject.toml
# SPDX-License-Identifier: Apache-2.0

.PHONY: notebook-setup
notebook-setup: ## installs what examples/python/sweep.ipynb needs (apt)
	@sh sim/setup.sh sim/packages_notebook.txt
