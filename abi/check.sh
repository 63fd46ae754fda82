#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The layers of the ABI guard that look at a built library; README.md says how they are used.
#   check.sh dump LIBRARY HEADERS DUMP       writes the interface down
#   check.sh symbols LIBRARY RECORDED        refuses any difference in soname, names, nodes
#   check.sh current RECORDED DUMP           refuses any difference from the recorded interface
#   check.sh compat DIRECTORY DUMP           refuses what breaks programs built against a release
#   check.sh update LIBRARY DUMP SYMBOLS RECORDED   records both
set -eu
export LC_ALL=C

list() {
    readelf -dW "$1" | sed -n 's/.*(SONAME).*\[\(.*\)\]/soname \1/p'
    readelf --dyn-syms -W "$1" | awk '
        $5 ~ /GLOBAL|WEAK|UNIQUE/ && $7 ~ /^[0-9]/ { sub(/@+/, " ", $8); print $8 }' | sort
}

# Every exported function must be there with its type: an empty comparison finds no difference.
dump() {
    abidw --headers-dir "$2" --drop-private-types --exported-interfaces-only --no-show-locs \
        --no-comp-dir-path --no-corpus-path --no-elf-needed --no-parameter-names \
        --type-id-style hash --out-file "$3.raw" "$1"
    sed "/<abi-instr/ { s/ path='.*\/\([^']*\)'/ path='\1'/; s/ language='[^']*'//; }" \
        "$3.raw" > "$3"
    rm "$3.raw"
    names=$(list "$1" | grep -cv '^soname')
    typed=$(grep -c '<function-decl .*elf-symbol-id=' "$3")
    [ "$names" -gt 0 ] && [ "$names" = "$typed" ] || {
        echo "of $names exported names $typed have a type in $3" >&2
        rm "$3"
        exit 1
    }
}

# Dump against dump: against a library, or with header options, abidiff misses changes.
compare() {
    abidiff --no-default-suppression --no-architecture "$@"
}

# What was accepted for a release stands beside its dump, word for word as reported. Bit 4 of the
# status says that something changed, any other bit that nobody can accept it.
compat() {
    result=77
    for release in "$1"/libpsc-*.abi; do
        [ -e "$release" ] || continue
        [ $result = 1 ] || result=0
        code=0
        report=$(compare --no-added-syms "$release" "$2") || code=$?
        accepted=${release%.abi}.accepted
        if [ $code = 0 ] || { [ $code = 4 ] && [ -e "$accepted" ] &&
                              [ "$report" = "$(cat "$accepted")" ]; }; then
            continue
        fi
        printf 'breaks programs built against %s:\n%s\n' "${release##*/}" "$report"
        result=1
    done
    return $result
}

command=$1
shift
case $command in
    dump) dump "$1" "$2" "$3" ;;
    symbols) list "$1" | diff -u "$2" - ;;
    current) compare --harmless "$1" "$2" ;;
    compat) compat "$1" "$2" ;;
    update) list "$1" > "$3" && cp "$2" "$4" ;;
    *) echo "check.sh: unknown command $command" >&2 && exit 2 ;;
esac
