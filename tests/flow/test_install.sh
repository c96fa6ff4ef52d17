#!/bin/sh
# test_install.sh - an installed copy: examples in C and C++, pages, completion, uninstall
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD version=$(cat VERSION)
make_it() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s --no-print-directory B="$BUILD" \
    PREFIX=/usr DESTDIR="$TMP/a b" "$@"; }
check "make install" make_it install
cp -r "$TMP/a b/usr" "$TMP/usr" # a prefix may be moved: pkg-config is told
usr=$TMP/usr
export PKG_CONFIG_PATH="$usr/lib/pkgconfig" LD_LIBRARY_PATH="$usr/lib"
flags() { pkg-config --define-variable=prefix="$usr" "$@" sphaera; }
has() { grep -qE -- "$1" "$2"; } # pattern, file

# ---- what is there, and what is exported ----
check "pkg-config knows version $version" [ "$(flags --modversion)" = "$version" ]
check "CHANGELOG begins with it" [ "$(sed -n 's/^## //p' CHANGELOG.md | head -n 1)" = "$version" ]
check "the tool has it too" [ "$("$usr/bin/sphaera" --version)" = "sphaera $version" ]
declared() {
    sed -n 's/^SPHAERA_API .*[ *]\(sphaera_[a-z_]*\)(.*/\1/p' "$usr/include/sphaera/sphaera.h" |
        sort
}
declared >"$TMP/declared"
check "the header declares functions" has '^sphaera_render$' "$TMP/declared"
major=${version%%.*}
check "its names have version SPHAERA_$major" sh -c "nm -D '$usr/lib/libsphaera.so' |
    grep -q ' sphaera_render@@SPHAERA_$major\$'"
# names of OpenImageIO's headers that g++ makes unique in a program stay: its own, and those of fmt
for how in "-D $usr/lib/libsphaera.so" "-g $usr/lib/libsphaera.a"; do
    # shellcheck disable=SC2086  # two words
    check "${how##*/} exports them and nothing else" sh -c "nm ${how%% *} --defined-only \
        '${how#* }' | awk 'NF == 3 && \$2 != \"A\" { print \$3 }' |
        sed 's/@.*//' | grep -v 'OpenImageIO\|3fmt' | sort |
        diff '$TMP/declared' -"
done

# ---- examples, compiled by hand against the copy ----
warn='-Wall -Wextra -Wconversion -Wshadow -Werror -pedantic'
# shellcheck disable=SC2046,SC2086  # words
compile() { # compiler, source, program, more
    "$1" $warn "$root/examples/$2" -o "$TMP/$3" $4 $(flags --cflags --libs)
}
check "C" compile "${CC:-gcc}" c/render.c render -std=c99
check "C, arrays" compile "${CC:-gcc}" c/arrays.c arrays -std=c99
check "C, core" compile "${CC:-gcc}" c/core.c core -std=c99
check "C++, rays" compile "${CXX:-g++}" cpp/rays.cpp batch "-std=c++11 -O1"
check "C++, machine" compile "${CXX:-g++}" cpp/machine.cpp machine "-std=c++11 -O1"
check "C++" compile "${CXX:-g++}" cpp/query.cpp query "-std=c++11 -Wno-sign-conversion -pthread"
# shellcheck disable=SC2046,SC2086  # words
check "C, with the static library" "${CC:-gcc}" examples/c/render.c -o "$TMP/static" \
    $(flags --static --cflags --libs | sed 's/-lsphaera/-l:libsphaera.a/')
cd "$TMP" || exit 1
check "a picture of a scene in memory" sh -c \
    './render two.png >two && grep "^2 spheres, 64x48" two &&
    oiiotool --info two.png | grep "64 x  *48, 3 channel"'
for program in render static; do
    ./$program five.png "$root/scenes/paper5.nff" >five
    "$usr/bin/sphaera" render "$root/scenes/paper5.nff" --profile standard --depth 1 --counters \
        -o tool.png >tool
    check "$program draws what the tool draws" "$usr/bin/sphaera" compare five.png tool.png
    check "... with its hash" [ "$(grep '^frame' five)" = "$(grep '^frame' tool)" ]
done
check "... and its counters" sh -c 'grep -qE "^node_visits +[1-9]" five'
refused() { # message, command: it fails and says so
    message=$1
    shift
    ! "$@" >said 2>&1 && cat said && grep -qE "$message" said
}
check "an error names file and line" refused 'bad.nff:1: ' sh -c \
    'echo "s 1 2 x 4" >bad.nff; ./render bad.png bad.nff'
check "a picture of no kind" refused 'two.xyz: no picture is written as .xyz' ./render two.xyz
check "nothing of them is there" sh -c '! ls bad.png two.xyz'
check "a scene of arrays, watched and cancelled" sh -c './arrays table.nff table.exr >said &&
    cat said && grep -q "^drawing: cancelled" said && grep -q "told often" said &&
    grep -qE "^distance 7\.8[0-9], normal z 0\.9" said'
check "... is the scene of its file" sh -c "'$usr/bin/sphaera' render table.nff --profile standard \
    --accel box4 --samples 2 | sed -n 's/^frame *//p' >hash && [ -s hash ] &&
    grep -q \"^frame   \$(cat hash)\" said"
check "... and a picture of one pixel for four" sh -c 'oiiotool --info table.exr | grep "64 x  *48"'
in_memory() { # what core.c prints is what the tool exports and counts
    ./core "$root/scenes/paper5.nff" >core.txt &&
        "$usr/bin/sphaera" build "$root/scenes/paper5.nff" --effects all -o core.sph &&
        "$usr/bin/sphaera" export --hex core core.sph || return 1
    first=$(grep -v '^//' core.mem.hex | head -n 1)
    has "^memory [0-9]+ lines, the first $(echo "$first" | cut -c1-8)...$(echo "$first" |
        cut -c57-64)\$" core.txt && has '^core shadow.reflect2' core.txt &&
        has '^ray 0 stage root: root ' core.txt || return 1
    "$usr/bin/sphaera" render core.sph --counters >counted
    visits=$(awk '/^node_visits / { print $NF }' counted)
    has "^expect node_visits $visits\$" core.txt
}
check "registers, memory, parameters, counters, stages" in_memory
whole_machine() {
    ./machine >known && cat known && ! has ': NO$' known && [ "$(grep -c ': yes$' known)" = 5 ] &&
        has '^arrays, row 3: left out: sphere that stands there twice' known &&
        has '^core lights1.spans, [0-9]+ parameters' known && has '^rays_primary [1-9]' known &&
        has '^reference keeps' known && has '^error: directions.0. has no length' known
}
check "a machine and all that is known of it, in C++" whole_machine
for accel in bvh4 bih box4 brute; do
    check "a batch of rays, $accel: at least 0.8 of the frame's rate" sh -c "./batch \
        '$root/scenes/paper100.nff' $accel >said && cat said && awk '\$7 < 0.8 { exit 1 }' said"
done
cat >rays.nff <<'END'
v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 64 48
l 4 6 8
f 0.9 0.3 0.2 0.7 0.3 10 0 1
s 0 0 0 1
s 1.2 0 -2 0.25
END
check "rays from nine threads" ./query rays.nff
./query rays.nff >hits
check "... in the middle" has '^4 id 0 distance (2.999|3.000|3.001) z (0.999|1.000|1.001)' hits
check "... beside it the other sphere" has '^7 id 1 distance 5.7[45]' hits
check "... and past both" has '^0 nothing' hits
check "the shared library loads OpenImageIO when asked for what needs it" sh -c \
    "! readelf -d '$usr/lib/libsphaera.so' | grep OpenImageIO"

# ---- the page's own lines, of a home of one's own ----
{
    echo "make() (cd '$root' && env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s B='$BUILD' \"\$@\")"
    echo 'set -e; unset PKG_CONFIG_PATH LD_LIBRARY_PATH'
    sed -n '/^## /q; s/^    //p' "$root/docs/reference/library.md"
} >page.sh
mkdir home
cp "$root/examples/c/render.c" .
check "the page's lines run as they are" env HOME="$TMP/home" sh page.sh
for program in render render-static; do
    check "... $program runs" env -u LD_LIBRARY_PATH "./$program" page.png
    readelf -d "$program" >"$program.needs"
done
check "... the one with the shared library" has 'NEEDED.*libsphaera' render.needs
check "... the other without" sh -c "! grep 'NEEDED.*libsphaera' render-static.needs"

# ---- what the header promises ----
cat >promises.c <<'END'
#include <assert.h>
#include <math.h>
#include <string.h>
#include <sphaera/sphaera.h>
int main(int argc, char **argv) {
    sphaera_error e = {""};
    sphaera_scene *s;
    sphaera_machine *m, *again;
    sphaera_frame *f, *g;
    sphaera_build_options zero = {0}, o;
    sphaera_hit hit;
    const double at[3] = {0, 0, 4}, far[3] = {0, 0, 1e9}, to[3] = {0, 0, -1}, none[3] = {0};
    assert(argc == 2 && sphaera_scene_parse("", 0, "x", 0, &s, &e) == -1 && !s && e.text[0]);
    assert(sphaera_scene_read("nowhere.nff", 0, &s, NULL) == -1 && !s);
    assert(!sphaera_scene_read(argv[1], 0, &s, &e));
    assert(sphaera_build(s, &zero, &m, &e) == -1 && !m && strstr(e.text, "sphaera_build_init"));
    sphaera_build_init(&o);
    o.accel = "tree";
    assert(sphaera_build(s, &o, &m, &e) == -1 && strstr(e.text, "'tree'"));
    o.accel = "bih", o.profile = "standart";
    assert(sphaera_build(s, &o, &m, &e) == -1 && strstr(e.text, "standart"));
    o.profile = "fine", o.depth = 11;
    assert(sphaera_build(s, &o, &m, &e) == -1 && strstr(e.text, "depth is 11"));
    o.depth = 2, o.shadow = 2;
    assert(sphaera_build(s, &o, &m, &e) == -1 && strstr(e.text, "shadow"));
    o.shadow = SPHAERA_AUTO;
    assert(!sphaera_build(s, &o, &m, &e) && !strcmp(sphaera_machine_profile(m), "fine"));
    assert(!sphaera_machine_write(m, "m.sph", &e) && !sphaera_machine_read("m.sph", &again, &e));
    assert(!sphaera_render(m, 1, &f, &e) && !sphaera_render(again, 2, &g, &e));
    assert(sphaera_frame_hash(f) == sphaera_frame_hash(g) && !sphaera_frame_errors(f));
    assert(sphaera_render(m, -1, &g, &e) == -1 && !g);
    assert(sphaera_frame_rgb(f, 3, NULL) == -1 && sphaera_counter_find("x") == -1);
    assert(sphaera_trace(m, far, to, &hit, &e) == -1 && strstr(e.text, "outside the grid"));
    assert(sphaera_trace(m, at, none, &hit, &e) == -1 && hit.id == SPHAERA_NONE);
    assert(!sphaera_trace(m, none, to, &hit, &e) && hit.inside && fabs(hit.distance - 1) < 0.01);
    sphaera_scene_free(NULL), sphaera_machine_free(NULL), sphaera_frame_free(NULL);
    return 0;
}
END
# shellcheck disable=SC2046  # words
check "a client for them" "${CC:-gcc}" promises.c -o promises $(flags --cflags --libs) -lm
check "they are kept" ./promises rays.nff

# ---- CMake ----
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.13)
project(client C CXX)
set(CMAKE_CXX_STANDARD 11)
find_package(sphaera 1.0 REQUIRED COMPONENTS static)
add_executable(by_cmake core.c)
target_link_libraries(by_cmake sphaera::sphaera)
add_executable(cmake_rays rays.cpp)
target_link_libraries(cmake_rays sphaera::sphaera)
add_executable(cmake_static core.c)
target_link_libraries(cmake_static sphaera::static)
END
if command -v cmake >said; then
    mkdir cmake && cp "$root/examples/c/core.c" "$root/examples/cpp/rays.cpp" CMakeLists.txt cmake
    check "find_package(sphaera)" sh -c "cmake -S cmake -B cmake/build -DCMAKE_PREFIX_PATH='$usr' &&
        cmake --build cmake/build"
    for program in by_cmake cmake_static; do
        check "... $program runs" sh -c "env -u LD_LIBRARY_PATH ./cmake/build/$program \
            '$root/scenes/paper5.nff' | diff core.txt -"
    done
    sed 's/sphaera 1.0/sphaera 2/' CMakeLists.txt >cmake/CMakeLists.txt
    check "... but not of another major version" sh -c "! cmake -S cmake -B cmake/other \
        -DCMAKE_PREFIX_PATH='$usr' 2>said && grep -q 'version: 1' said"
else
    echo "ok $((checks += 1)) - # SKIP there is no CMake"
fi

# ---- pages and completion ----
for command in $("$usr/bin/sphaera" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    "$usr/bin/sphaera" "$command" --help | grep -oE '^ {1,6}(-., )?--[a-z-]+' |
        grep -oE -- '--[a-z-]+' | sort -u >options
    page=$usr/share/man/man1/sphaera-$command.1
    check "a page of $command with each of its options" sh -c "[ -s options ] && tr -d '\\\\' \
        <'$page' | grep -oE '^\\.B (-., )?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u |
        diff options -"
done
if command -v groff >said; then
    check "groff takes the longest" sh -c "groff -man -Tascii -ww \
        '$usr/share/man/man1/sphaera-render.1' 2>&1 >/dev/null | tee said; [ ! -s said ]"
fi
cat >complete.bash <<'END'
. "$1"
shift
COMP_WORDS=(sphaera "$@") COMP_CWORD=$#
_sphaera
printf '%s\n' "${COMPREPLY[@]}"
END
completes() { # words, the last to be completed, is completed to: all of the first argument
    wanted=$1
    shift
    bash complete.bash "$usr/share/bash-completion/completions/sphaera" "$@" >said
    cat said
    [ "$(sort said | tr '\n' ' ')" = "$wanted " ]
}
check "bash: a command" completes "reference render" re
check "bash: an option" completes "--profile=" render --prof
check "bash: a file" completes "rays.nff" render rays
if command -v zsh >said; then
    check "zsh takes its file" zsh -n "$usr/share/zsh/site-functions/_sphaera"
else
    echo "ok $((checks += 1)) - # SKIP there is no zsh"
fi
check "zsh: each command is there" [ "$(grep -c "^    [a-z]*) options=('--" \
    "$usr/share/zsh/site-functions/_sphaera")" = "$("$usr/bin/sphaera" --help |
    sed -n '/^Commands:/,/^$/p' | grep -c '^  [a-z]')" ]

# ---- uninstall ----
cd "$root" || exit 1
check "make uninstall" make_it uninstall
check "... leaves nothing" [ -z "$(find "$TMP/a b" ! -type d)" ]
done_testing
