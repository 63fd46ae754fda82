/* SPDX-License-Identifier: Apache-2.0 */
/* Paths from the camera: next-event estimation at every light, directions of the BSDF, or both by
   multiple importance sampling. */
#ifndef PATH_TRACER_HPP
#define PATH_TRACER_HPP

#include "scene.hpp"

enum class Strategy { bsdf, light, mis };

struct Settings {
    Strategy strategy;
    std::array<psc::technique, lights> technique;
    int bounces = 2; /* 1: direct light alone */
};

/* What the camera gets from each light: radiance is linear in them. */
using Radiance = std::array<float, lights>;

/* How far the sampler's answers agree with each other, and with the geometry. */
struct Agreement {
    /* Of a sample: its own pdf, and that of its direction. */
    long samples = 0, pdf_differs = 0;
    /* Of a direction of the BSDF: pdf > 0, and hitting the light. */
    long directions = 0, support_differs = 0;
};

/* Radiance along a ray of the camera; first is the material that it sees, or -1. */
Radiance trace(const Scene &scene, const Settings &settings, float x, float y, Random &random,
               int &first, Agreement *agreement = nullptr);

#endif
