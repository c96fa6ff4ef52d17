# __init__.py - the scenes that the texture paper names, which their authors give away
# SPDX-License-Identifier: Apache-2.0
