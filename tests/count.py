#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""count.py TESTLOG: sums up a testlog.json of meson: every check of a test that prints TAP counts,
any other test as one. A test that died is a failure whatever it printed before. What was skipped is
named."""
import json
import pathlib
import re
import sys

passed = failed = skipped = 0
log = pathlib.Path(sys.argv[1])
tests = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []
for test in tests:
    output = test.get('stdout', '')
    checks = re.findall(r'^(not )?ok\b(.*# SKIP)?', output, re.MULTILINE)
    for reason in re.findall(r'^(?:ok|1\.\.0)\b.*# SKIP (.*)', output, re.MULTILINE):
        print(f"skipped: {test['name']}: {reason}")
    bad = sum(1 for no, skip in checks if no)
    skips = sum(1 for no, skip in checks if skip and not no)
    if test['result'] == 'SKIP':
        skipped += skips or 1
    elif test['result'] == 'OK':
        passed += len(checks) - bad - skips or 1
        skipped += skips
    else:
        passed += len(checks) - bad - skips
        skipped += skips
        failed += bad or 1
if not tests:
    failed = 1
if skipped:
    print(f'{skipped} skipped')
print(f'{passed} passed, {failed} failed')
sys.exit(failed != 0)
