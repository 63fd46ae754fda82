/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What the maps by projected solid angle share: from a boundary point, or a chord, of the
 * projected cap to the direction above it. Template: see precision.h.
 */

/* Height from its square, and the offset. A cap wholly above the horizon (ellipse) may be tiny
   and high: there z - sin beta would cancel. */
PSC_LANE void FN(lift)(const struct FN(psc_lobe) *l, int ellipse, real x, real y, real z2,
                       struct FN(psc_point) *p)
{
    const real z = SQRT(z2);

    p->x = x - l->cos_b * l->h0;
    p->y = y;
    p->height = z;
    if (ellipse)
        p->z = -(K(2.0) * l->cos_b * p->x + p->x * p->x + y * y) / (z + l->sin_b);
    else
        p->z = z - l->sin_b;
}

/* The point at rho times the boundary point (bx, by), relative to the ellipse's centre, where
   the boundary has the height bz. Concavity of z^2 makes every term positive: z is accurate
   relative to itself down to the horizon. margin = 1 - rho. */
PSC_LANE void FN(radial_point)(const struct FN(psc_lobe) *l, int ellipse, real bx, real by,
                               real bz, real rho, real margin, struct FN(psc_point) *p)
{
    const real k = bx * bx + by * by;

    FN(lift)(l, ellipse, rho * bx, rho * by,
             margin * (l->ome2 + rho * k) + rho * (bz * bz), p);
}

/* The point at the share s (rest = 1 - s) of the chord at height y that begins at x with the
   length chord; zl and zr are the heights of its ends. */
PSC_LANE void FN(chord_point)(const struct FN(psc_lobe) *l, int ellipse, real x, real y,
                              real chord, real zl, real zr, real s, real rest,
                              struct FN(psc_point) *p)
{
    const real step = s * chord;

    FN(lift)(l, ellipse, x + step, y, rest * (step * chord + zl * zl) + s * (zr * zr), p);
}
