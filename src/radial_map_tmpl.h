/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The radial map of a cap whose projection is part ellipse, part lune (section 4.2 of [UG18]).
 * Seen from the centre of the ellipse, the boundary is the horizon circle for |psi| < psi_l and
 * the ellipse beyond. Template: see precision.h.
 */

/* The share t of the sides: u in [0,1] from the middle, its complement r, and which side. */
PSC_LANE void FN(fold)(real t, real *u, real *r, real *side)
{
    *u = ABS(K(2.0) * t - K(1.0));
    *r = MIN(K(2.0) * t, K(2.0) - K(2.0) * t);
    *side = COPYSIGN(K(1.0), t - K(0.5));
}

/*
 * On the circle, twice the area swept from the ellipse's centre up to psi is Kepler's psi - x_e
 * sin psi; on the ellipse it is linear in theta. Kepler's equation is solved from a start
 * within 8.8e-4 (starts.py) by one step of fourth order (float: second).
 */
PSC_LANE void FN(radial_both)(const struct FN(psc_lobe) *l, real s, real t,
                              struct FN(psc_point) *p)
{
    const real rho = SQRT(s), margin = (K(1.0) - s) / (K(1.0) + rho);
    real u, r, side, y, y2, psi, mean, tau, x, sine_defect, versine, sine, cosine;
    real f, d, h, bx, by, bz;
    int circle;

    FN(fold)(t, &u, &r, &side);
    circle = r >= l->arc;

    mean = u * l->total;
    y = MIN(u, l->circle) * l->per_circle;
    y2 = y * y;
    psi = l->psi_l * y *
          (K(1.0) + (K(1.0) - y2) * (l->m + y2 * (l->m1 + y2 * (l->m2 + y2 * l->m3))));
    tau = r * l->per_ellipse;
    tau = MIN(tau, K(3.14159265358979323846));
    x = circle ? psi : MIN(tau, K(3.14159265358979323846) - tau);
    FN(sine_cosine_defects)(x, &sine_defect, &versine);
    sine = x - sine_defect;

    /* Ellipse: theta = pi - tau. */
    cosine = COPYSIGN(K(1.0) - versine, tau - (K(3.14159265358979323846) - tau));
    bx = l->sin_a * l->sin_b * cosine;
    by = l->sin_a * sine;
    bz = l->cos_a * l->sin_b - l->zc * cosine;

    /* Circle. */
    f = (l->del * psi - mean) + l->x_e * sine_defect;
    d = l->del + l->x_e * versine;
#if PSC_BITS == 64
    h = quintic_step(f, d, l->x_e * sine, l->x_e * (1.0 - versine), -l->x_e * sine, 0.01);
    turn_by(h, &sine, &versine);
#else
    d = K(1.0) / (d + SMALLEST); /* below 1e-19 rad float has no d */
    h = -f * d;
    h = h * (K(1.0) - h * (K(0.5) * l->x_e * sine * d));
    cosine = K(1.0) - versine;
    versine += h * (sine + K(0.5) * h * cosine);
    sine += h * (cosine - K(0.5) * h * sine);
#endif
    bx = circle ? l->del - versine : bx;
    by = circle ? sine : by;
    bz = circle ? K(0.0) : bz;

    FN(radial_point)(l, 0, bx, side * by, bz, rho, margin, p);
    /* On the outline, across is -sin beta times the height; on the circle, v. */
    d = circle ? l->v0 - l->cos_b * versine : -l->sin_b * bz;
    p->across = rho * d - margin * (l->cos_a * l->sin_b * l->sin_b);
    d = d * l->per_a;
    p->power = (K(1.0) - s) * (l->sin_b * l->sin_b) - (circle ? s * (d * d) : K(0.0));
}
