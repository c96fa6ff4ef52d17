# __init__.py - what each scene calls for, and what its own core saves
# SPDX-License-Identifier: Apache-2.0
