/* SPDX-License-Identifier: Apache-2.0 */
/* program.c by the C++ header. */
#include <psc/psc.hpp>

#include <cmath>
#include <cstdio>

int main()
{
    const double pi = std::acos(-1.0);
    const psc::receiver receiver = {{0, 0, 0}, {{0, 0, 1}}};
    const psc::technique technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC);
    psc::sampler sampler;
    psc_light_sample_f64 sample;

    if (psc_version() != PSC_VERSION)
        return 1;
    if (sampler.build(technique, receiver, psc::sphere{{0, 0, 2}, 1}) != PSC_SUCCESS)
        return 3;
    if (sampler.sample(0.3, 0.7, sample) != PSC_SUCCESS)
        return 4;
    std::printf("weight %.17g\n", sample.weight);
    return std::fabs(sample.weight - pi / 4) < pi / 4 * 1e-12 ? 0 : 5;
}
