/* SPDX-License-Identifier: Apache-2.0 */
#include "shade.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void check_result(psc_result result, const char *what)
{
    if (result >= 0)
        return;
    fprintf(stderr, "render: %s: %s\n", what, psc_result_string(result));
    exit(EXIT_FAILURE);
}

void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory) {
        fprintf(stderr, "render: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

/* ---- The work of a frame, shared out in tiles -------------------------------------------- */

enum { TILE = 512 };

typedef struct job {
    const frame *frame;
    const sampling *how;
    irradiance light;
    unsigned layer;
    void (*run)(const struct job *, size_t begin, size_t count);
    atomic_size_t next;
    double seconds[64];
    atomic_uint threads_seen;
} job;

static double processor_time(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *work(void *argument)
{
    job *j = argument;
    const size_t end = j->frame->first[j->layer + 1];
    const double start = processor_time();
    for (size_t i; (i = atomic_fetch_add(&j->next, TILE)) < end;)
        j->run(j, i, end - i < TILE ? end - i : TILE);
    j->seconds[atomic_fetch_add(&j->threads_seen, 1)] = processor_time() - start;
    return NULL;
}

static double run_layer(job *j, unsigned layer)
{
    pthread_t thread[64];
    const unsigned wanted = j->frame->threads;
    unsigned started = 0;
    double seconds = 0;

    j->layer = layer;
    atomic_store(&j->next, j->frame->first[layer]);
    atomic_store(&j->threads_seen, 0);
    while (started + 1 < wanted && !pthread_create(&thread[started], NULL, work, j))
        ++started;
    work(j);
    for (unsigned i = 0; i < started; ++i)
        pthread_join(thread[i], NULL);
    for (unsigned i = 0; i <= started; ++i)
        seconds += j->seconds[i];
    return seconds;
}

/* ---- Sampling a tile --------------------------------------------------------------------- */

/* One sample of one light for each point of a tile. */
typedef struct tile {
    float u[TILE], v[TILE];
    float x[TILE], y[TILE], z[TILE];
    float distance[TILE], weight[TILE];
    psc_result status[TILE];
} tile;

static void sample_tile(const psc_technique *technique, int fog, const hit *hits, size_t count,
                        const emitter *l, tile *t)
{
    const psc_receivers_f32 receivers = {
        .struct_size = sizeof receivers,
        .position = {{&hits->position.x, &hits->position.y, &hits->position.z}, sizeof *hits},
        .normal = {{fog ? NULL : &hits->normal.x, &hits->normal.y, &hits->normal.z},
                   sizeof *hits}};
    const psc_input_f32 uv = {{t->u, t->v}, sizeof(float)};
    const psc_samples_f32 out = {.struct_size = sizeof out,
                                 .direction = {{t->x, t->y, t->z}, sizeof(float)},
                                 .distance = {{t->distance}, sizeof(float)},
                                 .weight = {{t->weight}, sizeof(float)},
                                 .status = {t->status, sizeof(psc_result)}};

    check_result(light_sample_n(l, technique, count, &receivers, &uv, &out), "sampling a tile");
}

static void sample_singly(const psc_technique *technique, int fog, const hit *hits, size_t count,
                          const emitter *l, tile *t)
{
    psc_sampler_storage storage;
    psc_sampler *sampler;

    check_result(psc_sampler_init(&storage, sizeof storage, &sampler), "making a sampler");
    for (size_t i = 0; i < count; ++i) {
        const vec3 p = hits[i].position, n = hits[i].normal;
        const double position[3] = {p.x, p.y, p.z}, normal[3] = {n.x, n.y, n.z};
        const psc_receiver receiver = {sizeof receiver, 0, position, fog ? NULL : normal};
        psc_light_sample_f32 sample;

        t->status[i] = light_build(l, sampler, technique, &receiver);
        if (t->status[i] != PSC_SUCCESS)
            continue;
        t->status[i] = psc_sample_f32(sampler, t->u[i], t->v[i], &sample);
        t->x[i] = sample.direction[0];
        t->y[i] = sample.direction[1];
        t->z[i] = sample.direction[2];
        t->distance[i] = sample.distance;
        t->weight[i] = sample.weight;
    }
}

unsigned frame_share(unsigned layer, unsigned count)
{
    return (count + LAYERS - 1 - layer) / LAYERS;
}

static void shade_tile(const job *j, size_t begin, size_t count)
{
    const sampling *how = j->how;
    const scene *s = j->frame->scene;
    const hit *hits = j->frame->hits + begin;
    const uint32_t first = how->every_layer ? 0 : j->layer, step = how->every_layer ? 1 : LAYERS;
    const unsigned share = how->every_layer ? how->count : frame_share(j->layer, how->count);
    tile t;

    for (size_t k = 0; k < s->light_count; ++k) {
        const emitter *l = &s->lights[k];
        double sum[TILE] = {0};
        for (uint32_t i = first; i < how->count; i += step) {
            for (size_t m = 0; m < count; ++m) {
                const uint32_t key = mix(hits[m].pixel + mix(how->seed + 977 * (uint32_t)k));
                float uv[2];
                point(how->set, i, how->count, how->every_layer ? key + j->layer : key, uv);
                t.u[m] = uv[0];
                t.v[m] = uv[1];
            }
            (how->singly ? sample_singly : sample_tile)(&how->technique, s->fog > 0, hits, count,
                                                       l, &t);
            for (size_t m = 0; m < count; ++m) {
                const vec3 direction = {t.x[m], t.y[m], t.z[m]};
                if (t.status[m] != PSC_SUCCESS)
                    check_result(t.status[m], "sampling a light");
                else if (!scene_blocked(s, &hits[m], direction, t.distance[m]))
                    sum[m] += s->fog > 0 ? t.weight[m] * expf(-s->fog * t.distance[m])
                                         : t.weight[m];
            }
        }
        for (size_t m = 0; m < count; ++m) {
            double *light = j->light[begin + m];
            light[0] += sum[m] / share * l->radiance.x;
            light[1] += sum[m] / share * l->radiance.y;
            light[2] += sum[m] / share * l->radiance.z;
        }
    }
}

static void shade_tile_exactly(const job *j, size_t begin, size_t count)
{
    const scene *s = j->frame->scene;
    const int fog = s->fog > 0;
    for (size_t m = begin; m < begin + count; ++m) {
        const vec3 p = j->frame->hits[m].position, n = j->frame->hits[m].normal;
        const double position[3] = {p.x, p.y, p.z}, normal[3] = {n.x, n.y, n.z};
        const psc_receiver receiver = {sizeof receiver, 0, position, fog ? NULL : normal};
        for (size_t k = 0; k < s->light_count; ++k) {
            const emitter *l = &s->lights[k];
            const double light = light_exact(l, &receiver, s->fog);
            j->light[m][0] += light * l->radiance.x;
            j->light[m][1] += light * l->radiance.y;
            j->light[m][2] += light * l->radiance.z;
        }
    }
}

static double run_frame(job *j)
{
    double seconds = 0;
    memset(j->light, 0, j->frame->first[LAYERS] * sizeof *j->light);
    for (unsigned k = 0; k < LAYERS; ++k)
        if (!j->how || j->how->every_layer || frame_share(k, j->how->count) > 0)
            seconds += run_layer(j, k);
    return seconds;
}

double shade(const frame *f, const sampling *how, irradiance light)
{
    job j = {.frame = f, .how = how, .light = light, .run = shade_tile};
    return run_frame(&j);
}

void shade_exactly(const frame *f, irradiance light)
{
    job j = {.frame = f, .light = light, .run = shade_tile_exactly};
    run_frame(&j);
}

/* ---- Camera rays ------------------------------------------------------------------------- */

void frame_make(frame *f, const scene *s, unsigned width, unsigned threads)
{
    static const float place[LAYERS][2] = {
        {0.375f, 0.125f}, {0.625f, 0.875f}, {0.875f, 0.375f}, {0.125f, 0.625f}};
    static const float along[LAYERS] = {0.625f, 0.125f, 0.375f, 0.875f}; /* a ray through fog */
    const unsigned height = (unsigned)lroundf((float)width / s->aspect);
    const size_t pixels = (size_t)width * height;

    *f = (frame){.scene = s, .width = width, .height = height, .threads = threads};
    f->hits = allocate(pixels * LAYERS, sizeof *f->hits);
    for (unsigned k = 0; k < LAYERS; ++k) {
        f->index[k] = allocate(pixels, sizeof *f->index[k]);
        f->backdrop[k] = allocate(pixels, sizeof *f->backdrop[k]);
        f->first[k + 1] = f->first[k];
        for (uint32_t p = 0; p < pixels; ++p) {
            hit *h = &f->hits[f->first[k + 1]];
            const float x = ((float)(p % width) + place[k][0]) / (float)width;
            const float y = ((float)(p / width) + place[k][1]) / (float)height;
            h->pixel = p;
            f->index[k][p] = scene_look(s, 2 * x - 1, 1 - 2 * y, along[k], h, &f->backdrop[k][p])
                                 ? (int32_t)f->first[k + 1]++
                                 : -1;
        }
    }
}

void frame_free(frame *f)
{
    for (unsigned k = 0; k < LAYERS; ++k) {
        free(f->index[k]);
        free(f->backdrop[k]);
    }
    free(f->hits);
}
