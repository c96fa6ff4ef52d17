# __init__.py - what ships with rt_top as an IP block: make ip
# SPDX-License-Identifier: Apache-2.0
