#!/bin/sh
# test_price.sh - the table of `sphaera price`: against `accuracy`, the RTL's clocks, other sources
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
has() { grep -q -- "$1" "$2"; }
priced() { # scene and options: $TMP/p.json and the table in $TMP/p
    "$s" price "$@" --json "$TMP/p.json" >"$TMP/p" 2>"$TMP/err" || { cat "$TMP/err" && return 1; }
    cat "$TMP/p"
}
asked() { # Python: a condition of the price p and its rows r
    python3 -c "import json, sys
p = json.load(open('$TMP/p.json'))['price']
r = {row['name']: row for row in p['rows']}
sys.exit(not ($1))"
}

# ---- every figure is that of the command that tells of one profile ----
as_accuracy() { # scene, size
    priced "$1" --size "$2" --effects all || return 1
    for profile in draft standard fine reference; do
        "$s" accuracy "$1" --size "$2" --profile $profile --json "$TMP/a.json" >"$TMP/a" \
            2>"$TMP/err" || continue
        python3 - "$TMP" $profile <<'END' || return 1
import json, sys
a = json.load(open(sys.argv[1] + "/a.json"))
of, build = a["accuracy"], a["build"]
row = next(r for r in json.load(open(sys.argv[1] + "/p.json"))["price"]["rows"]
           if r["name"] == sys.argv[2])
m = row["measured"]
wrong = [(x, y) for x, y in ((m["psnr"], of["psnr"][-1]), (m["psnr_least"], of["psnr"][-1]),
                             (m["wrong"], of["silhouette"] + of["wrong_id"]),
                             *((m[n], of[n]) for n in ("pixels", "undecidable", "shadow",
                                                       "reflected", "refracted"))) if x != y]
print(sys.argv[2], wrong)
sys.exit(bool(wrong))
END
    done
}
for scene in paper5 huge_tiny facets/room refraction/nested texture/hall; do
    check "$scene is measured as accuracy does" as_accuracy scenes/$scene.nff 96x54
done

# ---- marks ----
marked() { # what stands behind the star, scene and options
    want=$1
    shift
    priced "$@" >"$TMP/text" || return 1
    cat "$TMP/text"
    has "^\* $want  *[0-9]" "$TMP/p" && [ "$(grep -c '^\* .* cheapest' "$TMP/p")" = 1 ]
}
check "the cheapest that keeps it" marked standard scenes/paper5.nff
check "measured, not expected: 40.9 dB are" marked standard scenes/sphereflake2.nff
check "less is asked for" marked draft scenes/paper5.nff --error 9,30
check "more is" marked fine scenes/huge_tiny.nff
nothing_does() {
    priced scenes/sphereflake2.nff --error 0.001,90 && ! has '^\*' "$TMP/p" &&
        has "^none keeps 0.001 pixels and 90 dB; .* comes nearest" "$TMP/p" &&
        asked "p['best'] is None and not any(row['keeps'] for row in p['rows'])"
}
check "none does: figures, and what would" nothing_does
would() { # what it says would do does
    error=$(sed -n 's/.*--error \([0-9.e,-]*\) would do.*/\1/p' "$TMP/p")
    priced scenes/sphereflake2.nff --error "$error" && asked "p['best'] is not None"
}
check "... and that does" would
refused() {
    priced scenes/huge_tiny.nff && has "^  draft .*huge_tiny.nff:62: radius .* is nothing" \
        "$TMP/p" && asked "r['draft']['why'] and 'measured' not in r['draft'] and p['best'] == 2"
}
check "a profile that holds it not is a row that says why" refused
one_row() {
    priced scenes/paper5.nff --profile standard:pq=13 && asked "list(r) == ['standard:pq=13']"
}
check "widths of one's own are the only row" one_row

# ---- cells, clock, milliseconds: of that very core, or estimated ----
known() {
    draft=$(python3 -c "from lab.pages import data
print(data.cell('accuracy.kinds; spheres sphereflake:3 draft; LUT4eq'))")
    priced scenes/sphereflake2.nff --size 100x50 --effects all &&
        asked "r['standard']['clock']['seeds'] == 5
        and r['standard']['clock']['median'] == 127.5 and r['draft']['cells']['lut4eq'] == $draft
        and abs(r['standard']['milliseconds'] - r['standard']['cycles_per_pixel'] * 5000 / 127500)
        < 1e-9 and not r['standard']['cells']['estimated']" && ! has '~[0-9.]* .*~' "$TMP/p"
}
check "a core that was routed" known
estimated() {
    priced scenes/sphereflake2.nff --size 100x50 --depth 1 --effects all &&
        asked "all(row['cells']['estimated'] and row['clock']['estimated'] for row in p['rows'])" &&
        has '^~:  *estimated: ' "$TMP/p" && has ' ~16846 .* ~127.5 ' "$TMP/p"
}
check "another depth is another core" estimated
unknown() {
    priced scenes/paper5.nff --profile standard:pq=13 --size 100x50 &&
        asked "not any(row['cells'] or row['clock'] or row['milliseconds'] for row in p['rows'])" &&
        has '^cells -: nobody' "$TMP/p" && has '^clock -: nobody' "$TMP/p"
}
check "other widths are another core" unknown
# ---- energy: the sum of its parts; of what is in no fit nothing ----
energies() {
    priced scenes/sphereflake2.nff --size 100x50 &&
        asked "all(abs(sum(row['energy']['parts'].values()) - row['energy']['nj_pixel']) < 1e-9
        for row in p['rows'] if row['energy']) and
        r['standard']['energy']['parts']['idle clock'] > 0 and
        r['draft']['energy']['nj_pixel'] < r['standard']['energy']['nj_pixel']
        < r['reference']['energy']['nj_pixel']" && has '^energy: as standard cells' "$TMP/p"
}
check "energy rises with width, and is the sum of its parts" energies
none_of() { # scene
    priced "$1" --size 32x18 && asked "not any(row.get('energy') for row in p['rows'])" &&
        has '^energy: not known of such a core' "$TMP/p"
}
check "... of smooth triangles none" none_of scenes/effects/effects.nff:smooth
# ---- the core of `make sim` ----
own() { # scene: the core of each row is that which build asks for
    priced "$1" --size 64x36 && for profile in draft standard fine reference; do
        "$s" build "$1" --size 64x36 --profile $profile -o "$TMP/own.sph" >"$TMP/text" 2>&1 &&
            core=$("$s" info "$TMP/own.sph" | sed -n 's/^core *//p') &&
            asked "r['$profile']['core'] == '$core'" || return 1
    done
}
for scene in light_below behind clear_behind; do
    check "$scene: cores are those of make sim" own tests/scenes/met.nff:$scene
done
python3 -m lab known "$TMP/known.h"
check "cells and clocks are those of docs/results/data" cmp cmodel/trial/known_table.h \
    "$TMP/known.h"

# ---- single knobs ----
knobs() {
    priced scenes/paper5.nff --more --size 96x54 && asked "
        r['standard, 2 pipes']['pipes'] == 2
        and r['standard, 2 pipes']['cycles_per_pixel'] < r['standard']['cycles_per_pixel']
        and all(row['keeps'] for row in p['rows'][4:])
        and 'standard, BIH' in p['tried'] and 'standard, BIH' not in r"
}
check "those that pay have rows" knobs

# ---- a sample ----
sampled() {
    priced scenes/paper100.nff --size 640x360 && cp "$TMP/p.json" "$TMP/whole.json" &&
        priced scenes/paper100.nff --size 640x360 --pixels 20000 && asked "p['sampled']" &&
        python3 - "$TMP" <<'END'
import json, sys
whole, some = (json.load(open(f"{sys.argv[1]}/{name}.json"))["price"]["rows"]
               for name in ("whole", "p"))
wrong = 0
for all_of, part in zip(whole, some):
    a, m = all_of["measured"], part["measured"]
    off = part["cycles_per_pixel"] / all_of["cycles_per_pixel"] - 1
    print(part["name"], a["psnr"], m["psnr_least"], a["wrong"] / a["pixels"], m["wrong_most"], off)
    wrong |= not (m["pixels"] <= 20000 and a["psnr"] >= m["psnr_least"] and abs(off) < 0.05
                  and a["wrong"] / (a["pixels"] - a["undecidable"]) <= m["wrong_most"])
sys.exit(wrong)
END
}
check "its bounds hold for the frame" sampled

# ---- clocks, against those that the RTL had ----
check "clocks of the frames of cycles.tsv" python3 -m lab cycles-check "$s"

# ---- wrong usage ----
says() { # words, arguments
    want=$1
    shift
    "$s" price "$@" >"$TMP/text" 2>&1 && return 1
    cat "$TMP/text"
    has "$want" "$TMP/text"
}
check "no number" says "'x' is no number" scenes/paper5.nff --pixels x
check "no scene" says "nosuch.nff: cannot open" nosuch.nff
"$s" build scenes/paper5.nff --size 8x8 -o "$TMP/m.sph" >"$TMP/text"
check "a machine file" says "a scene is needed" "$TMP/m.sph"
done_testing
