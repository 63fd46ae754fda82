/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The parallel map of an elliptic cone in a fixed number of operations, for semi-arcs up to
 * 68.9 degrees.
 *
 * In tau of ellipse_chord.h the share of the cone between the middle and a chord has the density
 * c^2 / (q sqrt(Y D)), an even function of period pi, whose series converges like
 * ((1 - r) / (1 + r))^m, r^2 = cos alpha:
 *     pi / 2 share = tau + sum of b_k sin 2 k tau.
 * A plane ellipse has E + sin E cos E there. tau starts from E, with the slopes of tau(E) right at
 * both ends (an error of 2e-2 at most, relative to the angles to both), and steps of third order do
 * the rest. All terms are multiples of the angle to the end of the map where that is small, so that
 * the chords there keep their digits.
 *
 * Arrays are those of ellipse_fit_tmpl.h: n elements next to each other, `stride` between
 * coefficients. Template: see precision.h.
 */

/* Rows of a span: the mean of the density, b_1 to b_(m - 1), and the two numbers of the
   start. */
#define PSC_SPAN_ROWS(m) ((m) + 2)

struct FN(span_input) {
    const real *ca, *cb; /* cosines of the semi-arcs */
};

PSC_LANE void FN(span_fit)(int m, size_t n, size_t stride, const real *c, const real *s,
                           const real *wave, const struct FN(span_input) *in, real *work,
                           real *span)
{
    size_t e;
    int j, k;

    for (j = 0; j < m; j++)
        for (e = 0; e < n; e++) {
            const real ca = in->ca[e], cb = in->cb[e], c2 = c[j] * c[j], s2 = s[j] * s[j];
            const real q = ca * c2 + s2, y = c2 + ca * s2, d = ca * c2 + cb * cb * s2;

            work[(size_t)j * stride + e] = c2 / (q * SQRT(y * d));
        }
    for (e = 0; e < n; e++) {
        const real ca = in->ca[e], root = SQRT(ca);
        real sum = K(0.0), middle, cube, end;

        PSC_UNROLL
        for (j = 0; j < m; j++)
            sum += work[(size_t)j * stride + e];
        span[e] = sum * (K(1.0) / (real)m);
        work[(size_t)m * stride + e] = K(1.0) / span[e];
        /* d tau / d E in the middle, and the cube of that at the end */
        sum = K(2.0) * span[e];
        middle = sum * (ca * root);
        cube = sum * (root * in->cb[e]);
        end = (K(2.0) + cube) * K(0.333333333333333333);
        for (j = 0; j < 2; j++) { /* Halley's steps: 1e-10 for cubes from 0.3 to 1 */
            const real power = end * end * end;

            end = end * (power + K(2.0) * cube) / (K(2.0) * power + cube);
        }
        span[(size_t)m * stride + e] = K(0.25) * (middle - end);
        span[(size_t)(m + 1) * stride + e] = K(0.25) * (middle + end - K(2.0));
    }
    for (k = 1; k < m; k++)
        for (e = 0; e < n; e++) {
            real sum = K(0.0);

            PSC_UNROLL
            for (j = 0; j < m; j++)
                sum += work[(size_t)j * stride + e] * wave[k * m + j];
            span[(size_t)k * stride + e] =
                sum * (K(1.0) / (real)(m * k)) * work[(size_t)m * stride + e];
        }
}
