#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# subproject.sh TESTS ROOT MESON: the library as a meson subproject of somebody else's C++ project.
set -u
. "$1/tap.sh"
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir "$place/subprojects"
ln -s "$2" "$place/subprojects/libpsc"
cp "$1/link/program.c" "$place/program.cc"
cat > "$place/meson.build" <<'END'
project('host', 'cpp')
test('program', executable('program', 'program.cc',
  dependencies : dependency('libpsc', fallback : ['libpsc', 'psc_dep'])))
END

# Without optimisation, which is quicker to compile.
export CFLAGS=-O0

host() {
    "$3" setup "$place/$1" "$place" -Ddefault_library="$1" && "$3" test -C "$place/$1" &&
        ! find "$place/$1" -name 'abi_frozen*' | grep . &&
        readelf -d "$place/$1/program" > "$place/needs" &&
        case $1 in
            shared) grep -q 'libpsc\.so\.0' "$place/needs" ;;
            static) ! grep 'libpsc' "$place/needs" ;;
        esac
}

check 'host project with a shared library' host shared "$2" "$3"
check 'host project with a static library' host static "$2" "$3"
tap_done
