# __init__.py - faults: those of tests/faults, planted one by one, and those that are drawn
# SPDX-License-Identifier: Apache-2.0
