#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ellipses_projected.py DIRECTORY: writes ellipse_projected_solid_angle.csv and
ellipsoid_projected_solid_angle.csv, reference values for elliptical disks and ellipsoids that a
one-sided receiver at the origin sees. Needs mpmath.

Projected solid angle is half the integral of N.(p x dp) / |p|^2 around the part of the light above
the horizon (Lambert): along the light's own outline, and back along the horizon, where it is the
angle between the two ends. Every value is computed a second time along the outline of the cone,
which follows from the quadratic form of the directions that hit, and a third time as an integral
of sin^2 over azimuths about N, with the roots of that form.
"""
import pathlib
import sys

from mpmath import acos, atan2, cos, matrix, mp, mpf, pi, quad, sin, sqrt

from ellipses import (Source, columns, cross, digits, dot, double, ellipse, ellipsoid,
                      exact, flat, nearest, outline, rim, same, solid, unit, write)


def tangents(c, axes):
    """The points of an ellipsoid that are seen edge-on: in its own coordinates, a circle."""
    e = columns(*axes)
    o = list(-(e ** -1 * matrix(c)))  # the receiver
    square = dot(o, o)
    least = min(range(3), key=lambda i: abs(o[i]))
    f = unit(cross(o, [mpf(i == least) for i in range(3)]))
    g = unit(cross(o, f))
    r = sqrt(1 - 1 / square)

    def points(t):
        x = [a / square + r * (cos(t) * p + sin(t) * q) for a, p, q in zip(o, f, g)]
        d = [r * (cos(t) * q - sin(t) * p) for p, q in zip(f, g)]
        return [a + b for a, b in zip(c, e * matrix(x))], list(e * matrix(d))
    return points


def along(points, n):
    """Along a closed curve p(t), an ellipse in its plane, as far as it is above the horizon."""
    # N.p = m + r cos(t - t0)
    at, quarter, half = (dot(n, points(t)[0]) for t in (mpf(0), pi / 2, pi))
    m = (at + half) / 2
    x, y = at - m, quarter - m
    r, t0 = sqrt(x * x + y * y), atan2(y, x)
    if m <= -r:
        return mpf(0)

    def rate(t):
        p, d = points(t)
        return dot(n, cross(p, d)) / dot(p, p)

    # once around, and the outline of a wide cone comes near twice
    width = pi if m >= r else acos(-m / r)
    low, high = t0 - width, t0 + width
    near = nearest(points)
    steps = [mpf(0)] + [s * pi / 4 ** k for k in range(12) for s in (-1, 1)]
    cuts = [near + s + pi * k for s in steps for k in range(-4, 5)]
    cuts = [low] + sorted(t for t in set(cuts) if low < t < high) + [high]
    total = quad(rate, cuts)
    if m < r:
        p, q = points(high)[0], points(low)[0]
        total += atan2(dot(n, cross(p, q)), dot(p, q))
    return abs(total) / 2


def angles_of(a, b, c):
    """The t in [0, 2 pi) with a cos^2 t + 2 b cos t sin t + c sin^2 t = 0."""
    # m + r cos(2 t - u)
    m, x = (a + c) / 2, (a - c) / 2
    r, u = sqrt(x * x + b * b), atan2(b, x)
    if abs(m) >= r:
        return []
    w = acos(-m / r)
    return [((u + s * w) / 2 + k * pi) % (2 * pi) for s in (-1, 1) for k in (0, 1)]


def about(form, z, n):
    """By azimuths about N: half the integral of sin^2 between the roots of the form."""
    least = min(range(3), key=lambda i: abs(n[i]))
    f = unit(cross(n, [mpf(i == least) for i in range(3)]))
    g = cross(n, f)

    def product(p, q):
        return (matrix(p).T * form * matrix(q))[0]

    nn, nf, ng = product(n, n), product(n, f), product(n, g)
    ff, fg, gg = product(f, f), product(f, g), product(g, g)

    def inside(phi, t):
        w = [sin(t) * (cos(phi) * a + sin(phi) * b) + cos(t) * c for a, b, c in zip(f, g, n)]
        return product(w, w) > 0 and dot(w, z) > 0

    def rate(phi):
        c, s = cos(phi), sin(phi)
        b, a = c * nf + s * ng, c * c * ff + 2 * c * s * fg + s * s * gg
        square = b * b - a * nn
        ends = [mpf(0), pi / 2]
        if square > 0:
            root = sqrt(square)
            # tan t of the zeros of nn + 2 b tan t + a tan^2 t
            big = -b - root if b > 0 else -b + root
            for y, x in ((big, a), (nn, big)):
                t = atan2(y if x > 0 else -y, abs(x))
                if 0 < t < pi / 2:
                    ends.append(t)
        ends.sort()
        return sum(sin(q) ** 2 - sin(p) ** 2 for p, q in zip(ends, ends[1:])
                   if inside(phi, (p + q) / 2))

    cuts = sorted(set(angles_of(nf * nf - ff * nn, nf * ng - fg * nn, ng * ng - gg * nn)
                      + angles_of(ff, fg, gg)))
    cuts = cuts + [cuts[0] + 2 * pi] if cuts else [mpf(0), pi / 2, pi, 3 * pi / 2, 2 * pi]
    with mp.workdps(30):
        return quad(rate, cuts, maxdegree=12) / 2


def receiver(source, how, cone):
    """A normal for which the light is above the horizon, cut by it, hardly there or hardly cut."""
    a, b = sqrt(cone.p), sqrt(cone.q)  # inverse tangents
    t = mpf(source.random.uniform(0, 6.28))
    side = cone.direction(cos(t), sin(t), 0)
    # N = z cos h + side sin h: visible if |tan h| <= 1 / sqrt((cos t / a)^2 + (sin t / b)^2)
    reach = 1 / sqrt((cos(t) / a) ** 2 + (sin(t) / b) ** 2)  # of tan(horizon - axis)
    if how == 'above':
        share = 1 + source.log(-1, 1)
    elif how == 'cut':
        share = mpf(source.random.uniform(-0.9, 0.9))
    elif how == 'low':
        share = -1 + source.log(-6, -1)
    else:
        share = 1 - source.log(-9, -2)
    return unit([share * p + reach * q for p, q in zip(cone.z, side)])


HOW = ('above', 'cut', 'cut', 'low', 'touch')


def row(kind, numbers, curve, cone, form, n):
    n = exact([n])[0]
    length = unit(n)
    first = along(curve, length)
    same(first, along(outline(cone), length))
    third = about(form, cone.z, length)
    size = pi / sqrt((1 + cone.p) * (1 + cone.q))  # the light's, in this measure
    assert abs(third - first) < mpf(10) ** -12 * size, (kind, first, third)
    return ','.join([kind] + [double(x) for x in numbers + n] + [digits(first)])


def flat_rows(kind, count):
    for i in range(count):
        source = Source(f'projected {kind} {i}')
        c, u, v = flat(source, kind if kind != 'needle' else 'mid')
        if kind == 'needle':
            n = unit(cross(u, v))
            y = cross(n, unit(u))
            v = [mpf(10) ** -4 * a for a in y]
        c, u, v = exact([c, u, v])
        cone = ellipse(c, u, v)
        w = columns(u, v, c) ** -1
        form = w.T * matrix([[-1, 0, 0], [0, -1, 0], [0, 0, 1]]) * w
        n = receiver(source, HOW[i % len(HOW)], cone)
        yield row(f'{kind} {HOW[i % len(HOW)]}', c + u + v, rim(c, u, v), cone, form, n)


def solid_rows(kind, count):
    for i in range(count):
        source = Source(f'projected solid {kind} {i}')
        c, axes = solid(source, kind)
        c, *axes = exact([c, *axes])
        numbers = c + axes[0] + axes[1] + axes[2]
        if kind == 'inside':
            n = exact([source.direction()])[0]
            yield ','.join([kind] + [double(x) for x in numbers + n] + [digits(pi)])
            continue
        cone = ellipsoid(c, axes)
        e = columns(*axes) ** -1
        square = e.T * e
        qc = square * matrix(c)
        form = qc * qc.T - ((matrix(c).T * qc)[0] - 1) * square
        n = receiver(source, HOW[i % len(HOW)], cone)
        yield row(f'{kind} {HOW[i % len(HOW)]}', numbers, tangents(c, axes), cone, form, n)


def main():
    folder = pathlib.Path(sys.argv[1])
    write(folder / 'ellipse_projected_solid_angle.csv',
          'kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,Nx,Ny,Nz,projected_solid_angle',
          [r for kind, count in (('mid', 10), ('far', 10), ('grazing', 10), ('close', 10),
                                 ('plane', 5), ('rim', 10), ('needle', 5))
           for r in flat_rows(kind, count)])
    write(folder / 'ellipsoid_projected_solid_angle.csv',
          'kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,wx,wy,wz,Nx,Ny,Nz,projected_solid_angle',
          [r for kind, count in (('mid', 10), ('far', 10), ('close', 10), ('thin', 10),
                                 ('inside', 3))
           for r in solid_rows(kind, count)])


if __name__ == '__main__':
    main()
