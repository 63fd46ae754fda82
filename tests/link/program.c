/* SPDX-License-Identifier: Apache-2.0 */
/* A program of somebody else's, in C and C++ alike: samples a sphere on the z axis. */
#include <psc/psc.h>

#include <stdio.h>

int main(void)
{
    static const double position[3] = {0, 0, 0}, normal[3] = {0, 0, 1}, center[3] = {0, 0, 2};
    const double pi = 3.14159265358979;
    psc_technique technique = {sizeof technique, PSC_MEASURE_PROJECTED_SOLID_ANGLE,
                               PSC_MAP_CONCENTRIC, 0, NULL};
    psc_receiver receiver = {sizeof receiver, 0, position, normal};
    psc_sampler_storage storage;
    psc_sampler *sampler;
    psc_light_sample_f64 sample;

    if (psc_version() != PSC_VERSION)
        return 1;
    if (psc_sampler_init(&storage, sizeof storage, &sampler) != PSC_SUCCESS)
        return 2;
    if (psc_build_sphere(sampler, &technique, &receiver, center, 1.0) != PSC_SUCCESS)
        return 3;
    if (psc_sample_f64(sampler, 0.3, 0.7, &sample) != PSC_SUCCESS)
        return 4;
    /* The projected solid angle of a sphere overhead is pi (radius / distance)^2. */
    printf("weight %.17g\n", sample.weight);
    return sample.weight < pi / 4 * (1 - 1e-12) || sample.weight > pi / 4 * (1 + 1e-12) ? 5 : 0;
}
