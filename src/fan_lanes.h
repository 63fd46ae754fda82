/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Fans by solid angle in plain double arithmetic, which is as good as exact products for all but
 * needles, receivers all but in the plane of the light, and lights as wide as half the sky; with
 * the tests for these. Triangles are functions of their vertices alone: loops that are vector code
 * build those of one light, or one of each light of a wavefront, to the same bits.
 */
#ifndef PSC_SRC_FAN_LANES_H
#define PSC_SRC_FAN_LANES_H

#include <psc/psc.h>

#include "fan.h"

/* What the maps need to know of a triangle A, B, C in units of |b|: see fan.h. In the frame at B
   a is (1 - less_a, 1 / per_along, 0) and c is (1 - less_c, slant, 1 / per_above). */
#define PSC_RAY_FIELDS(X, V)               \
    X(half) X(cos_a) X(near) X(far)        \
    V(toward_a) V(toward_c)                \
    X(per_along) X(per_above) X(slant)     \
    X(less_a) X(less_c)

#define PSC_RAY_NUMBER(name) double name;
#define PSC_RAY_VECTOR(name) double name[3];
struct psc_ray_fan_f64 { PSC_RAY_FIELDS(PSC_RAY_NUMBER, PSC_RAY_VECTOR) };
#undef PSC_RAY_NUMBER
#undef PSC_RAY_VECTOR
#define PSC_RAY_NUMBER(name) float name;
#define PSC_RAY_VECTOR(name) float name[3];
struct psc_ray_fan_f32 { PSC_RAY_FIELDS(PSC_RAY_NUMBER, PSC_RAY_VECTOR) };
#undef PSC_RAY_NUMBER
#undef PSC_RAY_VECTOR

PSC_LANE struct psc_ray_fan_f32 psc_ray_fan_round(const struct psc_ray_fan_f64 *from)
{
    struct psc_ray_fan_f32 r;

    PSC_RAY_FIELDS(PSC_ROUND_NUMBER, PSC_ROUND_VECTOR)
    return r;
}

/* ---- A triangle ---- */

/* The vertex that the triangles of a fan share, as the receiver sees it. */
struct psc_fan_pivot {
    double b[3], b2, size, inverse, unit[3]; /* |b|^2, |b|, 1 / |b|, b / |b| */
    double inverse2;                         /* the square of 1 / |b| */
};

PSC_LANE void see_pivot(const double vertex[3], const double position[3], struct psc_fan_pivot *o)
{
    subtract3(vertex, position, o->b);
    o->b2 = dot(o->b, o->b);
    o->size = SQRT(o->b2);
    o->inverse = 1.0 / o->size;
    o->inverse2 = o->inverse * o->inverse;
    scale3(o->inverse, o->b, o->unit);
}

/* A vertex next to that as the receiver sees it, and the edge to it; each to rounding of itself.
   Two triangles share it. */
struct psc_fan_ray {
    double to[3], spoke[3];
    double square, size, along, reach2; /* |to|^2, |to|, to . b, |spoke|^2 */
};

PSC_LANE void measure_ray(const struct psc_fan_pivot *p, struct psc_fan_ray *o)
{
    o->square = dot(o->to, o->to);
    o->size = SQRT(o->square);
    o->along = dot(p->b, o->to);
    o->reach2 = dot(o->spoke, o->spoke);
}

struct psc_fan_sight {
    double ab[3], size_ab, across; /* a x b, its length, (a x b) . (a x c) */
    double normal[3], volume;      /* (c - b) x (a - b), and b times that */
    double sine, cosine;           /* N and D of the solid angle, times |a| |b| |c| */
    double limit;                  /* the square of what the volume is relative to */
    double doubt;                  /* the square of what 8 roundings of may be missing of the solid
                                      angle */
};

/*
 * Returns whether rounding does no harm to the triangle's own. u being a rounding error,
 *  - a x b and a x c are off by less than 4 u of the lengths' products, and the volume, which is
 *    the edge to C times the first, by less than 8 u |b| |edge_a| |edge_c|. The volume has the sine
 *    of the angle at B or A as a factor; a place between the far side's ends moves by no more than
 *    that times the volume's error. So a sixteenth of the products will do for this triangle, where
 *    the doubts of all triangles together keep the elevation of b from being small (is_sure_fan());
 *  - the cosine D of the solid angle [OS83], 1 + cos ab + cos ac + cos bc, is off by less than 6 u;
 *    with N the sine, N^2 + D^2 = 2 (1 + cos ab) (1 + cos ac) (1 + cos bc), so that where that is
 *    1/8 no side is near half a turn, and the angle of (D, N) is off by less than 17 u;
 *  - every length is the volume divided by two others, none above the sum of |a|, |b| and |c|: so
 *    that the last line keeps all products, and in float the quotients, clear of the range's lower
 *    end; at the upper one the limit is infinite first.
 */
PSC_LANE int see_fan_triangle(const struct psc_fan_pivot *p, const struct psc_fan_ray *a,
                              const struct psc_fan_ray *c, const double edge_ac[3],
                              struct psc_fan_sight *o)
{
    const double dot_ac = dot(a->to, c->to), far2 = dot(edge_ac, edge_ac);
    const double at_b = p->b2 * c->reach2, at_a = a->square * far2;
    const double sizes = (a->size * p->size) * c->size, reach = (a->size + p->size) + c->size;
    double ac[3], square;

    cross_rounded(c->spoke, a->spoke, o->normal);
    cross_rounded(a->spoke, p->b, o->ab);
    cross_rounded(a->to, edge_ac, ac);
    o->volume = dot(c->spoke, o->ab);
    o->sine = ABS(o->volume);
    o->cosine = (sizes + a->along * c->size) + (dot_ac * p->size + c->along * a->size);
    o->size_ab = SQRT(dot(o->ab, o->ab));
    o->across = dot(o->ab, ac);
    square = o->cosine * o->cosine + o->sine * o->sine;
    o->limit = a->reach2 * MAX(at_a, at_b);
    o->doubt = o->limit / square;
    return (256.0 * (o->sine * o->sine) > o->limit) & (8.0 * square > sizes * sizes) &
           (o->sine > 0x1p-100 * ((reach * reach) * reach)) & (reach > 0x1p-120);
}

/* Half the solid angle. */
PSC_LANE double half_of(double cosine, double sine)
{
    double rest;

    return arc_and_rest(cosine, sine, &rest);
}

PSC_LANE double half_of_sight(const struct psc_fan_sight *o)
{
    return half_of(o->cosine, o->sine);
}

/* Whether the halves of some triangles, of which none is off by more than 8 u times the root of its
   doubt, add up to less than 64 u of their sum. */
PSC_LANE int is_sure_fan(int triangles, double doubts, double halves)
{
    return (double)triangles * doubts < 64.0 * (halves * halves);
}

/* The constants of the map but for half. */
PSC_LANE void build_ray_fan(const struct psc_fan_pivot *p, const struct psc_fan_ray *a,
                            const struct psc_fan_ray *c, const struct psc_fan_sight *o,
                            struct psc_ray_fan_f64 *f)
{
    const double more = a->size * p->size + ABS(a->along);
    const double per_more = 1.0 / (o->size_ab * more), per_volume = 1.0 / (a->size * o->sine);
    const double tangent = o->size_ab * (o->size_ab * per_more);
    const double per_ab = more * per_more, cotangent = more * per_ab;
    double across[3];

    f->cos_a = o->across * per_volume;
    f->near = a->along >= 0.0 ? tangent : cotangent;
    f->far = a->along >= 0.0 ? cotangent : tangent;
    scale3(per_ab, o->ab, across);
    scale3(COPYSIGN(1.0, o->volume), across, f->toward_c);
    cross_rounded(p->unit, across, f->toward_a);
    f->per_along = p->b2 * per_ab;
    f->per_above = (o->size_ab * p->size) * (a->size * per_volume);
    f->slant = dot(c->spoke, f->toward_a) * p->inverse;
    f->less_a = 1.0 - a->along * p->inverse2;
    f->less_c = 1.0 - c->along * p->inverse2;
}

/* The same constants as other triangles have them. */
static inline void fan_of_rays(const struct psc_ray_fan_f64 *from, const double b[3],
                               struct psc_fan_f64 *f)
{
    const double a_b = 1.0 - from->less_a, a_a = 1.0 / from->per_along;
    const double c_b = 1.0 - from->less_c, c_c = 1.0 / from->per_above;

    f->half = from->half;
    f->rest = PSC_PI - from->half;
    f->sin_a = f->gap = f->per_b = 1.0;
    f->cos_a = from->cos_a;
    f->sin_rest = 0.0;
    f->near = from->near;
    f->far = from->far;
    copy3(b, f->b);
    copy3(from->toward_a, f->toward_a);
    copy3(from->toward_c, f->toward_c);
    f->per_a = 1.0 / SQRT(a_b * a_b + a_a * a_a);
    f->per_c = 1.0 / SQRT((c_b * c_b + from->slant * from->slant) + c_c * c_c);
    f->share_a = from->per_along / f->per_a;
    f->share_c = from->per_above / f->per_c;
    f->slant = from->slant * f->per_c;
    f->cos_ab = a_b * f->per_a;
    f->cos_bc = c_b * f->per_c;
}

/* ---- The triangles of a light, number by number ---- */

/* Loops over the triangles of a fan take PSC_FAN_STEP at a time, the last of them beyond its end:
   the last vertex stands for those that there are not. */
enum {
    PSC_MAX_FAN = PSC_MAX_VERTICES - 2,
    PSC_FAN_STEP = 4,
    PSC_FAN_LANES = PSC_MAX_VERTICES + PSC_FAN_STEP
};

/* Triangle k has the vertices 0, k + 1 and k + 2. */
#define PSC_RAY_NUMBER(name) double name[PSC_FAN_LANES];
#define PSC_RAY_VECTOR(name) double name[3][PSC_FAN_LANES];
struct psc_ray_fans {
    double vertex[3][PSC_FAN_LANES], place[2][PSC_FAN_LANES]; /* in world space, on the surface */
    double b[3];                                              /* B, of length 1 */
    PSC_RAY_FIELDS(PSC_RAY_NUMBER, PSC_RAY_VECTOR)
};
#undef PSC_RAY_NUMBER
#undef PSC_RAY_VECTOR

PSC_LANE void store_ray_fan(struct psc_ray_fans *to, int k, const struct psc_ray_fan_f64 *fan)
{
#define PSC_RAY_NUMBER(name) to->name[k] = fan->name;
#define PSC_RAY_VECTOR(name)         \
    to->name[0][k] = fan->name[0];   \
    to->name[1][k] = fan->name[1];   \
    to->name[2][k] = fan->name[2];
    PSC_RAY_FIELDS(PSC_RAY_NUMBER, PSC_RAY_VECTOR)
#undef PSC_RAY_NUMBER
#undef PSC_RAY_VECTOR
}

PSC_LANE void load_ray_fan(const struct psc_ray_fans *from, int k, struct psc_ray_fan_f64 *fan)
{
#define PSC_RAY_NUMBER(name) fan->name = from->name[k];
#define PSC_RAY_VECTOR(name)           \
    fan->name[0] = from->name[0][k];   \
    fan->name[1] = from->name[1][k];   \
    fan->name[2] = from->name[2][k];
    PSC_RAY_FIELDS(PSC_RAY_NUMBER, PSC_RAY_VECTOR)
#undef PSC_RAY_NUMBER
#undef PSC_RAY_VECTOR
}

#endif
