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

/* The density of a sample and its weight. */
PSC_LANE void FN(rectangle_density)(int area, double volume, double total, enum psc_facing facing,
                                    double distance, double cosine, real *pdf, real *weight)
{
    const double cube = 2.0 * (distance * distance * distance);
    const double counts = fan_cosine_f64(facing, cosine);

    *pdf = (real)(area ? cube / volume : 1.0 / total);
    *weight = (real)(area ? counts * volume / cube : total * counts);
}

PSC_LANE void FN(rectangle_point)(const struct psc_rectangle *f, const real share[2],
                                  real point[3])
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = (real)f->corner[i] +
                   (share[0] * (real)f->edge_u[i] + share[1] * (real)f->edge_v[i]);
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
    FN(rectangle_point)(&l->rectangle, out->surface, out->point);
    out->distance = (real)(distance * (1.0 / l->view.scale));
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* Two loops for each measure: what becomes of the cosine is chosen in one of its own, since a loop
   that has to is no vector code. */
#define RECTANGLE_BLOCK(name, area)                                                            \
    static void FN(name)(const psc_sampler *s, size_t n, const real *restrict u,               \
                         const real *restrict v, struct FN(psc_results) *restrict r)           \
    {                                                                                          \
        const struct psc_rectangle f = s->polygon.rectangle;                                   \
        const double up[3] = {s->polygon.up[0], s->polygon.up[1], s->polygon.up[2]};           \
        const double volume = s->polygon.volume, total = s->total;                             \
        const double unit = 1.0 / s->polygon.view.scale;                                       \
        const real normal[3] = {(real)s->polygon.normal[0], (real)s->polygon.normal[1],        \
                                (real)s->polygon.normal[2]};                                   \
        const enum psc_facing facing = s->facing;                                              \
        double distance[PSC_BLOCK], cosine[PSC_BLOCK];                                         \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            real share[2], direction[3], point[3];                                             \
                                                                                               \
            FN(rectangle_lane)(&f, up, area, u[i], v[i], share, direction, distance + i,       \
                               cosine + i);                                                    \
            FN(rectangle_point)(&f, share, point);                                             \
            r->value[0][i] = direction[0];                                                     \
            r->value[1][i] = direction[1];                                                     \
            r->value[2][i] = direction[2];                                                     \
            FN(store_surface)(r, i, point, normal, (real)(distance[i] * unit), share[0],       \
                              share[1]);                                                       \
        }                                                                                      \
        for (i = 0; i < n; i++)                                                                \
            FN(rectangle_density)(area, volume, total, facing, distance[i], cosine[i],         \
                                  r->value[PSC_PDF] + i, r->value[PSC_WEIGHT] + i);            \
    }
RECTANGLE_BLOCK(rectangle_block, 0)
RECTANGLE_BLOCK(rectangle_area_block, 1)
#undef RECTANGLE_BLOCK
