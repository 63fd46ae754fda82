/* SPDX-License-Identifier: Apache-2.0 */
/* plugin LIBRARY: loads the library at run time, by its table and by names, and samples once. */
#include <dlfcn.h>
#include <psc/psc.h>
#include <stdio.h>
#include <string.h>

static const double position[3] = {0, 0, 0}, center[3] = {0, 0, 2};

static int sample(const psc_api_1 *api, psc_light_sample_f64 *out)
{
    psc_technique technique = {.struct_size = sizeof technique};
    psc_receiver receiver = {.struct_size = sizeof receiver, .position = position};
    psc_sampler_storage storage;
    psc_sampler *sampler;
    return api->version() == PSC_VERSION
           && api->sampler_init(&storage, sizeof storage, &sampler) == PSC_SUCCESS
           && api->build_sphere(sampler, &technique, &receiver, center, 1.0) == PSC_SUCCESS
           && api->sample_f64(sampler, 0.3, 0.7, out) == PSC_SUCCESS;
}

int main(int argc, char **argv)
{
    void *library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    psc_result (*get_api)(uint32_t, void *, size_t);
    psc_api_1 table, names;
    psc_light_sample_f64 by_table, by_name;

    if (!library) {
        fprintf(stderr, "%s\n", argc == 2 ? dlerror() : "usage: plugin LIBRARY");
        return 1;
    }
    *(void **)&get_api = dlsym(library, "psc_get_api");
    if (!get_api || get_api(1, &table, sizeof table) != PSC_SUCCESS || !sample(&table, &by_table))
        return 2;

    *(void **)&names.version = dlsym(library, "psc_version");
    *(void **)&names.sampler_init = dlsym(library, "psc_sampler_init");
    *(void **)&names.build_sphere = dlsym(library, "psc_build_sphere");
    *(void **)&names.sample_f64 = dlsym(library, "psc_sample_f64");
    if (!names.version || !names.sampler_init || !names.build_sphere || !names.sample_f64
        || !sample(&names, &by_name))
        return 3;
    printf("pdf %.17g\n", by_table.pdf);
    if (!(by_table.pdf > 0) || memcmp(&by_table, &by_name, sizeof by_name) != 0)
        return 4;
    return dlclose(library) ? 5 : 0;
}
