# SPDX-License-Identifier: Apache-2.0
"""libpsc for Python: ctypes and numpy, without copies.

    library = psc.Library('libpsc.so.0')
    sampler = library.sampler()
    if sampler.build(psc.Sphere((2, 1, 0.5), 0.75), position=(0, 0, 0), normal=(0, 0, 1),
                     measure=psc.PROJECTED_SOLID_ANGLE):
        s = sampler.sample(0.25, 0.75)
        sampler.sample_n(uv, direction=directions, weight=weights)   # arrays, filled in place

Arrays are of float32 or float64, all of one kind; pairs and vectors have a last axis of 2 or 3.
Any strides will do, numpy's broadcasting (strides of 0) included.
"""
import collections
import ctypes

import numpy

SOLID_ANGLE, PROJECTED_SOLID_ANGLE, AREA, VISIBLE_AREA = range(4)
RADIAL, PARALLEL, CONCENTRIC, QUASI_UNIFORM = range(4)
ONE_SIDED = 1  # of a light
TWO_SIDED = 1  # of a receiver
SUCCESS, EMPTY, CULLED, OUTSIDE = range(4)

Sphere = collections.namedtuple('Sphere', 'center radius')
Cap = collections.namedtuple('Cap', 'axis half_angle')

Vector = ctypes.c_double * 3
Pair = ctypes.c_double * 2


class Error(Exception):
    """An error that the library returned, in its words; result is its number."""

    def __init__(self, result, words):
        super().__init__(words)
        self.result = result


class Technique(ctypes.Structure):
    _fields_ = [('struct_size', ctypes.c_uint32), ('measure', ctypes.c_uint32),
                ('map', ctypes.c_uint32), ('flags', ctypes.c_uint32)]


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


def suffix(dtype):
    return {numpy.dtype('f4'): 'f32', numpy.dtype('f8'): 'f64'}[numpy.dtype(dtype)]


class Library:
    """The library, loaded from a path or by its soname."""

    def __init__(self, path='libpsc.so.0'):
        self.calls = ctypes.CDLL(path)
        self.calls.psc_result_string.restype = ctypes.c_char_p
        self.calls.psc_version.restype = ctypes.c_uint32
        self.calls.psc_sampler_destroy.restype = None

    def check(self, result):
        """Raises what is an error; returns the status."""
        if result < 0:
            raise Error(result, self.calls.psc_result_string(result).decode())
        return result

    def sampler(self):
        return Sampler(self)

    def sphere_sample_n(self, position, normal, center, radius, uv, measure=SOLID_ANGLE,
                        map=RADIAL, flags=0, **outputs):
        """One build and one sample for each element; a normal of None is a point in a volume."""
        count, dtype = len(uv), uv.dtype
        technique = Technique(ctypes.sizeof(Technique), measure, map, flags)
        receivers = Receivers(struct_size=ctypes.sizeof(Receivers),
                              position=view(position, count, 3, dtype))
        if normal is not None:
            receivers.normal = view(normal, count, 3, dtype)
        call = getattr(self.calls, 'psc_sphere_sample_n_' + suffix(dtype))
        return self.check(call(
            ctypes.byref(technique), ctypes.c_size_t(count), ctypes.byref(receivers),
            ctypes.byref(view(center, count, 3, dtype)),
            ctypes.byref(view(radius, count, 1, dtype)), ctypes.byref(view(uv, count, 2, dtype)),
            ctypes.byref(samples(count, dtype, outputs))))


class Sampler:
    """A light seen from a receiver."""

    def __init__(self, library):
        self.handle = ctypes.c_void_p()
        self.library, self.calls = library, library.calls
        library.check(self.calls.psc_sampler_create(None, ctypes.byref(self.handle)))

    def __del__(self):
        self.calls.psc_sampler_destroy(self.handle)

    def build(self, light, position, normal=None, measure=SOLID_ANGLE, map=RADIAL, one_sided=False,
              two_sided_receiver=False):
        """Whether anything of the light can be seen."""
        technique = Technique(ctypes.sizeof(Technique), measure, map, ONE_SIDED * one_sided)
        receiver = Receiver(ctypes.sizeof(Receiver), TWO_SIDED * two_sided_receiver,
                            Vector(*position), None if normal is None else Vector(*normal))
        parts = (Vector(*part) if hasattr(part, '__len__') else ctypes.c_double(part)
                 for part in light)
        call = getattr(self.calls, 'psc_build_' + type(light).__name__.lower())
        return self.library.check(call(self.handle, ctypes.byref(technique),
                                       ctypes.byref(receiver), *parts)) == SUCCESS

    def sample(self, u, v):
        """A sample, or None if the light cannot be seen; of weight 0 if it is culled."""
        out = Sample()
        result = self.calls.psc_sample_f64(self.handle, ctypes.c_double(u), ctypes.c_double(v),
                                           ctypes.byref(out))
        return None if self.library.check(result) == EMPTY else out

    def pdf(self, direction):
        out = ctypes.c_double()
        self.library.check(self.calls.psc_pdf_f64(self.handle, Vector(*direction),
                                                  ctypes.byref(out)))
        return out.value

    def invert(self, direction):
        """The (u, v) of a direction, or None if the sampler cannot give it."""
        out = Pair()
        result = self.calls.psc_invert_f64(self.handle, Vector(*direction), out)
        return tuple(out) if self.library.check(result) == SUCCESS else None

    def total(self):
        out = ctypes.c_double()
        self.library.check(self.calls.psc_sampler_total(self.handle, ctypes.byref(out)))
        return out.value

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
