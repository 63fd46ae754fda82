/* SPDX-License-Identifier: Apache-2.0 */
/* The parallel map of an elliptic cone by the series of span_fit_tmpl.h. Template: see
   precision.h. */

/* Turns the angle with cosine c and sine s by h, |h| <= 0.02. */
PSC_LANE void FN(span_turn)(real h, real *c, real *s)
{
    const real h2 = h * h, cosine = *c;
    const real odd =
        h * (K(1.0) - h2 * (K(1.66666666666666667e-1) - h2 * K(8.33333333333333333e-3)));
    const real even = h2 * (K(0.5) - h2 * (K(4.16666666666666667e-2) -
                                           h2 * K(1.38888888888888889e-3)));

    *c = cosine - (cosine * even + *s * odd);
    *s = *s - (*s * even - cosine * odd);
}

/* A step of third order for tau = E + delta, given by its cosine and sine. */
PSC_LANE void FN(span_step)(int m, size_t stride, const real *span, real ca, real cb2, real base,
                            real *delta, real *c, real *s)
{
    const real c2 = *c * *c, s2 = *s * *s, sc = *s * *c;
    const real x = K(2.0) * (*c - *s) * (*c + *s);
    const real q = ca * c2 + s2, y = c2 + ca * s2, d = ca * c2 + cb2 * s2;
    const real limit = K(0.25) * *c, inverse = K(1.0) / MAX(*c, SMALLEST);
    real b0, b1 = K(0.0), b2 = K(0.0), h, bend;
    int j;

    PSC_UNROLL
    for (j = m - 1; j > 0; j--) {
        b0 = span[(size_t)j * stride] + x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    /* Newton's step, and half of the density's logarithmic derivative, negated */
    h = -(*delta + b1 * (K(2.0) * sc) - base) * inverse * inverse * (q * SQRT(y * d) * span[0]);
    h = MIN(MAX(h, -limit), limit);
    bend = *s * inverse + K(0.5) * sc / (q * (y * d)) *
                              ((K(1.0) - ca) * d * (K(2.0) * y - q) + (cb2 - ca) * (q * y));
    h = h + h * h * bend;
    h = MIN(MAX(h, -limit), limit);
    *delta = *delta + h;
    FN(span_turn)(h, c, s);
}

/* The point at (u, v). */
PSC_LANE void FN(span_point)(int m, int steps, size_t stride, const real *span, real a, real ca,
                             real b, real cb, real u, real v, struct FN(psc_disk_point) *p)
{
    const real f = K(2.0) * v - K(1.0), cb2 = cb * cb;
    real sine, cosine, base, delta, defect, versine, c, s, q, y, k, z;

    /* E from the end: cos E, sin E */
    FN(solve_chord)(K(2.0) * MIN(u, K(1.0) - u), &sine, &cosine);
    base = sine * cosine;
    delta = K(2.0) * base *
            (span[(size_t)m * stride] +
             span[(size_t)(m + 1) * stride] * ((sine - cosine) * (sine + cosine)));
    FN(sine_cosine_defects)(delta, &defect, &versine);
    defect = delta - defect;
    c = sine - (sine * versine + cosine * defect);
    s = cosine - (cosine * versine - sine * defect);
    FN(span_step)(m, stride, span, ca, cb2, base, &delta, &c, &s);
    if (steps > 1)
        FN(span_step)(m, stride, span, ca, cb2, base, &delta, &c, &s);
    q = K(1.0) / (ca * (c * c) + s * s);
    y = K(1.0) / (c * c + ca * (s * s));
    p->c = c;
    p->s = COPYSIGN(s, u - K(0.5));
    p->rest = K(4.0) * v * (K(1.0) - v);
    k = SQRT(p->rest * q + f * f * ca * y);
    z = k * SQRT(ca * (c * c) + cb2 * (s * s));
    p->x = f * a * c * SQRT(y);
    p->y = k * b * p->s;
    p->z = -(p->x * p->x + p->y * p->y) / (K(1.0) + z);
}
