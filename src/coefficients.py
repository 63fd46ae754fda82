#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes coefficients.h: python3 coefficients.py > coefficients.h (needs mpmath).

Each polynomial is the Chebyshev interpolant of its function at 60 digits, within a factor of
two of the minimax one, turned into monomials and rounded; the error printed beside it is that
of the rounded polynomial, relative, the worst over 2000 points.
"""
from mpmath import mp, mpf, sin, cos, atan, sqrt, pi, chebyt, taylor

mp.dps = 60
KAPPA = sqrt(mpf(2)) - 1


def sine_excess(z):
    x = sqrt(z)
    return mpf(1) / 6 - z / 120 if x < mpf("1e-12") else (x - sin(x)) / x**3


def cosine_defect(z):
    x = sqrt(z)
    return mpf(1) / 2 - z / 24 if x < mpf("1e-12") else 2 * sin(x / 2) ** 2 / z


def atan_defect(z):
    t = sqrt(z)
    return mpf(1) / 3 - z / 5 if t < mpf("1e-12") else (t - atan(t)) / t**3


def segment_rise(w):
    """(N - 1) / w: fitted in place of N, so that the differences of N hold near 0 too."""
    z = w / (1 - KAPPA * w)
    if w < mpf("1e-12"):
        return mpf(6) / 5
    x = 2 * atan(sqrt(z))
    return (mpf(3) / 2 * (x - sin(x) * cos(x)) / sin(x) ** 3 - 1) / w


def interpolate(f, lo, hi, terms):
    """Monomial coefficients of the polynomial through f at the Chebyshev nodes of [lo, hi]."""
    nodes = [cos(pi * (2 * i + 1) / (2 * terms)) for i in range(terms)]
    values = [f((lo + hi) / 2 + (hi - lo) / 2 * x) for x in nodes]
    cheb = [
        (2 if k else 1) * sum(v * cos(k * pi * (2 * i + 1) / (2 * terms))
                              for i, v in enumerate(values)) / terms
        for k in range(terms)
    ]
    # Clenshaw on polynomials in z, with x = (2 z - lo - hi) / (hi - lo)
    slope, shift = 2 / (hi - lo), -(lo + hi) / (hi - lo)

    def times_2x(p):
        q = [mpf(0)] * (len(p) + 1)
        for i, c in enumerate(p):
            q[i] += 2 * shift * c
            q[i + 1] += 2 * slope * c
        return q

    def add(p, q):
        n = max(len(p), len(q))
        p, q = p + [mpf(0)] * (n - len(p)), q + [mpf(0)] * (n - len(q))
        return [a + b for a, b in zip(p, q)]

    b1, b2 = [mpf(0)], [mpf(0)]
    for c in reversed(cheb[1:]):
        b1, b2 = add(add(times_2x(b1), [-v for v in b2]), [c]), b1
    half = [v / 2 for v in times_2x(b1)]
    return add(add(half, [-v for v in b2]), [cheb[0]])[:terms]


def rounded(c, bits):
    with mp.workprec(bits):
        return +c


def hexfloat(c, bits):
    if bits == 53:
        return float(c).hex().replace("0x1.0000000000000p", "0x1p")
    mantissa, exponent = float(c).hex().split("p")
    return mantissa.rstrip("0").rstrip(".") + "p" + exponent + "f"


def emit(name, f, lo, hi, terms, bits, text):
    coeffs = [rounded(c, bits) for c in interpolate(f, lo, hi, terms)]
    worst = mpf(0)
    for i in range(2001):
        z = lo + (hi - lo) * i / 2000
        p = mpf(0)
        for c in reversed(coeffs):
            p = p * z + c
        worst = max(worst, abs(p / f(z) - 1))
    print(f"/* {text}: relative error {mp.nstr(worst, 2)} */")
    line = f"#define {name}"
    print(line + " \\")
    for i in range(0, terms, 3):
        row = ", ".join(hexfloat(c, bits) for c in coeffs[i:i + 3])
        print("    " + row + (", \\" if i + 3 < terms else ""))
    print()


print("""/* SPDX-License-Identifier: Apache-2.0 */
/* Written by coefficients.py: do not edit. */
#ifndef PSC_SRC_COEFFICIENTS_H
#define PSC_SRC_COEFFICIENTS_H
""")
right = (pi / 2) ** 2
top = 1 / (1 + KAPPA)
emit("PSC_SINE_F64", sine_excess, mpf(0), right, 8, 53, "(x - sin x) / x^3 of x^2 in [0, pi^2/4]")
emit("PSC_SINE_F32", sine_excess, mpf(0), right, 5, 24, "(x - sin x) / x^3 of x^2 in [0, pi^2/4]")
emit("PSC_COSINE_F64", cosine_defect, mpf(0), right, 9, 53, "(1 - cos x) / x^2 of x^2 in [0, pi^2/4]")
emit("PSC_COSINE_F32", cosine_defect, mpf(0), right, 5, 24, "(1 - cos x) / x^2 of x^2 in [0, pi^2/4]")
emit("PSC_ATAN_F64", atan_defect, mpf(0), mpf(1), 21, 53, "(t - atan t) / t^3 of t^2 in [0, 1]")
emit("PSC_ATAN_NEAR_F64", atan_defect, mpf(0), mpf("0.18"), 11, 53,
     "(t - atan t) / t^3 of t^2 in [0, 0.18]")
emit("PSC_ATAN_F32", atan_defect, mpf(0), mpf(1), 9, 24, "(t - atan t) / t^3 of t^2 in [0, 1]")
text = "(N - 1) / w, N = 3/2 (x - sin x cos x) / sin^3 x, of w as in segment.h"
emit("PSC_SEGMENT_F64", segment_rise, mpf(0), top, 16, 53, text)
emit("PSC_SEGMENT_F32", segment_rise, mpf(0), top, 8, 24, text)
print("#endif")
