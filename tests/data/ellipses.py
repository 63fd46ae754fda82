#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ellipses.py DIRECTORY: writes ellipse_maps.csv and ellipsoid_maps.csv, reference values for
elliptical disks and ellipsoids that a receiver at the origin sees. Needs mpmath.

From definitions alone. Forms and axes at 60 digits, integrals at 40. Which directions hit a light is a quadratic form: for a flat
one from its own coordinates, for an ellipsoid the discriminant of the ray. Its eigenvectors are the
axes of the cone. The solid angle is an integral over azimuths, and the maps are equations 6, 15
and 22 of [GUK17], with integrals by the tanh-sinh rule. Every total is computed a second time, as
an integral along the outline about another axis.

The x axis of a cone has no sign, so that (e1 + 1/2) and e1 are equally right: what is written is
for the x axis with a positive largest component.
"""
import pathlib
import random
import sys

from mpmath import atan, cos, eigsy, matrix, mp, mpf, nstr, pi, quad, sin, sqrt, tan

mp.dps = 60
QUADRATURE = 40  # digits of integrals


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = sqrt(dot(a, a))
    return [x / length for x in a]


def columns(*vectors):
    return matrix([[v[i] for v in vectors] for i in range(3)])


class Cone:
    """The directions w with w' form w >= 0 on the side of `towards`."""

    def __init__(self, form, towards):
        values, vectors = eigsy(form)
        order = sorted(range(3), key=lambda i: values[i], reverse=True)
        axis = [[vectors[i, k] for i in range(3)] for k in order]
        # one positive, along the axis; of the others the one nearer to 0 is the long semi-arc
        self.z, self.x = axis[0], axis[1]
        if dot(self.z, towards) < 0:
            self.z = [-c for c in self.z]
        if max(self.x, key=abs) < 0:
            self.x = [-c for c in self.x]
        self.y = cross(self.z, self.x)
        values = [values[k] for k in order]
        assert values[0] > 0 > values[1] >= values[2]
        self.p, self.q = -values[1] / values[0], -values[2] / values[0]  # 1 / tan^2

    def versine(self, phi):
        """1 - h of the outline at an azimuth."""
        t = 1 / (self.p * cos(phi) ** 2 + self.q * sin(phi) ** 2)  # tan^2
        root = sqrt(1 + t)
        return t / (root * (1 + root))

    def integral(self, f, high):
        """From 0; everything happens near 0, within an angle of the aspect, or near high."""
        aspect = sqrt(self.p / self.q)
        cuts = [mpf(0)]
        step = aspect / 8
        while step < high / 2:
            cuts.append(step)
            step *= 4
        with mp.workdps(QUADRATURE):
            return quad(f, cuts + [high / 2, high])

    def total(self):
        return 4 * self.integral(self.versine, pi / 2)

    def solve(self, f, share, high, guess):
        """The x with the share of the integral of f up to high, f > 0: Newton's steps in bounds."""
        low, x, end = mpf(0), guess, high
        off = self.integral(f, x) - share * self.integral(f, high)
        for _ in range(200):
            low, end = (low, x) if off > 0 else (x, end)
            new = x - off / f(x)
            if not low < new < end:
                new = sqrt(low * end) if low > 0 and end > 100 * low else (low + end) / 2
            if abs(new - x) <= abs(x) * mpf(10) ** -25:
                return new
            near = abs(new - x) < min(x, high - x) / 4
            with mp.workdps(QUADRATURE):
                more = quad(f, [x, new]) if near else self.integral(f, new) - self.integral(f, x)
            off += more
            x = new
        raise ArithmeticError('no solution')

    def direction(self, x, y, z):
        return [x * a + y * b + z * c for a, b, c in zip(self.x, self.y, self.z)]

    def radial(self, turn, e2):
        quarter = int(4 * turn) % 4
        t = 4 * turn - quarter
        t = 1 - t if quarter % 2 else t
        guess = atan(sqrt(self.p / self.q) * tan(t * pi / 2))
        phi = self.solve(self.versine, t, pi / 2, guess) if 0 < t < 1 else t * pi / 2
        omh = (1 - e2) * self.versine(phi)
        r = sqrt(omh * (2 - omh))
        x, y = r * cos(phi), r * sin(phi)
        return self.direction(-x if quarter in (1, 2) else x, -y if quarter > 1 else y, 1 - omh)

    def concentric(self, e1, e2):
        """[SC97], then the radial map with e2 = 1 - r^2."""
        a, b = 2 * e1 - 1, 2 * e2 - 1
        if abs(a) > abs(b):
            r, theta = a, pi / 4 * b / a
        else:
            r, theta = b, (pi / 2 - pi / 4 * a / b if b else mpf(0))
        if r < 0:
            r, theta = -r, theta + pi
        return self.radial((theta / (2 * pi)) % 1, 1 - r * r)

    def half(self, phi):
        """Half a chord, in the plane through the x axis at an angle to the z axis."""
        t = max((cos(phi) ** 2 - self.q * sin(phi) ** 2) / self.p, mpf(0))
        return sqrt(t / (1 + t))

    def parallel(self, e1, e2):
        beta = atan(1 / sqrt(self.q))
        # from the end, where the chords vanish like a root
        share = 2 * min(e1, 1 - e1)
        rest = self.solve(lambda s: self.half(beta - s), share, beta, share * beta)
        phi = beta - rest
        x = (2 * e2 - 1) * self.half(phi)
        rho = sqrt(1 - x * x)
        return self.direction(x, rho * (sin(phi) if e1 > 0.5 else -sin(phi)), rho * cos(phi))


def nearest(points):
    """Where the curve comes closest to the origin."""
    def off(t):
        return dot(points(t)[0], points(t)[0])

    at, step = mpf(0), pi / 200
    at = min((k * step for k in range(400)), key=off)
    while step > mpf(10) ** -12:
        step /= 2
        at = min((at - step, at, at + step), key=off)
    return at


def cuts_about(t):
    """Once around, smaller and smaller towards t from both sides."""
    steps = [pi / 4 ** k for k in range(18)]
    return [t - s for s in steps] + [t] + [t + s for s in reversed(steps)]


def along_rim(points, axis):
    """The solid angle inside a closed curve about an axis inside, from its points and tangents."""
    def rate(t):
        p, d = points(t)
        length = sqrt(dot(p, p))
        around = cross(p, d)
        return dot(axis, around) / (length * (length + dot(axis, p)))

    with mp.workdps(QUADRATURE + 15):  # far away, all but the light's size cancels
        # the trapezoidal rule converges geometrically; close to the rim too slowly
        count, total = 32, mpf(0)
        while count <= 1024:
            before, count = total, 2 * count
            total = sum(rate(2 * pi * k / count) for k in range(count)) * 2 * pi / count
            if abs(total - before) < abs(total) * mpf(10) ** -23:
                return abs(total)
        return abs(quad(rate, cuts_about(nearest(points))))


def ellipse(c, u, v):
    w = columns(u, v, c) ** -1
    form = w.T * matrix([[-1, 0, 0], [0, -1, 0], [0, 0, 1]]) * w
    return Cone(form, c)


def rim(c, u, v):
    def points(t):
        return ([a + cos(t) * p + sin(t) * q for a, p, q in zip(c, u, v)],
                [cos(t) * q - sin(t) * p for p, q in zip(u, v)])
    return points


def ellipsoid(c, axes):
    e = columns(*axes) ** -1
    square = e.T * e
    middle = matrix(c)
    qc = square * middle
    power = (middle.T * qc)[0] - 1
    return Cone(qc * qc.T - power * square, c)


def outline(cone):
    """The outline of a cone, in a plane across its axis, for along_rim()."""
    a, b = 1 / sqrt(cone.p), 1 / sqrt(cone.q)

    def points(t):
        return (cone.direction(a * cos(t), b * sin(t), 1),
                cone.direction(-a * sin(t), b * cos(t), 0))
    return points


def exact(vectors):
    """Rounded to double, which is what the files hold."""
    return [[mpf(float(x)) for x in v] for v in vectors]


def digits(x):
    return nstr(mpf(x), 20, min_fixed=-4, max_fixed=4)


def double(x):
    return repr(float(x))


class Source:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def direction(self):
        return unit([mpf(self.random.gauss(0, 1)) for _ in range(3)])

    def across(self, n):
        while True:
            a = self.direction()
            a = cross(n, a)
            if dot(a, a) > 0.1:
                return unit(a)

    def log(self, low, high):
        return mpf(10) ** mpf(self.random.uniform(low, high))

    def coordinate(self):
        return mpf(float(self.random.uniform(0.02, 0.98)))


def conjugate(source, long, short, aspect):
    """Semi-axes of an ellipse, turned in its own parameter: not perpendicular."""
    t = mpf(source.random.uniform(0, 6.28))
    return ([cos(t) * a - aspect * sin(t) * b for a, b in zip(long, short)],
            [sin(t) * a + aspect * cos(t) * b for a, b in zip(long, short)])


def flat(source, kind):
    """Centre and semi-axes of an elliptical disk, from the origin."""
    n = source.direction()
    x = source.across(n)
    y = cross(n, x)
    aspect = mpf(source.random.uniform(0.1, 0.95))
    height, beside = source.log(-1, 0.7), source.log(-1, 0.7)
    if kind == 'far':
        height, beside = source.log(1, 8), source.log(1, 8)
    elif kind == 'grazing':
        height, beside = source.log(-8, -1), mpf(source.random.uniform(1.2, 5))
    elif kind == 'close':
        height, beside = source.log(-3, -1), mpf(source.random.uniform(0, 0.5)) * aspect
    elif kind == 'plane':
        height, beside = source.log(-8, -3), mpf(source.random.uniform(0, 0.5)) * aspect
    elif kind == 'rim':
        height = source.log(-6, -1)
    elif kind == 'thin':
        aspect = source.log(-8, -1)
    s, c = sin(source.random.uniform(0, 6.28)), cos(source.random.uniform(0, 6.28))
    if kind == 'rim':
        # from next to the rim: outside by about the height
        t = source.random.uniform(0, 6.28)
        gap = 1 + source.log(-6, -1)
        foot = [gap * (cos(t) * a + aspect * sin(t) * b) for a, b in zip(x, y)]
    else:
        foot = [beside * (c * a + s * b) for a, b in zip(x, y)]
    u, v = conjugate(source, x, y, aspect)
    return [height * a + b for a, b in zip(n, foot)], u, v


def solid(source, kind):
    x = source.direction()
    y = source.across(x)
    z = cross(x, y)
    sizes = [mpf(1), mpf(source.random.uniform(0.2, 0.95)), mpf(source.random.uniform(0.2, 0.95))]
    if kind == 'thin':
        sizes[1:] = [source.log(-4, -1), source.log(-4, -1)]
    frame = [[s * a for a in d] for s, d in zip(sizes, (x, y, z))]
    # any rotation of the unit sphere before: conjugate semi-axes that are not perpendicular
    f = source.direction()
    g = source.across(f)
    turn = [f, g, cross(f, g)]
    axes = [[sum(t[k] * frame[k][i] for k in range(3)) for i in range(3)] for t in turn]
    factor = 1 + source.log(-1, 1)
    if kind == 'far':
        factor = source.log(1, 8)
    elif kind == 'close':
        factor = 1 + source.log(-6, -1)
    elif kind == 'inside':
        factor = mpf(source.random.uniform(0, 0.9))
    d = source.direction()
    return [-factor * sum(d[k] * axes[k][i] for k in range(3)) for i in range(3)], axes


def around(e1, e2):
    """From inside: 1 - z is twice what is inside, and the parallel map goes around the x axis."""
    def polar(turn, rest):
        inner = 1 - rest
        r = 2 * sqrt(inner * rest)
        return [r * cos(2 * pi * turn), r * sin(2 * pi * turn), 1 - 2 * inner]

    class Square(Cone):
        def __init__(self):
            pass

        def radial(self, turn, rest):
            return polar(turn, rest)

    r = 2 * sqrt(e2 * (1 - e2))
    t = pi * (2 * e1 - 1)
    return (polar(e1, e2), [2 * e2 - 1, r * sin(t), r * cos(t)],
            Square().concentric(e1, e2))


def same(a, b):
    assert abs(a / b - 1) < mpf(10) ** -21, (a, b)


def write(path, header, rows):
    path.write_text('\n'.join([header, *rows]) + '\n')


def flat_row(source, kind):
    c, u, v = exact(flat(source, kind))
    cone = ellipse(c, u, v)
    e1, e2 = source.coordinate(), source.coordinate()
    total = cone.total()
    same(total, along_rim(rim(c, u, v), unit(c)))
    inverse = columns(u, v, c) ** -1
    numbers = []
    for w in (cone.radial(e1, e2), cone.parallel(e1, e2), cone.concentric(e1, e2)):
        s, t, k = inverse * matrix(w)
        numbers += [s / k, t / k]
    return ','.join([kind] + [double(x) for x in c + u + v + [e1, e2]]
                    + [digits(x) for x in numbers + [total]])


def solid_row(source, kind):
    c, axes = solid(source, kind)
    c, *axes = exact([c, *axes])
    e1, e2 = source.coordinate(), source.coordinate()
    if kind == 'inside':
        maps, total = around(e1, e2), 4 * pi
    else:
        cone = ellipsoid(c, axes)
        maps = cone.radial(e1, e2), cone.parallel(e1, e2), cone.concentric(e1, e2)
        total = cone.total()
        same(total, along_rim(outline(cone), unit(c)))
    numbers = [x for w in maps for x in w]
    return ','.join([kind] + [double(x) for x in c + axes[0] + axes[1] + axes[2] + [e1, e2]]
                    + [digits(x) for x in numbers + [total]])


def main():
    folder = pathlib.Path(sys.argv[1])
    names = [f'{m}_{c}' for m in ('radial', 'parallel', 'concentric') for c in 'xyz']
    write(folder / 'ellipse_maps.csv',
          'kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,e1,e2,radial_s,radial_t,parallel_s,parallel_t,'
          'concentric_s,concentric_t,solid_angle',
          [flat_row(Source(f'{kind} {i}'), kind)
           for kind in ('mid', 'far', 'grazing', 'close', 'rim', 'thin') for i in range(10)])
    write(folder / 'ellipsoid_maps.csv',
          'kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,wx,wy,wz,e1,e2,' + ','.join(names) + ',solid_angle',
          [solid_row(Source(f'{kind} {i}'), kind)
           for kind in ('mid', 'far', 'close', 'thin', 'inside') for i in range(10)])


if __name__ == '__main__':
    main()
