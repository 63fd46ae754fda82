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
        vector = ffi.typeof 'double[3]',
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

    -- Methods of a sampler.
    local methods = {}
    local handle = ffi.typeof 'psc_sampler *[1]'
    local sample = ffi.typeof 'psc_light_sample_f64'
    local number, pair = ffi.typeof 'double[1]', ffi.typeof 'double[2]'

    -- Builds: whether anything of the light can be seen.
    function methods:build_sphere(...)
        return check(C.psc_build_sphere(self, ...)) == C.PSC_SUCCESS
    end
    function methods:build_cap(...)
        return check(C.psc_build_cap(self, ...)) == C.PSC_SUCCESS
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
    function methods:total()
        local out = number()
        check(C.psc_sampler_total(self, out))
        return out[0]
    end
    ffi.metatype('psc_sampler', { __index = methods })

    function psc.sampler()
        local out = handle()
        check(C.psc_sampler_create(nil, out))
        return ffi.gc(out[0], C.psc_sampler_destroy)
    end

    return psc
end
