/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The radial map of an elliptic cone without an equation to solve per sample, for
 * cos alpha >= cos beta / 2.
 *
 * Theta(eta) = theta of ellipse_cdf.h is solved at m nodes when the light is built. Three functions
 * of X = cos 2 theta are interpolated there,
 *     cos eta = cos theta A(X),   sin eta = sin theta B(X),   1 / (1 + z) = G(X),
 * analytic around [-1,1], so that the error falls like ((1 - k) / (1 + k))^m,
 * k = cos alpha / cos beta; then each is a polynomial. The number of nodes for an error of 1e-15
 * (8e-8 in float) is chosen by k.
 *
 * Every array has n elements next to each other and `stride` from one coefficient to the next: a
 * build is n = 1, a wavefront many lights at once, with the same operations in the same order.
 * Template: see precision.h.
 */

/* Of an ellipse: what a fit starts from. */
struct FN(fit_input) {
    const real *ca2, *cb2, *bend; /* squared cosines, cb^2 - ca^2 */
    const real *mu1;              /* mu - 1, see psc_cdf */
};

/* The interpolation at one node with cosine c and sine s: from tan eta = mu tan theta, an error
   of 3e-3 at most, by steps of third order (1 in float, else 2; 1 where k >= 0.99). */
PSC_LANE void FN(fit_node)(int m, int steps, size_t stride, const real *series, real ca2, real cb2,
                           real bend, real mu1, real c0, real s0, real *cosine, real *sine,
                           real *inverse)
{
    const real mean = series[0], ms = s0 + mu1 * s0;
    const real shrink = K(1.0) / SQRT(c0 * c0 + ms * ms);
    const real turn = c0 * s0 * mu1 * shrink, t2 = turn * turn;
    /* arc sine for |turn| <= 0.072 */
    real delta = turn + turn * t2 * (K(1.66666666666666667e-1) +
                 t2 * (K(7.5e-2) + t2 * (K(4.46428571428571429e-2) +
                 t2 * (K(3.03819444444444444e-2) + t2 * K(2.23721590909090909e-2)))));
    real c = c0 * shrink, s = ms * shrink;
    int i, k;

    for (i = 0; i < steps; i++) {
        const real z = SQRT(ca2 * (c * c) + cb2 * (s * s)), sum = K(1.0) + z;
        const real x = K(2.0) * (c - s) * (c + s), sc = s * c;
        real b0, b1 = K(0.0), b2 = K(0.0), h, h2, odd, even;

        PSC_UNROLL
        for (k = m - 1; k > 0; k--) {
            b0 = series[(size_t)k * stride] + x * b1 - b2;
            b2 = b1;
            b1 = b0;
        }
        h = -(delta + b1 * (K(2.0) * sc)) * (mean * sum);
        h = h + h * h * (K(0.5) * bend * sc) / (MAX(z, SMALLEST) * sum);
        delta = delta + h;
        h2 = h * h;
        odd = h * (K(1.0) - h2 * (K(1.66666666666666667e-1) - h2 * K(8.33333333333333333e-3)));
        even = h2 * (K(0.5) - h2 * K(4.16666666666666667e-2));
        b0 = c - (c * even + s * odd);
        s = s - (s * even - c * odd);
        c = b0;
    }
    *cosine = c;
    *sine = s;
    *inverse = K(1.0) / (K(1.0) + SQRT(ca2 * (c * c) + cb2 * (s * s)));
}

/* From values at the nodes to the coefficients of powers of X: Chebyshev's first. */
PSC_LANE void FN(fit_powers)(int m, size_t n, size_t stride, const real *wave, const real *power,
                             const real *values, real *work, real *to)
{
    const real share = K(1.0) / (real)m;
    size_t e;
    int i, j, k;

    for (k = 0; k < m; k++)
        for (e = 0; e < n; e++) {
            real sum = K(0.0);

            PSC_UNROLL
            for (j = 0; j < m; j++)
                sum += values[(size_t)j * stride + e] * wave[k * m + j];
            work[(size_t)k * stride + e] = sum * (k > 0 ? K(2.0) * share : share);
        }
    for (i = 0; i < m; i++)
        for (e = 0; e < n; e++) {
            real sum = K(0.0);

            PSC_UNROLL
            for (k = i; k < m; k += 2)
                sum += work[(size_t)k * stride + e] * power[k * m + i];
            to[(size_t)i * stride + e] = sum;
        }
}

/* The coefficients of A, B and G; series receives the mean of 1 / (1 + z) and the series of
   Theta. work has 4 m rows. */
PSC_LANE void FN(fit)(int m, int steps, size_t n, size_t stride, const real *c, const real *s,
                      const real *per_c, const real *per_s, const real *wave, const real *power,
                      const struct FN(fit_input) *in, real *work, real *series, real *fit)
{
    const size_t rows = (size_t)m * stride;
    real *cosines = work + rows, *sines = work + 2 * rows, *inverses = work + 3 * rows;
    size_t e;
    int j, k;

    for (j = 0; j < m; j++)
        for (e = 0; e < n; e++)
            inverses[(size_t)j * stride + e] =
                K(1.0) /
                (K(1.0) + SQRT(in->ca2[e] * (c[j] * c[j]) + in->cb2[e] * (s[j] * s[j])));
    for (k = 0; k < m; k++)
        for (e = 0; e < n; e++) {
            real sum = K(0.0);

            PSC_UNROLL
            for (j = 0; j < m; j++)
                sum += inverses[(size_t)j * stride + e] * wave[k * m + j];
            series[(size_t)k * stride + e] =
                k > 0 ? sum * (K(1.0) / (real)(m * k)) / series[e] : sum * (K(1.0) / (real)m);
        }
    for (j = 0; j < m; j++)
        for (e = 0; e < n; e++) {
            const size_t at = (size_t)j * stride + e;
            real cosine, sine, inverse;

            FN(fit_node)(m, steps, stride, series + e, in->ca2[e], in->cb2[e], in->bend[e],
                         in->mu1[e], c[j], s[j], &cosine, &sine, &inverse);
            cosines[at] = cosine * per_c[j];
            sines[at] = sine * per_s[j];
            inverses[at] = inverse;
        }
    FN(fit_powers)(m, n, stride, wave, power, cosines, work, fit);
    FN(fit_powers)(m, n, stride, wave, power, sines, work, fit + rows);
    FN(fit_powers)(m, n, stride, wave, power, inverses, work, fit + 2 * rows);
}
