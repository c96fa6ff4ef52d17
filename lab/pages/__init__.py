# __init__.py - pages whose tables and figures come out of the sources
# SPDX-License-Identifier: Apache-2.0
