/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The integral over s of cones that are not wide, as polynomials: where tan alpha is at most
 * PSC_SERIES_TANGENT and the horizon leaves more than a sliver.
 *
 * The density is sin^2 s (A(C) + cos s B(C)), C = cos 2s, with A and B analytic around [-1, 1],
 * also where the horizon cuts the cone and the density is continued below with its sign: that of
 * the same cone seen from straight below, and what the tilt adds. For polynomials A and B the
 * integral from the top is
 *     mean (s - sin s cos s) + sin^3 s (cos s P(C) + R(C)),
 *     A = 2 mean + (1 + 2 C) P - (1 - C^2) P',   B = 3 R - 2 (1 - C) R',
 * which keeps all its digits where s is small; from the bottom it is the same with B and R
 * negated. Template: see precision.h.
 */

/* A series, alone or as one of many that lie next to each other: stride from one coefficient to the
   next. */
struct FN(series_view) {
    size_t stride;
    const real *mean, *start, *even, *odd, *even_integral, *odd_integral, *even_slope, *odd_slope;
};

PSC_LANE struct FN(series_view) FN(view_of)(const struct FN(psc_fibre_series) *q)
{
    const struct FN(series_view) view = {1, &q->mean, q->start[0], q->even, q->odd,
                                         q->even_integral, q->odd_integral, q->even_slope,
                                         q->odd_slope};

    return view;
}

/* The sum of c[k] x^k for k below n, a multiple of 4, in four chains. */
PSC_LANE real FN(sum_by_fours)(int n, size_t stride, const real *c, real x)
{
    const real x2 = x * x, x4 = x2 * x2;
    real a = c[(size_t)(n - 4) * stride], b = c[(size_t)(n - 3) * stride];
    real d = c[(size_t)(n - 2) * stride], e = c[(size_t)(n - 1) * stride];
    int k;

    PSC_UNROLL
    for (k = n - 8; k >= 0; k -= 4) {
        a = a * x4 + c[(size_t)k * stride];
        b = b * x4 + c[(size_t)(k + 1) * stride];
        d = d * x4 + c[(size_t)(k + 2) * stride];
        e = e * x4 + c[(size_t)(k + 3) * stride];
    }
    return (a + b * x) + x2 * (d + e * x);
}

/* A place, from the top or the bottom: x in [0, pi] with x - sin x cos x. */
struct FN(fibre_arc) {
    real x, sine, cosine, segment;
};

PSC_LANE void FN(arc_of)(real x, struct FN(fibre_arc) *o)
{
    const real pi = K(3.14159265358979323846);
    const int far = x > K(0.5) * pi;
    const real near = far ? pi - x : x;
    real defect, versine, lens;

    FN(sine_cosine_defects)(near, &defect, &versine);
    o->x = x;
    o->sine = near - defect;
    o->cosine = far ? versine - K(1.0) : K(1.0) - versine;
    lens = defect + o->sine * versine;
    o->segment = far ? pi - lens : lens;
}

/* On by a few per mille. */
PSC_LANE void FN(arc_on)(real h, struct FN(fibre_arc) *o)
{
    const real h2 = h * h;
    const real sine =
        h * (K(1.0) - h2 * (K(0.166666666666666667) - h2 * K(0.00833333333333333333)));
    const real versine = h2 * (K(0.5) - h2 * K(0.0416666666666666667));
    const real next = o->sine + (o->cosine * sine - o->sine * versine);

    o->cosine = o->cosine - (o->cosine * versine + o->sine * sine);
    o->sine = next;
}

/* The integral up to a place from the top, or from the bottom (sign -1). */
PSC_LANE real FN(series_integral)(int n, const struct FN(series_view) *q, real sign,
                                  const struct FN(fibre_arc) *at)
{
    const real square = at->sine * at->sine, wave = K(1.0) - K(2.0) * square;

    return *q->mean * at->segment +
           at->sine * square *
               (at->cosine * FN(sum_by_fours)(n, q->stride, q->even_integral, wave) +
                sign * FN(sum_by_fours)(n, q->stride, q->odd_integral, wave));
}

/*
 * The step towards the place with the given integral: the inverse series to the third order, of the
 * fourth but for the second derivatives of A and B. With s and c of the place, y = sign c and
 * Q = A + y B, D = A' + y B' the density is s^2 Q, and Q' = -s (4 c D + sign B).
 */
PSC_LANE real FN(series_step)(int n, const struct FN(series_view) *q, real sign, real limit,
                              real target, const struct FN(fibre_arc) *at)
{
    const real error = FN(series_integral)(n, q, sign, at) - target;
    const real s = at->sine, c = at->cosine, square = s * s, wave = K(1.0) - K(2.0) * square;
    const real odd = sign * FN(sum_by_fours)(n, q->stride, q->odd, wave);
    const real odd_slope = sign * FN(sum_by_fours)(n, q->stride, q->odd_slope, wave);
    const real height = FN(sum_by_fours)(n, q->stride, q->even, wave) + c * odd;
    const real slope = FN(sum_by_fours)(n, q->stride, q->even_slope, wave) + c * odd_slope;
    const real drop = K(4.0) * c * slope + odd;
    const real bend = c * height - K(0.5) * square * drop; /* of the density, over 2 s */
    const real curve = (c * c - square) * height - K(2.5) * square * c * drop +
                       K(2.0) * square * square * (slope + K(2.0) * c * odd_slope);
    const real density = square * height;
    const real inverse = K(1.0) / (density > K(0.0) ? density : SMALLEST);
    const real h = -error * inverse, a2 = s * bend * inverse;
    const real a3 = K(0.333333333333333333) * curve * inverse;
    const real step = h * (K(1.0) + h * (h * (K(2.0) * a2 * a2 - a3) - a2));
    /* no farther than makes sense from either end, where the density is 0 */
    const real least = MAX(K(-0.75) * at->x, at->x - limit);

    return MIN(MAX(step, least), limit - at->x);
}

/* Where to start for the share and the rest of the whole: from the top, or from the bottom of a
   whole cone (the sign is -1). */
PSC_LANE real FN(series_start)(const struct FN(series_view) *q, int clipped, real end,
                               real share, real rest, real *sign, real *target)
{
    /* as comparisons of numbers, which become vector code */
    const int lower = share > K(0.5), cut = share > (clipped ? K(0.5) : K(2.0));
    const int mirrored = share > (clipped ? K(2.0) : K(0.5));
    const real cube = FN(rough_root)(lower ? rest : share);
    const real root = cut ? SQRT(rest) : cube, z = cut ? root : root * root, z2 = z * z;
    real c[PSC_START_TERMS], x;
    int i;

    for (i = 0; i < PSC_START_TERMS; i++)
        c[i] = lower ? q->start[(size_t)(PSC_START_TERMS + i) * q->stride]
                     : q->start[(size_t)i * q->stride];
    x = root * (((c[0] + z * c[1]) + z2 * (c[2] + z * c[3])) +
                z2 * z2 * ((c[4] + z * c[5]) + z2 * (c[6] + z * c[7])));
    *sign = mirrored ? K(-1.0) : K(1.0);
    *target = mirrored ? rest : share;
    return cut ? end - x : x;
}

/* All steps but the last give x, */
PSC_LANE real FN(series_nearer)(int n, const struct FN(series_view) *q, real sign, real end,
                                real target, real x)
{
    struct FN(fibre_arc) at;

    FN(arc_of)(x, &at);
    return x + FN(series_step)(n, q, sign, end, target, &at);
}

/* and that, which is small, the place. */
PSC_LANE void FN(series_place)(int n, const struct FN(series_view) *q,
                               const struct FN(psc_sheaf) *f, real sign, real target, real x,
                               struct FN(psc_fibre_site) *o)
{
    struct FN(fibre_arc) at;

    FN(arc_of)(x, &at);
    FN(arc_on)(FN(series_step)(n, q, sign, f->end, target, &at), &at);
    o->sine = at.sine;
    o->cosine = sign * at.cosine;
    o->rise = MAX(f->sin_m * (o->cosine - f->cos_end), K(0.0));
}

/* The place that has the given share of the whole above it, and the rest below: without bounds, in
   a number of steps that is that of the build. */
PSC_LANE void FN(series_find)(int n, const struct FN(series_view) *q,
                              const struct FN(psc_sheaf) *f, int steps, real share, real rest,
                              struct FN(psc_fibre_site) *o)
{
    real sign, target, x = FN(series_start)(q, f->clipped, f->end, share, rest, &sign, &target);
    int i;

    for (i = 1; i < steps; i++)
        x = FN(series_nearer)(n, q, sign, f->end, target, x);
    FN(series_place)(n, q, f, sign, target, x, o);
}
