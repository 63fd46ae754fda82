-- SPDX-License-Identifier: Apache-2.0
-- test.lua LIBRARY HEADER: what the LuaJIT client gets from the library.
local ffi = require 'ffi'
package.path = arg[0]:gsub('test%.lua$', '?.lua')
local psc = require 'psc' (arg[1], arg[2])
local C = psc.C

local count, failures = 0, 0
local function check(name, ok)
    count = count + 1
    failures = failures + (ok and 0 or 1)
    print((ok and 'ok ' or 'not ok ') .. count .. ' - ' .. name)
end

local function near(a, b, tolerance)
    return math.abs(a - b) <= tolerance * math.abs(b)
end

local origin, up, down = psc.vector(0, 0, 0), psc.vector(0, 0, 1), psc.vector(0, 0, -1)
local center, radius = psc.vector(0.3, -0.2, 2), 0.5
local from = psc.receiver(origin, up)
local distance = math.sqrt(0.3 ^ 2 + 0.2 ^ 2 + 2 ^ 2)
local exact = math.pi * (radius / distance) ^ 2 * 2 / distance

local sampler = psc.sampler()
check('the header and the library are of one version', C.psc_version() == psc.version)
check('an empty sampler gives nothing', not sampler:sample(0.5, 0.5) and sampler:total() == 0)

local technique = psc.technique(psc.PROJECTED_SOLID_ANGLE, psc.CONCENTRIC)
check('builds', sampler:build_sphere(technique, from, center, radius))
local s = sampler:sample(0.25, 0.75)
check('the weight of a sphere above the horizon', near(s.weight, exact, 1e-14))
check('pdf of the sample', near(sampler:pdf(s.direction), s.pdf, 1e-12))
local u, v = sampler:invert(s.direction)
check('inverse of the sample', near(u, 0.25, 1e-12) and near(v, 0.75, 1e-12))
check('below the horizon',
    not sampler:build_sphere(technique, psc.receiver(origin, down), center, radius)
    and not sampler:sample(0.5, 0.5))
check('a distant light',
    sampler:build_cap(psc.technique(), from, up, 0.1) and sampler:sample(0, 0).distance == math.huge)
local ok, message = pcall(sampler.build_sphere, sampler, technique, from, center, -1)
check('errors are raised: ' .. tostring(message), not ok and message:find('negative'))

-- A loop that LuaJIT compiles to machine code.
local n, sum = 1000000, 0
sampler:build_sphere(psc.technique(psc.SOLID_ANGLE, psc.RADIAL), from, center, radius)
for i = 0, n - 1 do
    sampler:sample((i + 0.5) / n, i * 0.6180339887498949 % 1, s)
    sum = sum + s.weight
end
check('the mean of a million single samples', near(sum / n, exact, 1e-6))

-- A wavefront over records: receivers and their results side by side.
ffi.cdef [[
    typedef struct hit {
        float position[3], normal[3], uv[2];
        float direction[3], weight;
        int32_t status;
    } hit;
]]
n = 100000
local hits = ffi.new('hit[?]', n)
for i = 0, n - 1 do
    local hit = hits[i]
    hit.position[0], hit.position[1] = (i % 317) / 100 - 1.5, (i % 101) / 30 - 1.5
    hit.normal[0], hit.normal[2] = 0.3, 1
    hit.uv[0], hit.uv[1] = (i + 0.5) / n, i * 0.6180339887498949 % 1
end
local stride = ffi.sizeof 'hit'
local receivers, out, in_uv = psc.receivers_f32(), psc.samples_f32(), ffi.new 'psc_input_f32'
psc.view(receivers.position, 3, hits[0].position, stride)
psc.view(receivers.normal, 3, hits[0].normal, stride)
psc.view(in_uv, 2, hits[0].uv, stride)
psc.view(out.direction, 3, hits[0].direction, stride)
local bytes = ffi.cast('char *', hits)
out.weight.component[0] = ffi.cast('float *', bytes + ffi.offsetof('hit', 'weight'))
out.weight.stride = stride
out.status.data = ffi.cast('psc_result *', bytes + ffi.offsetof('hit', 'status'))
out.status.stride = stride

-- Every shape, of numbers that floats hold.
local vector = psc.vector
local middle, normal_1 = vector(0.5, -0.25, 1), vector(1, 0.5, 0.5)
local x, y, z = vector(0.5, 0, 0.25), vector(0, 1, 0), vector(-0.25, 0, 0.5)
local lights = {
    sphere = { middle, 0.5 },
    cap = { middle, 0.75 },
    disk = { middle, normal_1, 0.75 },
    ellipse = { middle, x, y },
    ellipsoid = { middle, x, y, z },
    triangle = { middle, vector(1, 0.5, 1), vector(0, 1, -0.5) },
    rectangle = { middle, x, y },
    polygon = { vector(0, 0, 1), vector(1, 0, 1), vector(1.5, 1, 1), vector(0.5, 2, 1) },
}
local single = ffi.new 'psc_light_sample_f32'
local position, normal = vector(), vector()
local here, anything = psc.receiver(position, normal), psc.technique()
local number = ffi.new 'double[1]'
for shape_number, shape in ipairs(psc.shapes) do
    local parts, build = lights[shape], 'build_' .. shape
    local inputs = psc.repeated(unpack(parts))
    if shape == 'polygon' then
        local vertices, views = ffi.new('double[4][3]', parts), ffi.new('psc_input_f32[4]', inputs)
        parts = { 4, vertices[0], ffi.sizeof(vertices[0]), kept = vertices }
        inputs = { 4, views, kept = inputs }
    end
    local without = shape == 'cap' and { parts[2] } or { origin, unpack(parts) }
    without[#without + 1] = number

    sampler[build](sampler, anything, from, unpack(parts))
    sampler:sample(0.25, 0.75, s)
    u, v = sampler:invert(s.direction)
    psc.check(C['psc_' .. shape .. '_solid_angle'](unpack(without)))
    check(shape .. ': a sample, its density and inverse, totals',
        near(sampler:pdf(s.direction), s.pdf, 1e-9) and near(u, 0.25, 1e-9) and near(v, 0.75, 1e-9)
        and near(sampler:solid_angle(), number[0], 1e-12)
        and sampler:describe().shape == shape_number)

    inputs[#inputs + 1], inputs[#inputs + 2] = in_uv, out
    local same = C['psc_' .. shape .. '_sample_n_f32'](anything, n, receivers, unpack(inputs)) == 0
    local seen = 0
    for i = 0, n - 1, 97 do
        local hit = hits[i]
        for k = 0, 2 do
            position[k], normal[k] = hit.position[k], hit.normal[k]
        end
        sampler[build](sampler, anything, here, unpack(parts))
        local status = C.psc_sample_f32(sampler, hit.uv[0], hit.uv[1], single)
        same = same and status == hit.status
        if status ~= C.PSC_EMPTY then
            seen = seen + 1
            same = same and single.weight == hit.weight
            for k = 0, 2 do
                same = same and single.direction[k] == hit.direction[k]
            end
        end
    end
    check(shape .. ': a wavefront gives what single calls give', same and seen > 500)
end

print('1..' .. count)
os.exit(failures == 0)
