/* SPDX-License-Identifier: Apache-2.0 */
/* Sampling of fans that were built in plain arithmetic (fan_lanes.h). Template: see precision.h. */
#if PSC_REAL_BITS == 64
#define RAY_FAN_OF(from) (*(from))
#else
#define RAY_FAN_OF(from) psc_ray_fan_round(from)
#endif

/* None of these is so close to the whole sky that what it lacks of that matters. */
PSC_LANE void FN(ray_map)(const struct FN(psc_ray_fan) *f, real u, real v, struct FN(psc_spot) *p)
{
    struct FN(psc_fan) fan;

    fan.half = f->half;
    fan.rest = K(3.14159265358979323846) - f->half;
    fan.sin_a = fan.gap = K(1.0);
    fan.cos_a = f->cos_a;
    fan.sin_rest = K(0.0);
    fan.near = f->near;
    fan.far = f->far;
    FN(fan_map)(&fan, u, v, p);
}

PSC_LANE void FN(ray_direction)(const struct FN(psc_ray_fan) *f, const real b[3],
                                const struct FN(psc_spot) *p, real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = p->b * b[i] + (p->a * f->toward_a[i] + p->c * f->toward_c[i]);
}

/* Where the direction meets the triangle: see fan_hit(). No share is more than rounding outside
   [0, 1], and |b| is 1: the sum is of the coordinates of a and c, without the rest for b. */
PSC_LANE void FN(ray_hit)(const struct FN(psc_ray_fan) *f, const struct FN(psc_spot) *p,
                          real *share_a, real *share_c, real *distance)
{
    const real c = p->c * f->per_above;
    const real first = (p->a - c * f->slant) * f->per_along, a = MAX(first, K(0.0));
    const real inverse = K(1.0) / (p->b + (a * f->less_a + c * f->less_c));

    *share_a = a * inverse;
    *share_c = c * inverse;
    *distance = inverse;
}

/* A triangle in world space: B, the edges to A and C, and the coordinates of these on the surface
   of the light, where B has 0. */
struct FN(psc_ray_face) {
    real pivot[3], edge_a[3], edge_c[3], place_a[2], place_c[2];
};

PSC_LANE void FN(ray_point)(const struct FN(psc_ray_face) *f, real a, real c, real point[3],
                            real place[2])
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = f->pivot[i] + (a * f->edge_a[i] + c * f->edge_c[i]);
    place[0] = a * f->place_a[0] + c * f->place_c[0];
    place[1] = a * f->place_a[1] + c * f->place_c[1];
}

/* What is kept of triangle k. */
PSC_LANE void FN(load_rays)(const struct psc_ray_fans *f, int k, struct FN(psc_ray_fan) *fan,
                            real b[3], struct FN(psc_ray_face) *face)
{
    struct psc_ray_fan_f64 wide;
    int i;

    load_ray_fan(f, k, &wide);
    *fan = RAY_FAN_OF(&wide);
    for (i = 0; i < 3; i++) {
        const double start = f->vertex[i][0];

        b[i] = (real)f->b[i];
        face->pivot[i] = (real)start;
        face->edge_a[i] = (real)(f->vertex[i][k + 1] - start);
        face->edge_c[i] = (real)(f->vertex[i][k + 2] - start);
    }
    for (i = 0; i < 2; i++) {
        face->place_a[i] = (real)f->place[i][k + 1];
        face->place_c[i] = (real)f->place[i][k + 2];
    }
}

static psc_result FN(ray_sample)(const psc_sampler *s, real u, real v, FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *l = &s->polygon;
    const int k = FN(pick_triangle)(l, u, &u);
    struct FN(psc_ray_face) face;
    struct FN(psc_ray_fan) fan;
    struct FN(psc_polygon_world) w;
    struct FN(psc_spot) p;
    real a, c, distance, b[3];
    int i;

    FN(load_rays)(&l->fans, k, &fan, b, &face);
    FN(polygon_world)(s, &w);
    FN(ray_map)(&fan, u, v, &p);
    FN(ray_direction)(&fan, b, &p, out->direction);
    out->pdf = w.pdf;
    out->weight = w.total * FN(fan_cosine)(w.facing, FN(fan_height)(w.up, out->direction));
    FN(ray_hit)(&fan, &p, &a, &c, &distance);
    FN(ray_point)(&face, a, c, out->point, out->surface);
    out->distance = distance * w.unit;
    PSC_UNROLL
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* n samples of one triangle; what does not vary is a loop of its own, so that all of them become
   vector code. */
static void FN(ray_block)(const psc_sampler *s, int k, size_t n, const real *restrict u,
                          const real *restrict v, int surface, struct FN(psc_results) *restrict r)
{
    const struct psc_polygon_light *l = &s->polygon;
    const real normal[3] = {(real)l->normal[0], (real)l->normal[1], (real)l->normal[2]};
    real at_b[PSC_BLOCK], at_a[PSC_BLOCK], at_c[PSC_BLOCK], b[3];
    struct FN(psc_polygon_world) w;
    struct FN(psc_ray_face) face;
    struct FN(psc_ray_fan) fan;
    size_t i;

    FN(load_rays)(&l->fans, k, &fan, b, &face);
    FN(polygon_world)(s, &w);
    for (i = 0; i < n; i++) {
        struct FN(psc_spot) p;
        real direction[3];

        FN(ray_map)(&fan, u[i], v[i], &p);
        FN(ray_direction)(&fan, b, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        at_b[i] = p.b;
        at_a[i] = p.a;
        at_c[i] = p.c;
    }
    FN(weigh_samples)(&w, n, r);
    for (i = 0; surface && i < n; i++) {
        const struct FN(psc_spot) p = {at_b[i], at_a[i], at_c[i]};
        real a, c, distance, point[3], place[2];

        FN(ray_hit)(&fan, &p, &a, &c, &distance);
        FN(ray_point)(&face, a, c, point, place);
        FN(store_surface)(r, i, point, normal, distance * w.unit, place[0], place[1]);
    }
}
