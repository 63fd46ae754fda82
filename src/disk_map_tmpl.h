/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of an elliptic cone, and of the light behind it by its area, in the frame of the cone: lane
 * functions. The unit square is that of [GUK17]: u goes once around, or from chord to chord; v is
 * 0 on the outline and 1 in the middle, or goes along the chord. Template: see precision.h.
 */

/*
 * A sampled direction (x, y, 1 + z), accurate relative to the semi-arcs. Radial and concentric:
 * c, s the cosine and sine of eta, rest = v. Parallel: of tau, and rest = 4 v (1 - v), see
 * chord_point(). Area maps: (x, y, z) in the frame of struct psc_laid, c, s are the point of the
 * light and rest is its distance in units of area_reach.
 */
struct FN(psc_disk_point) {
    real x, y, z, c, s, rest;
};

/* Cosine and sine of 2 pi u. */
PSC_LANE void FN(full_turn)(real u, real *cosine, real *sine)
{
    real versine;

    FN(turn)(u, sine, cosine, &versine);
    *cosine = -*cosine;
    *sine = -*sine;
}

/* The direction towards eta with the cosine c and the sine s, inside by `inner`, of which 0 is the
   middle and 1 the outline; g = 1 / (1 + z): 1 - cosine of its angle to the axis is
   inner (1 - z), 1 - z = g ((a c)^2 + (b s)^2). */
PSC_LANE void FN(cone_point)(real a, real b, real inner, real rest, real c, real s, real g,
                             struct FN(psc_disk_point) *p)
{
    const real ac = a * c, bs = b * s;
    const real kz = inner * g, h = kz * (ac * ac + bs * bs);
    const real r = SQRT(kz * (K(2.0) - h));

    p->x = ac * r;
    p->y = bs * r;
    p->z = -h;
    p->c = c;
    p->s = s;
    p->rest = rest;
}

PSC_LANE real FN(power_sum)(int m, size_t stride, const real *c, real x)
{
    real sum = c[(size_t)(m - 1) * stride];
    int k;

    PSC_UNROLL
    for (k = m - 2; k >= 0; k--)
        sum = sum * x + c[(size_t)k * stride];
    return sum;
}

/* The interpolated maps of ellipse_fit_tmpl.h. */
PSC_LANE void FN(fitted_point)(int m, size_t stride, const real *fit, int concentric, real a, real b,
                               real u, real v, struct FN(psc_disk_point) *p)
{
    const size_t rows = (size_t)m * stride;
    real c, s, x, versine, radius, margin, inner, rest;

    if (concentric) {
        FN(square_to_disk)(u, v, &c, &s, &versine, &radius, &margin);
        inner = radius * radius;
        rest = margin * (K(1.0) + radius);
    } else {
        FN(full_turn)(u, &c, &s);
        inner = K(1.0) - v;
        rest = v;
    }
    x = (c - s) * (c + s);
    FN(cone_point)(a, b, inner, rest, c * FN(power_sum)(m, stride, fit, x),
                   s * FN(power_sum)(m, stride, fit + rows, x),
                   FN(power_sum)(m, stride, fit + 2 * rows, x), p);
}

/*
 * The radial map with the first guess for eta in place of the solution, tan eta = mu tan 2 pi u, and
 * its exact density: that of the radial map is constant, and differs by a factor 1 + z over
 * d eta / d u. mu^2 = (1 + ca) / (1 + cb) makes both ends of a quadrant right.
 */
PSC_LANE void FN(quasi_point)(real a, real b, real ca2, real cb2, real mu1, real u, real v,
                              struct FN(psc_disk_point) *p)
{
    real c, s, ms, shrink;

    FN(full_turn)(u, &c, &s);
    ms = s + mu1 * s;
    shrink = K(1.0) / SQRT(c * c + ms * ms);
    c = c * shrink;
    s = ms * shrink;
    FN(cone_point)(a, b, K(1.0) - v, v, c, s,
                   K(1.0) / (K(1.0) + SQRT(ca2 * (c * c) + cb2 * (s * s))), p);
}

/* Solid angle per area of the square: scale (mu^2 c^2 + s^2) / (1 + z), scale = 2 pi a b / mu. */
PSC_LANE real FN(quasi_share)(real ca2, real cb2, real mu2, real c, real s)
{
    const real c2 = c * c, s2 = s * s;

    return (mu2 * c2 + s2) / (K(1.0) + SQRT(ca2 * c2 + cb2 * s2));
}

/* How far in front of the receiver the direction goes, z, and z^2 (1 - U^2 - V^2) of
   ellipse_view.h, both without cancellation. */
PSC_LANE void FN(cone_depth)(real ca, real cb, const struct FN(psc_disk_point) *p, real *height,
                             real *margin)
{
    const real cc = ca * p->c, cs = cb * p->s, z = SQRT(cc * cc + cs * cs);

    *height = z + p->rest * (K(1.0) - z);
    *margin = p->rest * (*height + z) / (K(1.0) + z);
}

/* The same on a chord, see ellipse_chord.h. */
PSC_LANE void FN(chord_depth)(real ca, real cb, const struct FN(psc_disk_point) *p, real *height,
                              real *margin)
{
    const real c2 = p->c * p->c, s2 = p->s * p->s;
    const real q = K(1.0) / MAX(ca * c2 + s2, SMALLEST), y = K(1.0) / MAX(c2 + ca * s2, SMALLEST);
    const real square = p->rest * q + (K(1.0) - p->rest) * ca * y;

    *height = SQRT(square * (ca * c2 + cb * cb * s2));
    *margin = p->rest * ca * c2 * q;
}

/* The boost between the unit disks of ellipse_view.h: from (x', y') = (U', V') times h, and
   margin = h^2 (1 - U^2 - V^2); near and far exchanged for the way back. D through inverse = 1 / D. */
PSC_LANE void FN(boost)(real near, real far, real x, real y, real h, real margin, real *qx, real *qy,
                        real *inverse)
{
    const real sum = MAX(h + ABS(y), SMALLEST);
    const real other = (margin + x * x) / sum;
    const real plus = y < K(0.0) ? other : sum, minus = y < K(0.0) ? sum : other;
    const real p = near * plus, m = far * minus;

    *inverse = K(1.0) / MAX(p + m, SMALLEST);
    *qx = K(2.0) * x * *inverse;
    *qy = (p - m) * *inverse;
}

/* Area maps: the point (s, t) of the light, see struct psc_laid. */
PSC_LANE void FN(area_point)(const struct FN(psc_disk_world) *w, real s, real t,
                             struct FN(psc_disk_point) *p)
{
    const real x = w->flat_x + (w->flat_a * s + w->flat_skew * t), y = w->flat_y + w->flat_b * t;
    const real length = SQRT((x * x + y * y) + w->flat_height * w->flat_height);
    const real inverse = K(1.0) / length;

    p->x = x * inverse;
    p->y = y * inverse;
    p->z = w->flat_height * inverse;
    p->c = s;
    p->s = t;
    p->rest = length;
}

PSC_LANE void FN(area_polar)(const struct FN(psc_disk_world) *w, int concentric, real u, real v,
                           struct FN(psc_disk_point) *p)
{
    real c, s, versine, radius, margin;

    if (concentric) {
        FN(square_to_disk)(u, v, &c, &s, &versine, &radius, &margin);
    } else {
        FN(full_turn)(u, &c, &s);
        radius = SQRT(K(1.0) - v);
    }
    FN(area_point)(w, radius * c, radius * s, p);
}

/* Chords of the disk at the height sin E, E + sin E cos E = pi (u - 1/2). */
PSC_LANE void FN(area_chord)(const struct FN(psc_disk_world) *w, real u, real v,
                             struct FN(psc_disk_point) *p)
{
    real half, height;

    FN(solve_chord)(K(2.0) * MIN(u, K(1.0) - u), &half, &height);
    FN(area_point)(w, (K(2.0) * v - K(1.0)) * half, COPYSIGN(height, u - K(0.5)), p);
}

PSC_LANE void FN(area_lane)(enum psc_disk_map map, const struct FN(psc_disk_world) *w, real u,
                            real v, struct FN(psc_disk_point) *p)
{
    if (map == PSC_DISK_AREA_PARALLEL)
        FN(area_chord)(w, u, v, p);
    else
        FN(area_polar)(w, map == PSC_DISK_AREA_CONCENTRIC, u, v, p);
}
