/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling of one build of a sphere or a distant cap, one sample at a time or in blocks that
 * vectorise. Template: see precision.h.
 */
#include "cap_world_tmpl.h"

/* ---- One sample ---- */

#if PSC_REAL_BITS == 64
#define CAP_LOBE(side) ((side)->lobe)
#define CAP_NATIVE(native, lane, l, wide, u, v, p) lane##_f64(l, u, v, p)
#else
#define CAP_LOBE(side) psc_lobe_round(&(side)->lobe)
/* Float where it holds the accuracy, otherwise double inside. */
#define CAP_NATIVE(native, lane, l, wide, u, v, p) CAP_NATIVE_##native(lane, l, wide, u, v, p)
#define CAP_NATIVE_1(lane, l, wide, u, v, p) lane##_f32(l, u, v, p)
#define CAP_NATIVE_0(lane, l, wide, u, v, p)                     \
    do {                                                         \
        struct psc_point_f64 wide_point;                         \
        lane##_f64(wide, (double)(u), (double)(v), &wide_point); \
        cap_round_point(&wide_point, p);                         \
    } while (0)

PSC_LANE void cap_round_point(const struct psc_point_f64 *from, struct psc_point_f32 *to)
{
    to->x = (float)from->x;
    to->y = (float)from->y;
    to->z = (float)from->z;
    to->height = (float)from->height;
    to->power = (float)from->power;
    to->across = (float)from->across;
}
#endif

/* An area map, in double. */
PSC_LANE void FN(area_lane)(int concentric, const struct psc_lobe_f64 *l, real u, real v,
                            struct FN(psc_point) *p, real *pdf, real *inverse)
{
    struct psc_point_f64 point;
    double density, rest;

    if (concentric)
        concentric_area(l, (double)u, (double)v, &point, &density, &rest);
    else
        radial_area(l, (double)u, (double)v, &point, &density, &rest);
#if PSC_REAL_BITS == 64
    *p = point;
#else
    cap_round_point(&point, p);
#endif
    *pdf = (real)density;
    *inverse = (real)rest;
}

static psc_result FN(area_sample)(const psc_sampler *s, const struct psc_side *side, real u,
                                  real v, FN(psc_light_sample) *out)
{
    struct FN(psc_cap_world) w;
    struct FN(psc_point) p;
    real inverse;

    FN(cap_world)(s, side, &w);
    FN(area_lane)(side->map == PSC_CAP_CONCENTRIC_AREA, &side->lobe, u, v, &p, &out->pdf,
                  &inverse);
    FN(cap_direction)(&w, p.x, p.y, p.z, out->direction, out->direction + 1, out->direction + 2);
    FN(area_surface)(&w, p.x, p.y, p.power, p.across, out->point, out->normal, &out->distance);
    return FN(area_density)(&w, p.height, inverse, &out->weight);
}

/* The world's part of a sample; projected is that of the sampler, known to the compiler. */
PSC_LANE psc_result FN(cap_finish)(const psc_sampler *s, const struct psc_side *side,
                                   int projected, const struct FN(psc_point) *p,
                                   FN(psc_light_sample) *out)
{
    struct FN(psc_cap_world) w;
    psc_result status;

    /* The constants in the order of their use, and no sooner: there are more than registers. */
    FN(cap_measure)(s, side, &w);
    w.projected = projected;
    FN(cap_density)(&w, p->height, &out->pdf, &out->weight, &status);
    FN(cap_frame)(side, &w);
    FN(cap_direction)(&w, p->x, p->y, p->z, out->direction, out->direction + 1,
                      out->direction + 2);
    FN(cap_body)(s, side, &w);
    FN(cap_surface)(&w, out->direction, p->x, p->y, p->z,
                    FN(cap_depth)(&w, p->height, p->power, p->across), out->point, out->normal,
                    &out->distance);
    return status;
}

static psc_result FN(cap_sample)(const psc_sampler *s, real u, real v,
                                 FN(psc_light_sample) *out)
{
    const struct psc_side *side;
    struct FN(psc_point) p;

    if (s->sides == 0)
        return PSC_EMPTY;
    side = s->cap.side + FN(pick_side)(s, u, &u);
    out->surface[0] = out->surface[1] = K(0.0);
    switch (side->map) {
#define CAP_CASE(name, lane, native)                                 \
    case PSC_CAP_##name: {                                           \
        const struct FN(psc_lobe) l = CAP_LOBE(side);                \
                                                                     \
        (void)l;                                                     \
        CAP_NATIVE(native, lane, &l, &side->lobe, u, v, &p);         \
        break;                                                       \
    }
        PSC_CAP_MAPS(CAP_CASE)
#undef CAP_CASE
    case PSC_CAP_RADIAL_AREA:
    case PSC_CAP_CONCENTRIC_AREA:
        return FN(area_sample)(s, side, u, v, out);
    default:
        return PSC_EMPTY;
    }
    return s->projected ? FN(cap_finish)(s, side, 1, &p, out)
                        : FN(cap_finish)(s, side, 0, &p, out);
}

/* ---- Blocks ---- */

/* A loop takes as many elements at a time as numbers of its smallest type fill a vector. With one
   of half the size among them, these are two vectors of all others, whose chains of operations,
   hundreds long in most maps, run side by side where one alone would wait for itself. */
#if PSC_REAL_BITS == 64
typedef int32_t FN(psc_half);
#else
typedef int16_t FN(psc_half);
#endif

struct FN(psc_cap_points) {
    real x[PSC_BLOCK], y[PSC_BLOCK], z[PSC_BLOCK], height[PSC_BLOCK], power[PSC_BLOCK];
    real across[PSC_BLOCK];
    real pdf[PSC_BLOCK], inverse[PSC_BLOCK];
    FN(psc_half) pairs[PSC_BLOCK]; /* written for the sake of that alone */
};

#define CAP_STORE(to, i, p)         \
    do {                            \
        (to)->x[i] = (p).x;         \
        (to)->y[i] = (p).y;         \
        (to)->z[i] = (p).z;         \
        (to)->height[i] = (p).height; \
        (to)->power[i] = (p).power; \
        (to)->across[i] = (p).across; \
    } while (0)

#define CAP_BLOCK(name, lane, native)                                                          \
    static void FN(block_##lane)(const struct psc_side *side, size_t n,                        \
                                 const real *restrict u, const real *restrict v,               \
                                 struct FN(psc_cap_points) *restrict to)                       \
    {                                                                                          \
        const struct FN(psc_lobe) l = CAP_LOBE(side);                                          \
        const struct psc_lobe_f64 wide = side->lobe;                                           \
        size_t i;                                                                              \
                                                                                               \
        (void)l, (void)wide;                                                                   \
        for (i = 0; i < n; i++) {                                                              \
            struct FN(psc_point) p;                                                            \
                                                                                               \
            CAP_NATIVE(native, lane, &l, &wide, u[i], v[i], &p);                               \
            CAP_STORE(to, i, p);                                                               \
            to->pairs[i] = (FN(psc_half))v[i];                                                 \
        }                                                                                      \
    }
PSC_CAP_MAPS(CAP_BLOCK)
#undef CAP_BLOCK

#define AREA_BLOCK(lane, concentric)                                                                       \
    static void FN(block_##lane)(const struct psc_side *side, size_t n,                        \
                                 const real *restrict u, const real *restrict v,               \
                                 struct FN(psc_cap_points) *restrict to)                       \
    {                                                                                          \
        const struct psc_lobe_f64 l = side->lobe;                                              \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            struct FN(psc_point) p;                                                            \
            real pdf, inverse;                                                                 \
                                                                                               \
            FN(area_lane)(concentric, &l, u[i], v[i], &p, &pdf, &inverse);                     \
            CAP_STORE(to, i, p);                                                               \
            to->pdf[i] = pdf;                                                                  \
            to->inverse[i] = inverse;                                                          \
        }                                                                                      \
    }
AREA_BLOCK(radial_area, 0)
AREA_BLOCK(concentric_area, 1)
#undef AREA_BLOCK

typedef void (*FN(cap_block))(const struct psc_side *, size_t, const real *, const real *,
                              struct FN(psc_cap_points) *);
#define CAP_ROW(name, lane, native) FN(block_##lane),
static const FN(cap_block) FN(cap_blocks)[] = {
    PSC_CAP_MAPS(CAP_ROW) FN(block_radial_area), FN(block_concentric_area)};
#undef CAP_ROW

/* pdf, weight and status of a block: what does not vary is a loop of its own, so that all of
   them become vector code. */
static void FN(cap_densities)(const struct FN(psc_cap_world) *w, size_t n,
                              const struct FN(psc_cap_points) *restrict p, int area,
                              struct FN(psc_results) *restrict r)
{
    real *pdf = r->value[PSC_PDF], *weight = r->value[PSC_WEIGHT];
    psc_result *status = r->status;
    size_t i;

    if (area) {
        for (i = 0; i < n; i++) {
            pdf[i] = p->pdf[i];
            status[i] = FN(area_density)(w, p->height[i], p->inverse[i], &weight[i]);
        }
    } else if (w->projected) {
        const real total = w->total, rise = w->rise, inverse = w->inverse_total;

        for (i = 0; i < n; i++)
            pdf[i] = p->height[i] * rise * inverse;
        for (i = 0; i < n; i++)
            weight[i] = total;
        for (i = 0; i < n; i++)
            status[i] = PSC_SUCCESS;
    } else {
        const real total = w->total, inverse = w->inverse_total;
        const int both = w->facing == PSC_FACING_BOTH;

        for (i = 0; i < n; i++)
            pdf[i] = inverse;
        for (i = 0; i < n; i++)
            status[i] = PSC_SUCCESS;
        if (w->facing == PSC_FACING_NONE)
            for (i = 0; i < n; i++)
                weight[i] = total;
        else
            for (i = 0; i < n; i++) {
                const real cosine = both ? ABS(p->height[i]) : MAX(p->height[i], K(0.0));

                weight[i] = total * cosine;
                status[i] = cosine > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
            }
    }
}

static void FN(cap_directions)(const struct FN(psc_cap_world) *w, size_t n,
                               const struct FN(psc_cap_points) *restrict p,
                               struct FN(psc_results) *restrict r)
{
    const struct FN(psc_cap_world) own = *w;
    size_t i;

    for (i = 0; i < n; i++)
        FN(cap_direction)(&own, p->x[i], p->y[i], p->z[i], &r->value[0][i], &r->value[1][i],
                          &r->value[2][i]);
}

static void FN(cap_surfaces)(const struct FN(psc_cap_world) *w, size_t n,
                             const struct FN(psc_cap_points) *restrict p, int area,
                             struct FN(psc_results) *restrict r)
{
    real(*to)[PSC_BLOCK] = r->value;
    size_t i;

    for (i = 0; i < n; i++) {
        real direction[3] = {to[0][i], to[1][i], to[2][i]}, point[3], normal[3], distance;

        if (area)
            FN(area_surface)(w, p->x[i], p->y[i], p->power[i], p->across[i], point, normal,
                             &distance);
        else
            FN(cap_surface)(w, direction, p->x[i], p->y[i], p->z[i],
                            FN(cap_depth)(w, p->height[i], p->power[i], p->across[i]), point, normal,
                            &distance);
        FN(store_surface)(r, i, point, normal, distance, K(0.0), K(0.0));
    }
}

static void FN(cap_side_block)(const psc_sampler *s, int k, size_t n, const real *u,
                               const real *v, int surface, struct FN(psc_results) *r)
{
    const struct psc_side *side = s->cap.side + k;
    const int area = side->map >= PSC_CAP_RADIAL_AREA;
    struct FN(psc_cap_points) points;
    struct FN(psc_cap_world) w;

    FN(cap_blocks)[side->map](side, n, u, v, &points);
    FN(cap_world)(s, side, &w);
    FN(cap_directions)(&w, n, &points, r);
    FN(cap_densities)(&w, n, &points, area, r);
    if (surface)
        FN(cap_surfaces)(&w, n, &points, area, r);
}

static void FN(cap_sample_n)(const psc_sampler *s, size_t count, const FN(psc_input) *uv,
                             const FN(psc_samples) *out)
{
    FN(sample_sides)(s, count, uv, out, FN(cap_side_block));
}
