# __init__.py - many independent jobs: their results, and engines that run them
# SPDX-License-Identifier: Apache-2.0
