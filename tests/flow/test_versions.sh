#!/bin/sh
# test_versions.sh - what a tool made counts as long as the tool is the same version
# SPDX-License-Identifier: Apache-2.0
#
# A stub stands before each tool in PATH: it says a version, notes every other call, and fails.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
mkdir "$TMP/bin" "$TMP/b"
PATH=$TMP/bin:$PATH

stub() { # tool, version
    cat >"$TMP/bin/$1" <<END
#!/bin/sh
case \$1 in
-V | --version) echo "$1 $2" ;;
*) echo called >>"$TMP/calls" && exit 1 ;;
esac
END
    chmod +x "$TMP/bin/$1"
}
calls() { # command: how often it calls a stub
    : >"$TMP/calls"
    "$@" >"$TMP/said" 2>&1
    wc -l <"$TMP/calls"
}
# a result of the tool, made by version 1, is made again by no other call than that of version 2
renews() { # tool, result, command
    tool=$1 result=$2
    shift 2
    stub "$tool" 1
    [ "$(calls "$@")" -gt 0 ] || { echo "$tool is not called"; cat "$TMP/said"; return 1; }
    mkdir -p "${result%/*}" && touch "$result"
    [ "$(calls "$@")" -eq 0 ] || { echo "$tool is called again"; return 1; }
    stub "$tool" 2
    [ "$(calls "$@")" -gt 0 ] || { echo "$tool of another version is not called"; return 1; }
}
key=$(sim/cores.py key draft none generic)
check "make synth: another Yosys" renews yosys "$TMP/b/synth/$key/stat.json" \
    make -f make/area.mk results B="$TMP/b" PROFILES=draft EFFECTS=none TARGETS=generic

check "make sim: another Icarus" renews iverilog "$TMP/b/sim/none/tb_core.vvp" \
    make -f make/core.mk icarus B="$TMP/b" PROFILE=draft CORE=none KEY=none

stored() { # tool, version: the digest of what depends on it
    stub "$1" "$2"
    python3 -c "from lab.jobs import store; print(store.digest(['tool:$1']))"
}
check "results of experiments: another Yosys" \
    test "$(stored yosys 1)" != "$(stored yosys 2)"
check "... the same one" test "$(stored yosys 1)" = "$(stored yosys 1)"
check "sim/version.sh: a tool that is not there" \
    test "$(sh sim/version.sh env ccache -O2 no_such_tool)" = "no_such_tool: none"
done_testing
