/* SPDX-License-Identifier: Apache-2.0 */
/*
 * plugin LIBRARY: a host that knows the library as a path alone. It loads it by its function table
 * and by names, twice at once, again and again, and says what is wrong with one that is too old.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <link.h>
#include <psc/psc.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../tap.h"

typedef psc_result get_api_function(uint32_t, void *, size_t);

/* The way from the path of a library to its functions, as a host would write it. Returns NULL, or
   what is wrong with it in words. */
static const char *load(const char *path, void **library, psc_api_1 *api, size_t size)
{
    static char message[200];
    get_api_function *get_api;
    psc_result result;

    *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!*library)
        return dlerror();
    *(void **)&get_api = dlsym(*library, "psc_get_api");
    if (!get_api)
        return dlerror();
    result = get_api(1, api, size);
    if (result == PSC_SUCCESS)
        return NULL;
    /* Every library has the first two functions, which say the rest. */
    if (get_api(1, api, offsetof(psc_api_1, sampler_size)) != PSC_SUCCESS)
        return "not a libpsc";
    snprintf(message, sizeof message, "%s (it is %u.%u.%u, compiled for %d.%d.%d)",
             api->result_string(result), api->version() >> 22, api->version() >> 12 & 1023,
             api->version() & 4095, PSC_VERSION_MAJOR, PSC_VERSION_MINOR, PSC_VERSION_PATCH);
    return message;
}

static int sample(const psc_api_1 *api, psc_light_sample_f64 *out)
{
    static const double position[3] = {0, 0, 0}, center[3] = {0.5, 0, 2};
    psc_technique technique = {.struct_size = sizeof technique};
    psc_receiver receiver = {.struct_size = sizeof receiver, .position = position};
    psc_sampler_storage storage;
    psc_sampler *sampler;

    memset(out, 0, sizeof *out);
    return api->version() == PSC_VERSION
           && api->sampler_init(&storage, sizeof storage, &sampler) == PSC_SUCCESS
           && api->build_sphere(sampler, &technique, &receiver, center, 1.0) == PSC_SUCCESS
           && api->sample_f64(sampler, 0.3, 0.7, out) == PSC_SUCCESS && out->pdf > 0.0;
}

static int same(const psc_light_sample_f64 *a, const psc_light_sample_f64 *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* A second file of the same library, which the loader cannot take for the first. */
static int copy_file(const char *from, char *to)
{
    static char block[65536];
    const int out = mkstemp(to);
    FILE *in = fopen(from, "rb");
    int ok = in && out >= 0;
    size_t n;

    while (ok && (n = fread(block, 1, sizeof block, in)) > 0)
        ok = write(out, block, n) == (ssize_t)n;
    if (in)
        fclose(in);
    return out >= 0 && close(out) == 0 && ok;
}

static void mismatch(const char *path, psc_api_1 *api)
{
    struct {
        psc_api_1 known;
        void (*added_later)(void);
    } newer;
    char words[64];
    const char *message;
    get_api_function *get_api;
    void *library;

    message = load(path, &library, &newer.known, sizeof newer);
    snprintf(words, sizeof words, "(it is %d.%d.%d,", PSC_VERSION_MAJOR, PSC_VERSION_MINOR,
             PSC_VERSION_PATCH);
    tap_ok(message && strstr(message, "older") && strstr(message, words),
           "a host with a newer header is told: %s", message ? message : "(nothing)");
    *(void **)&get_api = library ? dlsym(library, "psc_get_api") : NULL;
    tap_ok(get_api && get_api(2, api, sizeof *api) == PSC_ERROR_UNKNOWN_VERSION,
           "there is no second table yet");
    tap_ok(library && !dlvsym(library, "psc_sample_f64", "PSC_99.0"),
           "nor a name of a later release: %s", dlerror());
    if (library)
        dlclose(library);
    message = load("/nowhere/libpsc.so.0", &library, api, sizeof *api);
    tap_ok(message && strstr(message, "/nowhere/libpsc.so.0"), "a wrong path: %s", message);
}

int main(int argc, char **argv)
{
    char other_path[] = "/tmp/psc-plugin-XXXXXX";
    void *library, *other;
    const struct link_map *map = NULL;
    psc_light_sample_f64 by_table, by_name, by_copy;
    psc_api_1 api, names, copy;
    const char *message;
    int i, ok;

    if (argc != 2) {
        fprintf(stderr, "usage: plugin LIBRARY\n");
        return 2;
    }
    message = load(argv[1], &library, &api, sizeof api);
    if (!tap_ok(!message && sample(&api, &by_table), "by table%s%s", message ? ": " : "",
                message ? message : ""))
        return tap_done();
    tap_ok(!dlsym(RTLD_DEFAULT, "psc_version"), "its names stay local");

    *(void **)&names.version = dlsym(library, "psc_version");
    *(void **)&names.sampler_init = dlsym(library, "psc_sampler_init");
    *(void **)&names.build_sphere = dlsym(library, "psc_build_sphere");
    *(void **)&names.sample_f64 = dlsym(library, "psc_sample_f64");
    tap_ok(names.version && names.sampler_init && names.build_sphere && names.sample_f64
               && sample(&names, &by_name) && same(&by_table, &by_name),
           "by names, the same sample");

    ok = dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && copy_file(map->l_name, other_path);
    message = ok ? load(other_path, &other, &copy, sizeof copy) : "cannot copy the library";
    if (tap_ok(!message, "a copy beside it%s%s", message ? ": " : "", message ? message : "")) {
        tap_ok(other != library && copy.sample_f64 != api.sample_f64 && sample(&copy, &by_copy)
                   && same(&by_table, &by_copy) && sample(&api, &by_copy)
                   && same(&by_table, &by_copy),
               "two copies at once, the same sample");
        tap_ok(dlclose(other) == 0 && sample(&api, &by_copy) && same(&by_table, &by_copy),
               "unloading one leaves the other");
    }
    unlink(other_path);

    tap_ok(dlclose(library) == 0 && !dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD), "unloads");
    for (i = 0, ok = 1; ok && i < 100; i++) {
        ok = !load(argv[1], &library, &api, sizeof api) && sample(&api, &by_copy)
             && same(&by_table, &by_copy) && dlclose(library) == 0;
    }
    tap_ok(ok, "loads and unloads a hundred times");
    mismatch(argv[1], &api);
    return tap_done();
}
