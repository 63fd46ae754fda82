# SPDX-License-Identifier: Apache-2.0
"""libpsc for Python: ctypes and numpy, without copies.

    library = psc.Library('libpsc.so.0')
    sampler = library.sampler()
    if sampler.build(psc.Sphere((2, 1, 0.5), 0.75), position=(0, 0, 0), normal=(0, 0, 1),
                     measure=psc.PROJECTED_SOLID_ANGLE):
        s = sampler.sample(0.25, 0.75)
        sampler.sample_n(uv, direction=directions, weight=weights)   # arrays, filled in place
    library.sample_n(psc.Disk(center, normals, radii), uv, positions, normals, weight=weights)

Arrays are of float32 or float64, all of one kind; pairs and vectors have a last axis of 2 or 3.
Any strides will do, numpy's broadcasting (strides of 0) included.
"""
import collections
import ctypes

import numpy

SOLID_ANGLE, PROJECTED_SOLID_ANGLE, AREA, VISIBLE_AREA = range(4)
RADIAL, PARALLEL, CONCENTRIC, QUASI_UNIFORM, TABULATED = range(5)
ONE_SIDED = 1  # of a light
TWO_SIDED = 1  # of a receiver
SUCCESS, EMPTY, CULLED, OUTSIDE = range(4)

# Lights, in the order of their build calls; for a wavefront each part may be an array of them.
Sphere = collections.namedtuple('Sphere', 'center radius')
Cap = collections.namedtuple('Cap', 'axis half_angle')
Disk = collections.namedtuple('Disk', 'center normal radius')
Ellipse = collections.namedtuple('Ellipse', 'center axis_u axis_v')
Ellipsoid = collections.namedtuple('Ellipsoid', 'center axis_u axis_v axis_w')
Triangle = collections.namedtuple('Triangle', 'v0 v1 v2')
Rectangle = collections.namedtuple('Rectangle', 'corner edge_u edge_v')
Polygon = collections.namedtuple('Polygon', 'vertices')  # an array with axes vertex, coordinate
SCALARS = {'radius', 'half_angle'}

Vector = ctypes.c_double * 3
Pair = ctypes.c_double * 2


class Error(Exception):
    """An error that the library returned, in its words; result is its number."""

    def __init__(self, result, words):
        super().__init__(words)
        self.result = result


class Technique(ctypes.Structure):
    _fields_ = [('struct_size', ctypes.c_uint32), ('measure', ctypes.c_uint32),
                ('map', ctypes.c_uint32), ('flags', ctypes.c_uint32),
                ('table', ctypes.c_void_p)]


class Receiver(ctypes.Structure):
    _fields_ = [('struct_size', ctypes.c_uint32), ('flags', ctypes.c_uint32),
                ('position', ctypes.POINTER(ctypes.c_double)),
                ('normal', ctypes.POINTER(ctypes.c_double))]


class Sample(ctypes.Structure):
    """One sampled point of a light; psc_light_sample_f64."""
    _fields_ = [('direction', Vector), ('pdf', ctypes.c_double), ('point', Vector),
                ('distance', ctypes.c_double), ('normal', Vector), ('weight', ctypes.c_double),
                ('surface', Pair)]


class View(ctypes.Structure):
    """psc_input_*, psc_output_* and, of its first component alone, psc_output_result."""
    _fields_ = [('component', ctypes.c_void_p * 3), ('stride', ctypes.c_ssize_t)]


class Statuses(ctypes.Structure):
    _fields_ = [('data', ctypes.c_void_p), ('stride', ctypes.c_ssize_t)]


class Samples(ctypes.Structure):
    _fields_ = [('struct_size', ctypes.c_uint32), ('reserved', ctypes.c_uint32)] + [
        (name, View) for name in ('direction', 'pdf', 'point', 'distance', 'normal', 'weight',
                                  'surface')] + [('status', Statuses)]


class Receivers(ctypes.Structure):
    _fields_ = [('struct_size', ctypes.c_uint32), ('flags', ctypes.c_uint32),
                ('position', View), ('normal', View)]


class Description(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint32) for name in ('struct_size', 'shape', 'measure', 'map',
                                                     'visibility', 'reserved')]


WIDTHS = {'direction': 3, 'pdf': 1, 'point': 3, 'distance': 1, 'normal': 3, 'weight': 1,
          'surface': 2}


def view(array, count, width, dtype, written=False):
    """Where the library finds the numbers of an array."""
    shape = (count,) if width == 1 else (count, width)
    if array.dtype != dtype or not array.flags.aligned or written and not array.flags.writeable:
        raise ValueError(f'not an array of {numpy.dtype(dtype).name}, aligned'
                         + ' and writable' * written)
    if array.shape != shape:
        raise ValueError(f'the shape is {array.shape}, not {shape}')
    first = array.__array_interface__['data'][0]
    step = array.strides[1] if width > 1 else 0
    return View((ctypes.c_void_p * 3)(*(first + k * step for k in range(width))),
                array.strides[0])


def parts(light):
    """The numbers of one light as its build call takes them."""
    if isinstance(light, Polygon):
        vertices = numpy.ascontiguousarray(light.vertices, 'f8')
        return (ctypes.c_size_t(len(vertices)),
                vertices.ctypes.data_as(ctypes.POINTER(ctypes.c_double)),
                ctypes.c_ssize_t(vertices.strides[0]))
    return tuple(ctypes.c_double(part) if name in SCALARS else Vector(*part)
                 for name, part in zip(light._fields, light))


def as_array(part, dtype):
    """An array as it is, or one of the numbers given; to be kept while the library reads it."""
    return part if isinstance(part, numpy.ndarray) else numpy.array(part, dtype)


def spread(array, count, width, dtype):
    """The view of an array, or of one value for every element."""
    return view(numpy.broadcast_to(array, (count,) if width == 1 else (count, width)), count,
                width, dtype)


def wavefront_parts(light, count, dtype):
    """The numbers of many lights, all of them arrays, as their wavefront call takes them."""
    if isinstance(light, Polygon):
        n = light.vertices.shape[-2]
        return ctypes.c_size_t(n), (View * n)(*(spread(light.vertices[..., k, :], count, 3, dtype)
                                                for k in range(n)))
    return tuple(ctypes.byref(spread(part, count, 1 if name in SCALARS else 3, dtype))
                 for name, part in zip(light._fields, light))


def samples(count, dtype, outputs):
    """Where the library puts what is wanted: arrays by the names of a sample's fields."""
    out = Samples(struct_size=ctypes.sizeof(Samples))
    for name, array in outputs.items():
        if name == 'status':
            v = view(array, count, 1, numpy.int32, True)
            out.status = Statuses(v.component[0], v.stride)
        else:
            setattr(out, name, view(array, count, WIDTHS[name], dtype, True))
    return out


def technique(measure, map, one_sided, table):
    return Technique(ctypes.sizeof(Technique), measure, map, ONE_SIDED * one_sided,
                     table and table.address)


def receiver(position, normal, two_sided):
    return Receiver(ctypes.sizeof(Receiver), TWO_SIDED * two_sided, Vector(*position),
                    None if normal is None else Vector(*normal))


def suffix(dtype):
    return {numpy.dtype('f4'): 'f32', numpy.dtype('f8'): 'f64'}[numpy.dtype(dtype)]


class Library:
    """The library, loaded from a path or by its soname."""

    def __init__(self, path='libpsc.so.0'):
        self.calls = ctypes.CDLL(path)
        self.calls.psc_result_string.restype = ctypes.c_char_p
        self.calls.psc_version.restype = ctypes.c_uint32
        self.calls.psc_sampler_destroy.restype = None
        self.calls.psc_table_size.restype = ctypes.c_size_t

    def check(self, result):
        """Raises what is an error; returns the status."""
        if result < 0:
            raise Error(result, self.calls.psc_result_string(result).decode())
        return result

    def sampler(self):
        return Sampler(self)

    def table(self, resolution):
        """What the tabulated map looks up."""
        return Table(self, resolution)

    def function(self, light, name):
        return getattr(self.calls, f'psc_{type(light).__name__.lower()}_{name}')

    def number(self, call, *arguments):
        """The double that a call gives."""
        out = ctypes.c_double()
        self.check(call(*arguments, ctypes.byref(out)))
        return out.value

    def solid_angle(self, light, position):
        """Without a sampler; a distant light has the same from everywhere."""
        call = self.function(light, 'solid_angle')
        if isinstance(light, Cap):
            return self.number(call, ctypes.c_double(light.half_angle))
        return self.number(call, Vector(*position), *parts(light))

    def form_factor(self, light, position, normal, two_sided_receiver=False):
        """Without a sampler; not of polygons."""
        return self.number(self.function(light, 'form_factor'),
                           ctypes.byref(receiver(position, normal, two_sided_receiver)),
                           *parts(light))

    def sample_n(self, light, uv, position, normal=None, measure=SOLID_ANGLE, map=RADIAL,
                 one_sided=False, two_sided_receivers=False, table=None, **outputs):
        """One build and one sample for each element; without a normal, of points in a volume."""
        count, dtype = len(uv), uv.dtype
        light = type(light)(*(as_array(part, dtype) for part in light))
        position = as_array(position, dtype)
        receivers = Receivers(ctypes.sizeof(Receivers), TWO_SIDED * two_sided_receivers,
                              spread(position, count, 3, dtype))
        if normal is not None:
            normal = as_array(normal, dtype)
            receivers.normal = spread(normal, count, 3, dtype)
        call = self.function(light, 'sample_n_' + suffix(dtype))
        return self.check(call(
            ctypes.byref(technique(measure, map, one_sided, table)), ctypes.c_size_t(count),
            ctypes.byref(receivers), *wavefront_parts(light, count, dtype),
            ctypes.byref(view(uv, count, 2, dtype)),
            ctypes.byref(samples(count, dtype, outputs))))


class Table:
    """Of the tabulated map, in memory of numpy's."""

    def __init__(self, library, resolution):
        size = library.calls.psc_table_size(ctypes.c_uint32(resolution))
        self.memory, self.address = numpy.empty(-(-size // 4), 'u4'), ctypes.c_void_p()
        library.check(library.calls.psc_table_init(
            ctypes.c_void_p(self.memory.ctypes.data), ctypes.c_size_t(size),
            ctypes.c_uint32(resolution), ctypes.byref(self.address)))


class Sampler:
    """A light seen from a receiver."""

    def __init__(self, library):
        self.handle = ctypes.c_void_p()
        self.library, self.calls = library, library.calls
        library.check(self.calls.psc_sampler_create(None, ctypes.byref(self.handle)))

    def __del__(self):
        self.calls.psc_sampler_destroy(self.handle)

    def build(self, light, position, normal=None, measure=SOLID_ANGLE, map=RADIAL, one_sided=False,
              two_sided_receiver=False, table=None):
        """Whether anything of the light can be seen."""
        self.table = table  # must live as long
        call = getattr(self.calls, 'psc_build_' + type(light).__name__.lower())
        return self.library.check(call(
            self.handle, ctypes.byref(technique(measure, map, one_sided, table)),
            ctypes.byref(receiver(position, normal, two_sided_receiver)), *parts(light))) == SUCCESS

    def describe(self):
        out = Description(struct_size=ctypes.sizeof(Description))
        self.library.check(self.calls.psc_sampler_describe(self.handle, ctypes.byref(out)))
        return out

    def sample(self, u, v):
        """A sample, or None if the light cannot be seen; of weight 0 if it is culled."""
        out = Sample()
        result = self.calls.psc_sample_f64(self.handle, ctypes.c_double(u), ctypes.c_double(v),
                                           ctypes.byref(out))
        return None if self.library.check(result) == EMPTY else out

    def pdf(self, direction):
        return self.library.number(self.calls.psc_pdf_f64, self.handle, Vector(*direction))

    def invert(self, direction):
        """The (u, v) of a direction, or None if the sampler cannot give it."""
        out = Pair()
        result = self.calls.psc_invert_f64(self.handle, Vector(*direction), out)
        return tuple(out) if self.library.check(result) == SUCCESS else None

    def total(self):
        return self.library.number(self.calls.psc_sampler_total, self.handle)

    def solid_angle(self):
        return self.library.number(self.calls.psc_sampler_solid_angle, self.handle)

    def projected_solid_angle(self):
        return self.library.number(self.calls.psc_sampler_projected_solid_angle, self.handle)

    def form_factor(self):
        return self.library.number(self.calls.psc_sampler_form_factor, self.handle)

    def area(self):
        return self.library.number(self.calls.psc_sampler_area, self.handle)

    def sample_n(self, uv, **outputs):
        """Fills arrays, named as the fields of a sample, and status."""
        call = getattr(self.calls, 'psc_sample_n_' + suffix(uv.dtype))
        return self.library.check(call(
            self.handle, ctypes.c_size_t(len(uv)), ctypes.byref(view(uv, len(uv), 2, uv.dtype)),
            ctypes.byref(samples(len(uv), uv.dtype, outputs))))

    def pdf_n(self, direction, pdf):
        dtype, count = direction.dtype, len(direction)
        call = getattr(self.calls, 'psc_pdf_n_' + suffix(dtype))
        return self.library.check(call(self.handle, ctypes.c_size_t(count),
                                       ctypes.byref(view(direction, count, 3, dtype)),
                                       ctypes.byref(view(pdf, count, 1, dtype, True))))

    def invert_n(self, direction, uv, status=None):
        dtype, count = direction.dtype, len(direction)
        call = getattr(self.calls, 'psc_invert_n_' + suffix(dtype))
        statuses = Statuses()
        if status is not None:
            v = view(status, count, 1, numpy.int32, True)
            statuses = Statuses(v.component[0], v.stride)
        return self.library.check(call(self.handle, ctypes.c_size_t(count),
                                       ctypes.byref(view(direction, count, 3, dtype)),
                                       ctypes.byref(view(uv, count, 2, dtype, True)),
                                       ctypes.byref(statuses)))
