#!/bin/sh
# key.sh - the name of a core: every parameter that shapes it, so that builds never mix
# SPDX-License-Identifier: Apache-2.0
#
# usage: [ENGINES=n] [PIPES=n] [LEAF_UNITS=n] [SHADES=n] [ROOT_STEP=n] [QUOTIENT_STEP=n] \
#            [SIZES=list] sim/key.sh PROFILE LIST [TARGET]
# PROFILE as sim/profile.sh takes it, LIST as sim/parameters.sh, SIZES as sim/sizes.sh; TARGET is a
# target of synthesis.
# A core whose parameters do not go together has no name: sim/legal.sh says why, exit code 1.
# Sizes, units of an engine and steps are in the name if they are not the core's own: 1 pipe, units
# by its rule (0), steps of 2.
set -eu
here=$(dirname "$0")
name=$(sh "$here/profile.sh" "$1" name)
# shellcheck disable=SC2046  # words
sh "$here/legal.sh" $(sh "$here/profile.sh" "$1") $(sh "$here/parameters.sh" "$2") \
    ENGINES="${ENGINES:-1}" PIPES="${PIPES:-1}" LEAF_UNITS="${LEAF_UNITS:-0}" \
    SHADES="${SHADES:-0}" ROOT_STEP="${ROOT_STEP:-2}" QUOTIENT_STEP="${QUOTIENT_STEP:-2}" \
    $(sh "$here/sizes.sh" "${SIZES:-}")
key=$name${3:+-$3}-$2-engines${ENGINES:-1}
[ "${PIPES:-1}" = 1 ] || key=$key-pipes$PIPES
[ "${LEAF_UNITS:-0}" = 0 ] || key=$key-leaf_units$LEAF_UNITS
[ "${SHADES:-0}" = 0 ] || key=$key-shades$SHADES
[ "${ROOT_STEP:-2}" = 2 ] || key=$key-root$ROOT_STEP
[ "${QUOTIENT_STEP:-2}" = 2 ] || key=$key-quotient$QUOTIENT_STEP
sizes=$(sh "$here/sizes.sh" "${SIZES:-}" name)
echo "$key${sizes:+-$sizes}"
