#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# standards.sh TESTS INCLUDE: the public headers compile alone, without a warning: psc.h in every C
# and C++ since C89 and C++98, psc.hpp since C++17.
set -u
. "$1/tap.sh"
include=$2

alone() {
    echo "#include <psc/$4>" | "$1" -x "$2" "-std=$3" -I "$include" -fsyntax-only \
        -pedantic -Wall -Wextra -Wshadow -Wconversion -Wundef -Werror -
}

for row in 'gcc c' 'clang c' 'g++ c++' 'clang++ c++'; do
    set -- $row
    command -v "$1" > /dev/null || { skip "no $1"; continue; }
    case $2 in
        c) standards='c89 c99 c11 c17' ;;
        c++) standards='c++98 c++11 c++14 c++17 c++20' ;;
    esac
    for standard in $standards; do
        check "psc.h, $1 -std=$standard" alone "$1" "$2" "$standard" psc.h
    done
    [ "$2" = c++ ] || continue
    for standard in c++17 c++20; do
        check "psc.hpp, $1 -std=$standard" alone "$1" "$2" "$standard" psc.hpp
    done
done
tap_done
