/* SPDX-License-Identifier: Apache-2.0 */
/* A floor, half of it glossy, a wall and a knot, in Embree; lights; a camera. */
#ifndef PATH_SCENE_HPP
#define PATH_SCENE_HPP

#include <memory>
#include <vector>

#include <embree3/rtcore.h>

#include "light.hpp"

/* Diffuse, plus a lobe of Phong about the direction of the mirror. */
struct Material {
    const char *name;
    float diffuse, specular, exponent;

    /* The BSDF for a unit normal and unit directions away from the point. */
    float f(Vector normal, Vector in, Vector out) const;
    /* Density of sample() per steradian. */
    float pdf(Vector normal, Vector in, Vector out) const;
    Vector sample(Vector normal, Vector in, Random &random) const;
};

enum { FLOOR, GLOSSY_FLOOR, WALL, KNOT, MATERIALS };
constexpr int lights = 4;

struct Hit {
    float distance;
    int light;    /* or -1 */
    int material; /* or -1: nothing was hit */
    Vector position, normal;
};

class Scene {
public:
    Scene();

    Hit intersect(Vector origin, Vector direction) const;
    /* Whether anything is between a point and one of a light, seen in a direction. */
    bool occluded(Vector origin, Vector direction, float distance, int light) const;
    /* The direction of the camera's ray through a point of the unit square. */
    Vector view(float x, float y) const;

    Vector eye = {0, -6.5f, 2.6f};
    std::array<Light, lights> light;
    std::array<Material, MATERIALS> material;

private:
    void quad(int what, Vector corner, Vector u, Vector v);
    void knot();

    std::vector<Vector> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<int> materials; /* of the triangles */
    std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device{nullptr, rtcReleaseDevice};
    std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene{nullptr, rtcReleaseScene};
};

#endif
