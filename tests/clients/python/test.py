#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test.py LIBRARY: what the Python client gets from the library."""
import math
import sys

import numpy

import psc

count = failures = 0


def check(name, ok):
    global count, failures
    count += 1
    failures += not ok
    print(f"{'ok' if ok else 'not ok'} {count} - {name}")


library = psc.Library(sys.argv[1])
sampler = library.sampler()
sphere = psc.Sphere((0.3, -0.2, 2), 0.5)
origin, up = (0, 0, 0), (0, 0, 1)

# One sample.
check('an empty sampler gives nothing', sampler.sample(0.5, 0.5) is None and sampler.total() == 0)
check('builds', sampler.build(sphere, origin, up, psc.PROJECTED_SOLID_ANGLE, psc.PARALLEL))
s = sampler.sample(0.25, 0.75)
distance = math.dist(sphere.center, origin)
exact = math.pi * (sphere.radius / distance) ** 2 * sphere.center[2] / distance
check('the weight of a sphere above the horizon', abs(s.weight / exact - 1) < 1e-14)
check('the point is on the light', abs(math.dist(s.point, sphere.center) / 0.5 - 1) < 1e-14)
check('pdf of the sample', abs(sampler.pdf(s.direction) / s.pdf - 1) < 1e-12)
check('inverse of the sample', math.dist(sampler.invert(s.direction), (0.25, 0.75)) < 1e-12)
check('below the horizon', not sampler.build(sphere, origin, (0, 0, -1), psc.PROJECTED_SOLID_ANGLE)
      and sampler.sample(0.5, 0.5) is None)
try:
    sampler.build(psc.Sphere((math.nan, 0, 1), 1), origin)
    words = ''
except psc.Error as error:
    words = str(error)
check(f'errors are exceptions: {words}', 'NaN' in words)

# Ten million samples, in arrays of records that nobody copies.
n = 10_000_000
rng = numpy.random.default_rng(1)
record = numpy.zeros(n, [('uv', 'f4', 2), ('weight', 'f4'), ('direction', 'f4', 3)])
record['uv'][:, 0] = rng.random(n, 'f4')
record['uv'][:, 1] = rng.random(n, 'f4')
sampler.build(sphere, origin, up, psc.SOLID_ANGLE, psc.CONCENTRIC)
status = sampler.sample_n(record['uv'], weight=record['weight'], direction=record['direction'])
check('ten million samples in records', status == psc.SUCCESS)
error = record['weight'].std(dtype='f8') / math.sqrt(n)
check('their mean is the projected solid angle',
      abs(record['weight'].mean(dtype='f8') - exact) < 5 * error and error < 1e-4 * exact)
weight = numpy.empty(n, 'f4')
direction = numpy.empty((3, n), 'f4')
sampler.sample_n(record['uv'], weight=weight, direction=direction.T)
check('separate arrays by component hold the same bits',
      (weight == record['weight']).all() and (direction.T == record['direction']).all())

# Strided views: backwards, every second element, columns.
uv = rng.random((1000, 2))
weight = numpy.empty(1000)
sampler.sample_n(uv, weight=weight)
sparse = numpy.full((2000, 5), -1.0)
sampler.sample_n(uv[::-1], weight=sparse[::2, 3])
check('backwards into a column', (sparse[::2, 3] == weight[::-1]).all()
      and (sparse[1::2] == -1).all() and (numpy.delete(sparse, 3, 1) == -1).all())
directions, pdf, back = numpy.empty((1000, 3)), numpy.empty(1000), numpy.empty(1000)
sampler.sample_n(uv, direction=directions, pdf=pdf)
sampler.pdf_n(directions, back)
check('densities of an array', numpy.allclose(pdf, back, rtol=1e-10, atol=0))
for wrong in uv.astype('f4'), numpy.broadcast_to(0.0, 1000), numpy.empty(999):
    try:
        sampler.sample_n(uv, weight=wrong)
        refused = False
    except ValueError:
        refused = True
    check(f'an output of {wrong.dtype}, {wrong.shape} is refused', refused)

# Every shape: single calls, totals, arrays, and wavefronts, culled and empty elements included.
lights = [
    sphere, psc.Cap((0.3, -0.2, 1), 0.7), psc.Disk((0.3, -0.2, 1), (1, 0.5, 0.5), 0.75),
    psc.Ellipse((0.3, -0.2, 1), (0.5, 0, 0.25), (0, 1, 0)),
    psc.Ellipsoid((0.3, -0.2, 1), (0.5, 0, 0.25), (0, 1, 0), (-0.25, 0, 0.5)),
    psc.Triangle((0.5, 0, 1), (1, 0.5, 1), (0, 1, -0.5)),
    psc.Rectangle((0.5, 0, 1), (1, 0, 0.5), (0, 0.5, 0)),
    psc.Polygon(((0, 0, 1), (1, 0, 1), (1.5, 1, 1), (0.5, 2, 1), (-0.5, 1, 1))),
]
position = rng.uniform(-3, 3, (1000, 3))
normal = rng.normal(size=(1000, 3))
again, status = numpy.empty((1000, 2)), numpy.empty(1000, 'i4')
for shape, light in enumerate(lights, 1):
    name = type(light).__name__
    sampler.build(light, origin, up, map=psc.RADIAL)
    s = sampler.sample(0.25, 0.75)
    ok = sampler.describe().shape == shape and abs(sampler.pdf(s.direction) / s.pdf - 1) < 1e-9
    ok &= math.dist(sampler.invert(s.direction), (0.25, 0.75)) < 1e-9
    ok &= abs(library.solid_angle(light, origin) / sampler.total() - 1) < 1e-12
    if shape <= 5:
        ok &= abs(library.form_factor(light, origin, up) / sampler.form_factor() - 1) < 1e-12
    ok &= abs(sampler.solid_angle() / sampler.total() - 1) < 1e-15
    sampler.sample_n(uv, direction=directions)
    ok &= sampler.invert_n(directions, again, status) == psc.SUCCESS
    ok &= (status == psc.SUCCESS).all() and numpy.allclose(again, uv, rtol=0, atol=1e-9)
    check(f'{name}: a sample, its density and inverse, totals', ok)

    # One light for all receivers; then one for each, in float.
    weight[:] = -1
    result = library.sample_n(light, uv, position, normal, weight=weight, status=status)
    ok = result == psc.SUCCESS and {psc.SUCCESS, psc.CULLED} <= set(status)
    for i in range(0, 1000, 7):
        sampler.build(light, position[i], normal[i])
        one = sampler.sample(*uv[i])
        ok &= weight[i] == (-1 if one is None else one.weight)
    check(f'{name}: a wavefront gives what single calls give', ok)
    sizes = 2.0 ** rng.integers(-1, 2, 1000)
    many = type(light)(*(numpy.multiply.outer(sizes, part).astype('f4') for part in light))
    points, normals, square = (array.astype('f4') for array in (position, normal, uv))
    found, one = numpy.full(1000, -1, 'f4'), numpy.empty(1, 'f4')
    ok = library.sample_n(many, square, points, normals, weight=found) == psc.SUCCESS
    for i in range(0, 1000, 7):
        sampler.build(type(light)(*(part[i].tolist() for part in many)), points[i], normals[i])
        one[:] = -1
        sampler.sample_n(square[i:i + 1], weight=one)
        ok &= found[i] == one[0]
    check(f'{name}: a wavefront of many lights, in float', ok)

# The map that needs a table, which the sampler keeps alive.
disk = lights[2]
mean = {}
for how in {'map': psc.RADIAL}, {'map': psc.TABULATED, 'table': library.table(256)}:
    sampler.build(disk, origin, up, **how)
    sampler.sample_n(uv, weight=weight, status=status)
    mean[how['map']] = numpy.where(status == psc.SUCCESS, weight, 0).mean()
check('the tabulated map', abs(mean[psc.TABULATED] / mean[psc.RADIAL] - 1) < 0.05)
try:
    library.table(1)
    words = ''
except psc.Error as error:
    words = str(error)
check(f'a table without rows: {words}', 'resolution' in words)

print(f'1..{count}')
sys.exit(failures != 0)
