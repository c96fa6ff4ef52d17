# expected.awk - what was expected of a profile against what was measured, a line a run
# SPDX-License-Identifier: Apache-2.0
#
# Reads what `sphaera accuracy` prints, of many runs one after another, each behind a line
# "run SCENE PROFILE". Prints a row each; ends with 1 if one was worse than expected: its dB are
# less, or more pixels see another thing. Edges that move hit pixels by chance: these may be more by
# three times the root of their number and three. Where a plane goes on
# beyond the grid few pixels are far off, and a sample of them is known: half a dB.
function row(most, bad) {
    if (scene == "") return
    if (psnr == "") {
        printf "| %s | %s | does not fit |\n", scene, profile
        return
    }
    most = wrong + 3 * sqrt(wrong) + 3
    bad = seen > most || (psnr != "inf" && psnr + cut / 2 < expected + 0)
    printf "| %s | %s | %s | %s | %d | %.1f | %s |%s\n", scene, profile, psnr, expected, seen,
           wrong, off, bad ? " worse than expected" : ""
    failed += bad
    rows++
}
$1 == "run" {
    row()
    scene = $2
    profile = $3
    cut = 0
    psnr = ""
}
/the plane goes on beyond the grid/ { cut = 1 }
$1 == "psnr" { psnr = $2 }
$1 == "wrong" { seen = $3 + $6 }
$1 == "expected" {
    expected = $2
    wrong = $4
    off = $(NF - 2)
}
END {
    row()
    exit failed || !rows
}
