# __init__.py - generators: what follows from definitions and from the files of rtl
# SPDX-License-Identifier: Apache-2.0
