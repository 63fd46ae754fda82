#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# readme.sh TESTS ROOT LIBRARY: the program in the README, as printed, compiles without a warning
# and samples.
set -u
. "$1/tap.sh"
root=$2
library=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk '/^```c$/ {on = 1; next} /^```$/ {on = 0} on' "$root/README.md" > "$work/example.c"
check 'the README has an example' test -s "$work/example.c"
check 'it compiles' cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I"$root/include" \
    "$work/example.c" "$library" -lm -Wl,-rpath,"$(dirname "$library")" -o "$work/example"
check 'it samples' sh -c "'$work/example' | grep -q '^direction .* pdf '"
tap_done
