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
sed "s|^prefix=|prefix=$place|" "$pc" > "$place/libpsc.pc"
warnings='-Wall -Wextra -pedantic -Werror'
export LD_LIBRARY_PATH="$library"

# What goes where, below the library's directory and the prefix.
layout() {
    find "$place$prefix" -type f -o -type l | sed "s|^$library/|LIB/|; s|^$place$prefix/||" |
        LC_ALL=C sort > "$place/installed"
    diff - "$place/installed" <<END
LIB/libpsc.a
LIB/libpsc.so
LIB/libpsc.so.0
LIB/libpsc.so.0.${version#*.}
LIB/pkgconfig/libpsc.pc
include/psc/psc.h
include/psc/psc.hpp
share/doc/libpsc/LICENSE
share/doc/libpsc/NEWS
share/doc/libpsc/README.md
share/doc/libpsc/guide.md
END
}
prefix=$(PKG_CONFIG_PATH=${pc%/*} pkg-config --variable=prefix libpsc)
version=$(PKG_CONFIG_PATH=$place pkg-config --modversion libpsc)

flags() {
    PKG_CONFIG_PATH=$place pkg-config "$@" libpsc
}

# shared COMPILER SOURCE
shared() {
    $1 $warnings "$link/$2" -o "$place/program" $(flags --cflags --libs) &&
        readelf -d "$place/program" | grep -q 'libpsc\.so\.0' &&
        "$place/program"
}

static() {
    $1 $warnings "$link/$2" -o "$place/program" -static $(flags --static --cflags --libs) &&
        "$place/program"
}

plugin() {
    cc $warnings -std=c11 "$link/plugin.c" -o "$place/plugin" $(flags --cflags) -ldl &&
        ! readelf -d "$place/plugin" | grep 'libpsc' &&
        "$place/plugin" libpsc.so.0
}

uninstalled() {
    cc $warnings "$link/program.c" -o "$place/program" \
        $(PKG_CONFIG_PATH=$build/meson-uninstalled pkg-config --cflags --libs libpsc) &&
        LD_LIBRARY_PATH=$build/src "$place/program"
}

# A program that was linked with a later release, which has more names.
too_old() {
    mkdir -p "$place/later" &&
        echo 'int psc_later(void); int psc_later(void) { return 0; }' > "$place/later.c" &&
        echo 'PSC_99.0 { global: psc_later; };' > "$place/later.map" &&
        echo 'int psc_later(void); int main(void) { return psc_later(); }' > "$place/main.c" &&
        cc -shared -fPIC "$place/later.c" -o "$place/later/libpsc.so" \
            -Wl,-soname,libpsc.so.0,--version-script="$place/later.map" &&
        cc "$place/main.c" -o "$place/program" -L"$place/later" -lpsc || return 1
    ! "$place/program" 2> "$place/message" && cat "$place/message" &&
        grep -q 'PSC_99\.0.*not found' "$place/message"
}

# cmake_project STATIC
cmake_project() {
    rm -rf "$place/cmake"
    PKG_CONFIG_PATH=$place cmake -G Ninja -S "$link" -B "$place/cmake" -DSTATIC="$1" &&
        cmake --build "$place/cmake" || return 1
    for language in c cxx; do
        readelf -d "$place/cmake/program_$language" > "$place/needs"
        case $1 in
            OFF) grep -q 'libpsc\.so\.0' "$place/needs" ;;
            ON) ! grep 'libpsc' "$place/needs" ;;
        esac && "$place/cmake/program_$language" || return 1
    done
}

check 'layout' layout
check 'C program, shared library' shared cc program.c
check 'C program, static library' static cc program.c
for compiler in g++ clang++; do
    command -v $compiler > /dev/null || { skip "no $compiler"; continue; }
    for standard in c++98 c++11 c++17 c++20; do
        check "C++ program, $compiler -std=$standard" \
            shared "$compiler -x c++ -std=$standard" program.c
    done
    check "psc.hpp, $compiler, shared library" shared "$compiler -std=c++17" program.cpp
    check "psc.hpp, $compiler, static library" static "$compiler -std=c++17" program.cpp
done
check 'program that loads the library at run time' plugin
check 'program built against the build directory' uninstalled
check 'program built with a later library is told so' too_old
if command -v cmake > /dev/null; then
    check 'CMake project, shared library' cmake_project OFF
    check 'CMake project, static library' cmake_project ON
else
    skip 'no cmake'
fi
tap_done
