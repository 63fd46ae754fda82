#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes ellipse_rules.h: python3 ellipse_rules.py > ellipse_rules.h (needs mpmath).

A rule of m nodes interpolates an even function of period pi, given at (j + 1/2) pi / (2 m), by a
polynomial of degree m - 1 in the cosine of twice the angle. Correctly rounded.
"""
from mpmath import mp, mpf, sin, cos, pi

mp.dps = 40
F64 = (4, 6, 8, 12, 16, 24)
F32 = (3, 4, 6, 10, 12)


def number(x, bits):
    with mp.workprec(bits):
        x = +x
    if abs(x) < mpf(2) ** -100:
        return "0"
    if x == int(x):
        return str(int(x))
    mantissa, exponent = float(x).hex().split("p")
    return mantissa.rstrip("0").rstrip(".") + "p" + exponent + ("f" if bits == 24 else "")


def array(name, values, bits):
    text = ", ".join(number(v, bits) for v in values)
    lines, line = [], f"    .{name} = {{"
    for word in text.split(" "):
        if len(line) + len(word) > 98:
            lines.append(line.rstrip())
            line = "        "
        line += word + " "
    return "\n".join(lines + [line.rstrip() + "},"])


def chebyshev(m):
    """Monomial coefficients of T_0 to T_(m - 1)."""
    t = [[1], [0, 1]]
    while len(t) < m:
        next_t = [0] + [2 * c for c in t[-1]]
        for i, c in enumerate(t[-2]):
            next_t[i] -= c
        t.append(next_t)
    return [row + [0] * (m - len(row)) for row in t[:m]]


def rule(m, bits):
    real = "float" if bits == 24 else "double"
    name = f"f{32 if bits == 24 else 64}_{m}"
    nodes = [(2 * j + 1) * pi / (4 * m) for j in range(m)]
    print(f"static const struct {{")
    print(f"    {real} c[{m}], s[{m}], per_c[{m}], per_s[{m}], wave[{m * m}], power[{m * m}];")
    if bits == 53:
        print(f"    {real} column[{m * m}];")
    print(f"}} psc_rule_{name} = {{")
    print(array("c", [cos(x) for x in nodes], bits))
    print(array("s", [sin(x) for x in nodes], bits))
    print(array("per_c", [1 / cos(x) for x in nodes], bits))
    print(array("per_s", [1 / sin(x) for x in nodes], bits))
    print(array("wave", [cos(2 * k * x) for k in range(m) for x in nodes], bits))
    print(array("power", [c for row in chebyshev(m) for c in row], bits))
    if bits == 53:
        print(array("column", [cos(2 * k * x) for x in nodes for k in range(m)], bits))
    print("};\n")


print("""/* SPDX-License-Identifier: Apache-2.0 */
/* Written by ellipse_rules.py: do not edit.
   Rules of m nodes x_j = (j + 1/2) pi / (2 m): cosines and sines with their reciprocals,
   wave[k m + j] = cos 2 k x_j, power[k m + i] the coefficient of x^i in the Chebyshev polynomial
   T_k; column[j m + k] = wave[k m + j]. */
#ifndef PSC_SRC_ELLIPSE_RULES_H
#define PSC_SRC_ELLIPSE_RULES_H
""")
for m in F64:
    rule(m, 53)
for m in F32:
    rule(m, 24)
print("#endif")
