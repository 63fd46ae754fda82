/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The life of a handle: in memory of the caller, from an allocator, copied and moved; what the
 * results are called; the function table.
 */
#include <limits.h>
#include <stdlib.h>

#include "shapes.h"
#include "tap.h"

static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};

static void results(void)
{
    static const psc_result strange[] = {4, 5, 1000, -22, -1000, INT32_MIN, INT32_MAX};
    int a, b;
    size_t i;

    for (a = PSC_ERROR_RESOLUTION; a <= PSC_OUTSIDE; a++) {
        const char *words = psc_result_string(a);
        int distinct = words && strlen(words) > 3;

        for (b = PSC_ERROR_RESOLUTION; distinct && b < a; b++)
            distinct = strcmp(words, psc_result_string(b)) != 0;
        tap_ok(distinct, "result %d has words of its own: %s", a, words ? words : "(none)");
    }
    for (i = 0; i < sizeof strange / sizeof strange[0]; i++)
        tap_ok(psc_result_string(strange[i]) != NULL, "result %ld has words", (long)strange[i]);
}

static int is_empty(const psc_sampler *s)
{
    double total = 1.0;
    return psc_sampler_total(s, &total) == PSC_EMPTY && total == 0.0;
}

static void memory(void)
{
    static union {
        psc_sampler_storage storage;
        unsigned char bytes[sizeof(psc_sampler_storage) + 64];
    } room;
    size_t size = psc_sampler_size(), align = psc_sampler_align(), i;
    psc_sampler *s, *mark = (psc_sampler *)(void *)&room;

    tap_ok(size > 0 && size <= sizeof(psc_sampler_storage), "size fits the storage");
    tap_ok(align > 0 && (align & (align - 1)) == 0 && align <= sizeof(void *) * 2,
           "alignment is one of malloc's");
    s = mark;
    tap_ok(psc_sampler_init(NULL, size, &s) == PSC_ERROR_NULL_POINTER && !s, "no memory");
    tap_ok(psc_sampler_init(&room, size, NULL) == PSC_ERROR_NULL_POINTER, "no place for it");
    for (i = 0; i < size; i += i < size - 2 ? (size - 2) / 3 : 1) {
        s = mark;
        tap_ok(psc_sampler_init(&room, i, &s) == PSC_ERROR_STORAGE && !s, "%zu bytes are short",
               i);
    }
    for (i = 1; i < align; i++) {
        s = mark;
        tap_ok(psc_sampler_init(room.bytes + i, sizeof(psc_sampler_storage), &s) ==
                   PSC_ERROR_STORAGE && !s, "%zu bytes off the alignment", i);
    }
    tap_ok(psc_sampler_init(room.bytes + align, size, &s) == PSC_SUCCESS && s && is_empty(s),
           "exactly enough, on the alignment");
    psc_sampler_destroy(s);
    tap_ok(is_empty(s), "destroying an initialised sampler leaves it alone");
    psc_sampler_destroy(NULL);
    tap_ok(1, "destroying NULL");
}

/* ---- Allocators */

struct account {
    int allocated, released, fail;
    size_t size, align;
    void *memory;
};

static void *allocate(void *user, size_t size, size_t align)
{
    struct account *account = user;

    account->allocated++;
    account->size = size;
    account->align = align;
    account->memory = account->fail ? NULL : malloc(size);
    return account->memory;
}

static void release(void *user, void *memory_)
{
    struct account *account = user;

    if (memory_ == account->memory)
        account->released++;
    free(memory_);
}

static psc_allocator make_allocator(struct account *account)
{
    psc_allocator allocator = {sizeof allocator, 0, NULL, allocate, release};

    memset(account, 0, sizeof *account);
    allocator.user = account;
    return allocator;
}

static void refuse(const char *name, const psc_allocator *allocator, const struct account *account,
                   psc_result expected)
{
    static psc_sampler_storage storage;
    psc_sampler *s = (psc_sampler *)(void *)&storage;
    psc_result result = psc_sampler_create(allocator, &s);

    tap_ok(result == expected && !s, "%s: %s", name, psc_result_string(expected));
    tap_ok(account->released == 0 && account->allocated == account->fail,
           "%s: nothing is kept", name);
}

static void allocators(void)
{
    struct { psc_allocator a; uint64_t more[2]; } later;
    struct account account;
    psc_allocator allocator = make_allocator(&account);
    const struct test_technique *what;
    psc_sampler *s;
    uint32_t size;

    tap_ok(psc_sampler_create(&allocator, NULL) == PSC_ERROR_NULL_POINTER &&
               account.allocated == 0, "create: no place for it");
    account.fail = 1;
    refuse("an allocator without memory", &allocator, &account, PSC_ERROR_OUT_OF_MEMORY);
    for (size = 0; size < sizeof allocator; size += 3) {
        allocator = make_allocator(&account);
        allocator.struct_size = size;
        refuse("a short allocator", &allocator, &account, PSC_ERROR_STRUCT_SIZE);
    }
    allocator.struct_size = 4097;
    refuse("an allocator of no size", &allocator, &account, PSC_ERROR_STRUCT_SIZE);
    allocator = make_allocator(&account);
    allocator.reserved = 1;
    refuse("an unknown field", &allocator, &account, PSC_ERROR_UNKNOWN_FIELD);
    allocator = make_allocator(&account);
    allocator.allocate = NULL;
    refuse("no allocate", &allocator, &account, PSC_ERROR_NULL_POINTER);
    allocator = make_allocator(&account);
    allocator.release = NULL;
    refuse("no release", &allocator, &account, PSC_ERROR_NULL_POINTER);

    memset(&later, 0, sizeof later);
    later.a = make_allocator(&account);
    later.a.struct_size = sizeof later;
    later.more[1] = 1;
    refuse("a later field that is set", &later.a, &account, PSC_ERROR_UNKNOWN_FIELD);
    later.more[1] = 0;
    tap_ok(psc_sampler_create(&later.a, &s) == PSC_SUCCESS, "a later field that is not");
    psc_sampler_destroy(s);

    allocator = make_allocator(&account);
    tap_ok(psc_sampler_create(&allocator, &s) == PSC_SUCCESS && is_empty(s), "create");
    tap_ok(account.allocated == 1 && account.size >= psc_sampler_size() &&
               account.align == psc_sampler_align(), "one allocation, of the right size");
    memset(&allocator, 0, sizeof allocator); /* it was copied */
    for (FOR_TECHNIQUES(&shape_sphere, what)) {
        const double center[3] = {0.5, 0.0, 0.3};
        psc_light_sample_f64 sample;

        build_sphere(s, what, 0, origin, up, center, 0.4);
        psc_sample_f64(s, 0.5, 0.5, &sample);
        build_sphere(s, what, 0, origin, up, center, -1.0);
    }
    tap_ok(account.allocated == 1 && account.released == 0, "building allocates nothing");
    psc_sampler_destroy(s);
    tap_ok(account.allocated == 1 && account.released == 1, "destroy releases it");
    tap_ok(psc_sampler_create(NULL, &s) == PSC_SUCCESS && is_empty(s), "create with malloc");
    psc_sampler_destroy(s);
}

/* ---- Copies */

static void copies(const struct shape *shape)
{
    const struct test_technique *what;

    for (FOR_TECHNIQUES(shape, what)) {
        uint64_t seed = 10;
        struct test_sampler here;
        psc_sampler_storage there;
        psc_light_sample_f64 a, b;
        struct light light;

        memset(&a, 0, sizeof a);
        do
            place_light(&seed, shape, what, PLACE_ORDINARY, HORIZON_CUT, FACING_ONE, &light);
        while (build_light(make_sampler(&here), &light) != PSC_SUCCESS);
        psc_sample_f64(here.sampler, 0.3, 0.6, &a);
        memcpy(&there, &here.storage, psc_sampler_size());
        memset(&here.storage, 0xff, sizeof here.storage);
        psc_sample_f64((psc_sampler *)(void *)&there, 0.3, 0.6, &b);
        tap_ok(memcmp(&a, &b, sizeof a) == 0 && a.pdf > 0.0, "a copy samples the same: %s, %s",
               shape->name, what->name);
    }
}

/* ---- The function table */

static void table(void)
{
    psc_api_1 api;
    unsigned char bytes[sizeof api + 16];
    void (*entry)(void);
    size_t i, size;
    int ok;

    tap_ok(psc_get_api(1, NULL, sizeof api) == PSC_ERROR_NULL_POINTER, "no table");
    for (i = 0; i < 4; i++) {
        static const uint32_t version[4] = {0, 2, 1000, UINT32_MAX};

        memset(bytes, 0xa5, sizeof bytes);
        ok = psc_get_api(version[i], bytes, sizeof api) == PSC_ERROR_UNKNOWN_VERSION;
        for (size = 0; size < sizeof bytes; size++)
            ok &= bytes[size] == 0xa5;
        tap_ok(ok, "version %lu is unknown", (unsigned long)version[i]);
    }
    memset(bytes, 0xa5, sizeof bytes);
    ok = psc_get_api(1, bytes, sizeof bytes) == PSC_ERROR_UNKNOWN_VERSION &&
         psc_get_api(1, bytes, 0) == PSC_ERROR_STRUCT_SIZE &&
         psc_get_api(1, bytes, sizeof entry + 1) == PSC_ERROR_STRUCT_SIZE;
    for (i = 0; i < sizeof bytes; i++)
        ok &= bytes[i] == 0xa5;
    tap_ok(ok, "a larger table than there is, none, and parts of functions");
    for (size = sizeof entry; size <= sizeof api; size += sizeof entry) {
        memset(bytes, 0xa5, sizeof bytes);
        ok = psc_get_api(1, bytes, size) == PSC_SUCCESS;
        for (i = size; i < sizeof bytes; i++)
            ok &= bytes[i] == 0xa5;
        for (i = 0; i < size; i += sizeof entry) {
            memcpy(&entry, bytes + i, sizeof entry);
            ok &= entry != NULL;
        }
        tap_ok(ok, "the first %zu bytes", size);
    }
    psc_get_api(1, &api, sizeof api);
    tap_ok(api.version() == psc_version() && psc_version() == PSC_VERSION, "its version");
    tap_ok(strcmp(api.result_string(PSC_EMPTY), psc_result_string(PSC_EMPTY)) == 0,
           "its result strings");
    tap_ok(api.sampler_size() == psc_sampler_size() && api.sampler_align() == psc_sampler_align(),
           "its sizes");
}

int main(void)
{
    int i;

    results();
    memory();
    allocators();
    for (i = 0; shapes[i]; i++)
        copies(shapes[i]);
    table();
    return tap_done();
}
