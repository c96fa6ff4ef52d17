# __init__.py - checks of rt_top by packages of others
# SPDX-License-Identifier: Apache-2.0
