// SPDX-License-Identifier: Apache-2.0
// test.js LIBRARY: what the JavaScript client gets from the library.
'use strict';
const psc = require('./psc')(process.argv[2]);
const { view } = psc;

let count = 0, failures = 0;
function check(name, ok)
{
    failures += !ok;
    console.log(`${ok ? 'ok' : 'not ok'} ${++count} - ${name}`);
}
const near = (a, b, tolerance) => Math.abs(a - b) <= tolerance * Math.abs(b);

const center = [0.3, -0.2, 2], radius = 0.5, sphere = psc.sphere(center, radius);
const from = { position: [0, 0, 0], normal: [0, 0, 1] };
const distance = Math.hypot(...center);
const exact = Math.PI * (radius / distance) ** 2 * center[2] / distance;
const sampler = psc.sampler();

// One sample.
check('an empty sampler gives nothing',
      sampler.sample(0.5, 0.5) === null && sampler.ask('total') === 0);
check('builds', sampler.build(sphere, from, { measure: psc.PROJECTED_SOLID_ANGLE,
                                              map: psc.PARALLEL }));
const s = sampler.sample(0.25, 0.75);
check('the weight of a sphere above the horizon', near(s.weight, exact, 1e-14));
check('pdf of the sample', near(sampler.pdf(s.direction), s.pdf, 1e-12));
const [u, v] = sampler.invert(s.direction);
check('inverse of the sample', near(u, 0.25, 1e-12) && near(v, 0.75, 1e-12));
check('a direction away from the light',
      sampler.invert([1, 0, 0]) === null && sampler.pdf([1, 0, 0]) === 0);
check('below the horizon', !sampler.build(sphere, { position: [0, 0, 0], normal: [0, 0, -1] }));
check('a distant light', sampler.build(psc.cap([0, 1, 1], 0.00465), from) &&
                         sampler.sample(0.5, 0.5).distance === Infinity);
let words = '';
try {
    sampler.build(psc.sphere(center, -1), from);
} catch (error) {
    words = error.message;
}
check(`errors are thrown: ${words}`, words.includes('negative'));

// A million samples into one array of records, and into separate arrays.
const n = 1000000, uv = new Float32Array(2 * n);
for (let i = 0; i < n; i++) {
    uv[2 * i] = (i + 0.5) / n;
    uv[2 * i + 1] = i * 0.6180339887498949 % 1;
}
sampler.build(sphere, from, { measure: psc.SOLID_ANGLE, map: psc.CONCENTRIC });
const records = new Float32Array(5 * n), weights = new Float32Array(n);
check('a million samples in records',
      sampler.sampleN(n, view(uv, 2),
                      { direction: view(records, 3, 0, 5), weight: view(records, 1, 3, 5) }) === 0);
sampler.sampleN(n, view(uv, 2, 2 * n - 2, -2), { weight: view(weights, 1) });
let sum = 0, same = true;
for (let i = 0; i < n; i++) {
    sum += records[5 * i + 3];
    same &&= weights[n - 1 - i] === records[5 * i + 3] && records[5 * i + 4] === 0;
}
check('their mean is the projected solid angle', near(sum / n, exact, 1e-6));
check('backwards the same bits', same);
for (const [name, outputs] of [
    ['too short', { weight: view(weights, 1, 1) }], ['too wide', { weight: view(records, 3) }],
    ['of another type', { pdf: view(new Float64Array(n), 1) }]]) {
    let refused = false;
    try {
        sampler.sampleN(n, view(uv, 2), outputs);
    } catch {
        refused = true;
    }
    check(`an array that is ${name} is refused`, refused);
}

// Every shape: single calls, totals, and wavefronts of one light by strides of 0.
const lights = {
    sphere: [[0.5, -0.25, 1], 0.5], cap: [[0.5, -0.25, 1], 0.75],
    disk: [[0.5, -0.25, 1], [1, 0.5, 0.5], 0.75],
    ellipse: [[0.5, -0.25, 1], [0.5, 0, 0.25], [0, 1, 0]],
    ellipsoid: [[0.5, -0.25, 1], [0.5, 0, 0.25], [0, 1, 0], [-0.25, 0, 0.5]],
    triangle: [[0.5, -0.25, 1], [1, 0.5, 1], [0, 1, -0.5]],
    rectangle: [[0.5, -0.25, 1], [0.5, 0, 0.25], [0, 1, 0]],
    polygon: [[0, 0, 1], [1, 0, 1], [1.5, 1, 1], [0.5, 2, 1]],
};
const m = 1000, position = Float64Array.from({ length: 3 * m }, (_, i) => Math.sin(i * i) * 3);
const normal = Float64Array.from({ length: 3 * m }, (_, i) => Math.cos(i * i + 1));
const square = Float64Array.from({ length: 2 * m }, (_, i) =>
    i % 2 ? (0.3 + (i >> 1) * 0.6180339887498949) % 1 : ((i >> 1) + 0.5) / m);
const back = new Float64Array(2 * m), directions = new Float64Array(3 * m);
const pdfs = new Float64Array(m), own = new Float64Array(m);
psc.shapes.forEach((shape, i) => {
    const light = psc[shape](...lights[shape]);
    sampler.build(light, from);
    const s = sampler.sample(0.25, 0.75), [u, v] = sampler.invert(s.direction);
    check(`${shape}: a sample, its density and inverse, totals`,
          near(sampler.pdf(s.direction), s.pdf, 1e-9) && near(u, 0.25, 1e-9) &&
          near(v, 0.75, 1e-9) && near(psc.solidAngle(light, from.position),
                                      sampler.ask('solidAngle'), 1e-12) &&
          sampler.describe().shape === i + 1);
    sampler.sampleN(m, view(square, 2), { direction: view(directions, 3), pdf: view(own, 1) });
    sampler.pdfN(m, view(directions, 3), view(pdfs, 1));
    sampler.invertN(m, view(directions, 3), view(back, 2));
    check(`${shape}: arrays of densities and inverses`,
          pdfs.every((pdf, k) => near(pdf, own[k], 1e-9)) &&
          back.every((x, k) => Math.abs(x - square[k]) < 1e-9));

    const weight = new Float64Array(m).fill(-1), status = new Int32Array(m);
    const views = lights[shape].map(part => view(Float64Array.from([part].flat()),
                                                 [part].flat().length, 0, 0));
    let same = psc.sampleN(m, { position: view(position, 3), normal: view(normal, 3) },
                           psc[shape](...views), view(square, 2),
                           { weight: view(weight, 1), status: view(status, 1) }) === 0;
    for (let k = 0; k < m; k++) {
        const part = array => Array.from(array.subarray(3 * k, 3 * k + 3));
        sampler.build(light, { position: part(position), normal: part(normal) });
        const one = sampler.sample(square[2 * k], square[2 * k + 1]);
        same &&= weight[k] === (one === null ? -1 : one.weight);
    }
    check(`${shape}: a wavefront gives what single calls give`,
          same && status.includes(0) && status.includes(2));
});
// The map that needs a table.
const mean = how => {
    const weight = new Float64Array(m);
    sampler.build(psc.disk(...lights.disk), from, how);
    sampler.sampleN(m, view(square, 2), { weight: view(weight, 1) });
    return weight.reduce((a, b) => a + b) / m;
};
check('the tabulated map',
      near(mean({ map: psc.TABULATED, table: psc.table(256) }), mean({ map: psc.RADIAL }), 0.05));
check('form factors', near(psc.formFactor(sphere, from), exact / Math.PI, 1e-14) &&
                      psc.formFactor(psc.disk(...lights.disk), from) > 0 &&
                      psc.formFactor(psc.polygon(...lights.polygon), from) > 0);

console.log(`1..${count}`);
process.exitCode = failures === 0 ? 0 : 1;
