/* SPDX-License-Identifier: Apache-2.0 */
/* The inverses of the maps of the unit square in elementary_tmpl.h. */
#ifndef PSC_SRC_SQUARE_H
#define PSC_SRC_SQUARE_H

#include "elementary.h"

/* The inverse of turn(): v of the direction (c, s). */
PSC_LANE double unturn(double c, double s)
{
    const double u = angle_of(c, ABS(s)) * (1.0 / PSC_PI);

    return 0.5 * (s < 0.0 ? 1.0 - u : 1.0 + u);
}

/* The inverse of square_to_disk(). */
PSC_LANE void disk_to_square(double p, double q, double *u, double *v)
{
    const int along_u = ABS(p) > ABS(q);
    const double radius = SQRT(p * p + q * q);
    const double far = COPYSIGN(radius, along_u ? p : q);
    const double tangent = along_u ? q / p : q != 0.0 ? p / q : 0.0;
    const double angle = angle_of(1.0, ABS(tangent));
    const double near = far * COPYSIGN(angle, tangent) * (4.0 / PSC_PI);

    *u = 0.5 + 0.5 * (along_u ? far : near);
    *v = 0.5 + 0.5 * (along_u ? near : far);
}

/* Polar coordinates of the disk, the squared radius being u, in either map of the square. */
PSC_LANE void polar_to_square(int concentric, double u, double c, double s, double uv[2])
{
    if (concentric) {
        const double r = SQRT(c * c + s * s);
        const double scale = r > 0.0 ? SQRT(u) / r : 0.0;

        disk_to_square(c * scale, s * scale, uv, uv + 1);
    } else {
        uv[0] = u;
        uv[1] = unturn(c, s);
    }
}

#endif
