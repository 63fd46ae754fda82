/* SPDX-License-Identifier: Apache-2.0 */
/* Sampling of one build of a rectangle along its edges. Template: see precision.h. */

/* The maps of a rectangle along its edges, in double: fractions of the edges, direction, distance
   and the cosine at the receiver. */
PSC_LANE void FN(rectangle_lane)(const struct psc_rectangle *f, const double up[3], int area,
                                 real u, real v, real share[2], real direction[3],
                                 double *distance, double *cosine)
{
    struct psc_rectangle_point p;
    double d[3], inverse;
    int i;

    p.u = (double)u;
    p.v = (double)v;
    if (area) {
        point_between(&f->start, &f->along, &f->across, p.u, p.v, d);
    } else {
        rectangle_map(f, p.u, p.v, &p);
        rectangle_vector(f, &p, d);
    }
    *distance = __builtin_sqrt(dot(d, d));
    inverse = 1.0 / *distance;
    *cosine = dot(up, d) * inverse;
    for (i = 0; i < 3; i++)
        direction[i] = (real)(d[i] * inverse);
    share[0] = (real)p.u;
    share[1] = (real)p.v;
}

/* By solid angle of a plain one. surface: whether more than the direction is wanted. */
PSC_LANE void FN(plain_rectangle_lane)(const struct psc_plain_rectangle *f, const double up[3],
                                       int surface, real u, real v, real share[2],
                                       real direction[3], double *distance, double *cosine)
{
    struct psc_plain_point p;
    double d[3];
    int i;

    plain_rectangle_map(f, surface, (double)u, (double)v, &p);
    for (i = 0; i < 3; i++) {
        d[i] = (p.x * f->x[i] + p.y * f->y[i]) + p.z * f->up[i];
        direction[i] = (real)d[i];
    }
    *cosine = dot(up, d);
    if (!surface)
        return;
    *distance = p.distance;
    share[0] = (real)p.u;
    share[1] = (real)p.v;
}

/* The density of a sample and its weight. */
PSC_LANE void FN(rectangle_density)(int area, double volume, double total, enum psc_facing facing,
                                    double distance, double cosine, real *pdf, real *weight)
{
    const double cube = 2.0 * (distance * distance * distance);
    const double counts = fan_cosine_f64(facing, cosine);

    *pdf = (real)(area ? cube / volume : 1.0 / total);
    *weight = (real)(area ? counts * volume / cube : total * counts);
}

PSC_LANE void FN(rectangle_point)(const double corner[3], const double edge_u[3],
                                  const double edge_v[3], const real share[2], real point[3])
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = (real)corner[i] + (share[0] * (real)edge_u[i] + share[1] * (real)edge_v[i]);
}

static psc_result FN(rectangle_sample)(const psc_sampler *s, real u, real v,
                                       FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *l = &s->polygon;
    const int area = s->measure == PSC_MEASURE_AREA;
    double distance, cosine;
    int i;

    FN(rectangle_lane)(&l->rectangle, l->up, area, u, v, out->surface, out->direction, &distance,
                       &cosine);
    FN(rectangle_density)(area, l->volume, s->total, s->facing, distance, cosine, &out->pdf,
                          &out->weight);
    FN(rectangle_point)(l->corner[0], l->corner[1], l->edge_v, out->surface, out->point);
    out->distance = (real)(distance * l->unit);
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* By solid angle of a plain one. */
static psc_result FN(plain_rectangle_sample)(const psc_sampler *s, real u, real v,
                                             FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *l = &s->polygon;
    double distance, cosine;
    int i;

    FN(plain_rectangle_lane)(&l->plain_rectangle, l->up, 1, u, v, out->surface, out->direction,
                             &distance, &cosine);
    out->pdf = (real)s->inverse_total;
    out->weight = (real)(s->total * fan_cosine_f64(s->facing, cosine));
    FN(rectangle_point)(l->corner[0], l->corner[1], l->edge_v, out->surface, out->point);
    out->distance = (real)distance;
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* Two loops for each map: what becomes of the cosine is chosen in one of its own, since a loop
   that has to is no vector code. */
#define RECTANGLE_BLOCK(name, area, surface, type, constants, lane, ...)                       \
    static void FN(name)(const psc_sampler *s, size_t n, const real *restrict u,               \
                         const real *restrict v, struct FN(psc_results) *restrict r)           \
    {                                                                                          \
        const struct psc_polygon_light *const l = &s->polygon;                                 \
        const struct type f = l->constants;                                                    \
        const double up[3] = {l->up[0], l->up[1], l->up[2]};                                   \
        const double volume = l->volume, total = s->total, unit = l->unit;                     \
        const real normal[3] = {(real)l->normal[0], (real)l->normal[1], (real)l->normal[2]};   \
        const enum psc_facing facing = s->facing;                                              \
        double distance[PSC_BLOCK], cosine[PSC_BLOCK];                                         \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            real share[2], direction[3], point[3];                                             \
                                                                                               \
            FN(lane)(&f, up, __VA_ARGS__, u[i], v[i], share, direction, distance + i,          \
                     cosine + i);                                                              \
            r->value[0][i] = direction[0];                                                     \
            r->value[1][i] = direction[1];                                                     \
            r->value[2][i] = direction[2];                                                     \
            if (surface) {                                                                     \
                FN(rectangle_point)(l->corner[0], l->corner[1], l->edge_v, share, point);      \
                FN(store_surface)(r, i, point, normal, (real)(distance[i] * unit), share[0],   \
                                  share[1]);                                                   \
            }                                                                                  \
        }                                                                                      \
        for (i = 0; i < n; i++)                                                                \
            FN(rectangle_density)(area, volume, total, facing, area ? distance[i] : 1.0,       \
                                  cosine[i], r->value[PSC_PDF] + i, r->value[PSC_WEIGHT] + i); \
    }
RECTANGLE_BLOCK(rectangle_block, 0, 1, psc_rectangle, rectangle, rectangle_lane, 0)
RECTANGLE_BLOCK(rectangle_area_block, 1, 1, psc_rectangle, rectangle, rectangle_lane, 1)
RECTANGLE_BLOCK(plain_rectangle_block, 0, 0, psc_plain_rectangle, plain_rectangle,
                plain_rectangle_lane, 0)
RECTANGLE_BLOCK(plain_rectangle_block_whole, 0, 1, psc_plain_rectangle, plain_rectangle,
                plain_rectangle_lane, 1)
#undef RECTANGLE_BLOCK

static void FN(parallel_block)(const psc_sampler *s, size_t n, const real *u, const real *v,
                               int surface, struct FN(psc_results) *r)
{
    (s->measure == PSC_MEASURE_AREA ? FN(rectangle_area_block)
     : !s->polygon.plain            ? FN(rectangle_block)
     : surface                      ? FN(plain_rectangle_block_whole)
                                    : FN(plain_rectangle_block))(s, n, u, v, r);
}
