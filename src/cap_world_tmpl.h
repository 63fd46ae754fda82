/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From a point in the frame of a lobe to the world: direction, density and weight, and where the
 * direction meets the light. Lane functions. Template: see precision.h.
 */

/* The constants of a side in the precision of the kernel. */
struct FN(psc_cap_world) {
    real x[3], y[3], z[3], axis[3];
    real center[3], offset[3];
    real sin_a, cos_a, h0, sin_b;
    real radius, distance, slack;
    real total;
    real rise, inverse_total; /* of the lobe, for float's sake; 1 / (total rise) */
    enum psc_facing facing;
    int projected, inside, distant;
};

PSC_LANE void FN(cap_vector)(const double from[3], real to[3])
{
    to[0] = (real)from[0];
    to[1] = (real)from[1];
    to[2] = (real)from[2];
}

PSC_LANE void FN(cap_frame)(const struct psc_side *side, struct FN(psc_cap_world) *w)
{
    FN(cap_vector)(side->x, w->x);
    FN(cap_vector)(side->y, w->y);
    FN(cap_vector)(side->z, w->z);
    FN(cap_vector)(side->axis, w->axis);
}

/* What densities need. */
PSC_LANE void FN(cap_measure)(const psc_sampler *s, const struct psc_side *side,
                              struct FN(psc_cap_world) *w)
{
    w->total = (real)s->total;
#if PSC_REAL_BITS == 64
    (void)side;
    w->rise = 1.0; /* the same bits: powers of two are exact */
    w->inverse_total = s->inverse_total;
#else
    w->rise = (real)side->lobe.rise;
    w->inverse_total = (real)(s->inverse_total * unit_inverse(side->lobe.rise));
#endif
    w->facing = s->facing;
    w->projected = s->projected;
}

/* What hits need. */
PSC_LANE void FN(cap_body)(const psc_sampler *s, const struct psc_side *side,
                           struct FN(psc_cap_world) *w)
{
    w->sin_a = (real)side->lobe.sin_a;
    w->cos_a = (real)side->lobe.cos_a;
    w->h0 = (real)side->lobe.h0;
    w->sin_b = (real)side->lobe.sin_b;
    w->radius = (real)s->cap.radius;
    w->distance = (real)s->cap.distance;
    w->inside = s->cap.inside;
    w->distant = s->cap.radius == 0.0;
    FN(cap_vector)(s->cap.center, w->center);
    w->slack = K(0.0);
    if (w->inside) {
        FN(cap_vector)(s->cap.offset, w->offset);
        w->slack = (real)s->cap.slack;
    }
}

PSC_LANE void FN(cap_world)(const psc_sampler *s, const struct psc_side *side,
                            struct FN(psc_cap_world) *w)
{
    FN(cap_frame)(side, w);
    FN(cap_measure)(s, side, w);
    FN(cap_body)(s, side, w);
}

/* The cosine that counts; without a normal there is none, and 1 stands for it. */
PSC_LANE real FN(cap_cosine)(const struct FN(psc_cap_world) *w, real height)
{
    return w->facing == PSC_FACING_NONE  ? K(1.0)
           : w->facing == PSC_FACING_ONE ? MAX(height, K(0.0))
                                         : ABS(height);
}

PSC_LANE void FN(cap_density)(const struct FN(psc_cap_world) *w, real height, real *pdf,
                              real *weight, psc_result *status)
{
    const real cosine = FN(cap_cosine)(w, height);

    *pdf = w->projected ? height * w->rise * w->inverse_total : w->inverse_total;
    *weight = w->projected ? w->total : w->total * cosine;
    *status = w->projected || cosine > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* The direction from the offset in the side's frame. */
PSC_LANE void FN(cap_direction)(const struct FN(psc_cap_world) *w, real x, real y, real z,
                                real *dx, real *dy, real *dz)
{
    *dx = w->axis[0] + ((x * w->x[0] + y * w->y[0]) + z * w->z[0]);
    *dy = w->axis[1] + ((x * w->x[1] + y * w->y[1]) + z * w->z[1]);
    *dz = w->axis[2] + ((x * w->x[2] + y * w->y[2]) + z * w->z[2]);
}

/* The depth inside the cap, see lobe.h. */
PSC_LANE real FN(cap_depth)(const struct FN(psc_cap_world) *w, real height, real power,
                            real across)
{
    const real up = w->sin_b * height;
    const real quotient = w->sin_a * power * (w->sin_a / (up - across));

    if (!w->projected)
        return power;
    return (up < K(0.0)) != (across < K(0.0)) ? quotient : across + up;
}

/* Distance in units of that of the centre, and the normal in the side's frame (axial: along the
   axis), of the near intersection with the sphere. No ray is intersected: all terms of
     distance = cos^2 alpha / (cos alpha + depth + g),  g^2 = depth (2 cos alpha + depth)
   are positive. */
PSC_LANE void FN(cap_hit)(const struct FN(psc_cap_world) *w, real depth, real *ratio,
                          real *scale, real *axial)
{
    const real d = MAX(depth, K(0.0));
    const real g = SQRT(d * (K(2.0) * w->cos_a + d));
    const real sum = w->cos_a + d + g;
    /* The rim seen from the surface itself: the receiver is the point, its normal the axis. */
    const int touching = sum < SMALLEST;
    const real whole = touching ? K(1.0) : sum, square = w->cos_a * w->cos_a;
    const real inverse = K(1.0) / (whole * w->sin_a);

    *scale = square * inverse;
    *ratio = *scale * w->sin_a;
    *axial = -(touching ? K(1.0) : d + w->h0 * w->cos_a + g) * inverse;
}

/* The far intersection, for a receiver inside: distance in radii. */
PSC_LANE real FN(inside_distance)(const struct FN(psc_cap_world) *w, real dx, real dy, real dz)
{
    const real b = (dx * w->offset[0] + dy * w->offset[1]) + dz * w->offset[2];
    const real root = SQRT(w->slack + b * b);

    return b >= K(0.0) ? b + root : w->slack / (root - b);
}

/* The point of the sphere whose normal is scale (x, y, z) + axial times the axis, in the frame of
   the side. */
PSC_LANE void FN(cap_point)(const struct FN(psc_cap_world) *w, real scale, real x, real y, real z,
                            real axial, real point[3], real normal[3])
{
    normal[0] = scale * ((x * w->x[0] + y * w->y[0]) + z * w->z[0]) + axial * w->axis[0];
    normal[1] = scale * ((x * w->x[1] + y * w->y[1]) + z * w->z[1]) + axial * w->axis[1];
    normal[2] = scale * ((x * w->x[2] + y * w->y[2]) + z * w->z[2]) + axial * w->axis[2];
    point[0] = w->center[0] + w->radius * normal[0];
    point[1] = w->center[1] + w->radius * normal[1];
    point[2] = w->center[2] + w->radius * normal[2];
}

/* Fills everything of a result that the direction and the depth decide. */
PSC_LANE void FN(cap_surface)(const struct FN(psc_cap_world) *w, const real direction[3], real x,
                              real y, real z, real depth, real point[3], real normal[3],
                              real *distance)
{
    int i;

    if (w->distant) {
        for (i = 0; i < 3; i++) {
            point[i] = direction[i];
            normal[i] = -direction[i];
        }
        *distance = w->distance;
    } else if (w->inside) {
        const real t = FN(inside_distance)(w, direction[0], direction[1], direction[2]);

        *distance = t * w->radius;
        for (i = 0; i < 3; i++) {
            normal[i] = t * direction[i] - w->offset[i];
            point[i] = w->center[i] + w->radius * normal[i];
        }
    } else {
        real ratio, scale, axial;

        FN(cap_hit)(w, depth, &ratio, &scale, &axial);
        *distance = ratio * w->distance;
        FN(cap_point)(w, scale, x, y, z, axial, point, normal);
    }
}

/* The area maps: pdf, weight and surface point follow from w, not from the direction. */
PSC_LANE psc_result FN(area_density)(const struct FN(psc_cap_world) *w, real height,
                                     real inverse, real *weight)
{
    const real cosine = FN(cap_cosine)(w, height);

    *weight = cosine * inverse;
    return *weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* t: distance in radii. */
PSC_LANE void FN(area_surface)(const struct FN(psc_cap_world) *w, real x, real y, real from_near,
                               real t, real point[3], real normal[3], real *distance)
{
    *distance = w->radius * t;
    FN(cap_point)(w, t, x, y, K(0.0), from_near - K(1.0), point, normal);
}
