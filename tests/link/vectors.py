#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vectors.py DIRECTORY ISA...: that loops of the kernels are still vector code, by disassembly.

A loop that a compiler no longer vectorises gives the same results and passes every other test. In
the objects of each instruction set below DIRECTORY, a function that is one loop over a block has to
do its arithmetic on vectors. Copies of the loop for the elements that are left over are in order,
so the count of vector operations need only be a fourth of that of the others: it is 0 when the
vector code is lost.
"""

import pathlib
import re
import shutil
import subprocess
import sys

# By family: the functions that are such loops, and instruction sets that have no vector code for
# them.
LOOPS = [
    ("cap", r"block_\w+_f\d\d", ()),
    ("cap", r"wave_(radial|parallel|concentric)_\w+_f\d\d", ()),
    ("cap", r"wave_(cone|projected)_directions_f\d\d", ()),
    ("cap", r"weigh_cuts|wave_views_f\d\d", ()),
    ("cap", r"pdf_(cone|projected|area|area_inside)", ()),
    ("cap", r"look_(cone|projected)", ("base",)), # SSE2 has no choice between doubles by integers
    ("cap", r"invert_(radial|parallel|concentric)_\w+", ()),
    ("disk", r"(radial|concentric|parallel|area_\w+)_block_\w+", ()),
    ("disk", r"find_(whole|clipped)_\d+_f\d\d", ()),
    ("disk", r"wave_(radial|concentric|parallel|area_\w+|quasi|hits_\w+)(_\d+)?_f\d\d", ()),
    ("disk", r"wave_(span_)?fit_\d+_f\d\d", ()),
    ("disk", r"view_(disk|elliptical|ellipsoid)_(cones|areas)_f\d\d", ()),
    ("disk", r"fibre_wave_(place_)?(whole|clipped)\w*", ()),
    ("disk", r"place_(whole|clipped)(_brief)?_f\d\d", ()),
    ("polygon", r"(fan|plain)_block_f\d\d", ()),
    ("polygon", r"ray_block_f\d\d", ()),
    ("polygon", r"build_fan_step", ()),
    ("polygon", r"place_fan_step", ()),
    ("polygon", r"(start|see)_fans_(around|above)_f\d\d", ()),
    ("polygon", r"(frame|judge)_fans_f\d\d|place_vertices_f\d\d", ()),
    ("polygon", r"build_picked_(around|above)_f\d\d", ("base",)),
    ("polygon", r"(rectangle|rectangle_area|plain_rectangle)_block(_whole)?_f\d\d", ()),
    ("polygon", r"(plain|exact)_(rectangles|areas)_(around|above)(_whole)?_f\d\d", ("base",)),
    ("polygon", r"pdf_rectangle(_area)?", ("base",)),
    ("polygon", r"invert_rectangle_(around|beside|area)", ("base",)),
    ("polygon", r"flat_block_f\d\d", ()),
    ("polygon", r"(solve_sectors|sector_block)_f\d\d", ()),
    ("polygon", r"sector_quarters", ()),
    ("polygon", r"triangle_wave_f\d\d", ("base",)),
    ("polygon", r"build_(exact_(around|above)|(whole_)?elements)_f\d\d", ("base",)),
    ("polygon", r"(judge_elements|find_(halves|normals))_f\d\d", ("base",)),
    ("polygon", r"flat_(around|above)_f\d\d", ("base",)),
]
# Those that a compiler may have inlined into what calls them.
MAY_BE_MISSING = (r"weigh_cuts|wave_(cone|projected)_directions|(fan|plain)_block|triangle_wave"
                  r"|build_|\(judge_")
DOUBLE_ONLY = r"pdf_|look_|invert_|sector_quarters|(build|place)_fan_step"

ARITHMETIC = re.compile(r"v?(?:add|sub|mul|div|sqrt|fn?m(?:add|sub)\d+)(p|s)[sd]$")


def functions(path):
    """The vector and the scalar operations of each function of an object."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", path], capture_output=True,
                          text=True, check=True).stdout
    counts, count = {}, None
    for line in text.splitlines():
        start = re.match(r"[0-9a-f]+ <(.*)>:", line)
        operation = re.match(r"\s+[0-9a-f]+:\s+(\S+)", line)
        if start:
            count = counts.setdefault(start.group(1).split(".")[0], {"p": 0, "s": 0})
        elif operation and count is not None:
            kind = ARITHMETIC.match(operation.group(1))
            if kind:
                count[kind.group(1)] += 1
    return counts


class Tap:
    count = failed = 0

    def line(self, good, text):
        self.count += 1
        self.failed += not good
        print(f"{'ok' if good else 'not ok'} {self.count} - {text}")


def check_object(tap, path, family, bits, isa):
    counts = functions(path)
    for loops_of, pattern, scalar in LOOPS:
        if loops_of != family or (bits == "32" and re.match(DOUBLE_ONLY, pattern)):
            continue
        name = f"{family}, f{bits}, {isa}: {pattern}"
        found = {f: c for f, c in counts.items() if re.fullmatch(pattern, f)}
        lost = [f for f, c in found.items() if c["p"] < 8 or 4 * c["p"] < c["s"]]
        if isa in scalar:
            tap.line(True, f"{name} # SKIP no vector code there")
        elif not found and re.match(MAY_BE_MISSING, pattern):
            tap.line(True, f"{name} # SKIP inlined")
        else:
            tap.line(found and not lost, f"{name}: {len(found)} functions, lost: {lost or 'none'}")


def main():
    directory, isas = pathlib.Path(sys.argv[1]), sys.argv[2:]
    tap = Tap()
    if not shutil.which("objdump"):
        print("1..0 # SKIP no objdump")
        return 0
    for family in sorted({row[0] for row in LOOPS}):
        for isa in isas:
            for bits in ("32", "64"):
                objects = list(directory.glob(f"libpsc_{family}_f{bits}_{isa}.a.p/*.o"))
                if objects:
                    check_object(tap, objects[0], family, bits, isa)
                else:
                    tap.line(False, f"{family}, f{bits}, {isa}: no object")
    print(f"1..{tap.count}")
    return tap.failed > 0


if __name__ == "__main__":
    sys.exit(main())
