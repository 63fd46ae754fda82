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
need abidw abigail-tools
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
