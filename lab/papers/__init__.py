# __init__.py - the papers, claim by claim
# SPDX-License-Identifier: Apache-2.0
