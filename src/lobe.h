/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A lobe: everything the maps need to know of one cap seen from one side of a horizon. Built in
 * double (projected_build.h, *_map.h), handed to float kernels rounded.
 *
 * Symbols follow [UG18]: alpha, beta, and the projected ellipse with its centre x_e = cos alpha
 * cos beta and semi-axes a_x = sin alpha sin beta, a_y = sin alpha. psi is the angle on the
 * horizon circle seen from its centre, theta the parameter on the ellipse.
 */
#ifndef PSC_SRC_LOBE_H
#define PSC_SRC_LOBE_H

#include "cap.h"

#define PSC_LOBE_FIELDS(X)                                                                  \
    X(sin_a) X(cos_a) X(sin_b) X(cos_b)                                                     \
    X(per_a) /* 1 / sin alpha */                                                            \
    X(h0)    /* 1 - cos alpha */                                                            \
    X(x_e)                                                                                  \
    X(del)   /* 1 - x_e */                                                                  \
    X(ome2)  /* 1 - x_e^2 */                                                                \
    X(zc)    /* sin alpha cos beta */                                                       \
    X(low)   /* height of the lowest point of the outline, sin(beta - alpha), if above 0 */ \
    X(high)  /* sin(alpha + beta), the height of the highest, or of a lune's middle */      \
    X(total) /* the measure of the whole: steradians, projected ones, or squared lengths */ \
    X(rise)  /* a power of two: pdf is height rise / (total rise), for float's sake */      \
    /* Radial map: `circle` is the share of the horizon's circle [0, psi_l], `arc` that of  \
       the ellipse beyond it. */                                                            \
    X(circle) X(arc) X(per_ellipse) X(psi_l) X(m) X(m1) X(m2) X(m3) X(per_circle)           \
    /* Radial map of a lune: k = |a_x|, v0 = cos beta - cos alpha, and the start values. */ \
    X(k) X(q2) X(v0) X(layer) X(layer_width) X(a1) X(a2) X(a3) X(a4) X(a5)                  \
    /* Parallel map, see clipped_map_tmpl.h: the units, and the start values. Chords beyond \
       y_l have the share `whole` of the total. */                                          \
    X(slant) X(half_slant) X(base) X(tip_sine) X(per_tip_sine) X(tip_cosine)                \
    X(tip_cos_psi) X(tip_y) X(thickness) X(area) X(chord_unit)                              \
    X(whole) X(whole_scale) X(x_m) X(lam) X(mu) X(n) X(p0) X(p1) X(p2)                      \
    /* Area maps: see area_map.h; total_area = 2 pi width. */                              \
    X(delta) X(gap) X(width) X(visible) X(total_area)

#define PSC_FIELD_F64(name) double name;
#define PSC_FIELD_F32(name) float name;
struct psc_lobe_f64 { PSC_LOBE_FIELDS(PSC_FIELD_F64) };
struct psc_lobe_f32 { PSC_LOBE_FIELDS(PSC_FIELD_F32) };
#undef PSC_FIELD_F64
#undef PSC_FIELD_F32

PSC_LANE struct psc_lobe_f32 psc_lobe_round(const struct psc_lobe_f64 *lobe)
{
    struct psc_lobe_f32 r;
#define PSC_FIELD_ROUND(name) r.name = (float)lobe->name;
    PSC_LOBE_FIELDS(PSC_FIELD_ROUND)
#undef PSC_FIELD_ROUND
    return r;
}

/*
 * A sampled direction in the lobe's frame. The offset (x, y, z) is direction - axis, accurate
 * relative to sin alpha; height is its cosine to the normal.
 *
 * How deep it is inside the cap, up + across with up = sin beta height and across = cos beta x -
 * cos alpha (x from the receiver's axis), decides where it hits a sphere. Where the two have
 * opposite signs their sum cancels; then power = (up^2 - across^2) / sin^2 alpha helps, a
 * quadratic form that is 0 on the outline of the cap. The cone maps have the depth itself in
 * power, the area maps w, and the distance in across.
 */
struct psc_point_f64 { double x, y, z, height, power, across; };
struct psc_point_f32 { float x, y, z, height, power, across; };

#endif
