/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file psc.hpp
 * psc.h for C++17: lights and receivers as values, samplers that need no care, one name for both
 * precisions, and views of arrays.
 *
 *     psc::sampler sampler;                                             // once per thread
 *     psc::technique technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE);
 *     psc_light_sample_f32 s;
 *
 *     if (sampler.build(technique, {position, normal}, psc::sphere{center, radius}) == PSC_SUCCESS
 *         && sampler.sample(u, v, s) == PSC_SUCCESS)
 *         L += radiance * bsdf * s.weight;
 *
 * Everything is inline and no more than a call of psc.h, whose documentation holds: results are
 * returned, nothing throws, and outputs are left alone where psc.h leaves them alone. What cannot
 * fail is returned by value.
 */
#ifndef PSC_PSC_HPP
#define PSC_PSC_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <tuple>
#include <type_traits>

#include <psc/psc.h>

namespace psc {

/** A point or a direction. */
using vector = std::array<double, 3>;

/* ---- What is asked for ------------------------------------------------------------------ */

/** A psc_technique that knows its size; the default is solid angle, radial. */
struct technique : psc_technique {
    technique() noexcept : technique(PSC_MEASURE_SOLID_ANGLE)
    {
    }
    explicit technique(psc_measure measure_, psc_map map_ = PSC_MAP_RADIAL,
                       std::uint32_t flags_ = 0, const psc_table *table_ = nullptr) noexcept
        : psc_technique{sizeof(psc_technique), measure_, map_, flags_, table_}
    {
    }
};

/** The point that is lit. */
struct receiver {
    vector position;
    std::optional<vector> normal = {}; /**< none for a point in a volume */
    std::uint32_t flags = 0;           /**< 0 or PSC_RECEIVER_TWO_SIDED */
};

/** What psc.h makes of a receiver: it points into r. */
inline psc_receiver borrow(const receiver &r) noexcept
{
    return {sizeof(psc_receiver), r.flags, r.position.data(),
            r.normal ? r.normal->data() : nullptr};
}

/* ---- Lights: their numbers, and the calls that take them ------------------------------------ */

/** See psc_build_sphere(). */
struct sphere {
    vector center;
    double radius;

    auto parts() const noexcept
    {
        return std::make_tuple(center.data(), radius);
    }
    static constexpr auto build = psc_build_sphere;
    static constexpr auto form_factor = psc_sphere_form_factor;
    static constexpr auto solid_angle = psc_sphere_solid_angle;
    static constexpr auto sample_n_f32 = psc_sphere_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_sphere_sample_n_f64;
};

/** See psc_build_cap(). */
struct cap {
    vector axis;
    double half_angle;

    auto parts() const noexcept
    {
        return std::make_tuple(axis.data(), half_angle);
    }
    static constexpr auto build = psc_build_cap;
    static constexpr auto form_factor = psc_cap_form_factor;
    static constexpr auto sample_n_f32 = psc_cap_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_cap_sample_n_f64;
};

/** See psc_build_disk(). */
struct disk {
    vector center, normal;
    double radius;

    auto parts() const noexcept
    {
        return std::make_tuple(center.data(), normal.data(), radius);
    }
    static constexpr auto build = psc_build_disk;
    static constexpr auto form_factor = psc_disk_form_factor;
    static constexpr auto solid_angle = psc_disk_solid_angle;
    static constexpr auto sample_n_f32 = psc_disk_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_disk_sample_n_f64;
};

/** See psc_build_ellipse(). */
struct ellipse {
    vector center, axis_u, axis_v;

    auto parts() const noexcept
    {
        return std::make_tuple(center.data(), axis_u.data(), axis_v.data());
    }
    static constexpr auto build = psc_build_ellipse;
    static constexpr auto form_factor = psc_ellipse_form_factor;
    static constexpr auto solid_angle = psc_ellipse_solid_angle;
    static constexpr auto sample_n_f32 = psc_ellipse_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_ellipse_sample_n_f64;
};

/** See psc_build_ellipsoid(). */
struct ellipsoid {
    vector center, axis_u, axis_v, axis_w;

    auto parts() const noexcept
    {
        return std::make_tuple(center.data(), axis_u.data(), axis_v.data(), axis_w.data());
    }
    static constexpr auto build = psc_build_ellipsoid;
    static constexpr auto form_factor = psc_ellipsoid_form_factor;
    static constexpr auto solid_angle = psc_ellipsoid_solid_angle;
    static constexpr auto sample_n_f32 = psc_ellipsoid_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_ellipsoid_sample_n_f64;
};

/** See psc_build_triangle(). */
struct triangle {
    vector v0, v1, v2;

    auto parts() const noexcept
    {
        return std::make_tuple(v0.data(), v1.data(), v2.data());
    }
    static constexpr auto build = psc_build_triangle;
    static constexpr auto solid_angle = psc_triangle_solid_angle;
    static constexpr auto form_factor = psc_triangle_form_factor;
    static constexpr auto sample_n_f32 = psc_triangle_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_triangle_sample_n_f64;
};

/** See psc_build_rectangle(). */
struct rectangle {
    vector corner, edge_u, edge_v;

    auto parts() const noexcept
    {
        return std::make_tuple(corner.data(), edge_u.data(), edge_v.data());
    }
    static constexpr auto build = psc_build_rectangle;
    static constexpr auto solid_angle = psc_rectangle_solid_angle;
    static constexpr auto form_factor = psc_rectangle_form_factor;
    static constexpr auto sample_n_f32 = psc_rectangle_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_rectangle_sample_n_f64;
};

/** See psc_build_polygon(). The vertices are somebody else's, and must live as long. */
struct polygon {
    const vector *vertices;
    std::size_t count;

    auto parts() const noexcept
    {
        return std::make_tuple(count, vertices ? vertices->data() : nullptr,
                               std::ptrdiff_t(sizeof(vector)));
    }
    static constexpr auto build = psc_build_polygon;
    static constexpr auto solid_angle = psc_polygon_solid_angle;
    static constexpr auto form_factor = psc_polygon_form_factor;
    static constexpr auto sample_n_f32 = psc_polygon_sample_n_f32;
    static constexpr auto sample_n_f64 = psc_polygon_sample_n_f64;
};

/** Builds the sampler of a light, whichever it is. */
template <class Light>
psc_result build(psc_sampler *sampler, const psc_technique &technique, const receiver &from,
                 const Light &light) noexcept
{
    const psc_receiver point = borrow(from);
    return std::apply(
        [&](auto... part) { return Light::build(sampler, &technique, &point, part...); },
        light.parts());
}

/** Form factor from a receiver to a light, without a sampler. */
template <class Light>
psc_result form_factor(const receiver &from, const Light &light, double &out) noexcept
{
    const psc_receiver point = borrow(from);
    return std::apply([&](auto... part) { return Light::form_factor(&point, part..., &out); },
                      light.parts());
}

/** Solid angle of a light that is not distant, seen from a point, without a sampler. */
template <class Light>
psc_result solid_angle(const vector &position, const Light &light, double &out) noexcept
{
    return std::apply(
        [&](auto... part) { return Light::solid_angle(position.data(), part..., &out); },
        light.parts());
}

/* ---- Arrays ------------------------------------------------------------------------------- */

/** Numbers at every stride bytes, component by component: passes as an input, and as an output
    unless they are constant. */
template <class Real> struct view {
    std::array<Real *, 3> component;
    std::ptrdiff_t stride;

    using value = std::remove_const_t<Real>;
    using input = std::conditional_t<std::is_same_v<value, float>, psc_input_f32, psc_input_f64>;
    using output = std::conditional_t<std::is_same_v<value, float>, psc_output_f32, psc_output_f64>;

    operator input() const noexcept
    {
        return {{component[0], component[1], component[2]}, stride};
    }
    template <class T = Real, class = std::enable_if_t<!std::is_const_v<T>>>
    operator output() const noexcept
    {
        return {{component[0], component[1], component[2]}, stride};
    }
};

/** One number per element, the first at first; a stride of 0 repeats it. */
template <class Real>
view<Real> scalars(Real *first, std::ptrdiff_t stride = sizeof(Real)) noexcept
{
    return {{first, nullptr, nullptr}, stride};
}

/** Two adjacent numbers per element. */
template <class Real>
view<Real> pairs(Real *first, std::ptrdiff_t stride = 2 * sizeof(Real)) noexcept
{
    return {{first, first + 1, nullptr}, stride};
}

/** Three adjacent numbers per element. */
template <class Real>
view<Real> vectors(Real *first, std::ptrdiff_t stride = 3 * sizeof(Real)) noexcept
{
    return {{first, first + 1, first + 2}, stride};
}

/** Where samples go: nothing is wanted until it is assigned a view. */
template <class Real>
struct samples : std::conditional_t<std::is_same_v<Real, float>, psc_samples_f32, psc_samples_f64> {
    using base = std::conditional_t<std::is_same_v<Real, float>, psc_samples_f32, psc_samples_f64>;

    samples() noexcept : base{}
    {
        this->struct_size = sizeof(base);
    }
};

/** Many receivers: vectors, and vectors or nothing. */
template <class Real>
struct receivers
    : std::conditional_t<std::is_same_v<Real, float>, psc_receivers_f32, psc_receivers_f64> {
    using base =
        std::conditional_t<std::is_same_v<Real, float>, psc_receivers_f32, psc_receivers_f64>;
    using input = typename view<Real>::input;

    explicit receivers(const input &position_, const input &normal_ = {},
                       std::uint32_t flags_ = 0) noexcept
        : base{sizeof(base), flags_, position_, normal_}
    {
    }
};

namespace detail {

/* A part of the lights of a wavefront as a call of psc.h takes it. */
template <class Input> struct part {
    static const Input *pass(const Input &view) noexcept
    {
        return &view;
    }
    static const Input *pass(const Input *views) noexcept
    {
        return views;
    }
    static std::size_t pass(std::size_t number) noexcept
    {
        return number;
    }
};

} // namespace detail

/** One build and one sample per element: sample_n<psc::sphere>(technique, count, from, uv, out,
    centers, radii), with a view for each part of the light. Polygons take the number of their
    vertices and an array with a psc_input_f32 or psc_input_f64 for each. */
template <class Light, class Real, class... Parts>
psc_result sample_n(const psc_technique &technique, std::size_t count, const receivers<Real> &from,
                    const typename view<Real>::input &uv, const samples<Real> &out,
                    const Parts &...parts) noexcept
{
    using part = detail::part<typename view<Real>::input>;
    if constexpr (std::is_same_v<Real, float>)
        return Light::sample_n_f32(&technique, count, &from, part::pass(parts)..., &uv, &out);
    else
        return Light::sample_n_f64(&technique, count, &from, part::pass(parts)..., &uv, &out);
}

/* ---- The sampler ------------------------------------------------------------------------ */

/** A light seen from a receiver, ready to be sampled. Empty at first; a value of some kilobytes,
    which owns nothing. One per thread is enough, and one per light where MIS asks again. */
class sampler {
public:
    sampler() noexcept
    {
        psc_sampler_init(&storage, sizeof storage, &handle);
    }
    sampler(const sampler &other) noexcept : sampler()
    {
        *this = other;
    }
    sampler &operator=(const sampler &other) noexcept
    {
        if (this != &other)
            std::memcpy(&storage, &other.storage, psc_sampler_size());
        return *this;
    }

    /** For what is not below. */
    psc_sampler *get() noexcept
    {
        return handle;
    }
    const psc_sampler *get() const noexcept
    {
        return handle;
    }

    template <class Light>
    psc_result build(const psc_technique &technique, const receiver &from,
                     const Light &light) noexcept
    {
        return psc::build(handle, technique, from, light);
    }

    psc_result sample(double u, double v, psc_light_sample_f64 &out) const noexcept
    {
        return psc_sample_f64(handle, u, v, &out);
    }
    psc_result sample(float u, float v, psc_light_sample_f32 &out) const noexcept
    {
        return psc_sample_f32(handle, u, v, &out);
    }

    /** Density of a direction per steradian: 0 where the sampler gives none, or is empty. */
    double pdf(const double direction[3]) const noexcept
    {
        double out = 0;
        psc_pdf_f64(handle, direction, &out);
        return out;
    }
    float pdf(const float direction[3]) const noexcept
    {
        float out = 0;
        psc_pdf_f32(handle, direction, &out);
        return out;
    }

    psc_result invert(const double direction[3], double uv[2]) const noexcept
    {
        return psc_invert_f64(handle, direction, uv);
    }
    psc_result invert(const float direction[3], float uv[2]) const noexcept
    {
        return psc_invert_f32(handle, direction, uv);
    }

    psc_result sample_n(std::size_t count, const psc_input_f64 &uv,
                        const psc_samples_f64 &out) const noexcept
    {
        return psc_sample_n_f64(handle, count, &uv, &out);
    }
    psc_result sample_n(std::size_t count, const psc_input_f32 &uv,
                        const psc_samples_f32 &out) const noexcept
    {
        return psc_sample_n_f32(handle, count, &uv, &out);
    }
    psc_result pdf_n(std::size_t count, const psc_input_f64 &direction,
                     const psc_output_f64 &out) const noexcept
    {
        return psc_pdf_n_f64(handle, count, &direction, &out);
    }
    psc_result pdf_n(std::size_t count, const psc_input_f32 &direction,
                     const psc_output_f32 &out) const noexcept
    {
        return psc_pdf_n_f32(handle, count, &direction, &out);
    }
    psc_result invert_n(std::size_t count, const psc_input_f64 &direction,
                        const psc_output_f64 &uv,
                        const psc_output_result &status = {}) const noexcept
    {
        return psc_invert_n_f64(handle, count, &direction, &uv, &status);
    }
    psc_result invert_n(std::size_t count, const psc_input_f32 &direction,
                        const psc_output_f32 &uv,
                        const psc_output_result &status = {}) const noexcept
    {
        return psc_invert_n_f32(handle, count, &direction, &uv, &status);
    }

    /** In the measure that the sampler is uniform in; 0 when empty. */
    double total() const noexcept
    {
        double out = 0;
        psc_sampler_total(handle, &out);
        return out;
    }
    /** Of the whole light, whether above the horizon or not; 0 when empty. */
    double solid_angle() const noexcept
    {
        double out = 0;
        psc_sampler_solid_angle(handle, &out);
        return out;
    }
    psc_result projected_solid_angle(double &out) const noexcept
    {
        return psc_sampler_projected_solid_angle(handle, &out);
    }
    psc_result form_factor(double &out) const noexcept
    {
        return psc_sampler_form_factor(handle, &out);
    }
    psc_result area(double &out) const noexcept
    {
        return psc_sampler_area(handle, &out);
    }
    psc_description describe() const noexcept
    {
        psc_description out = {sizeof out, 0, 0, 0, 0, 0};
        psc_sampler_describe(handle, &out);
        return out;
    }

private:
    psc_sampler_storage storage;
    psc_sampler *handle;
};

} // namespace psc

#endif
