# __init__.py - the model against a renderer of somebody else's
# SPDX-License-Identifier: Apache-2.0
