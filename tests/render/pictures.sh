#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes the pictures that the README shows anew, with few colours and so small; needs ImageMagick.
# Programs are taken from the build directory BUILD.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${BUILD:-$(cd "$here/../.." && pwd)/build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shrink() {
    convert "$work/$1.png" +dither -colors "$2" -define png:compression-level=9 \
        "png8:$here/pictures/$1.png"
}
# The upper half, which is that of one sample a pixel.
upper() {
    height=$(identify -format %h "$work/$1.png")
    convert "$work/$1.png" -crop "x$(((height + 34) / 2))+0+0" +repage "$work/$1.png"
}
"$build/tests/render/maps" "$work"
"$build/tests/render/render" --output "$work" --width 224 --repeat 1 --samples 4 \
    cornell cornell-open sun
"$build/tests/render/render" --output "$work" --width 200 --repeat 1 --samples 4 disk fog windows
shrink gallery 255
shrink sun 96
shrink maps 24
shrink maps-disks 24
shrink maps-polygons 24
shrink maps-horizon 24
for scene in disk fog windows; do
    upper $scene
    shrink $scene 128
done
