/* SPDX-License-Identifier: Apache-2.0 */
/* What every renderer has. Template: see real.h. */

static inline real FN(dot)(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void FN(cross)(const real a[3], const real b[3], real c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Two unit vectors that make a right-handed frame with the unit vector z. */
static inline void FN(frame)(const real z[3], real x[3], real y[3])
{
    const int i = fabs(z[0]) > fabs(z[1]) ? 0 : 1;
    const real scale = R(1) / sqrt(z[i] * z[i] + z[2] * z[2]);

    x[0] = x[1] = R(0);
    x[i] = -z[2] * scale;
    x[2] = z[i] * scale;
    FN(cross)(z, x, y);
}

static inline void FN(to_world)(const real x[3], const real y[3], const real z[3], real px, real py,
                                real pz, real to[3])
{
    int i;

    for (i = 0; i < 3; i++)
        to[i] = px * x[i] + py * y[i] + pz * z[i];
}
