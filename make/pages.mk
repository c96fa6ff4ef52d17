# pages.mk - tables and figures of the pages, from the sources
# SPDX-License-Identifier: Apache-2.0
#
# A page has regions, `<!-- begin: NAME -->` to `<!-- end -->`, that lab/pages/regions.py makes.
# `make test ONLY=test_pages` fails when one is older than what it tells of. A table that an
# experiment measured says of which commit it is; that sources have changed since is no fault.

.PHONY: pages pages-age
pages-age: ## of each measured table: commit, day, how many commits changed sources since
	$(Q)python3 -m lab age

pages: ## tables and figures of README and docs; synthesises cores whose RTL changed, 90 s each
	$(Q)BUILD=$B python3 -m lab cores
	$(Q)python3 -m lab pages
