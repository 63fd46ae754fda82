#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""names.py ROOT VERSION: every list of what is public holds the same names.

The header is the original; the version script, the recorded symbols, the function table and
tests/abi_frozen.c repeat it.
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
count = failures = 0


def check(name, ok, explanation=''):
    global count, failures
    count += 1
    failures += not ok
    print(f"{'ok' if ok else 'not ok'} {count} - {name}")
    if not ok and explanation:
        print(f'# {explanation}')


def same(name, want, have):
    check(name, want and want == have, f'missing {sorted(set(want) - set(have))}, '
          f'too much {sorted(set(have) - set(want))}, or another order')


def found(pattern, text):
    return re.findall(pattern, text, re.MULTILINE)


def read(path):
    return (root / path).read_text()


header = read('include/psc/psc.h')
code = re.sub(r'/\*.*?\*/|^#.*?$', '', header, flags=re.DOTALL | re.MULTILINE)
frozen = read('tests/abi_frozen.c')

functions = found(r'^PSC_API [^;(]*?(psc_\w+)\(', code)
table = re.search(r'typedef struct psc_api_1 \{(.*?)\} psc_api_1;', code, re.DOTALL).group(1)
same('version script', functions,
     found(r'^ +(psc_\w+);', read('src/libpsc.map')))
same('abi/libpsc.symbols', sorted(functions),
     sorted(found(r'^(psc_\w+) ', read('abi/libpsc.symbols'))))
same('psc_api_1', [f for f in functions if f != 'psc_get_api'],
     ['psc_' + f for f in found(r'\(\*(\w+)\)', table)])
same('abi_frozen.c: functions', functions,
     ['psc_' + f for f in found(r'^    F\(\d+, (\w+)', frozen)]
     + found(r'&(psc_get_api)', frozen))

constants = [c for body in found(r'enum \{([^}]*)\}', code) for c in found(r'(PSC_\w+) =', body)]
same('abi_frozen.c: constants', sorted(constants),
     sorted(found(r'^CONSTANT\((PSC_\w+),', frozen)))
same('abi_frozen.c: types', sorted(found(r'\} (psc_\w+);', code)),
     sorted(found(r'^SIZE\((psc_\w+),', frozen)))
same('abi_frozen.c: integer types', sorted(found(r'^typedef u?int32_t (psc_\w+);', code)),
     sorted(found(r'^TYPE\((psc_\w+),', frozen)))

documented = found(r'/\*\*((?:(?!\*/).)*?)\*/\s*PSC_API [^;(]*?(psc_\w+)\(',
                   re.sub(r'\n', ' ', header))
since = [name for comment, name in documented if '@since' in comment]
same('@since', functions, since)
check('version', sys.argv[2].split('.') == found(r'^#define PSC_VERSION_M?[AIP]\w+ (\d+)', header),
      f'the project is {sys.argv[2]}')

print(f'1..{count}')
sys.exit(failures != 0)
