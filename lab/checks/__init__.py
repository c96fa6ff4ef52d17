# __init__.py - tests of this package, run by tests/lab
# SPDX-License-Identifier: Apache-2.0
