#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# setup.sh BUILD WHAT: installs what is missing from Debian's packages (with sudo, unless root), then
# configures the build directory: for WHAT = render, the library and the renderer; for tests,
# everything.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build=$1
what=$2

missing=
need() {
    command -v "$1" > /dev/null || missing="$missing $2"
}
need cc gcc
need python3 python3
need meson meson
need ninja ninja-build
need pkg-config pkg-config
pkg-config --exists cairo 2> /dev/null || missing="$missing libcairo2-dev"
options=-Drender=enabled

if [ "$what" = tests ]; then
    need c++ g++
    need cmake cmake
    need git git
    need readelf binutils
    need abidw abigail-tools
    need doxygen doxygen
    # Clients. Node.js is used where it is: Debian's npm would bring 500 packages.
    need luajit luajit
    need rustc rustc
    /usr/bin/python3 -c 'import numpy' 2> /dev/null || missing="$missing python3-numpy"
    [ -f /usr/include/embree3/rtcore.h ] || missing="$missing libembree-dev"
    options="$options -Dabi=enabled"
fi

if [ -n "$missing" ]; then
    echo "installing$missing"
    sudo=
    [ "$(id -u)" = 0 ] || sudo=sudo
    $sudo apt-get -qq update
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 install \
        --no-install-recommends $missing > /dev/null
fi

if [ -f "$build/build.ninja" ]; then
    meson configure "$build" $options
else
    meson setup "$build" "$root" $options
fi

# What the JavaScript client needs and Debian lacks. Without it, its test is skipped by name.
if [ "$what" = tests ] && command -v npm > /dev/null &&
    [ ! -d "$build/javascript/node_modules/koffi" ]; then
    mkdir -p "$build/javascript"
    cp "$root"/tests/clients/javascript/package*.json "$build/javascript"
    npm ci --prefix "$build/javascript" --ignore-scripts --no-audit --no-fund --silent ||
        echo 'npm did not install koffi: the JavaScript client is not tested'
fi
