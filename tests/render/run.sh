#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds the library and renders every scene with every technique: the main job, on a machine that
# needs nothing but Debian and compilers. Arguments are passed to render (see render --help);
# BUILD names another build directory, OUTPUT another place for the pictures.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${BUILD:-$root/build}
output=${OUTPUT:-$build/pictures}

sh "$root/tests/setup.sh" "$build" render
meson compile -C "$build" render maps
mkdir -p "$output"
"$build/tests/render/maps" "$output"
"$build/tests/render/render" --output "$output" "$@"
echo "The pictures are in $output."
