#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# install.sh TESTS BUILD MESON: installs into a temporary place, then builds and runs programs there
# as their authors would. Also against the build directory, without installing.
set -u
. "$1/tap.sh"
link=$1/link
build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

check 'install' "$3" install -C "$build" --no-rebuild --quiet --destdir "$place"
pc=$(find "$place" -name libpsc.pc)
[ -f "$pc" ] || { echo "Bail out! libpsc.pc is not installed"; exit 1; }
library=$(dirname "$(dirname "$pc")")
warnings='-Wall -Wextra -pedantic -Werror'

flags() {
    PKG_CONFIG_PATH=${pc%/*} pkg-config --define-variable=prefix="$place$prefix" "$@" libpsc
}
prefix=$(PKG_CONFIG_PATH=${pc%/*} pkg-config --variable=prefix libpsc)

shared() {
    $1 $warnings "$link/program.c" -o "$place/program" $(flags --cflags --libs) &&
        readelf -d "$place/program" | grep -q 'libpsc\.so\.0' &&
        LD_LIBRARY_PATH=$library "$place/program"
}

static() {
    cc $warnings "$link/program.c" -o "$place/program" -static $(flags --static --cflags --libs) &&
        "$place/program"
}

plugin() {
    cc $warnings -std=c11 "$link/plugin.c" -o "$place/plugin" $(flags --cflags) -ldl &&
        ! readelf -d "$place/plugin" | grep 'libpsc' &&
        LD_LIBRARY_PATH=$library "$place/plugin" libpsc.so.0
}

uninstalled() {
    cc $warnings "$link/program.c" -o "$place/program" \
        $(PKG_CONFIG_PATH=$build/meson-uninstalled pkg-config --cflags --libs libpsc) &&
        LD_LIBRARY_PATH=$build/src "$place/program"
}

check 'C program, shared library' shared cc
for standard in c++98 c++11 c++17 c++20; do
    check "C++ program, $standard" shared "c++ -x c++ -std=$standard"
done
check 'static program' static
check 'program that loads the library at run time' plugin
check 'program built against the build directory' uninstalled
tap_done
