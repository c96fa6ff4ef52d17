#!/bin/sh
# test_view_live.sh - `sphaera view` by scripts: its window shows what `sphaera render` draws
# SPDX-License-Identifier: Apache-2.0
#
# The first window is one of Xvfb if that is installed; the others are SDL's that nobody sees, which
# cost less. Without SDL2 what needs no window is checked alone.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
page=docs/reference/tool.md
has() { grep -qF -- "$1" "$2"; } # text, file
said() { check "... and says so" has "$1" "$TMP/err"; }

# ---- without a window ----
"$s" view --keys >"$TMP/keys"
check "the page has the list of keys" \
    sh -c "sed -n '/^| key |/,/^\$/p' $page | sed '/^\$/d' | diff -u - '$TMP/keys'"
mkdir "$TMP/bin"
cp "$s" "$(dirname "$s")/sphaera_image.so" "$TMP/bin"
fails 1 "a tool that has no window" "$TMP/bin/sphaera" view scenes/paper5.nff
said "make view-setup"
printf 'wait 1\nkey F12\n' >"$TMP/bad.txt"
fails 1 "a script with a wrong key" "$s" view scenes/paper5.nff --script "$TMP/bad.txt"
said "bad.txt:2: \`F12\` is wrong"
fails 2 "--samples" "$s" view scenes/paper5.nff --samples 2
"$s" build scenes/paper5.nff -o "$TMP/m.sph" >"$TMP/text" 2>&1
fails 1 "a machine" "$s" view "$TMP/m.sph"
said "a scene is needed"

if [ ! -f "$(dirname "$s")/sphaera_view.so" ]; then
    echo "ok $((checks += 1)) - the window # SKIP SDL2 is not installed: make view-setup"
    done_testing
    exit 0
fi

# ---- with one ----
live() { SDL_VIDEODRIVER=dummy "$s" view "$@"; }
real=live
if command -v Xvfb >"$TMP/out" && command -v xauth >"$TMP/out"; then
    on_xvfb() { xvfb-run -a -s "-screen 0 640x480x24" "$s" view "$@"; }
    real=on_xvfb
fi
echo "# the first window: $real"
same() { # name, screenshot, options of render
    name=$1 shot=$2
    shift 2
    "$s" render "$@" -o "$TMP/expected.png" >"$TMP/text" 2>&1
    check "$name" "$s" compare "$TMP/expected.png" "$shot"
}
size="--size 96x54"
standard="$size --profile standard"

# Layers; a camera that moved by every way; a pixel's rays.
cat >"$TMP/move.txt" <<END
wait refined
screenshot $TMP/L2.png
key 1
screenshot $TMP/L0.png
key 4
screenshot $TMP/depths.png
key 9
wait refined
screenshot $TMP/difference.png
key 2
press left
move 20 10 100
release left
wheel 2
finger 0.02 -0.03
pinch 0.1
key a
key up
key =
press right
move 25 12
release right
wait refined
screenshot $TMP/moved.png
scene $TMP/moved.nff
key 3
key v
click 48 27
screenshot $TMP/rays.png
key c
wait refined
screenshot $TMP/clear.png
report
END
# shellcheck disable=SC2086  # options on purpose
check "a script" $real scenes/sphereflake2.nff $standard --script "$TMP/move.txt" \
    --record "$TMP/v.png"
cp "$TMP/out" "$TMP/live"
# shellcheck disable=SC2086
{
    same "L2" "$TMP/L2.png" scenes/sphereflake2.nff $standard
    same "Rendering" "$TMP/L0.png" scenes/sphereflake2.nff $standard --layer 0
    same "depth colours" "$TMP/depths.png" scenes/sphereflake2.nff $standard --depths
    "$s" accuracy scenes/sphereflake2.nff $standard -d "$TMP/strip.png" >"$TMP/text" 2>&1
    oiiotool "$TMP/strip.png" --cut 96x54+192+0 -o "$TMP/strip.png" >"$TMP/text" 2>&1
    check "difference" "$s" compare "$TMP/strip.png" "$TMP/difference.png"
    same "L1 of the camera that moved" "$TMP/moved.png" "$TMP/moved.nff" $standard --layer 1
    same "L2 of it, without its rays" "$TMP/clear.png" "$TMP/moved.nff" $standard
    check "the camera did move" sh -c "! cmp -s '$TMP/moved.nff' scenes/sphereflake2.nff &&
        ! cmp -s '$TMP/clear.png' '$TMP/L2.png'"
    check "rays are drawn over it" sh -c "! cmp -s '$TMP/rays.png' '$TMP/clear.png'"
    "$s" build "$TMP/moved.nff" $standard -o "$TMP/moved.sph" >"$TMP/text" 2>&1
    "$s" info "$TMP/moved.sph" --pixel 48,27 | sed -n '/^rays/,$p' >"$TMP/rays"
    sed -n '/^rays/,/^answers/p' "$TMP/live" | sed '/^answers/d' >"$TMP/printed"
    check "and printed as info does" diff -u "$TMP/rays" "$TMP/printed"
    check "key v prints the camera of the scene that is written" \
        sh -c "grep -c '^from\|^at\|^up\|^angle' '$TMP/live' | grep -qx 4"
}
check "each input is answered" grep -qE '^answers +[0-9]{2} to inputs, mean' "$TMP/live"
last=$(find "$TMP" -name 'v-0*.png' | sort | tail -1)
check "the record ends with what was seen last" "$s" compare "$TMP/clear.png" "$last"
check "and tells its names" has "record   $TMP/v-0000.png and so on" "$TMP/live"

# Key f: the pointer is the head.
cat >"$TMP/head.txt" <<END
key f
move 90 8
wait refined
screenshot $TMP/head.png
scene $TMP/head.nff
END
# shellcheck disable=SC2086
check "the pointer as the head" live scenes/oblique.nff $standard --script "$TMP/head.txt"
# shellcheck disable=SC2086
same "shows what the eye sees there" "$TMP/head.png" "$TMP/head.nff" $standard
check "... of a picture that is shifted" grep -q '^shift' "$TMP/head.nff"

# Key m: what `sphaera price` says of the frame, in each profile, and of a camera that moved; not
# any more when it is pressed again.
cat >"$TMP/price.txt" <<END
key m
wait refined
key p
wait refined
key 9
wait refined
key right
wait refined
scene $TMP/priced.nff
key m
key left
wait refined
report
END
# shellcheck disable=SC2086
check "frames at rest are measured" live scenes/sphereflake2.nff $standard \
    --script "$TMP/price.txt"
sed -n 's/^price //p' "$TMP/out" >"$TMP/priced"
as_price() { # line, profile, scene
    "$s" price "$3" $size --profile "$2" --effects all --pixels 8192 --json - |
        python3 -c "import json, sys
row = json.load(sys.stdin)['price']['rows'][0]
psnr, cycles = row['measured']['psnr'], row['cycles_per_pixel']
print(f\"   {row['name']}: {psnr:.2f} dB, {row['measured']['wrong']} wrong, {cycles:.2f} cycles \"
      f\"a pixel, most for {row['limit']['unit']}\")" >"$TMP/row"
    sed -n "$1p" "$TMP/priced" | diff -u "$TMP/row" -
}
check "... as by price" as_price 1 standard scenes/sphereflake2.nff
check "... in the next profile" as_price 2 fine scenes/sphereflake2.nff
check "... of a camera that moved" as_price 3 fine "$TMP/priced.nff"
check "... three times" test "$(wc -l <"$TMP/priced")" = 3

# Settings, switched while it runs.
cat >"$TMP/set.txt" <<END
key t
key b
key b
key b
key n
key p
key p
wait refined
screenshot $TMP/set.png
key 5
screenshot $TMP/visits.png
key 3
key t
key t
wait refined
screenshot $TMP/bih.png
key 5
screenshot $TMP/visits_bih.png
key 3
key 0
wait refined
screenshot $TMP/home.png
END
# shellcheck disable=SC2086
check "settings" live scenes/refraction/nested.nff $standard --script "$TMP/set.txt"
# shellcheck disable=SC2086
{
    set -- scenes/refraction/nested.nff $size --profile reference --depth 3
    same "the picture of them" "$TMP/set.png" "$@" --tree paper --background exact
    same "with a BIH" "$TMP/bih.png" "$@" --accel bih --background exact
    same "from home" "$TMP/home.png" "$@" --accel bih --background exact
    printf 'key 5\nwait refined\nscreenshot %s/asked.png\n' "$TMP" >"$TMP/asked.txt"
    live "$@" --tree paper --background exact --script "$TMP/asked.txt" >"$TMP/text" 2>&1
    check "visits of a tree that was switched to" "$s" compare "$TMP/asked.png" "$TMP/visits.png"
    live "$@" --accel bih --background exact --script "$TMP/asked.txt" >"$TMP/text" 2>&1
    check "and of a BIH" "$s" compare "$TMP/asked.png" "$TMP/visits_bih.png"
    check "which are others" sh -c "! cmp -s '$TMP/visits.png' '$TMP/visits_bih.png'"
}

# What cannot be drawn is told; what was seen stays.
cat >"$TMP/refuse.txt" <<END
wait refined
key t
wait refined
key t
wait refined
key t
wait refined
screenshot $TMP/refused.png
END
# shellcheck disable=SC2086
{
    set -- scenes/paper5.nff $standard --traverse first
    live "$@" --script "$TMP/refuse.txt" 2>"$TMP/err"
    said "four spheres, this is bih"
    same "the tree before is back" "$TMP/refused.png" "$@" --tree balanced
}
printf 'wait refined\nscreenshot %s/no/where.png\n' "$TMP" >"$TMP/nowhere.txt"
# shellcheck disable=SC2086
fails 1 "a screenshot into no folder" live scenes/paper5.nff $size --script "$TMP/nowhere.txt"
if command -v ffmpeg >"$TMP/out"; then
    printf 'wait refined\nkey w\nwait 100\n' >"$TMP/film.txt"
    # shellcheck disable=SC2086
    check "a video" live scenes/paper5.nff $size --script "$TMP/film.txt" --record "$TMP/film.mp4"
    check "is one" sh -c "ffprobe '$TMP/film.mp4' 2>&1 | grep -q 'Video: h264.*96x54'"
else
    echo "ok $((checks += 1)) - a video # SKIP ffmpeg is not installed: make view-setup"
fi
done_testing
