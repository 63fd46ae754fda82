#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# setup.sh BUILD: installs what is missing from Debian's packages (with sudo, unless root), then
# configures the build directory for everything: library, tests, ABI guard, renderer.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build=$1

missing=
need() {
    command -v "$1" > /dev/null || missing="$missing $2"
}
need cc gcc
need c++ g++
need python3 python3
need meson meson
need ninja ninja-build
need pkg-config pkg-config
need readelf binutils
need cmake cmake
need abidw abigail-tools
# The clients in other languages.
need luajit luajit
need rustc rustc
need node nodejs
need npm npm
/usr/bin/python3 -c 'import numpy' 2> /dev/null || missing="$missing python3-numpy"
[ -f /usr/include/embree3/rtcore.h ] || missing="$missing libembree-dev"
need doxygen doxygen
pkg-config --exists cairo 2> /dev/null || missing="$missing libcairo2-dev"

if [ -n "$missing" ]; then
    echo "installing$missing"
    sudo=
    [ "$(id -u)" = 0 ] || sudo=sudo
    $sudo apt-get -qq update
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 install \
        --no-install-recommends $missing > /dev/null
fi

if [ -f "$build/build.ninja" ]; then
    meson configure "$build" -Dabi=enabled -Drender=enabled
else
    meson setup "$build" "$root" -Dabi=enabled -Drender=enabled
fi

# What the JavaScript client needs and Debian lacks. Without it, its test is skipped by name.
if [ ! -d "$build/javascript/node_modules/koffi" ]; then
    mkdir -p "$build/javascript"
    cp "$root"/tests/clients/javascript/package*.json "$build/javascript"
    npm ci --prefix "$build/javascript" --ignore-scripts --no-audit --no-fund --silent ||
        echo 'no koffi: the JavaScript client is not tested'
fi
