# __init__.py - what accuracy costs in time and cells
# SPDX-License-Identifier: Apache-2.0
