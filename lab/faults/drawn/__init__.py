# __init__.py - the mutation campaign of the RTL: `make campaign`
# SPDX-License-Identifier: Apache-2.0
