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

/* A step of third order for eta = theta + delta, given by its cosine and sine. */
PSC_LANE void FN(fit_step)(int m, size_t stride, const real *series, real ca2, real cb2, real bend,
                           real *delta, real *cosine, real *sine)
{
    const real c = *cosine, s = *sine, z = SQRT(ca2 * (c * c) + cb2 * (s * s)), sum = K(1.0) + z;
    const real x = K(2.0) * (c - s) * (c + s), sc = s * c;
    real b0, b1 = K(0.0), b2 = K(0.0), h, h2, odd, even;
    int k;

    PSC_UNROLL
    for (k = m - 1; k > 0; k--) {
        b0 = series[(size_t)k * stride] + x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    h = -(*delta + b1 * (K(2.0) * sc)) * (series[0] * sum);
    h = h + h * h * (K(0.5) * bend * sc) / (MAX(z, SMALLEST) * sum);
    *delta = *delta + h;
    h2 = h * h;
    odd = h * (K(1.0) - h2 * (K(1.66666666666666667e-1) - h2 * K(8.33333333333333333e-3)));
    even = h2 * (K(0.5) - h2 * K(4.16666666666666667e-2));
    *cosine = c - (c * even + s * odd);
    *sine = s - (s * even - c * odd);
}

/* The interpolation at one node with cosine c0 and sine s0: from tan eta = mu tan theta, an error
   of 3e-3 at most, by steps of third order (1 in float, else 2; 1 where k >= 0.99). */
PSC_LANE void FN(fit_node)(int m, int steps, size_t stride, const real *series, real ca2, real cb2,
                           real bend, real mu1, real c0, real s0, real *cosine, real *sine,
                           real *inverse)
{
    const real ms = s0 + mu1 * s0, shrink = K(1.0) / SQRT(c0 * c0 + ms * ms);
    const real turn = c0 * s0 * mu1 * shrink, t2 = turn * turn;
    /* arc sine for |turn| <= 0.072 */
    real delta = turn + turn * t2 * (K(1.66666666666666667e-1) +
                 t2 * (K(7.5e-2) + t2 * (K(4.46428571428571429e-2) +
                 t2 * (K(3.03819444444444444e-2) + t2 * K(2.23721590909090909e-2)))));
    real c = c0 * shrink, s = ms * shrink;

    FN(fit_step)(m, stride, series, ca2, cb2, bend, &delta, &c, &s);
    if (steps > 1)
        FN(fit_step)(m, stride, series, ca2, cb2, bend, &delta, &c, &s);
    *cosine = c;
    *sine = s;
    *inverse = K(1.0) / (K(1.0) + SQRT(ca2 * (c * c) + cb2 * (s * s)));
}

/* From values at the nodes to the coefficients of powers of X: Chebyshev's first. */
PSC_LANE void FN(fit_powers)(int m, size_t n, size_t stride, const real *wave, const real *power,
                             const real *restrict values, real *restrict work, real *restrict to)
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
    /* Powers are even or odd, and so those of an even m are every other one: as many for each i,
       with zeros, so that the loop over k has a constant length. */
    for (i = 0; i < m; i++)
        for (e = 0; e < n; e++) {
            const int every = m % 2 ? 1 : 2, from = m % 2 ? 0 : i % 2;
            real sum = K(0.0);

            PSC_UNROLL
            for (k = 0; k < m / every; k++)
                sum += work[(size_t)(from + every * k) * stride + e] *
                       power[(from + every * k) * m + i];
            to[(size_t)i * stride + e] = sum;
        }
}

/* The mean of 1 / (1 + z), twice, and the series of Theta. */
PSC_LANE void FN(fit_series)(int m, size_t n, size_t stride, const real *c, const real *s,
                             const real *wave, const struct FN(fit_input) *in,
                             real *restrict values, real *restrict mean, real *restrict series)
{
    const real *restrict ca2 = in->ca2, *restrict cb2 = in->cb2;
    size_t e;
    int j, k;

    for (j = 0; j < m; j++)
        for (e = 0; e < n; e++)
            values[(size_t)j * stride + e] =
                K(1.0) / (K(1.0) + SQRT(ca2[e] * (c[j] * c[j]) + cb2[e] * (s[j] * s[j])));
    for (e = 0; e < n; e++) {
        real sum = K(0.0);

        PSC_UNROLL
        for (j = 0; j < m; j++)
            sum += values[(size_t)j * stride + e];
        series[e] = mean[e] = sum * (K(1.0) / (real)m);
    }
    for (k = 1; k < m; k++)
        for (e = 0; e < n; e++) {
            real sum = K(0.0);

            PSC_UNROLL
            for (j = 0; j < m; j++)
                sum += values[(size_t)j * stride + e] * wave[k * m + j];
            series[(size_t)k * stride + e] = sum * (K(1.0) / (real)(m * k)) / mean[e];
        }
}

/* The functions at the nodes. */
PSC_LANE void FN(fit_nodes)(int m, int steps, size_t n, size_t stride, const real *c, const real *s,
                            const real *per_c, const real *per_s, const struct FN(fit_input) *in,
                            const real *restrict series, real *restrict cosines,
                            real *restrict sines, real *restrict inverses)
{
    const real *restrict ca2 = in->ca2, *restrict cb2 = in->cb2;
    const real *restrict bend = in->bend, *restrict mu1 = in->mu1;
    size_t e;
    int j;

    for (j = 0; j < m; j++)
        for (e = 0; e < n; e++) {
            const size_t at = (size_t)j * stride + e;
            real cosine, sine, inverse;

            FN(fit_node)(m, steps, stride, series + e, ca2[e], cb2[e], bend[e], mu1[e], c[j], s[j],
                         &cosine, &sine, &inverse);
            cosines[at] = cosine * per_c[j];
            sines[at] = sine * per_s[j];
            inverses[at] = inverse;
        }
}

/* The coefficients of A, B and G; work has 4 m rows. */
PSC_LANE void FN(fit)(int m, int steps, size_t n, size_t stride, const real *c, const real *s,
                      const real *per_c, const real *per_s, const real *wave, const real *power,
                      const struct FN(fit_input) *in, real *work, real *series, real *fit)
{
    const size_t rows = (size_t)m * stride;
    real *cosines = work + rows, *sines = work + 2 * rows, *inverses = work + 3 * rows;

    FN(fit_series)(m, n, stride, c, s, wave, in, inverses, cosines, series);
    FN(fit_nodes)(m, steps, n, stride, c, s, per_c, per_s, in, series, cosines, sines, inverses);
    FN(fit_powers)(m, n, stride, wave, power, cosines, work, fit);
    FN(fit_powers)(m, n, stride, wave, power, sines, work, fit + rows);
    FN(fit_powers)(m, n, stride, wave, power, inverses, work, fit + 2 * rows);
}
