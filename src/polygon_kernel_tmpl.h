/* SPDX-License-Identifier: Apache-2.0 */
/* Sampling of one build of a flat light with straight edges. Template: see precision.h. */
#if PSC_REAL_BITS == 64
#define FAN_OF(from) (*(from))
#define FACE_OF(from) (*(from))
#else
#define FAN_OF(from) psc_fan_round(from)
#define FACE_OF(from) psc_face_round(from)
#endif

/* A triangle of a fan in world space. */
PSC_LANE struct FN(psc_face) FN(face_at)(const struct psc_polygon_light *l, int k)
{
    struct FN(psc_face) face;
    int i;

    if (!l->plain)
        return FACE_OF(l->face + k);
    for (i = 0; i < 3; i++) {
        face.pivot[i] = (real)l->corner[1][i];
        face.edge_a[i] = (real)(l->corner[0][i] - l->corner[1][i]);
        face.edge_c[i] = (real)(l->corner[2][i] - l->corner[1][i]);
    }
    face.s_a = face.s_c = face.t_a = face.t_b = K(0.0);
    face.s_b = face.t_c = K(1.0);
    return face;
}

/* What all samples of a light share. */
struct FN(psc_polygon_world) {
    real pdf, total, unit; /* density, its inverse, and the length of 1 in the fan */
    real up[3];            /* the receiver's normal */
    enum psc_facing facing;
};

PSC_LANE void FN(polygon_world)(const psc_sampler *s, struct FN(psc_polygon_world) *w)
{
    w->pdf = (real)s->inverse_total;
    w->total = (real)s->total;
    w->unit = (real)s->polygon.unit;
    w->up[0] = (real)s->polygon.up[0];
    w->up[1] = (real)s->polygon.up[1];
    w->up[2] = (real)s->polygon.up[2];
    w->facing = s->facing;
}

/* Densities and weights of n samples by solid angle whose directions are there. */
PSC_LANE void FN(weigh_samples)(const struct FN(psc_polygon_world) *w, size_t n,
                                struct FN(psc_results) *restrict r)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};

        r->value[PSC_PDF][i] = w->pdf;
        r->value[PSC_WEIGHT][i] =
            w->total * FN(fan_cosine)(w->facing, FN(fan_height)(w->up, direction));
    }
}

/* The triangle of the fan that u falls to, and u within it. */
PSC_LANE int FN(pick_triangle)(const struct psc_polygon_light *l, real u, real *within)
{
    int i, k = 0;

    *within = u;
    if (l->triangles == 1)
        return 0;
    for (i = 1; i < l->triangles; i++)
        k += u >= (real)l->below[i];
    u = (u - (real)l->below[k]) * (real)l->per_share[k];
    *within = MIN(u, K(1.0));
    return k;
}

#include "fan_kernel_tmpl.h"

/* A point of the area map but for its weight. */
PSC_LANE void FN(round_flat)(const struct psc_flat_point *p, real share[3], real direction[3],
                             real *distance, real *pdf)
{
    int i;

    for (i = 0; i < 3; i++) {
        share[i] = (real)p->share[i];
        direction[i] = (real)p->direction[i];
    }
    *distance = (real)p->distance;
    *pdf = (real)p->pdf;
}

/* ---- One sample ---- */

/* Where the direction meets a plain triangle, as fan_hit(). */
PSC_LANE void FN(plain_hit)(const struct FN(psc_ray_fan) *fan, const struct FN(psc_spot) *p,
                            real share[3], real *distance)
{
    real rest;

    FN(ray_hit)(fan, p, share, share + 2, distance);
    rest = (K(1.0) - share[0]) - share[2];
    share[1] = MAX(rest, K(0.0));
}

/* Of a plain triangle, with what is the same in all these. */
static psc_result FN(plain_sample)(const psc_sampler *s, real u, real v, FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *l = &s->polygon;
    const double *const start = l->corner[1];
    const struct FN(psc_ray_fan) fan = RAY_FAN_OF(&l->rays);
    const real b[3] = {(real)l->b[0], (real)l->b[1], (real)l->b[2]};
    struct FN(psc_polygon_world) w;
    struct FN(psc_spot) p;
    real share[3], distance;
    int i;

    FN(polygon_world)(s, &w);
    FN(ray_map)(&fan, u, v, &p);
    FN(ray_direction)(&fan, b, &p, out->direction);
    out->pdf = w.pdf;
    out->weight = w.total * FN(fan_cosine)(w.facing, FN(fan_height)(w.up, out->direction));
    FN(plain_hit)(&fan, &p, share, &distance);
    out->surface[0] = share[1];
    out->surface[1] = share[2];
    out->distance = distance * w.unit;
    PSC_UNROLL
    for (i = 0; i < 3; i++)
        out->point[i] = (real)start[i] + (share[0] * (real)(l->corner[0][i] - start[i]) +
                                          share[2] * (real)(l->corner[2][i] - start[i]));
    PSC_UNROLL
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static psc_result FN(polygon_sample)(const psc_sampler *s, real u, real v,
                                     FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *l = &s->polygon;
    struct FN(psc_polygon_world) w;
    struct FN(psc_face) face;
    real share[3], distance;
    int i, k;

    if (s->sides == 0)
        return PSC_EMPTY;
    if (s->projected)
        return FN(sector_sample)(s, u, v, out);
    if (s->map == PSC_MAP_PARALLEL)
        return FN(rectangle_sample)(s, u, v, out);
    if (l->plain == PSC_PLAIN_FAN)
        return FN(ray_sample)(s, u, v, out);
    k = FN(pick_triangle)(l, u, &u);
    FN(polygon_world)(s, &w);
    if (s->measure == PSC_MEASURE_AREA) {
        struct psc_flat_point p;

        flat_map(l->flat + k, l->volume, (double)u, (double)v, &p);
        FN(round_flat)(&p, share, out->direction, &distance, &out->pdf);
        out->weight = (real)(fan_cosine_f64(w.facing, p.height) * p.inverse);
    } else {
        const struct FN(psc_fan) fan = FAN_OF(l->fan + k);
        struct FN(psc_spot) p;

        FN(fan_map)(&fan, u, v, &p);
        FN(fan_direction)(&fan, &p, out->direction);
        FN(fan_hit)(&fan, &p, share, share + 1, share + 2, &distance);
        out->pdf = w.pdf;
        out->weight = w.total * FN(fan_cosine)(w.facing, FN(fan_height)(w.up, out->direction));
    }
    face = FN(face_at)(l, k);
    FN(face_point)(&face, share[0], share[1], share[2], out->point, out->surface,
                   out->surface + 1);
    out->distance = distance * w.unit;
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static psc_result FN(triangle_sample)(const psc_sampler *s, real u, real v,
                                      FN(psc_light_sample) *out)
{
    return s->sides > 0 && s->polygon.plain && s->measure == PSC_MEASURE_SOLID_ANGLE
               ? FN(plain_sample)(s, u, v, out)
               : FN(polygon_sample)(s, u, v, out);
}

static psc_result FN(any_rectangle_sample)(const psc_sampler *s, real u, real v,
                                           FN(psc_light_sample) *out)
{
    return s->sides > 0 && s->polygon.plain && s->measure == PSC_MEASURE_SOLID_ANGLE
               ? FN(plain_rectangle_sample)(s, u, v, out)
               : FN(polygon_sample)(s, u, v, out);
}

#include "polygon_blocks_tmpl.h"

/* Leaves a block to the calls for one. */
static void FN(pending_wave)(const struct psc_wave *wave, const real *u, const real *v,
                             struct FN(psc_results) *r)
{
    size_t i;

    (void)u, (void)v;
    for (i = 0; i < wave->count; i++)
        r->status[i] = PSC_PENDING;
}
