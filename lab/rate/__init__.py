# __init__.py - what pipes gain, and frames a second of a board
# SPDX-License-Identifier: Apache-2.0
