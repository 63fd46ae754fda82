#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# objects.sh TESTS SHARED STATIC: what the built libraries define and need.
set -u
. "$1/tap.sh"

# Prints the lines that do not match; fails if there are any, and if there are none at all.
only() {
    [ -s "$2" ] && ! grep -Ev "$1" "$2"
}

list=$(mktemp)
trap 'rm -f "$list"' EXIT
nm -g --defined-only "$3" | awk 'NF == 3 { print $3 }' > "$list"
check 'every global symbol of the static library begins with psc_' only '^psc_' "$list"
readelf -dW "$2" | sed -nE 's/.*\((NEEDED|SONAME)\).*\[(.*)\]/\1 \2/p' > "$list"
check 'the shared library needs libc and libm at most' \
    only '^(NEEDED lib[cm]\.so|SONAME libpsc\.so)' "$list"
tap_done
