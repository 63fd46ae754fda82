#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs every test, on a machine that needs nothing but Debian and compilers. Arguments are passed
# to meson test; BUILD names another build directory.
set -u
tests=$(cd "$(dirname "$0")" && pwd)
build=${BUILD:-$tests/../build}
log=$build/meson-logs/testlog.json

rm -f "$log"
sh "$tests/setup.sh" "$build" tests || { echo '0 passed, 1 failed'; exit 1; }
meson test -C "$build" --print-errorlogs "$@"
status=$?
python3 "$tests/count.py" "$log" || exit 1
exit $status
