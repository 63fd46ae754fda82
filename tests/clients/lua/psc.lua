-- SPDX-License-Identifier: Apache-2.0
-- libpsc for LuaJIT: the header itself is the declaration, for it needs no preprocessor.
--
--     local psc = require 'psc' ('libpsc.so.0', '/usr/include/psc/psc.h')
--     local sampler = psc.sampler()
--     local technique = psc.technique(psc.PROJECTED_SOLID_ANGLE, psc.RADIAL)
--     if sampler:build_sphere(technique, psc.receiver(position, normal), center, radius) then
--         local s = sampler:sample(0.25, 0.75)
--     end
--
-- Vectors are double[3], as psc.vector(x, y, z) makes them. Everything else is under its own name
-- in psc.C, types in ffi.
local ffi = require 'ffi'

local function declare(header)
    local file = assert(io.open(header))
    local text = file:read('*a')
    file:close()
    ffi.cdef((text:gsub('#ifdef __cplusplus.-#endif', ''):gsub('#[^\n]*', '')
        :gsub('PSC_API ', '')))
    return tonumber(text:match('#define PSC_VERSION (%d+)'))
end

return function(library, header)
    local version = declare(header)
    local C = ffi.load(library)
    local psc = {
        C = C,
        version = version, -- of the header; C.psc_version() is the library's
        SOLID_ANGLE = C.PSC_MEASURE_SOLID_ANGLE,
        PROJECTED_SOLID_ANGLE = C.PSC_MEASURE_PROJECTED_SOLID_ANGLE,
        AREA = C.PSC_MEASURE_AREA,
        VISIBLE_AREA = C.PSC_MEASURE_VISIBLE_AREA,
        RADIAL = C.PSC_MAP_RADIAL,
        PARALLEL = C.PSC_MAP_PARALLEL,
        CONCENTRIC = C.PSC_MAP_CONCENTRIC,
        QUASI_UNIFORM = C.PSC_MAP_QUASI_UNIFORM,
        TABULATED = C.PSC_MAP_TABULATED,
        vector = ffi.typeof 'double[3]',
        shapes = { 'sphere', 'cap', 'disk', 'ellipse', 'ellipsoid', 'triangle', 'rectangle',
            'polygon' },
    }

    -- Raises what is an error; returns the status.
    function psc.check(result)
        if result < 0 then
            error(ffi.string(C.psc_result_string(result)), 3)
        end
        return result
    end
    local check = psc.check

    -- A struct of a type that begins with its own size.
    local function sized(name)
        local type = ffi.typeof(name)
        return function()
            local s = type()
            s.struct_size = ffi.sizeof(type)
            return s
        end
    end

    local new_technique, new_receiver = sized 'psc_technique', sized 'psc_receiver'
    local new_description = sized 'psc_description'

    function psc.technique(measure, map, flags)
        local t = new_technique()
        t.measure, t.map, t.flags = measure or 0, map or 0, flags or 0
        return t
    end

    -- Points to its two vectors, which must live as long.
    function psc.receiver(position, normal, flags)
        local r = new_receiver()
        r.position, r.normal, r.flags = position, normal, flags or 0
        return r
    end

    psc.receivers_f32, psc.receivers_f64 = sized 'psc_receivers_f32', sized 'psc_receivers_f64'
    psc.samples_f32, psc.samples_f64 = sized 'psc_samples_f32', sized 'psc_samples_f64'

    -- Sets the view of n numbers that begin at a pointer; a stride of 0 repeats them.
    function psc.view(view, n, pointer, stride)
        for k = 0, n - 1 do
            view.component[k] = pointer + k
        end
        view.stride = stride
    end

    -- A light that does not move in a wavefront: the parts of a build call, as floats.
    -- The inputs that are returned point to those, and keep them alive.
    function psc.repeated(...)
        local inputs = { kept = {} }
        for i, part in ipairs { ... } do
            local n = type(part) == 'number' and 1 or 3
            local floats, input = ffi.new 'float[3]', ffi.new 'psc_input_f32'
            for k = 0, n - 1 do
                floats[k] = n == 1 and part or part[k]
            end
            psc.view(input, n, floats, 0)
            inputs[i], inputs.kept[i] = input, floats
        end
        return inputs
    end

    -- Methods of a sampler.
    local methods = {}
    local handle = ffi.typeof 'psc_sampler *[1]'
    local sample = ffi.typeof 'psc_light_sample_f64'
    local number, pair = ffi.typeof 'double[1]', ffi.typeof 'double[2]'

    -- Builds, of each shape: whether anything of the light can be seen.
    for _, shape in ipairs(psc.shapes) do
        local build = C['psc_build_' .. shape]
        methods['build_' .. shape] = function(self, ...)
            return check(build(self, ...)) == C.PSC_SUCCESS
        end
    end

    -- A sample, or nil if there is none; into the one that is given, or a new one.
    function methods:sample(u, v, out)
        out = out or sample()
        if C.psc_sample_f64(self, u, v, out) ~= C.PSC_EMPTY then
            return out
        end
    end
    function methods:pdf(direction)
        local out = number()
        C.psc_pdf_f64(self, direction, out)
        return out[0]
    end
    -- u, v of a direction, or nothing.
    function methods:invert(direction)
        local out = pair()
        if C.psc_invert_f64(self, direction, out) == C.PSC_SUCCESS then
            return out[0], out[1]
        end
    end
    for _, name in ipairs { 'total', 'solid_angle', 'projected_solid_angle', 'form_factor',
        'area' } do
        local question = C['psc_sampler_' .. name]
        methods[name] = function(self)
            local out = number()
            check(question(self, out))
            return out[0]
        end
    end
    function methods:describe()
        local out = new_description()
        check(C.psc_sampler_describe(self, out))
        return out
    end
    ffi.metatype('psc_sampler', { __index = methods })

    function psc.sampler()
        local out = handle()
        check(C.psc_sampler_create(nil, out))
        return ffi.gc(out[0], C.psc_sampler_destroy)
    end

    return psc
end
