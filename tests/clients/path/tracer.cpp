/* SPDX-License-Identifier: Apache-2.0 */
#include "tracer.hpp"

/* A point of a path, with every light as it is seen from there. */
struct Vertex {
    Vector position, normal, in;
    const Material *material;
    std::array<psc::sampler, lights> sampler;

    void build(const Scene &scene, const Settings &settings)
    {
        const psc::receiver here = {wide(position), wide(normal)};
        for (int l = 0; l < lights; l++) {
            const psc::technique &how = settings.technique[l];
            std::visit([&](const auto &s) { sampler[l].build(how, here, s); },
                       scene.light[l].shape);
        }
    }
};

/* The balance heuristic: E. Veach, thesis, 1997, section 9.2. */
static float balance(Strategy strategy, float pdf, float other)
{
    return strategy == Strategy::mis ? pdf / (pdf + other) : 1;
}

static float next_event(const Scene &scene, const Settings &settings, const Vertex &at, int l,
                        Random &random, Agreement *agreement)
{
    psc_light_sample_f32 s;
    const float u = random(), v = random();

    if (at.sampler[l].sample(u, v, s) != PSC_SUCCESS)
        return 0;
    const Vector out = {s.direction[0], s.direction[1], s.direction[2]};
    if (agreement) {
        agreement->samples++;
        agreement->pdf_differs += std::fabs(at.sampler[l].pdf(s.direction) / s.pdf - 1) > 1e-3f;
    }
    const float f = at.material->f(at.normal, at.in, out);
    if (f == 0 || scene.occluded(at.position, out, s.distance, l))
        return 0;
    return f * s.weight * scene.light[l].radiance
           * balance(settings.strategy, s.pdf, at.material->pdf(at.normal, at.in, out));
}

static void compare_support(const Scene &scene, const Vertex &at, Vector out, Agreement &agreement)
{
    const float direction[3] = {out.x, out.y, out.z};
    for (int l = 0; l < lights; l++) {
        Vector normal;
        const bool hit = std::isfinite(scene.light[l].hit(at.position, out, normal))
                         && scene.light[l].shines(out, normal);
        agreement.directions++;
        agreement.support_differs += hit != (at.sampler[l].pdf(direction) > 0);
    }
}

Radiance trace(const Scene &scene, const Settings &settings, float x, float y, Random &random,
               int &first, Agreement *agreement)
{
    Radiance radiance = {};
    Vertex at;
    Vector origin = scene.eye, direction = scene.view(x, y);
    float throughput = 1, pdf = 0;

    first = -1;
    for (int bounce = 0;; bounce++) {
        const Hit hit = scene.intersect(origin, direction);
        if (bounce == 0)
            first = hit.light < 0 ? hit.material : -1;
        if (hit.light >= 0) {
            /* The camera sees lights as they are; other directions came from a BSDF. */
            const Light &light = scene.light[hit.light];
            const float d[3] = {direction.x, direction.y, direction.z};
            const bool counts = bounce == 0 || settings.strategy != Strategy::light;
            if (counts && light.shines(direction, hit.normal))
                radiance[hit.light] +=
                    throughput * light.radiance
                    * (bounce == 0 || settings.strategy == Strategy::bsdf
                           ? 1
                           : balance(settings.strategy, pdf, at.sampler[hit.light].pdf(d)));
            break;
        }
        if (hit.material < 0 || bounce == settings.bounces)
            break;

        at.position = hit.position;
        at.normal = hit.normal;
        at.in = -direction;
        at.material = &scene.material[hit.material];
        if (settings.strategy != Strategy::bsdf) {
            at.build(scene, settings);
            for (int l = 0; l < lights; l++)
                radiance[l] += throughput * next_event(scene, settings, at, l, random, agreement);
        }
        const Vector out = at.material->sample(at.normal, at.in, random);
        const float f = at.material->f(at.normal, at.in, out);
        if (f == 0)
            break;
        pdf = at.material->pdf(at.normal, at.in, out);
        throughput *= f * dot(at.normal, out) / pdf;
        if (agreement && settings.strategy != Strategy::bsdf)
            compare_support(scene, at, out, *agreement);
        origin = hit.position;
        direction = out;
    }
    return radiance;
}
