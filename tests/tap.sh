# SPDX-License-Identifier: Apache-2.0
# Prints test results in TAP from a shell script: check NAME COMMAND... for each, then tap_done.
tap_count=0
tap_failures=0

check() {
    tap_name=$1
    shift
    tap_count=$((tap_count + 1))
    if tap_output=$("$@" 2>&1); then
        echo "ok $tap_count - $tap_name"
    else
        tap_failures=$((tap_failures + 1))
        echo "not ok $tap_count - $tap_name"
        echo "$tap_output" | sed 's/^/# /'
    fi
}

skip() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count # SKIP $1"
}

tap_done() {
    echo "1..$tap_count"
    [ $tap_failures = 0 ]
    exit
}
