#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""breaks.py ROOT COMPILER...: breaks a copy of the interface in every way; the guard must refuse.

Each break is an edit of the header, the version script or the link, and the layers that refuse
it, no more and no less:

    F  tests/abi_frozen.c does not compile     S  abi/libpsc.symbols differs
    N  tests/headers/names.py: lists differ    C  the recorded interface differs
    L  the library does not link               R  a release's interface is broken

The library is made of the header's declarations with empty bodies: that is all the guard sees.
"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HEADER, MAP, LINK = 'include/psc/psc.h', 'src/libpsc.map', 'soname'
TOTAL = 'PSC_API psc_result psc_sampler_total(const psc_sampler *sampler, double *total);'
EXTRA = '\nPSC_API psc_result psc_extra(const psc_sampler *sampler);'
AREA_NAME = '    psc_sampler_area;\n'

BREAKS = [
    ('nothing at all', '', []),
    ('function removed', 'FSNCR', [(HEADER, TOTAL, ''), (MAP, '    psc_sampler_total;\n', '')]),
    ('function removed, its name left in the version script', 'L', [(HEADER, TOTAL, '')]),
    ('function renamed', 'FSNCR', [(HEADER, 'psc_sampler_area(', 'psc_sampler_extent('),
                                   (MAP, 'psc_sampler_area;', 'psc_sampler_extent;')]),
    ('function added, not recorded', 'SNC', [(HEADER, TOTAL, TOTAL + EXTRA),
                                             (MAP, AREA_NAME, AREA_NAME + '    psc_extra;\n')]),
    ('function added, not exported', 'N', [(HEADER, TOTAL, TOTAL + EXTRA)]),
    ('data exported', 'SNCR', [(HEADER, TOTAL, TOTAL + '\nPSC_API extern int psc_extra;'),
                               (MAP, AREA_NAME, AREA_NAME + '    psc_extra;\n')]),
    ('name moved to another node', 'SNCR',
     [(MAP, AREA_NAME, ''),
      (MAP, '    *;\n};', f'    *;\n}};\nPSC_0.2 {{\n{AREA_NAME}}} PSC_0.1;')]),
    ('soname changed', 'SCR', [(LINK, '0', '1')]),
    ('parameter size_t to uint32_t', 'FCR',
     [(HEADER, 'sampler_init(void *memory, size_t size,', 'sampler_init(void *memory, uint32_t size,')]),
    ('parameter size_t to ptrdiff_t', 'FCR',
     [(HEADER, 'sampler_init(void *memory, size_t size,', 'sampler_init(void *memory, ptrdiff_t size,')]),
    ('parameter double to float', 'FCR', [(HEADER, 'psc_cap_solid_angle(double half',
                                           'psc_cap_solid_angle(float half')]),
    ('parameters swapped', 'FCR', [(HEADER, '(double half_angle, double *solid_angle)',
                                    '(double *solid_angle, double half_angle)')]),
    ('parameter added', 'FCR', [(HEADER, 'psc_sampler_size(void)', 'psc_sampler_size(int flags)')]),
    ('return type changed', 'FCR', [(HEADER, 'uint32_t psc_version', 'uint64_t psc_version')]),
    ('const dropped from a parameter', 'FC', [(HEADER, 'total(const psc_sampler',
                                                'total(psc_sampler')]),
    ('const added to a parameter', 'FC', [(HEADER, 'destroy(psc_sampler',
                                            'destroy(const psc_sampler')]),
    ('integer type widened', 'FNCR', [(HEADER, 'uint32_t psc_map;', 'uint64_t psc_map;')]),
    ('result type widened', 'FNCR', [(HEADER, 'int32_t psc_result;', 'int64_t psc_result;')]),
    ('fields reordered', 'FCR',
     [(HEADER, '    psc_measure measure;\n    psc_map map;\n    uint32_t flags;',
       '    psc_map map;\n    psc_measure measure;\n    uint32_t flags;')]),
    ('field inserted', 'FCR', [(HEADER, '    const double *position;',
                                '    void *scene;\n    const double *position;')]),
    ('field appended', 'FCR', [(HEADER, '} psc_technique;',
                                '    uint32_t more;\n} psc_technique;')]),
    ('field removed', 'FCR', [(HEADER, '    double surface[2];', '')]),
    ('field retyped, same size', 'FCR', [(HEADER, 'double *position;', 'float *position;')]),
    ('field renamed', 'FC', [(HEADER, 'const double *position;', 'const double *origin;')]),
    ('array field lengthened', 'FCR', [(HEADER, 'float surface[2]', 'float surface[3]')]),
    ('struct aligned otherwise', 'FN', [(HEADER, '} psc_light_sample_f64;',
                                         '} __attribute__((aligned(16))) psc_light_sample_f64;')]),
    ('storage shrunk', 'F', [(HEADER, 'bytes[16384]', 'bytes[8192]')]),
    ('callback signature changed', 'FCR', [(HEADER, '(*release)(void *user, void *memory)',
                                            '(*release)(void *memory)')]),
    ('constant changed', 'F', [(HEADER, 'PSC_CULLED = 2', 'PSC_CULLED = 4')]),
    ('constant removed', 'FN', [(HEADER, '    PSC_MAP_PARALLEL = 1,', '')]),
    ('constant added, not recorded', 'N', [(HEADER, 'PSC_MAP_RADIAL = 0,',
                                            'PSC_MAP_RADIAL = 0, PSC_MAP_POLAR = 7,')]),
    ('struct added, not recorded', 'N', [(HEADER, '} psc_description;',
                                          '} psc_description;\n'
                                          'typedef struct { int a; } psc_more;')]),
    ('table fields reordered', 'FN', [(HEADER, '    uint32_t (*version)(void);\n', ''),
                                      (HEADER, '    size_t (*sampler_size)(void);\n',
                                       '    uint32_t (*version)(void);\n'
                                       '    size_t (*sampler_size)(void);\n')]),
    ('table appended, not recorded', 'FN', [(HEADER, '} psc_api_1;',
                                             '    void (*extra)(void);\n} psc_api_1;')]),
    ('version macros disagree', 'FN', [(HEADER, '_PATCH 0', '_PATCH 1')]),
]


def bodies(header):
    """A definition for each declaration: the code of a library that does nothing."""
    code = re.sub(r'/\*.*?\*/|^#.*?$', '', header, flags=re.DOTALL | re.MULTILINE)
    declared = re.findall(r'PSC_API ([^;]+?\));', code)
    data = re.findall(r'PSC_API extern ([^;(]+);', code)
    return '\n'.join(['#include <psc/psc.h>'] + [f'{d} = 1;' for d in data] + [
        d + (' {}' if d.startswith('void ') else ' { return 0; }') for d in declared])


def refusals(edits, root, compiler, version):
    """The layers that refuse the interface after the edits."""
    with tempfile.TemporaryDirectory() as place:
        tree = pathlib.Path(place)
        for path in (HEADER, MAP, 'tests/abi_frozen.c', 'tests/tap.h', 'abi/libpsc.symbols',
                     'abi/x86_64/libpsc.abi'):
            (tree / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / path, tree / path)
        soname = '0'
        for path, old, new in edits:
            if path == LINK:
                soname = new
                continue
            text = (tree / path).read_text()
            if text.count(old) != 1:
                raise ValueError(f'the edit applies {text.count(old)} times: {old}')
            (tree / path).write_text(text.replace(old, new))
        recorded = tree / 'abi/x86_64'
        release = tree / 'release'
        release.mkdir()
        shutil.copy(recorded / 'libpsc.abi', release / 'libpsc-0.0.1.abi')
        (tree / 'library.c').write_text(bodies((tree / HEADER).read_text()))

        def fails(*command):
            return subprocess.run([str(word) for word in command], cwd=tree,
                                  capture_output=True).returncode != 0

        if fails(*compiler, '-shared', '-fPIC', '-O0', '-g', '-gdwarf-4', '-fvisibility=hidden',
                 '-DPSC_BUILDING', '-Iinclude', 'library.c', '-o', 'library.so',
                 f'-Wl,--version-script={MAP},--no-undefined-version,-soname,libpsc.so.{soname}'):
            return 'L'
        check = root / 'abi/check.sh'
        undumped = fails(check, 'dump', 'library.so', 'include', 'dump')
        layers = {
            'F': fails(*compiler, '-std=c11', '-Iinclude', '-fsyntax-only', 'tests/abi_frozen.c'),
            'S': fails(check, 'symbols', 'library.so', 'abi/libpsc.symbols'),
            'N': fails(root / 'tests/headers/names.py', tree, version),
            'C': undumped or fails(check, 'current', recorded / 'libpsc.abi', 'dump'),
            'R': undumped or fails(check, 'compat', release, 'dump'),
        }
        return ''.join(layer for layer, refused in layers.items() if refused)


def main(root, version, *compiler):
    print(f'1..{len(BREAKS)}')
    failures = 0
    with concurrent.futures.ThreadPoolExecutor() as pool:
        found = [pool.submit(refusals, edits, pathlib.Path(root), compiler, version)
                 for _, _, edits in BREAKS]
    for number, ((name, expected, _), future) in enumerate(zip(BREAKS, found), 1):
        error = future.exception()
        layers = error or future.result()
        ok = layers == expected
        failures += not ok
        print(f"{'ok' if ok else 'not ok'} {number} - {name}: refused by "
              f"{layers or 'none'}{'' if ok else f', not {expected}'}")
    return failures != 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
