/* SPDX-License-Identifier: Apache-2.0 */
#include "scene.hpp"

#include <cstring>
#include <limits>
#include <stdexcept>

/* ---- Materials */

static Vector mirror(Vector normal, Vector in)
{
    return 2 * dot(normal, in) * normal - in;
}

float Material::f(Vector normal, Vector in, Vector out) const
{
    if (dot(normal, in) <= 0 || dot(normal, out) <= 0)
        return 0;
    const float lobe = std::fmax(0.0f, dot(mirror(normal, in), out));
    return diffuse / pi + specular * (exponent + 2) / (2 * pi) * std::pow(lobe, exponent);
}

float Material::pdf(Vector normal, Vector in, Vector out) const
{
    const float lobe = std::fmax(0.0f, dot(mirror(normal, in), out));
    const float cosine = std::fmax(0.0f, dot(normal, out));
    return (diffuse * cosine / pi + specular * (exponent + 1) / (2 * pi) * std::pow(lobe, exponent))
           / (diffuse + specular);
}

Vector Material::sample(Vector normal, Vector in, Random &random) const
{
    const bool matt = random() * (diffuse + specular) < diffuse;
    const float phi = 2 * pi * random(), u = 1 - random();
    const float z = matt ? std::sqrt(u) : std::pow(u, 1 / (exponent + 1));
    const float r = std::sqrt(std::fmax(0.0f, 1 - z * z));
    return about(matt ? normal : unit(mirror(normal, in)), r * std::cos(phi), r * std::sin(phi), z);
}

/* ---- Geometry */

void Scene::quad(int what, Vector corner, Vector u, Vector v)
{
    const auto first = std::uint32_t(points.size());
    points.insert(points.end(), {corner, corner + u, corner + u + v, corner + v});
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
    materials.insert(materials.end(), 2, what);
}

/* A tube along the (2,3) torus knot. */
void Scene::knot()
{
    const int around = 16, along = 192;
    const auto first = std::uint32_t(points.size());
    const auto curve = [](float t) -> Vector {
        const float r = 0.72f + 0.3f * std::cos(3 * t);
        return {r * std::cos(2 * t), 0.5f + r * std::sin(2 * t), 1.0f + 0.35f * std::sin(3 * t)};
    };
    for (int i = 0; i < along; i++) {
        const float t = 2 * pi * float(i) / along;
        const Vector center = curve(t), tangent = unit(curve(t + 1e-2f) - curve(t - 1e-2f));
        const Vector side = unit(cross(tangent, {0, 0, 1})), up = cross(side, tangent);
        for (int k = 0; k < around; k++) {
            const float a = 2 * pi * float(k) / around;
            points.push_back(center + 0.15f * (std::cos(a) * side + std::sin(a) * up));
            const auto at = [&](int p, int q) {
                return first + std::uint32_t(p % along * around + q % around);
            };
            triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
            materials.insert(materials.end(), 2, KNOT);
        }
    }
}

Scene::Scene()
    : light{{{psc::sphere{{-1.9, -0.6, 0.5}, 0.4}, "sphere", 6, {1, 0.75f, 0.5f}},
             {psc::triangle{{-1.6, 2.6, 1.2}, {-0.4, 2.6, 1.4}, {-1.2, 2.3, 2.2}}, "triangle", 7,
              {1, 0.5f, 0.6f}},
             {psc::disk{{2.1, -0.9, 0.42}, {-1, 0.25, 0}, 0.36}, "disk", 6, {0.5f, 0.7f, 1}},
             /* Half sunk into the floor. */
             {psc::rectangle{{1.3, 2.3, -0.6}, {1.6, -0.6, 0}, {0, 0, 1.2}}, "rectangle", 4,
              {0.6f, 1, 0.7f}, true}}},
      material{{{"diffuse floor", 0.7f, 0, 1},
                {"glossy floor", 0.1f, 0.7f, 60},
                {"wall", 0.6f, 0, 1},
                {"knot", 0.4f, 0.4f, 20}}}
{
    quad(FLOOR, {-4, -4, 0}, {4, 0, 0}, {0, 7, 0});
    quad(GLOSSY_FLOOR, {0, -4, 0}, {4, 0, 0}, {0, 7, 0});
    quad(WALL, {-4, 3, 0}, {8, 0, 0}, {0, 0, 4});
    knot();

    device.reset(rtcNewDevice("threads=1"));
    if (!device)
        throw std::runtime_error("Embree gives no device");
    scene.reset(rtcNewScene(device.get()));
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        sizeof points[0], points.size()),
                points.data(), points.size() * sizeof points[0]);
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                        sizeof triangles[0], triangles.size()),
                triangles.data(), triangles.size() * sizeof triangles[0]);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
}

/* ---- Rays */

static RTCRay ray_from(Vector origin, Vector direction, float end)
{
    RTCRay ray = {};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = 1e-4f;
    ray.tfar = end;
    ray.mask = ~0u;
    return ray;
}

Hit Scene::intersect(Vector origin, Vector direction) const
{
    RTCRayHit query = {};
    RTCIntersectContext context;
    Hit hit = {std::numeric_limits<float>::infinity(), -1, -1, {}, {}};

    query.ray = ray_from(origin, direction, hit.distance);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene.get(), &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        hit.distance = query.ray.tfar;
        hit.material = materials[query.hit.primID];
        hit.normal = unit({query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
        if (dot(hit.normal, direction) > 0)
            hit.normal = -hit.normal;
    }
    for (int l = 0; l < lights; l++) {
        Vector normal;
        const float t = light[l].hit(origin, direction, normal);
        if (t < hit.distance) {
            hit.distance = t;
            hit.light = l;
            hit.normal = normal;
        }
    }
    hit.position = origin + hit.distance * direction;
    return hit;
}

bool Scene::occluded(Vector origin, Vector direction, float distance, int to) const
{
    RTCRay ray = ray_from(origin, direction, distance * (1 - 1e-4f));
    RTCIntersectContext context;

    for (int l = 0; l < lights; l++) {
        Vector normal;
        if (l != to && light[l].hit(origin, direction, normal) < distance)
            return true;
    }
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene.get(), &context, &ray);
    return ray.tfar < 0;
}

Vector Scene::view(float x, float y) const
{
    const Vector forward = unit(Vector{0, 0.6f, 0.8f} - eye);
    const Vector right = unit(cross(forward, {0, 0, 1})), up = cross(right, forward);
    return unit(forward + (x - 0.5f) * 0.96f * right + (0.5f - y) * 0.72f * up);
}
