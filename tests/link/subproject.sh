#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# subproject.sh TESTS ROOT MESON: the library as a meson subproject of somebody else's project in
# C and C++.
set -u
. "$1/tap.sh"
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir "$place/subprojects"
ln -s "$2" "$place/subprojects/libpsc"
cp "$1/link/program.c" "$1/link/program.cpp" "$place"
cat > "$place/meson.build" <<'END'
project('host', 'c', 'cpp', default_options : 'cpp_std=c++17')
psc = dependency('libpsc', fallback : ['libpsc', 'psc_dep'])
test('c', executable('program_c', 'program.c', dependencies : psc))
test('cpp', executable('program_cpp', 'program.cpp', dependencies : psc))
END

# Without optimisation, which is quicker to compile.
export CFLAGS=-O0

host() {
    "$3" setup "$place/$1" "$place" -Ddefault_library="$1" && "$3" test -C "$place/$1" &&
        ! find "$place/$1" -name 'abi_frozen*' | grep . || return 1
    for language in c cpp; do
        readelf -d "$place/$1/program_$language" > "$place/needs" &&
            case $1 in
                shared) grep -q 'libpsc\.so\.0' "$place/needs" ;;
                static) ! grep 'libpsc' "$place/needs" ;;
            esac || return 1
    done
}

check 'host project with a shared library' host shared "$2" "$3"
check 'host project with a static library' host static "$2" "$3"
tap_done
