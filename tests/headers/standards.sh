#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# standards.sh TESTS INCLUDE: the public header compiles alone in every C and C++ since C89 and
# C++98, without a warning.
set -u
. "$1/tap.sh"
include=$2

alone() {
    echo '#include <psc/psc.h>' | "$1" -x "$2" "-std=$3" -I "$include" -fsyntax-only \
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
        check "$1 -std=$standard" alone "$1" "$2" "$standard"
    done
done
tap_done
