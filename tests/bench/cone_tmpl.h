/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Uniform sampling of the cone of a sphere [Wan92], as renderers write it: with the sine and
 * cosine of libm, and with a series for cones too narrow for 1 - cos. Template: see real.h.
 */
struct FN(cone) {
    real x[3], y[3], axis[3], center[3];
    real radius, sin2_max, one_minus_cos_max, pdf;
};

static inline int FN(cone_build)(struct FN(cone) *c, const real position[3], const real normal[3],
                                 const real *light) /* center, radius */
{
    const real *const center = light, radius = light[3];
    const real w[3] = {center[0] - position[0], center[1] - position[1],
                       center[2] - position[2]};
    const real d2 = FN(dot)(w, w), inverse = R(1) / sqrt(d2);
    int i;

    (void)normal; /* a cone does not look at the horizon */
    for (i = 0; i < 3; i++) {
        c->axis[i] = w[i] * inverse;
        c->center[i] = center[i];
    }
    FN(frame)(c->axis, c->x, c->y);
    c->radius = radius;
    c->sin2_max = radius * radius / d2;
    c->one_minus_cos_max = c->sin2_max < R(0.00068523)
                               ? c->sin2_max * R(0.5)
                               : R(1) - sqrt(MAX(R(0), R(1) - c->sin2_max));
    c->pdf = R(1) / (R(2 * PI) * c->one_minus_cos_max);
    return 1;
}

/* Direction and density; returns the square of the sine of the angle to the axis, and its cosine
   and azimuth. */
static inline real FN(cone_direction)(const struct FN(cone) *c, real u, real v, real direction[3],
                                      real *pdf, real *cosine, real *cos_phi, real *sin_phi)
{
    const real cos_theta = R(1) - u * c->one_minus_cos_max, phi = R(2 * PI) * v;
    const int narrow = c->sin2_max < R(0.00068523);
    const real sin2 = narrow ? c->sin2_max * u : MAX(R(0), R(1) - cos_theta * cos_theta);
    const real sine = sqrt(sin2);

    *cosine = narrow ? sqrt(R(1) - sin2) : cos_theta;
    *cos_phi = cos(phi);
    *sin_phi = sin(phi);
    FN(to_world)(c->x, c->y, c->axis, sine * *cos_phi, sine * *sin_phi, *cosine, direction);
    *pdf = c->pdf;
    return sin2;
}

static inline void FN(cone_sample)(const struct FN(cone) *c, real u, real v, real direction[3],
                                   real *pdf)
{
    real cosine, cos_phi, sin_phi;

    FN(cone_direction)(c, u, v, direction, pdf, &cosine, &cos_phi, &sin_phi);
}

/* With the point on the sphere, its normal and its distance, as a shadow ray wants them. */
static inline void FN(cone_hit)(const struct FN(cone) *c, real u, real v, real direction[3],
                                real *pdf, real point[3], real normal[3], real *distance)
{
    real cosine, cos_phi, sin_phi, cos_alpha, sin_alpha;
    const real sin2 = FN(cone_direction)(c, u, v, direction, pdf, &cosine, &cos_phi, &sin_phi);
    const real sin_max = sqrt(c->sin2_max);
    int i;

    cos_alpha = sin2 / sin_max + cosine * sqrt(MAX(R(0), R(1) - sin2 / c->sin2_max));
    sin_alpha = sqrt(MAX(R(0), R(1) - cos_alpha * cos_alpha));
    FN(to_world)(c->x, c->y, c->axis, sin_alpha * cos_phi, sin_alpha * sin_phi, -cos_alpha, normal);
    for (i = 0; i < 3; i++)
        point[i] = c->center[i] + c->radius * normal[i];
    *distance = c->radius / sin_max * cosine -
                sqrt(MAX(R(0), c->radius * c->radius *
                                    (R(1) - sin2 / c->sin2_max)));
}
