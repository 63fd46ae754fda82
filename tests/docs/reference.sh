#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# reference.sh TESTS ROOT: doxygen renders the headers and the guide without a warning.
set -u
. "$1/tap.sh"
root=$2
command -v doxygen > /dev/null || { echo '1..0 # SKIP no doxygen'; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$root" || exit 1

render() {
    (cat tests/docs/Doxyfile; echo "OUTPUT_DIRECTORY=$work") | doxygen -
}

# Every function has a place of its own on the page of the header.
complete() {
    for name in $(sed -nE 's/^PSC_API [^(]*[ *](psc_[a-z0-9_]+)\(.*/\1/p' include/psc/psc.h); do
        grep -q "\"memname\">.* $name </td>" "$work/html/psc_8h.html" || echo "$name"
    done > "$work/missing"
    [ -s "$work/html/psc_8hpp.html" ] && ! grep . "$work/missing"
}

check 'no warnings' render
check 'every function is there' complete
tap_done
