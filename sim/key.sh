#!/bin/sh
# key.sh - the name of a core: every parameter that shapes it, so that builds never mix
# SPDX-License-Identifier: Apache-2.0
#
# usage: [ENGINES=n] [ROOT_STEP=n] [QUOTIENT_STEP=n] sim/key.sh PROFILE LIST [TARGET]
# PROFILE as sim/profile.sh takes it, LIST as sim/parameters.sh; TARGET is a target of synthesis.
# Steps are in the name if they are not the core's own, which is 2.
set -eu
here=$(dirname "$0")
name=$(sh "$here/profile.sh" "$1" name)
sh "$here/parameters.sh" "$2" >/dev/null
key=$name${3:+-$3}-$2-engines${ENGINES:-1}
[ "${ROOT_STEP:-2}" = 2 ] || key=$key-root$ROOT_STEP
[ "${QUOTIENT_STEP:-2}" = 2 ] || key=$key-quotient$QUOTIENT_STEP
echo "$key"
