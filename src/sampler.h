/* SPDX-License-Identifier: Apache-2.0 */
/* The handle, and what a shape and a kernel have to supply. */
#ifndef PSC_SRC_SAMPLER_H
#define PSC_SRC_SAMPLER_H

#include <psc/psc.h>

#include "cap_side.h"
#include "disk_side.h"
#include "polygon_state.h"
#include "shapes.h"

/* What becomes of a cosine: none without a normal, one side, or both sides of the plane. */
enum psc_facing { PSC_FACING_NONE, PSC_FACING_ONE, PSC_FACING_BOTH };

struct psc_kernel_f32;
struct psc_kernel_f64;
struct psc_shape_row;

struct psc_sampler {
    psc_allocator allocator; /* of this sampler; struct_size 0 when it owns nothing */

    const struct psc_kernel_f32 *f32; /* bound when built */
    const struct psc_kernel_f64 *f64;
    const struct psc_shape_row *shape; /* NULL: nothing built */
    psc_measure measure;
    psc_map map;
    psc_case visibility;
    enum psc_facing facing;
    int projected; /* pdf is proportional to the cosine */

    double total, inverse_total;

    int sides;    /* 0, 1 or 2: parts of the light that u selects from; 0 when it is empty */
    double split; /* share of u of the first side */

    /* By family. */
    union {
        struct psc_cap_light cap;
        struct psc_disk_light disk;
        struct psc_polygon_light polygon;
    };
};

_Static_assert(sizeof(struct psc_sampler) <= sizeof(psc_sampler_storage), "storage too small");
_Static_assert(_Alignof(struct psc_sampler) <= _Alignof(psc_sampler_storage), "misaligned");

/* The technique and receiver of a call, checked. */
struct psc_request {
    psc_measure measure;
    enum psc_facing facing; /* between these two, which would be copied by one load, before the two
                               stores to them have left for memory */
    psc_map map;
    const double *position;
    const double *normal; /* finite and not zero, or NULL */
    int one_sided;        /* whether the light leaves its surface on one side only */
    const psc_table *table;
    int numbers;          /* of the geometry, where a shape may have more or fewer */
};

/* Of a description whose size is not the one that is known: newer ones may be longer if what is
   added is zero. See checks.h. */
psc_result psc_check_other_size(const void *from, size_t size);
psc_result psc_check_allocator(const psc_allocator *allocator);
/* For psc_samples_f32 and _f64: the size and the reserved field. */
psc_result psc_check_samples(const void *samples, size_t size);

static inline void psc_put_status(const psc_output_result *to, size_t i, psc_result status)
{
    if (to->data)
        *(psc_result *)(void *)((char *)to->data + (ptrdiff_t)i * to->stride) = status;
}

static inline void psc_fill_status(const psc_output_result *to, size_t count, psc_result status)
{
    size_t i;

    for (i = 0; i < count; i++)
        psc_put_status(to, i, status);
}

/* Numbers of a shape's geometry. */
#define PSC_MAX_GEOMETRY 48

#define PSC_INDEX(from, NAME, name) PSC_KERNEL_##NAME,
enum psc_kernel_index { PSC_SHAPES(PSC_INDEX, ) PSC_KERNEL_COUNT };
#undef PSC_INDEX

/* What a shape supplies: the row that stands for it everywhere. */
struct psc_shape_row {
    psc_shape shape;
    enum psc_kernel_index kernel;
    uint32_t maps[4]; /* by measure: a bit 1 << map for each map that is offered */
    psc_result (*solid_angle)(const psc_sampler *sampler, double *value);
    psc_result (*projected_solid_angle)(const psc_sampler *sampler, double *value);
    psc_result (*area)(const psc_sampler *sampler, double *value);
    /* In double for both precisions; epsilon is that of the direction. */
    double (*pdf)(const psc_sampler *sampler, const double direction[3], double epsilon);
    psc_result (*invert)(const psc_sampler *sampler, const double direction[3], double epsilon,
                         double uv[2]);
};

#define PSC_DECLARE(from, NAME, name) extern const struct psc_shape_row psc_shape_##name;
PSC_SHAPES(PSC_DECLARE, )
#undef PSC_DECLARE

/* Leaves the sampler empty: safe to sample, pdf 0. */
void psc_clear(psc_sampler *sampler);

/* The same of a sampler that is built, of a light of which nothing is seen. */
static inline void psc_see_nothing(psc_sampler *sampler)
{
    sampler->sides = 0;
    sampler->total = sampler->inverse_total = 0.0;
    sampler->visibility = PSC_CASE_EMPTY;
}

/* Builds any shape from a checked request and its numbers. */
psc_result psc_build_numbers(psc_sampler *sampler, const struct psc_shape_row *shape,
                             const struct psc_request *request, const double *geometry);

/* Builds any shape from pointers to the parts of its geometry: what the public build calls are.
   kinds has a letter for each part, v for a vector, s for a scalar. */
psc_result psc_build(psc_sampler *sampler, const struct psc_shape_row *shape, const char *kinds,
                     const psc_technique *technique, const psc_receiver *receiver,
                     const double *const parts[]);

/* Form factor of any shape that is offered by projected solid angle; parts as above. */
psc_result psc_form_factor(const struct psc_shape_row *shape, const char *kinds,
                           const psc_receiver *receiver, const double *const parts[],
                           double *form_factor);

/* Builds and samples any shape for each element: what the public wavefront calls are. */
psc_result psc_wavefront_f64(const struct psc_shape_row *shape, const char *kinds,
                             const psc_technique *technique, size_t count,
                             const psc_receivers_f64 *receivers,
                             const psc_input_f64 *const parts[], const psc_input_f64 *uv,
                             const psc_samples_f64 *out);
psc_result psc_wavefront_f32(const struct psc_shape_row *shape, const char *kinds,
                             const psc_technique *technique, size_t count,
                             const psc_receivers_f32 *receivers,
                             const psc_input_f32 *const parts[], const psc_input_f32 *uv,
                             const psc_samples_f32 *out);

/* ---- Kernels: per shape, precision and instruction set ---- */

#define PSC_BLOCK 128
#define PSC_WAVE_NUMBERS (18 * PSC_BLOCK)

/*
 * The inputs of a block of a wavefront, one array per number: where the caller has them, or in
 * `numbers`. Blocks of shapes that have more than 12 numbers of their own are shorter.
 */
#define PSC_WAVE(real)                                                                      \
    {                                                                                       \
        const real *position[3], *normal[3]; /* normals are 0 where there is none */        \
        const real *geometry[PSC_MAX_GEOMETRY];                                             \
        real numbers[PSC_WAVE_NUMBERS];                                                     \
        psc_measure measure;                                                                \
        psc_map map;                                                                        \
        enum psc_facing facing;                                                             \
        int one_sided;                                                                      \
        const psc_table *table;                                                             \
        int parts; /* numbers of the geometry */                                            \
        size_t count;                                                                       \
        int surface; /* whether point, normal, distance or surface are wanted */            \
        int weight;  /* and whether that is */                                              \
    }
struct psc_wave_f64 PSC_WAVE(double);
struct psc_wave_f32 PSC_WAVE(float);
#undef PSC_WAVE

/* Components of psc_light_sample in its order, one array each. */
enum {
    PSC_DIRECTION = 0,
    PSC_PDF = 3,
    PSC_POINT = 4,
    PSC_DISTANCE = 7,
    PSC_NORMAL = 8,
    PSC_WEIGHT = 11,
    PSC_SURFACE = 12,
    PSC_COMPONENTS = 14
};
struct psc_results_f64 {
    double value[PSC_COMPONENTS][PSC_BLOCK];
    psc_result status[PSC_BLOCK];
};
struct psc_results_f32 {
    float value[PSC_COMPONENTS][PSC_BLOCK];
    psc_result status[PSC_BLOCK];
};

/* The status of an element that a wavefront kernel leaves to the calls for one, and of a build that
   the quick one leaves to that for all. */
#define PSC_PENDING INT32_MAX

/* A block of directions, and what is asked of them: in double for both precisions. */
struct psc_directions {
    size_t count;
    double epsilon; /* of the direction */
    double direction[3][PSC_BLOCK];
    double pdf[PSC_BLOCK];
    double uv[2][PSC_BLOCK]; /* where status is PSC_SUCCESS */
    psc_result status[PSC_BLOCK];
};

static inline void psc_load_direction(const struct psc_directions *d, size_t i,
                                      double direction[3])
{
    direction[0] = d->direction[0][i];
    direction[1] = d->direction[1][i];
    direction[2] = d->direction[2][i];
}

struct psc_kernel_f64 {
    psc_result (*sample)(const psc_sampler *sampler, double u, double v,
                         psc_light_sample_f64 *sample);
    void (*sample_n)(const psc_sampler *sampler, size_t count, const psc_input_f64 *uv,
                     const psc_samples_f64 *out);
    /* NULL: the calls for one do it. */
    void (*wave)(const struct psc_wave_f64 *wave, const double *u, const double *v,
                 struct psc_results_f64 *results);
    /* Fills a cleared sampler; the numbers are finite. In double behind both precisions. */
    psc_result (*build)(psc_sampler *sampler, const struct psc_request *request,
                        const double *geometry);
    /* Fill pdf, or uv and status; the sampler is not empty. NULL: the calls for one do it. */
    void (*pdf)(const psc_sampler *sampler, struct psc_directions *directions);
    void (*invert)(const psc_sampler *sampler, struct psc_directions *directions);
    /* Checks and builds what single calls ask for most, of a geometry of vectors and a scalar, if
       it has one; or returns PSC_PENDING and leaves it to build. NULL: none. */
    psc_result (*quick)(psc_sampler *sampler, const psc_technique *technique,
                        const psc_receiver *receiver, const double *const vectors[],
                        double scalar);
};

struct psc_kernel_f32 {
    psc_result (*sample)(const psc_sampler *sampler, float u, float v,
                         psc_light_sample_f32 *sample);
    void (*sample_n)(const psc_sampler *sampler, size_t count, const psc_input_f32 *uv,
                     const psc_samples_f32 *out);
    void (*wave)(const struct psc_wave_f32 *wave, const float *u, const float *v,
                 struct psc_results_f32 *results);
};

/* The kernels of an instruction set, by psc_kernel_index. */
struct psc_variant {
    const char *name;
    int (*runs)(void); /* whether this CPU does */
    const struct psc_kernel_f32 *f32[PSC_KERNEL_COUNT];
    const struct psc_kernel_f64 *f64[PSC_KERNEL_COUNT];
};

/* Every variant that was compiled, the base first. */
extern const struct psc_variant psc_variants[];
extern const unsigned psc_variant_count;
/* The best that this CPU runs. */
const struct psc_variant *psc_dispatch(void);

#endif
