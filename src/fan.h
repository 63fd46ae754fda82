/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A triangle of a fan: what the maps need to know of it. Built in double (fan_build.h), handed to
 * float kernels rounded. A triangular light is a fan of one.
 *
 * A, B, C are the vertices as [Arv95] names them, B the one that all triangles of a fan share;
 * a, b, c are the vectors to them from the receiver, alpha is the angle of the spherical triangle
 * at A, and side c the one from A to B.
 */
#ifndef PSC_SRC_FAN_H
#define PSC_SRC_FAN_H

#include "polygon_view.h"

/* X is a number, V a vector. Lengths are in units of the builder's choice. sin_a and cos_a may have
   a common factor, which that of near, far and the root of gap then takes back. */
#define PSC_FAN_FIELDS(X, V)                                                          \
    X(half) X(rest) /* half the solid angle, and what it lacks of pi */               \
    X(sin_a) X(cos_a) /* of alpha */                                                  \
    X(sin_rest) /* of alpha - half */                                                 \
    X(near) X(far) /* sin^2 and cos^2 of half the side c, times a number that keeps   \
       squares clear of the subnormal ones */                                         \
    X(gap) /* (sin alpha sin c / 2)^2, times the square of that */                    \
    V(b) V(toward_a) V(toward_c) /* frame at B: b / |b|, across it in the plane of a  \
       and b, and normal to that plane on the side of C */                            \
    X(share_a) X(share_c) X(slant) /* from the frame to a / |a| and c / |c| */        \
    X(cos_ab) X(cos_bc)                                                               \
    X(per_a) X(per_b) X(per_c) /* 1 / |a| and so on */

/* The same triangle in world space: B, the edges to A and C, and the vertices' coordinates on the
   light's surface. */
#define PSC_FACE_FIELDS(X, V)           \
    V(pivot) V(edge_a) V(edge_c)        \
    X(s_a) X(s_b) X(s_c)                \
    X(t_a) X(t_b) X(t_c)

#define PSC_NUMBER_F64(name) double name;
#define PSC_NUMBER_F32(name) float name;
#define PSC_VECTOR_F64(name) double name[3];
#define PSC_VECTOR_F32(name) float name[3];
struct psc_fan_f64 { PSC_FAN_FIELDS(PSC_NUMBER_F64, PSC_VECTOR_F64) };
struct psc_fan_f32 { PSC_FAN_FIELDS(PSC_NUMBER_F32, PSC_VECTOR_F32) };
struct psc_face_f64 { PSC_FACE_FIELDS(PSC_NUMBER_F64, PSC_VECTOR_F64) };
struct psc_face_f32 { PSC_FACE_FIELDS(PSC_NUMBER_F32, PSC_VECTOR_F32) };
#undef PSC_NUMBER_F64
#undef PSC_NUMBER_F32
#undef PSC_VECTOR_F64
#undef PSC_VECTOR_F32

#define PSC_ROUND_NUMBER(name) r.name = (float)from->name;
#define PSC_ROUND_VECTOR(name)          \
    r.name[0] = (float)from->name[0];   \
    r.name[1] = (float)from->name[1];   \
    r.name[2] = (float)from->name[2];

/* What float cannot hold is far from any light that it can: bounded, so that nothing is NaN. */
PSC_LANE float psc_bounded(double x)
{
    return (float)MIN(x, 0x1p96);
}

PSC_LANE struct psc_fan_f32 psc_fan_round(const struct psc_fan_f64 *from)
{
    struct psc_fan_f32 r;

    PSC_FAN_FIELDS(PSC_ROUND_NUMBER, PSC_ROUND_VECTOR)
    r.gap = (float)MAX(from->gap, 0x1p-120);
    r.share_a = psc_bounded(from->share_a);
    r.share_c = psc_bounded(from->share_c);
    r.per_a = psc_bounded(from->per_a);
    r.per_b = psc_bounded(from->per_b);
    r.per_c = psc_bounded(from->per_c);
    return r;
}

PSC_LANE struct psc_face_f32 psc_face_round(const struct psc_face_f64 *from)
{
    struct psc_face_f32 r;

    PSC_FACE_FIELDS(PSC_ROUND_NUMBER, PSC_ROUND_VECTOR)
    return r;
}

/* For the area maps, which are computed in double: b and the edges to A and C in the view, and
   the receiver's normal. */
struct psc_flat {
    struct psc_word2 b, edge_a, edge_c;
    double up[3];
};

/* A sampled direction in the frame at B. */
struct psc_spot_f64 { double b, a, c; };
struct psc_spot_f32 { float b, a, c; };

#endif
