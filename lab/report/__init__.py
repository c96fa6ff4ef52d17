# __init__.py - a run of `make sim` as a page, a row of a table; all scenes as one page
# SPDX-License-Identifier: Apache-2.0
