/* SPDX-License-Identifier: Apache-2.0 */
/* Rays against the shapes of lights. Everything near the beginning of a ray counts: a point of the
   scene is never on a light. */
#include "light.hpp"

#include <limits>

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

struct Ray {
    Vector origin, direction;
    Vector &normal;

    float operator()(const psc::sphere &s) const
    {
        const Vector to = narrow(s.center) - origin;
        const float r = float(s.radius), along = dot(to, direction);
        const Vector off = to - along * direction; /* as good as the radius, near and far */
        const float half = r * r - dot(off, off);
        if (half < 0)
            return nowhere;
        const float t = along - std::sqrt(half);
        normal = 1 / r * (t * direction - to);
        return t > 0 ? t : nowhere;
    }

    /* Sets where the ray meets a plane, relative to a point of it. */
    float plane(Vector point, Vector n, Vector &there) const
    {
        const float t = dot(point - origin, n) / dot(direction, n);
        normal = n;
        there = origin + t * direction - point;
        return t > 0 && t < nowhere ? t : nowhere;
    }

    float operator()(const psc::disk &d) const
    {
        Vector there;
        const float t = plane(narrow(d.center), unit(narrow(d.normal)), there);
        return dot(there, there) <= float(d.radius * d.radius) ? t : nowhere;
    }

    float operator()(const psc::rectangle &r) const
    {
        const Vector u = narrow(r.edge_u), v = narrow(r.edge_v);
        Vector there;
        const float t = plane(narrow(r.corner), unit(cross(u, v)), there);
        const float a = dot(there, u), b = dot(there, v);
        return a >= 0 && a <= dot(u, u) && b >= 0 && b <= dot(v, v) ? t : nowhere;
    }

    float operator()(const psc::triangle &f) const
    {
        const Vector u = narrow(f.v1) - narrow(f.v0), v = narrow(f.v2) - narrow(f.v0);
        const Vector n = cross(u, v);
        Vector there;
        const float t = plane(narrow(f.v0), unit(n), there);
        const float b = dot(cross(there, v), n), c = dot(cross(u, there), n);
        return b >= 0 && c >= 0 && b + c <= dot(n, n) ? t : nowhere;
    }
};

} // namespace

float Light::hit(Vector origin, Vector direction, Vector &normal) const
{
    return std::visit(Ray{origin, direction, normal}, shape);
}

std::optional<psc::technique> Light::offered(psc_measure measure) const
{
    const psc::receiver anywhere = {{0, 0, 0}, {{0, 0, 1}}};
    psc::sampler sampler;

    for (psc_map map : {PSC_MAP_RADIAL, PSC_MAP_CONCENTRIC, PSC_MAP_PARALLEL}) {
        const psc::technique how(measure, map, one_sided ? PSC_TECHNIQUE_ONE_SIDED : 0);
        const psc_result result =
            std::visit([&](const auto &s) { return sampler.build(how, anywhere, s); }, shape);
        if (result != PSC_ERROR_UNSUPPORTED_TECHNIQUE)
            return how;
    }
    return {};
}
