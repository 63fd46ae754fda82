#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run.sh CLIENT ROOT LIBRARY [KOFFI]: runs the test of a client in another language, or says what of
# that language is missing. KOFFI is the folder with node_modules.
# run.sh missing WHAT: says that.
set -u

skip() {
    echo "1..0 # SKIP no $1"
    exit 0
}

[ "$1" = missing ] && skip "$2"
client=$1
here=$2/tests/clients
library=$3

has() {
    command -v "$1" > /dev/null
}

case $client in
    python)
        export PYTHONDONTWRITEBYTECODE=1
        # The first python3 may be one without Debian's modules.
        for python in python3 /usr/bin/python3; do
            has $python && $python -c 'import numpy' 2> /dev/null &&
                exec $python "$here/python/test.py" "$library"
        done
        skip 'python3 with numpy'
        ;;
    lua)
        has luajit || skip luajit
        exec luajit "$here/lua/test.lua" "$library" "$2/include/psc/psc.h"
        ;;
    rust)
        has rustc || skip rustc
        place=$(mktemp -d)
        trap 'rm -rf "$place"' EXIT
        rustc --edition 2021 -O -D warnings -L "native=${library%/*}" \
            -C "link-arg=-Wl,-rpath,${library%/*}" -o "$place/test" "$here/rust/test.rs" || exit
        "$place/test"
        ;;
    javascript)
        has node || skip node
        export NODE_PATH=$4/node_modules
        node -e "require('koffi')" 2> /dev/null || skip "koffi for node (npm installs it)"
        exec node "$here/javascript/test.js" "$library"
        ;;
esac
