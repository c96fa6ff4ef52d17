# __init__.py - scenes in which everything moves: build, upload and draw, frame by frame
# SPDX-License-Identifier: Apache-2.0
