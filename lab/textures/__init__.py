# __init__.py - the experiments of the texture paper; images and scenes for them
# SPDX-License-Identifier: Apache-2.0
