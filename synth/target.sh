# target.sh - what Yosys is told of a family; sourced
# SPDX-License-Identifier: Apache-2.0
#
# Of $target, $top and $flat (empty: the hierarchy stays): $map maps what was read, $defines is what
# the sources are read with (rtl/memory/rt_memory.vh), $targets names all families.
# Yosys 0.23 has no multipliers of gowin and efinix, and breaks off over those of ice40 (ICE40_DSP):
# there products are of LUTs.
targets='ecp5 xc7 gowin ice40 nexus gatemate efinix generic'
keep=
[ -n "$flat" ] || keep=-noflatten
defines=
case $target in ice40 | gatemate | efinix) defines='-DRT_NO_LUT_RAM -DRT_FALLING_BITS=1024' ;; esac
case $target in
ecp5) # -nowidelut: a 5-input function then takes as many LUT4 as it needs, not always two
    map="synth_ecp5 -nowidelut $keep -top $top"
    ;;
xc7) map="synth_xilinx -family xc7 -noiopad -noclkbuf ${flat:+-flatten} -top $top" ;;
gowin) map="synth_gowin -noiopads $keep -top $top" ;;
ice40) map="synth_ice40 $keep -top $top" ;;
nexus) map="synth_nexus -noiopad $keep -top $top" ;;
gatemate) map="synth_gatemate -noiopad -noclkbuf $keep -top $top" ;;
efinix) map="synth_efinix $keep -top $top" ;;
generic) # simple gates; memories and multipliers stay what they are
    map="proc; ${flat:+flatten;} opt_expr; opt_clean; opt -nodffe -nosdff; fsm; opt; wreduce;
        peepopt; opt_clean; share; opt; memory -nomap; opt_clean; opt -fast -full;
        techmap t:* t:\$mul %d t:\$mem_v2 %d; opt -fast; abc -g simple; opt_clean"
    ;;
*)
    echo "synth: no target '$target'; there are $targets" >&2
    exit 2
    ;;
esac
