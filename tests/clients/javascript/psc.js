// SPDX-License-Identifier: Apache-2.0
// libpsc for Node.js, by the koffi package, on typed arrays without copies.
//
//     const psc = require('./psc')('libpsc.so.0');
//     const sampler = psc.sampler();
//     if (sampler.build(psc.sphere([2, 1, 0.5], 0.75), { position, normal },
//                       { measure: psc.PROJECTED_SOLID_ANGLE })) {
//         const s = sampler.sample(0.25, 0.75);
//         sampler.sampleN(count, view(uv, 2), { direction: view(directions, 3) });
//     }
//     psc.sampleN(count, { position: view(positions, 3), normal: view(normals, 3) },
//                 psc.sphere(view(centers, 3), view(radii, 1)), view(uv, 2),
//                 { weight: view(weights, 1) });
//
// A view is { array, width, offset, stride }: so many adjacent numbers per element, the first of
// them at offset, the next element stride numbers further (0 repeats one).
'use strict';
const koffi = require('koffi');

koffi.opaque('psc_sampler');
koffi.struct('psc_technique', {
    struct_size: 'uint32_t', measure: 'uint32_t', map: 'uint32_t', flags: 'uint32_t',
    table: 'void *',
});
koffi.struct('psc_receiver', {
    struct_size: 'uint32_t', flags: 'uint32_t', position: 'const double *',
    normal: 'const double *',
});
// psc_input_*, psc_output_*: the same in memory for every type of number.
koffi.struct('psc_view', { component: koffi.array('void *', 3), stride: 'intptr_t' });
koffi.struct('psc_output_result', { data: 'void *', stride: 'intptr_t' });
koffi.struct('psc_samples', {
    struct_size: 'uint32_t', reserved: 'uint32_t', direction: 'psc_view', pdf: 'psc_view',
    point: 'psc_view', distance: 'psc_view', normal: 'psc_view', weight: 'psc_view',
    surface: 'psc_view', status: 'psc_output_result',
});
koffi.struct('psc_receivers', {
    struct_size: 'uint32_t', flags: 'uint32_t', position: 'psc_view', normal: 'psc_view',
});

koffi.struct('psc_description', {
    struct_size: 'uint32_t', shape: 'uint32_t', measure: 'uint32_t', map: 'uint32_t',
    visibility: 'uint32_t', reserved: 'uint32_t',
});

// What the calls of each shape take: so many numbers each. A polygon takes its vertices.
const SHAPES = {
    sphere: [3, 1], cap: [3, 1], disk: [3, 3, 1], ellipse: [3, 3, 3], ellipsoid: [3, 3, 3, 3],
    triangle: [3, 3, 3], rectangle: [3, 3, 3], polygon: null,
};
const QUESTIONS = {
    total: 'total', solidAngle: 'solid_angle', projectedSolidAngle: 'projected_solid_angle',
    formFactor: 'form_factor', area: 'area',
};

const EMPTY = 1, OUTSIDE = 3;
const NOWHERE = { component: [null, null, null], stride: 0 };

function view(array, width, offset = 0, stride = width)
{
    return { array, width, offset, stride };
}

// A view as the library reads it. Its elements must be inside the array: nobody else looks.
function pointers({ array, width, offset, stride }, count)
{
    const size = array.BYTES_PER_ELEMENT, last = offset + stride * (count - 1);

    if (count > 0 && (Math.min(offset, last) < 0 || Math.max(offset, last) + width > array.length))
        throw new RangeError('the array is too short');
    const first = koffi.address(array) + BigInt(offset * size);
    return {
        component: [0, 1, 2].map(k => k < width ? first + BigInt(k * size) : null),
        stride: stride * size,
    };
}

// The type that two views have in common.
function same(a, b)
{
    if (a.array.constructor !== b.array.constructor)
        throw new TypeError('the arrays are of two types');
    return a.array.constructor;
}

const FIELDS = { direction: 3, pdf: 1, point: 3, distance: 1, normal: 3, weight: 1, surface: 2 };

function samples(outputs, count, Numbers)
{
    const out = { struct_size: koffi.sizeof('psc_samples'), reserved: 0 };

    for (const [name, width] of Object.entries(FIELDS)) {
        const wanted = outputs[name];
        if (wanted && !(wanted.array instanceof Numbers && wanted.width === width))
            throw new TypeError(`${name} is not a view of ${width} in a ${Numbers.name}`);
        out[name] = wanted ? pointers(wanted, count) : NOWHERE;
    }
    if (outputs.status && !(outputs.status.array instanceof Int32Array))
        throw new TypeError('status is not in an Int32Array');
    const status = outputs.status ? pointers(outputs.status, count) : NOWHERE;
    out.status = { data: status.component[0], stride: status.stride };
    return out;
}

module.exports = path => {
    const library = koffi.load(path);
    const resultString = library.func('const char *psc_result_string(int32_t)');
    const calls = {
        version: library.func('uint32_t psc_version()'),
        create: library.func('int32_t psc_sampler_create(void *, _Out_ psc_sampler **)'),
        destroy: library.func('void psc_sampler_destroy(psc_sampler *)'),
        tableSize: library.func('size_t psc_table_size(uint32_t)'),
        tableInit: library.func('int32_t psc_table_init(void *, size_t, uint32_t, ' +
                                '_Out_ void **)'),
        build: {}, solidAngle: {}, formFactor: {}, sampler: {},
        describe: library.func('int32_t psc_sampler_describe(psc_sampler *, ' +
                               '_Inout_ psc_description *)'),
        sample: library.func('int32_t psc_sample_f64(psc_sampler *, double, double, double *)'),
        pdf: library.func('int32_t psc_pdf_f64(psc_sampler *, const double *, _Out_ double *)'),
        invert: library.func('int32_t psc_invert_f64(psc_sampler *, const double *, double *)'),
    };
    for (const [name, words] of Object.entries(QUESTIONS))
        calls.sampler[name] =
            library.func(`int32_t psc_sampler_${words}(psc_sampler *, _Out_ double *)`);
    for (const [shape, widths] of Object.entries(SHAPES)) {
        const parts = widths ? widths.map(n => n === 3 ? 'const double *' : 'double').join(', ')
                             : 'size_t, const double *, intptr_t';
        calls.build[shape] = library.func(
            `int32_t psc_build_${shape}(psc_sampler *, psc_technique *, psc_receiver *, ${parts})`);
        calls.solidAngle[shape] = library.func(
            `int32_t psc_${shape}_solid_angle(` +
            (shape === 'cap' ? 'double' : `const double *, ${parts}`) + ', _Out_ double *)');
        calls.formFactor[shape] = library.func(
            `int32_t psc_${shape}_form_factor(psc_receiver *, ${parts}, _Out_ double *)`);
    }
    for (const [bits, Numbers] of [['f32', Float32Array], ['f64', Float64Array]]) {
        const many = calls[Numbers.name] = {
            sampleN: library.func(`int32_t psc_sample_n_${bits}(psc_sampler *, size_t, ` +
                                  'psc_view *, psc_samples *)'),
            pdfN: library.func(`int32_t psc_pdf_n_${bits}(psc_sampler *, size_t, psc_view *, ` +
                               'psc_view *)'),
            invertN: library.func(`int32_t psc_invert_n_${bits}(psc_sampler *, size_t, ` +
                                  'psc_view *, psc_view *, psc_output_result *)'),
        };
        for (const [shape, widths] of Object.entries(SHAPES)) {
            const parts = widths ? widths.map(() => 'psc_view *').join(', ')
                                 : 'size_t, psc_view *';
            many[shape] = library.func(
                `int32_t psc_${shape}_sample_n_${bits}(psc_technique *, size_t, psc_receivers *, ` +
                `${parts}, psc_view *, psc_samples *)`);
        }
    }

    // Throws what is an error; returns the status.
    function check(result)
    {
        if (result < 0)
            throw Object.assign(new Error(resultString(result)), { result });
        return result;
    }

    function technique({ measure = 0, map = 0, flags = 0, table = null } = {})
    {
        return { struct_size: koffi.sizeof('psc_technique'), measure, map, flags,
                 table: table?.address ?? null };
    }

    function borrow({ position, normal = null, flags = 0 })
    {
        return { struct_size: koffi.sizeof('psc_receiver'), flags, position, normal };
    }

    // The number that a call leaves behind its other arguments.
    function number(call, ...rest)
    {
        const out = [0];
        check(call(...rest, out));
        return out[0];
    }

    // The parts of a light as its build call takes them.
    function parts({ shape, parts })
    {
        return shape === 'polygon' ? [parts.length, parts.flat(), 24] : parts;
    }

    const forgotten = new FinalizationRegistry(calls.destroy);

    class Sampler {
        #handle;
        #table; // of the technique: must live as long

        constructor()
        {
            const out = [null];
            check(calls.create(null, out));
            this.#handle = out[0];
            forgotten.register(this, this.#handle);
        }
        // Whether anything of the light can be seen.
        build(light, receiver, how)
        {
            this.#table = how?.table;
            return check(calls.build[light.shape](this.#handle, technique(how), borrow(receiver),
                                                  ...parts(light))) === 0;
        }
        // A sample, or null if there is none; of weight 0 if it is culled.
        sample(u, v)
        {
            const s = new Float64Array(14);
            if (check(calls.sample(this.#handle, u, v, s)) === EMPTY)
                return null;
            return {
                direction: s.subarray(0, 3), pdf: s[3], point: s.subarray(4, 7), distance: s[7],
                normal: s.subarray(8, 11), weight: s[11], surface: s.subarray(12, 14),
            };
        }
        pdf(direction)
        {
            return number(calls.pdf, this.#handle, direction);
        }
        // [u, v] of a direction, or null.
        invert(direction)
        {
            const uv = new Float64Array(2);
            const result = check(calls.invert(this.#handle, direction, uv));
            return result === EMPTY || result === OUTSIDE ? null : uv;
        }
        // 'total', 'solidAngle', 'projectedSolidAngle', 'formFactor' or 'area'.
        ask(question)
        {
            return number(calls.sampler[question], this.#handle);
        }
        describe()
        {
            const out = { struct_size: koffi.sizeof('psc_description'), shape: 0, measure: 0,
                          map: 0, visibility: 0, reserved: 0 };
            check(calls.describe(this.#handle, out));
            return out;
        }
        sampleN(count, uv, outputs)
        {
            const Numbers = uv.array.constructor;
            return check(calls[Numbers.name].sampleN(
                this.#handle, count, pointers(uv, count), samples(outputs, count, Numbers)));
        }
        pdfN(count, direction, pdf)
        {
            return check(calls[same(direction, pdf).name].pdfN(
                this.#handle, count, pointers(direction, count), pointers(pdf, count)));
        }
        invertN(count, direction, uv)
        {
            return check(calls[same(direction, uv).name].invertN(
                this.#handle, count, pointers(direction, count), pointers(uv, count), null));
        }
    }

    return {
        SOLID_ANGLE: 0, PROJECTED_SOLID_ANGLE: 1, AREA: 2, VISIBLE_AREA: 3,
        RADIAL: 0, PARALLEL: 1, CONCENTRIC: 2, QUASI_UNIFORM: 3, TABULATED: 4,
        version: calls.version,
        view,
        // psc.disk(center, normal, radius) and so on, in the order of the build calls.
        ...Object.fromEntries(Object.keys(SHAPES).map(
            shape => [shape, (...parts) => ({ shape, parts })])),
        shapes: Object.keys(SHAPES),
        sampler: () => new Sampler(),
        // What the tabulated map looks up, for a technique.
        table(resolution)
        {
            const size = calls.tableSize(resolution), out = [null];
            const memory = new Uint32Array(Math.ceil(size / 4));
            check(calls.tableInit(memory, size, resolution, out));
            return { memory, address: out[0] };
        },
        // Without a sampler; a distant light has the same solid angle from everywhere.
        solidAngle: (light, position) => light.shape === 'cap'
            ? number(calls.solidAngle.cap, light.parts[1])
            : number(calls.solidAngle[light.shape], position, ...parts(light)),
        // Not of polygons.
        formFactor: (light, receiver) =>
            number(calls.formFactor[light.shape], borrow(receiver), ...parts(light)),
        // One build and one sample for each element, of a light whose parts are views.
        sampleN(count, { position, normal, flags = 0 }, { shape, parts }, uv, outputs, how)
        {
            const Numbers = uv.array.constructor;
            const receivers = {
                struct_size: koffi.sizeof('psc_receivers'), flags,
                position: pointers(position, count),
                normal: normal ? pointers(normal, count) : NOWHERE,
            };
            const light = parts.map(part => pointers(part, count));
            return check(calls[Numbers.name][shape](
                technique(how), count, receivers,
                ...(shape === 'polygon' ? [light.length, light] : light), pointers(uv, count),
                samples(outputs, count, Numbers)));
        },
    };
};
