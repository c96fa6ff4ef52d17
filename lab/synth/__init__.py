# __init__.py - synthesised cores: tables, budgets
# SPDX-License-Identifier: Apache-2.0
