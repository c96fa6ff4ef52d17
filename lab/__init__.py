# __init__.py - the project's Python: `python3 -m lab`, from the root of the tree
# SPDX-License-Identifier: Apache-2.0
