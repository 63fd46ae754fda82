#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# dist.sh TESTS ROOT MESON: the tarball that meson dist makes holds the whole tree, builds and
# installs.
set -u
. "$1/tap.sh"
root=$2
meson=$3
git -C "$root" rev-parse 2> /dev/null || { echo '1..0 # SKIP not a git checkout'; exit 0; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
# Without optimisation, which is quicker to compile.
export CFLAGS=-O0

dist() {
    "$meson" setup "$place/build" "$root" -Dtests=false &&
        "$meson" dist -C "$place/build" --no-tests --allow-dirty --formats gztar &&
        tar -xzf "$place"/build/meson-dist/libpsc-*.tar.gz -C "$place"
}

whole() {
    git -C "$root" ls-tree -r --name-only HEAD | LC_ALL=C sort > "$place/tracked"
    (cd "$place"/libpsc-* && find . -type f | sed 's|^\./||' | LC_ALL=C sort) > "$place/packed"
    diff "$place/tracked" "$place/packed"
}

works() {
    "$meson" setup "$place/again" "$place"/libpsc-* --prefix=/usr -Dtests=false &&
        "$meson" install -C "$place/again" --destdir "$place/installed" &&
        cc "$1/link/program.c" -o "$place/program" \
            $(PKG_CONFIG_PATH=$place/again/meson-uninstalled pkg-config --cflags --libs libpsc) &&
        LD_LIBRARY_PATH=$place/again/src "$place/program"
}

check 'meson dist' dist
check 'the tarball holds the whole tree' whole
check 'it builds, installs and works' works "$1"
tap_done
