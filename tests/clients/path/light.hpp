/* SPDX-License-Identifier: Apache-2.0 */
/* Lights: shapes that the library samples and that a ray can hit. */
#ifndef PATH_LIGHT_HPP
#define PATH_LIGHT_HPP

#include <optional>
#include <variant>

#include <psc/psc.hpp>

#include "vector.hpp"

using Shape = std::variant<psc::sphere, psc::disk, psc::rectangle, psc::triangle>;

struct Light {
    Shape shape;
    const char *name;
    float radiance;
    Vector color;
    bool one_sided = false;

    /* The distance along a ray to where the light begins, or infinity; the normal there. */
    float hit(Vector origin, Vector direction, Vector &normal) const;

    /* The first of the library's maps that the shape has for a measure; nothing if it has none. */
    std::optional<psc::technique> offered(psc_measure measure) const;

    /* How to sample by a measure that is wanted, or by solid angle, which every shape offers. */
    psc::technique technique(psc_measure wanted) const
    {
        const auto found = offered(wanted);
        return found ? *found : *offered(PSC_MEASURE_SOLID_ANGLE);
    }

    /* Whether it shines against the direction of a ray that hit it. */
    bool shines(Vector direction, Vector normal) const
    {
        return !one_sided || dot(direction, normal) < 0;
    }
};

#endif
