# __init__.py - a BIH on the scenes of its thesis
# SPDX-License-Identifier: Apache-2.0
