/* SPDX-License-Identifier: Apache-2.0 */
/* psc.hpp gives what psc.h gives, to the last bit: every shape, call and precision. */
#include <cmath>
#include <cstring>
#include <deque>
#include <tuple>
#include <type_traits>
#include <vector>

#include <psc/psc.hpp>

#include "../tap.h"

namespace {

constexpr int count = 64;
const psc::receiver from = {{0.1, 0.2, 0}, {{0.2, -0.1, 1}}};
const psc::technique technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL);

template <class A, class B> bool same(const A &a, const B &b)
{
    static_assert(sizeof a == sizeof b);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/* The calls of a sampler, in one precision, against those of its handle. */
template <class Real, class Sample, class Single, class Density, class Inverse>
bool answers(const psc::sampler &sampler, Single single, Density density, Inverse inverse)
{
    bool ok = true;
    std::vector<Real> uv, directions, pdfs(count), back(2 * count);
    for (int i = 0; i < count; i++) {
        const Real u = (Real(i) + Real(0.5)) / count, v = Real(i * 37 % count) / count;
        Sample a = {}, b = {};
        Real pdf = -1, at[2] = {-1, -1}, expected[2] = {-1, -1};
        ok &= sampler.sample(u, v, a) == single(sampler.get(), u, v, &b) && same(a, b);
        density(sampler.get(), b.direction, &pdf);
        ok &= sampler.pdf(b.direction) == pdf;
        ok &= sampler.invert(b.direction, at) == inverse(sampler.get(), b.direction, expected)
              && same(at, expected);
        uv.insert(uv.end(), {u, v});
        directions.insert(directions.end(), b.direction, b.direction + 3);
    }
    struct Record {
        Real direction[3], weight;
    };
    std::vector<Record> records(count);
    std::vector<psc_result> status(count, -1);
    psc::samples<Real> out;
    out.direction = psc::vectors(records[0].direction, sizeof(Record));
    out.weight = psc::scalars(&records[0].weight, sizeof(Record));
    out.status = {status.data(), sizeof status[0]};
    ok &= sampler.sample_n(count, psc::pairs(uv.data()), out) == PSC_SUCCESS;
    ok &= sampler.pdf_n(count, psc::vectors(directions.data()), psc::scalars(pdfs.data()))
          == PSC_SUCCESS;
    ok &= sampler.invert_n(count, psc::vectors(directions.data()), psc::pairs(back.data()))
          == PSC_SUCCESS;
    for (std::size_t i = 0; i < count; i++) {
        Sample s = {};
        Real at[2] = {};
        ok &= status[i] == sampler.sample(uv[2 * i], uv[2 * i + 1], s)
              && records[i].weight == s.weight && same(records[i].direction, s.direction);
        ok &= pdfs[i] == sampler.pdf(&directions[3 * i]);
        if (sampler.invert(&directions[3 * i], at) == PSC_SUCCESS)
            ok &= same(at, reinterpret_cast<const Real(&)[2]>(back[2 * i]));
    }
    return ok;
}

/* The parts of a light, each the same for all elements of a wavefront. */
template <class Real> class repeated {
public:
    psc::view<const Real> operator()(const double *vector)
    {
        numbers.push_back({Real(vector[0]), Real(vector[1]), Real(vector[2])});
        return psc::vectors<const Real>(numbers.back().data(), 0);
    }
    psc::view<const Real> operator()(double number)
    {
        numbers.push_back({Real(number)});
        return psc::scalars<const Real>(numbers.back().data(), 0);
    }

private:
    std::deque<std::array<Real, 3>> numbers;
};

template <class Real, class Light, class... Arguments>
psc_result call(const Light &light, const Arguments &...arguments)
{
    repeated<Real> repeat;
    return std::apply(
        [&](auto... part) { return psc::sample_n<Light>(arguments..., repeat(part)...); },
        light.parts());
}

template <class Real, class... Arguments>
psc_result call(const psc::polygon &light, const Arguments &...arguments)
{
    repeated<Real> repeat;
    std::vector<typename psc::view<Real>::input> vertices;
    for (std::size_t i = 0; i < light.count; i++)
        vertices.push_back(repeat(light.vertices[i].data()));
    return psc::sample_n<psc::polygon>(arguments..., light.count, vertices.data());
}

/* One sample per receiver, against builds one by one. */
template <class Real, class Sample, class Light> bool wavefront(const Light &light)
{
    std::vector<Real> uv(2 * count), positions(3 * count), weights(count, -1), normals;
    bool ok = true;
    for (std::size_t i = 0; i < count; i++) {
        uv[2 * i] = uv[2 * i + 1] = (Real(i) + Real(0.5)) / count;
        positions[3 * i] = Real(i) / 16 - 2;
        normals.insert(normals.end(), {0, Real(i) / 64, 1});
    }
    const psc::receivers<Real> many(psc::vectors(positions.data()), psc::vectors(normals.data()));
    psc::samples<Real> out;
    out.weight = psc::scalars(weights.data());
    ok &= call<Real>(light, technique, count, many, psc::pairs(uv.data()), out) == PSC_SUCCESS;
    for (std::size_t i = 0; i < count; i++) {
        psc::sampler one;
        Sample s = {};
        one.build(technique,
                  {{positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]},
                   {{normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}}},
                  light);
        s.weight = -1;
        one.sample(uv[2 * i], uv[2 * i + 1], s);
        ok &= s.weight == weights[i] && s.weight > 0;
    }
    return ok;
}

/* Whether there are form factors of a light without a sampler, and solid angles. */
template <class Light, class = void> constexpr bool has_form_factor = false;
template <class Light>
constexpr bool has_form_factor<Light, std::void_t<decltype(Light::form_factor)>> = true;
template <class Light, class = void> constexpr bool has_solid_angle = false;
template <class Light>
constexpr bool has_solid_angle<Light, std::void_t<decltype(Light::solid_angle)>> = true;

/* A light, its name, and what its sampler is when it is built by a call of psc.h. */
template <class Light, class Build>
void light(const char *name, psc_shape shape, const Light &light, Build build)
{
    psc::sampler sampler, by_hand;
    const psc_receiver point = psc::borrow(from);
    double a = -1, b = -1;

    bool ok = sampler.build(technique, from, light) == PSC_SUCCESS
              && build(by_hand.get(), &technique, &point) == PSC_SUCCESS;
    psc_light_sample_f64 s = {}, t = {};
    sampler.sample(0.3, 0.6, s);
    by_hand.sample(0.3, 0.6, t);
    tap_ok(ok && same(s, t) && sampler.describe().shape == shape, "%s: builds", name);
    tap_ok(answers<double, psc_light_sample_f64>(sampler, psc_sample_f64, psc_pdf_f64,
                                                 psc_invert_f64)
               && answers<float, psc_light_sample_f32>(sampler, psc_sample_f32, psc_pdf_f32,
                                                       psc_invert_f32),
           "%s: samples, densities and inverses, single and in arrays", name);

    psc_sampler_total(sampler.get(), &a);
    ok = sampler.total() == a && psc_sampler_solid_angle(sampler.get(), &a) == PSC_SUCCESS
         && sampler.solid_angle() == a;
    a = b = -1;
    ok &= psc_sampler_form_factor(sampler.get(), &a) == sampler.form_factor(b) && a == b;
    if constexpr (has_form_factor<Light>)
        ok &= psc::form_factor(from, light, b) == PSC_SUCCESS && a == b;
    ok &= psc_sampler_projected_solid_angle(sampler.get(), &a)
              == sampler.projected_solid_angle(b)
          && a == b;
    a = b = -1;
    ok &= psc_sampler_area(sampler.get(), &a) == sampler.area(b) && a == b;
    if constexpr (has_solid_angle<Light>)
        /* Not to the bit: a rectangle's own way is not that of the fan which samples it. */
        ok &= psc::solid_angle(from.position, light, b) == PSC_SUCCESS
              && std::fabs(b - sampler.solid_angle()) <= 1e-15 * b;
    tap_ok(ok, "%s: totals, with and without a sampler", name);
    tap_ok(wavefront<double, psc_light_sample_f64>(light)
               && wavefront<float, psc_light_sample_f32>(light),
           "%s: wavefronts", name);
}

void samplers()
{
    psc::sampler a, empty;
    psc_light_sample_f32 s;
    const psc::sphere sphere{{0, 0, 2}, 1};

    tap_ok(empty.total() == 0 && empty.sample(0.5f, 0.5f, s) == PSC_EMPTY
               && empty.describe().shape == PSC_SHAPE_NONE,
           "a sampler is empty at first");
    a.build(technique, from, sphere);
    psc::sampler copy = a;
    std::vector<psc::sampler> moved;
    for (int i = 0; i < 5; i++)
        moved.push_back(a);
    a.build(technique, {{0, 0, 0}, {{0, 0, -1}}}, sphere);
    psc_light_sample_f32 t;
    bool ok = a.sample(0.2f, 0.3f, s) == PSC_EMPTY && copy.sample(0.2f, 0.3f, s) == PSC_SUCCESS;
    for (const psc::sampler &m : moved)
        ok &= m.sample(0.2f, 0.3f, t) == PSC_SUCCESS && same(s, t);
    empty = copy;
    ok &= empty.sample(0.2f, 0.3f, t) == PSC_SUCCESS && same(s, t);
    tap_ok(ok, "copies are samplers of their own");
    tap_ok(a.build(psc::technique(99), from, sphere) == PSC_ERROR_UNKNOWN_MEASURE
               && a.build(technique, from, psc::sphere{{0, 0, 2}, -1}) == PSC_ERROR_NEGATIVE_SIZE,
           "errors are returned");
}

} // namespace

int main()
{
    samplers();
    light("sphere", PSC_SHAPE_SPHERE, psc::sphere{{0.5, 0, 2}, 0.75},
          [](auto... call) {
              const double center[3] = {0.5, 0, 2};
              return psc_build_sphere(call..., center, 0.75);
          });
    light("cap", PSC_SHAPE_CAP, psc::cap{{0.5, 0, 2}, 0.25}, [](auto... call) {
        const double axis[3] = {0.5, 0, 2};
        return psc_build_cap(call..., axis, 0.25);
    });
    light("triangle", PSC_SHAPE_TRIANGLE, psc::triangle{{0.5, 0, 2}, {1, 0.5, 2}, {0, 1, 1.5}},
          [](auto... call) {
              const double v0[3] = {0.5, 0, 2}, v1[3] = {1, 0.5, 2}, v2[3] = {0, 1, 1.5};
              return psc_build_triangle(call..., v0, v1, v2);
          });
    const psc::vector center = {0.5, 0, 2}, x = {1, 0, 0.5}, y = {0, 0.5, 0}, z = {-0.25, 0, 0.5};
    light("disk", PSC_SHAPE_DISK, psc::disk{center, {0.25, 0, 1}, 0.75}, [&](auto... call) {
        const double normal[3] = {0.25, 0, 1};
        return psc_build_disk(call..., center.data(), normal, 0.75);
    });
    light("ellipse", PSC_SHAPE_ELLIPSE, psc::ellipse{center, x, y}, [&](auto... call) {
        return psc_build_ellipse(call..., center.data(), x.data(), y.data());
    });
    light("ellipsoid", PSC_SHAPE_ELLIPSOID, psc::ellipsoid{center, x, y, z}, [&](auto... call) {
        return psc_build_ellipsoid(call..., center.data(), x.data(), y.data(), z.data());
    });
    light("rectangle", PSC_SHAPE_RECTANGLE, psc::rectangle{center, x, y}, [&](auto... call) {
        return psc_build_rectangle(call..., center.data(), x.data(), y.data());
    });
    const psc::vector vertices[] = {{0, 0, 2}, {1, 0, 2}, {1.5, 1, 2}, {0.5, 2, 2}, {-0.5, 1, 2}};
    light("polygon", PSC_SHAPE_POLYGON, psc::polygon{vertices, 5}, [&](auto... call) {
        return psc_build_polygon(call..., 5, vertices[0].data(), sizeof vertices[0]);
    });
    return tap_done();
}
