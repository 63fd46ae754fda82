#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# readme.sh TESTS ROOT LIBRARY: the programs in the README and in the guide, as printed, compile
# without a warning and run.
set -u
. "$1/tap.sh"
root=$2
library=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# blocks FILE LANGUAGE: the blocks of a language, one after the other.
blocks() {
    awk -v begin="^\`\`\`$2\$" '$0 ~ begin {on = 1; next} /^```$/ {on = 0} on' "$root/$1"
}

# program NAME FILE LANGUAGE COMPILER...
program() {
    name=$1 file=$2 language=$3
    shift 3
    blocks "$file" "$language" > "$work/$name.$language"
    check "$name: there is one" test -s "$work/$name.$language"
    check "$name: it compiles" "$@" -Wall -Wextra -Wpedantic -Werror -I"$root/include" \
        "$work/$name.$language" "$library" -lm -Wl,-rpath,"$(dirname "$library")" -o "$work/$name"
}

program readme README.md c cc -std=c99
check 'readme: it samples' sh -c "'$work/readme' | grep -q '^direction .* pdf '"
program guide include/psc/guide.md c cc -std=c11
check 'guide: it runs' "$work/guide"
program guide_cpp include/psc/guide.md cpp c++ -std=c++17
check 'guide_cpp: it runs' "$work/guide_cpp"
others() {
    ! sed -n 's/^```//p' "$root/README.md" "$root/include/psc/guide.md" | grep -vE '^(c|cpp|)$'
}
check 'no blocks of other languages' others
tap_done
