#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes fibre_starts.h: python3 fibre_starts.py > fibre_starts.h (needs mpmath).

The density of a small cone over s is sin^2 s (c + cos s), whose horizon is at cos s = -c. The
places of fixed shares are interpolated, as quotients by a root of the share, by polynomials in
1 / c where the cone is whole and in the square of the end of s where it is clipped.
"""
from mpmath import cos, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 30
NODES, POWERS = 8, 6
HALF = mpf(1) / 2
# By the root that the place goes with: z is its square, or itself.
SPAN = (HALF ** (mpf(2) / 3), sqrt(HALF))
POWER = (mpf(3) / 2, mpf(2))
Z = [[span * (1 - cos((2 * i + 1) * pi / (2 * NODES))) / 2 for i in range(NODES)] for span in SPAN]
SHARE = [[z ** power for z in row] for row, power in zip(Z, POWER)]
ROOT = [[sqrt(z) for z in Z[0]], Z[1]]


def integral(s, still, tilt):
    return still * (s - sin(s) * cos(s)) / 2 + tilt * sin(s) ** 3 / 3


def place(share, still, tilt, end, lower):
    """From the top, or from the end."""
    whole, low, high = integral(end, still, tilt), mpf(0), end
    for _ in range(60):
        x = (low + high) / 2
        part = whole - integral(end - x, still, tilt) if lower else integral(x, still, tilt)
        low, high = (x, high) if part < share * whole else (low, x)
    return low


def quotients(clipped, t):
    end = sqrt(t) if clipped else pi
    still, tilt = (-cos(end), 1) if clipped else (1, t)
    return [place(share, still, tilt, end, lower) / root / (end if clipped else 1)
            for lower in range(2)
            for share, root in zip(SHARE[clipped * lower], ROOT[clipped * lower])]


def model(clipped, low, high):
    """Coefficients by power and node, through nodes of Chebyshev's."""
    t = [(low + high) / 2 - (high - low) / 2 * cos((2 * i + 1) * pi / (2 * POWERS))
         for i in range(POWERS)]
    values = matrix([quotients(clipped, x) for x in t])
    return lu_solve_all(matrix([[x ** k for k in range(POWERS)] for x in t]), values)


def lu_solve_all(a, b):
    columns = [lu_solve(a, b[:, j]) for j in range(b.cols)]
    return [[columns[j][i] for j in range(b.cols)] for i in range(a.cols)]


def to_powers(z):
    """[j][k]: what the value at node j adds to the coefficient of z^k."""
    unit = matrix(NODES, NODES)
    for j in range(NODES):
        unit[j, j] = 1
    columns = lu_solve_all(matrix([[x ** k for k in range(NODES)] for x in z]), unit)
    return [[columns[k][j] for k in range(NODES)] for j in range(NODES)]


def number(x):
    mantissa, exponent = float(x).hex().split("p")
    return mantissa.rstrip("0").rstrip(".") + "p" + exponent


def table(declaration, rows):
    print(f"static const double {declaration} = {{")
    text, line = ", ".join(number(x) for row in rows for x in row), "   "
    for word in text.split(" "):
        if len(line) + len(word) > 98:
            print(line)
            line = "   "
        line += " " + word
    print(line + "};\n")


print("""/* SPDX-License-Identifier: Apache-2.0 */
/* Written by fibre_starts.py: do not edit. */
#ifndef PSC_SRC_FIBRE_STARTS_H
#define PSC_SRC_FIBRE_STARTS_H

#define PSC_START_TERMS 8
#define PSC_MODEL_TERMS 6

/* Shares and their roots, cube roots first, then square roots. */""")
table("psc_start_share[2 * PSC_START_TERMS]", SHARE)
table("psc_start_root[2 * PSC_START_TERMS]", ROOT)
print("""/* Places over their roots in powers of the tilt of a whole cone, from the top and the bottom; over
   the end too, in powers of its square, of a clipped one. */""")
table("psc_start_model[2 * PSC_MODEL_TERMS * 2 * PSC_START_TERMS]",
      model(0, mpf(0), mpf("0.9")) + model(1, mpf("0.94") ** 2, mpf("2.75") ** 2))
print("""/* [j][k]: what the value at a node adds to a coefficient; for either root. */""")
table("psc_start_powers[2 * PSC_START_TERMS * PSC_START_TERMS]", to_powers(Z[0]) + to_powers(Z[1]))
print("#endif")
