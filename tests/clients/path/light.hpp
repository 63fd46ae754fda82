/* SPDX-License-Identifier: Apache-2.0 */
/* Lights: shapes that the library samples and that a ray can hit. */
#ifndef PATH_LIGHT_HPP
#define PATH_LIGHT_HPP

#include <variant>

#include <psc/psc.hpp>

#include "vector.hpp"

struct Light {
    std::variant<psc::sphere, psc::triangle> shape;
    const char *name;
    float radiance;
    Vector color;
    bool one_sided = false;

    /* The distance along a ray to where the light begins, or infinity; the normal there. */
    float hit(Vector origin, Vector direction, Vector &normal) const;

    psc::technique technique(psc_measure measure) const
    {
        return psc::technique(measure, PSC_MAP_RADIAL,
                              one_sided ? PSC_TECHNIQUE_ONE_SIDED : 0);
    }

    /* A measure that is wanted, or solid angle, which every shape offers. */
    psc_measure offered(psc_measure measure) const
    {
        psc::sampler sampler;
        const psc::receiver anywhere = {{0, 0, 0}, {{0, 0, 1}}};
        const psc_result result = std::visit(
            [&](const auto &s) { return sampler.build(technique(measure), anywhere, s); }, shape);
        if (result == PSC_ERROR_UNSUPPORTED_TECHNIQUE)
            return PSC_MEASURE_SOLID_ANGLE;
        return measure;
    }

    /* Whether it shines against the direction of a ray that hit it. */
    bool shines(Vector direction, Vector normal) const
    {
        return !one_sided || dot(direction, normal) < 0;
    }
};

#endif
