#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes starts.h: python3 starts.py > starts.h (needs mpmath; about a minute).

Start values for the radial map of a cap that the horizon cuts: what solving for them at build
would give, as polynomials in two numbers that the build knows anyway. Each is a least-squares fit
over a grid of all caps, repeated with more weight where it is worst, so that it ends close to the
smallest worst error, which is printed. Only that error counts, so five digits do.
"""
from math import cos, pi, sin, sqrt
from operator import mul
from mpmath import atan2, mp, mpf
from mpmath import cos as mcos, sin as msin, sqrt as msqrt

mp.dps = 40
TIP_A, TIP_B = 0.18669119, 0.05217386  # as in lune_map.h


def least_squares(columns, right):
    """By modified Gram-Schmidt; destroys its arguments."""
    n = len(columns)
    r = [[0.0] * n for _ in range(n)]
    y = [0.0] * n
    for k in range(n):
        a = columns[k]
        r[k][k] = sqrt(sum(map(mul, a, a)))
        a = columns[k] = [v / r[k][k] for v in a]
        for j in range(k + 1, n):
            d = r[k][j] = sum(map(mul, a, columns[j]))
            columns[j] = [v - d * w for v, w in zip(columns[j], a)]
        y[k] = sum(map(mul, a, right))
        right = [v - y[k] * w for v, w in zip(right, a)]
    for k in reversed(range(n)):
        y[k] = (y[k] - sum(r[k][j] * y[j] for j in range(k + 1, n))) / r[k][k]
    return y


def fit(rows, right, rounds):
    """Coefficients x that make the largest |right - rows x| small."""
    weights = [1.0] * len(rows)
    best = None
    for _ in range(rounds):
        columns = [[w * v for w, v in zip(weights, column)] for column in zip(*rows)]
        x = least_squares(columns, [w * v for w, v in zip(weights, right)])
        errors = [abs(b - sum(map(mul, row, x))) for row, b in zip(rows, right)]
        worst = max(errors)
        if best is None or worst < best[0]:
            best = worst, x
        weights = [w * (e / worst + 0.02) ** 0.35 for w, e in zip(weights, errors)]
        top = max(weights)
        weights = [max(w / top, 1e-3) for w in weights]
    return best


# ---- A lune: d = W (a1 + W (a2 + W (a3 + (1 - W) (g0 + g1 W)))), see lune_map.h ----

def tip_layer(x):
    share = ((1 + x * (TIP_A + TIP_B * x)) /
             (1 + x * (TIP_A + x * ((TIP_B + 2 / 15) + x * (2 * TIP_B / pi)))))
    return x * (x * x / 3 + share), share


def lune_samples(sine, psi_l, count):
    """For sin |beta| and the angle of the tip: share^2, 1 - a1, a2, and pairs W, d."""
    sb, psi_l = mpf(sine), mpf(psi_l)
    cb = msqrt(1 - sb * sb)
    q, ca = cb * msin(psi_l), cb * mcos(psi_l)
    sa = msqrt(sb * sb + q * q)
    k, x_e = sa * sb, ca * cb

    def area(psi):
        return psi - x_e * msin(psi) - k * sa * atan2(sb * msin(psi), mcos(psi) - x_e)

    total = area(psi_l)
    layer = float((3 * total * q / (sa * sa * k)) ** (mpf(1) / 3))
    width, share = tip_layer(layer)
    z = width * float(k / q)
    a1 = z / float(psi_l)
    a2 = float(ca * (1 / q + q / sa ** 2)) * z * a1 / 4
    pairs = []
    for i in range(count):
        t = (i + 0.7) / count
        d = t * (1 + t) / 2
        r = float(1 - area(psi_l * (1 - d)) / total)
        if r > 1e-7:
            pairs.append((tip_layer(layer * r ** (1 / 3))[0] / width, d))
    return share * share, 1 - a1, a2, pairs


LUNE_POWERS = [(i, j) for i in range(5) for j in range(5 - i)]


def lune_fit():
    rows, right = [], []
    for i in range(26):
        t = (i + 0.5) / 26
        sine = 10 ** (-6 * (1 - t / 0.35) - 1.2) if t < 0.35 else \
            sin(0.06 + (pi / 2 - 0.06) * (t - 0.35) / 0.65)
        sine = sin(pi / 2 - 3e-4) if i == 25 else sine
        for j in range(22):
            psi_l = 1e-3 if j == 0 else 1.57 if j == 21 else pi / 2 * (j + 0.5) / 22
            s, e, a2, pairs = lune_samples(sine, psi_l, 14)
            for w, d in pairs:
                # What the solver makes of an error: most in the middle of thin lunes.
                scale = 1 + 0.4 * s * s if 0.25 < d < 0.9 else 1.0
                base = scale * w / d
                terms = [s ** a * e ** b for a, b in LUNE_POWERS]
                first = base * w * w * (1 - w)
                rows.append([first * v for v in terms] + [first * w * v for v in terms])
                right.append(scale - base * ((1 - e) + w * (a2 + w * (e - a2))))
    return fit(rows, right, 30)


# ---- Kepler: psi = psi_l y (1 + m (1 - y^2) (1 + y^2 (k0 + y^2 (k1 + y^2 k2)))) ----

def kepler_fit():
    rows, right = [], []
    for i in range(17):
        for j in range(17):
            psi_l = pi / 2 * i / 16 if i else 1e-3
            cb = sin(pi / 2 * j / 16) if j else 3e-3
            x_e, rest = cos(psi_l) * cb * cb, 1 - cos(psi_l) * cb * cb

            def area(psi):
                return rest * psi + x_e * float(psi - msin(mpf(psi)))

            m = x_e * float(psi_l - msin(mpf(psi_l))) / (rest * psi_l)
            for k in range(14):
                psi = psi_l * (k + 0.5) / 14
                y = area(psi) / area(psi_l)
                y2, ratio = y * y, psi / (psi_l * y)
                first = m * (1 - y2) / ratio
                rows.append([first * y2 ** p * v for p in (1, 2, 3) for v in (1, m, psi_l ** 2)])
                right.append(1 - (1 + m * (1 - y2)) / ratio)
    return fit(rows, right, 30)


def horner(coefficients, name):
    """c[0] + name (c[1] + name (c[2] + ...)), of texts."""
    text = coefficients[-1]
    for c in reversed(coefficients[:-1]):
        text = f"({c} + {name} * {text})"
    return text


def define(name, arguments, lines):
    print(f"#define {name}({arguments}) \\")
    print(" \\\n".join("    " + line for line in lines))


print("""/* SPDX-License-Identifier: Apache-2.0 */
/* Written by starts.py: do not edit. */
#ifndef PSC_SRC_STARTS_H
#define PSC_SRC_STARTS_H
""")
worst, x = lune_fit()
print(f"""/* Lunes: the two coefficients of the start, of share^2 and 1 - a1 (lune_map.h). The start is
   within {worst:.1e} of the distance from the tip. */""")
for k in range(2):
    c = dict(zip(LUNE_POWERS, x[15 * k:]))
    inner = [horner([f"{c[i, j]:.5f}" for j in range(5 - i)], "(e)") for i in range(5)]
    lines = [("(" if i < 4 else "") + inner[i] + (" + (s) *" if i < 4 else "))))")
             for i in range(5)]
    define(f"PSC_LUNE_{k}", "s, e", lines)
worst, x = kepler_fit()
print(f"""
/* Ellipse and lune: the coefficients of y^2, y^4 and y^6 in the start for Kepler's equation, of m
   and psi_l^2 (radial_map_tmpl.h). The start is within {worst:.1e}. */""")
for k in range(3):
    one, m, z = x[3 * k:3 * k + 3]
    define(f"PSC_KEPLER_{k}", "m, z", [f"(({one:.5f} + (m) * {m:.5f}) + (z) * {z:.5f})"])
print("""
#endif""")
