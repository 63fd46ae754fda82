/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The parallel map of a cap that the horizon cuts (section 4.1 of [UG18]): chords parallel to
 * the x axis from the outline of the cap to the horizon circle, at heights up to y_l = sin psi_l,
 * and, if the centre is above the horizon, whole chords of the ellipse beyond. Template: see
 * precision.h.
 *
 * At the height y = sin alpha sin theta = sin psi the chord is cos psi - x_e + a_x cos theta
 * long, with a_x = sin alpha sin beta negative for a lune. The area between -y and y is
 *     F(theta) = psi + sin psi cos psi - 2 x_e y + a_x (theta + sin theta cos theta) sin alpha,
 * and with N of segment.h and b = |sin beta| / sin alpha it becomes a sum without cancellation,
 * of terms of the size of 1 in these units, for caps of any size and lunes of any thickness:
 *     F(theta) = 2 sin^3 alpha sigma^5 c^2 Phi(theta),    chord = sin^2 alpha sigma^4 c^2 g,
 *     Phi = sn (g + sn^2 bracket / 3) [+ b/2 (theta - sin theta cos theta)],
 * where sigma = c = 1, bracket = N(psi), and the last term stands, if the centre is above, and
 * where for a lune sigma = sin theta_l, c = cos beta, and
 *     bracket = N(psi) / (1 + b) - b (N(theta) - N(psi)) / (sigma^2 c^2);
 * sn = sin theta / sigma. The derivatives of g in theta / sigma are -sn q and
 * sn^2 (cos alpha / c)^2 / cos^3 psi - cos theta q.
 *
 * The unknown is the distance x from the end of theta, pi/2 or theta_l.
 */

/* A chord: its height y, its length in the units above, and what the derivatives need. */
struct FN(chord) {
    real sine, cosine; /* of theta; sine in units of sigma */
    real cos_psi, per_cos;
    real length, slope; /* g and q */
};

/* The chord at theta. lune: excess = (cos^2 theta - cos^2 theta_l) / sigma^2, the squared distance
   from the tip. */
PSC_LANE struct FN(chord) FN(chord_at)(const struct FN(psc_lobe) *l, int lune, real sine,
                                       real cosine, real excess)
{
    const real sc = l->sin_a * cosine;
    struct FN(chord) c;
    real beyond, inverse;

    c.sine = sine;
    c.cosine = cosine;
    c.cos_psi = SQRT(l->cos_a * l->cos_a + sc * sc);
    beyond = c.cos_psi + l->cos_a;
    if (lune) {
        /* The chord is v^2 / (cos psi - x_e - a_x cos theta), v = cos beta cos psi - cos alpha. */
        const real whole = cosine * cosine + beyond * (l->base + l->slant * cosine);
        const real meet = c.cos_psi + l->tip_cos_psi, both = cosine + l->slant * c.cos_psi;
        real depth;

        inverse = K(1.0) / (c.cos_psi * both * meet);
        depth = excess * (c.cos_psi * both * inverse);
        c.per_cos = both * meet * inverse;
        c.length = depth * depth * (beyond / whole);
        c.slope = excess * (meet * inverse);
    } else {
        inverse = K(1.0) / (c.cos_psi * beyond);
        c.per_cos = beyond * inverse;
        c.length = cosine * cosine * (c.cos_psi * inverse) + (l->base + l->slant * cosine);
        c.slope = cosine * c.per_cos + l->slant;
    }
    return c;
}

/* The w of psi and of theta, and what the second has more, divided by (sigma cos beta)^2. */
PSC_LANE void FN(lune_arguments)(real tip_y, real tip_sine, real tip_cos_psi, real sn2,
                                 real cos_psi, real cosine, real *w_psi, real *w_theta,
                                 real *rise)
{
    const real y2 = tip_y * tip_y * sn2, s2 = tip_sine * tip_sine * sn2;
    const real m = K(1.0) + cos_psi, o = K(1.0) + cosine, meet = cos_psi + cosine;
    const real d_psi = m * m + PSC_KAPPA * y2, d_theta = o * o + PSC_KAPPA * s2;
    const real inverse = K(1.0) / (d_psi * d_theta * meet);

    *w_psi = y2 * (d_theta * meet * inverse);
    *w_theta = s2 * (d_psi * meet * inverse);
    *rise = K(2.0) * (tip_cos_psi * tip_cos_psi) * sn2 * (m * o * inverse);
}

/* Phi but for the term in theta. */
PSC_LANE real FN(chord_area)(const struct FN(psc_lobe) *l, int lune, const struct FN(chord) *c)
{
    const real sn2 = c->sine * c->sine;
    real bracket;

    if (lune) {
        real w_psi, w_theta, rise, n, dn;

        FN(lune_arguments)(l->tip_y, l->tip_sine, l->tip_cos_psi, sn2, c->cos_psi, c->cosine,
                           &w_psi, &w_theta, &rise);
        n = FN(segment_difference)(w_psi, w_theta, 1, &dn);
        bracket = (l->thickness - K(1.2) * l->slant * rise) +
                  (l->thickness * n - l->slant * (dn * rise));
    } else {
        const real y2 = l->tip_y * l->tip_y * sn2, m = K(1.0) + c->cos_psi;

        bracket = FN(segment)(y2 / (m * m + PSC_KAPPA * y2));
    }
    return c->sine * (c->length + K(0.333333333333333333) * sn2 * bracket);
}

#if PSC_BITS == 32
/* Phi of a lune, less what it should be. Next to the tips the bracket is a third of its first
   terms, which takes more than float has; the rest of it is small there. */
PSC_LANE float lune_residual(const struct psc_lobe_f32 *l, const struct chord_f32 *c, float r)
{
    const double sn = (double)c->sine, sn2 = sn * sn, cosine = (double)c->cosine;
    const double cos_a = (double)l->cos_a, sc = (double)l->sin_a * cosine;
    const double thickness = (double)l->thickness, slant = (double)l->slant;
    double w_psi, w_theta, rise, bracket;
    float n, dn;

    lune_arguments_f64((double)l->tip_y, (double)l->tip_sine, (double)l->tip_cos_psi, sn2,
                       __builtin_sqrt(cos_a * cos_a + sc * sc), cosine, &w_psi, &w_theta, &rise);
    n = segment_difference_f32((float)w_psi, (float)w_theta, 1, &dn);
    bracket = (thickness - 1.2 * slant * rise) +
              (thickness * (double)n - slant * ((double)dn * rise));
    return (float)(sn * ((double)c->length + (1.0 / 3.0) * sn2 * bracket) -
                   (double)(1.0f - r) * (double)l->area);
}
#endif

/* Where the solver is: the distance x from the end of theta, its sine and cosine. */
struct FN(place) {
    real x, sine, cosine, sine_defect, versine;
};

PSC_LANE struct FN(place) FN(place_at)(real x)
{
    struct FN(place) at;

    FN(sine_cosine_defects)(x, &at.sine_defect, &at.versine);
    at.x = x;
    at.sine = x - at.sine_defect;
    at.cosine = K(1.0) - at.versine;
    return at;
}

PSC_LANE struct FN(chord) FN(chord_there)(const struct FN(psc_lobe) *l, int lune,
                                          const struct FN(place) *at)
{
    if (lune) {
        const real near = at->sine * l->per_tip_sine;
        const real sine = K(1.0) - (at->versine + l->tip_cosine * near);
        const real cosine = l->tip_cosine * at->cosine + l->tip_sine * at->sine;

        return FN(chord_at)(l, 1, sine, cosine, near * (cosine + l->tip_cosine * sine));
    }
    return FN(chord_at)(l, 0, at->cosine, at->sine, K(0.0));
}

/*
 * The step in theta / sigma that a rational formula of third order takes from a chord towards the
 * share 1 - r of the total; whole: of the ellipse's chords, where the chord becomes that of the
 * ellipse.
 */
PSC_LANE real FN(chord_step)(const struct FN(psc_lobe) *l, int lune, int whole, real r,
                             const struct FN(place) *at, struct FN(chord) *c, real *bend)
{
    const real sigma2 = lune ? l->tip_sine * l->tip_sine : K(1.0);
    const real k = l->tip_cos_psi * l->tip_cos_psi * (c->per_cos * c->per_cos * c->per_cos);
    const real sn2 = c->sine * c->sine;
    real f, d, d1, d2;

#if PSC_BITS == 32
    if (lune)
        f = lune_residual(l, c, r);
    else
#endif
        f = FN(chord_area)(l, lune, c) - (K(1.0) - r) * l->area;
    *bend = sn2 * k - c->cosine * c->slope;
    if (!lune) {
        /* x - sin x cos x, twice the area beyond a whole chord */
        const real cap = at->sine_defect + at->sine * at->versine;

        f += l->half_slant * ((K(1.57079632679489661923) - K(2.0) * at->x) + cap);
        f = whole ? r * l->area - l->slant * cap : f;
        c->length = whole ? K(2.0) * l->slant * c->cosine : c->length;
        c->slope = whole ? K(2.0) * l->slant : c->slope;
        *bend = whole ? -c->length : *bend;
    }
    d = c->cosine * c->length;
    d1 = -c->sine * (c->cosine * c->slope + sigma2 * c->length);
    d2 = c->cosine * (*bend - sigma2 * c->length) + K(2.0) * sigma2 * sn2 * c->slope;
    return -f * (K(6.0) * d * d - K(3.0) * f * d1) /
           (K(6.0) * d * (d * d - f * d1) + f * f * d2);
}

/*
 * The chord with the share r of the area beyond it. The remaining area goes like x^4 or x^3 at the
 * end, which the start puts into one power (within 20 %, mostly a few); two steps follow. The last
 * one is so small that the chord follows it by its slope and curvature.
 */
PSC_LANE struct FN(chord) FN(chord_solve)(const struct FN(psc_lobe) *l, int lune, int whole,
                                          real r)
{
    const real scaled = r * l->whole_scale, x0 = l->x_m * SQRT(SQRT(r));
    const real cut = l->n * (l->mu + x0) * r / (l->lam + x0 + SMALLEST);
    const real root = FN(rough_root)(whole ? MIN(scaled, K(1.0)) : cut), root2 = root * root;
    const real ellipse = root * (K(1.33067228) + root2 * (K(0.15687702) + root2 * K(0.0831)));
    const real start = root * (l->p0 + root * (l->p1 + root * l->p2));
    const real sigma = lune ? l->tip_sine : K(1.0);
    struct FN(place) at = FN(place_at)(whole ? ellipse : start);
    struct FN(chord) c = FN(chord_there)(l, lune, &at);
    real h, bend, limit, dx, odd, even, sine, length;

    h = -sigma * FN(chord_step)(l, lune, whole, r, &at, &c, &bend);
    limit = K(0.3) * at.x;
    h = MIN(MAX(h, -limit), limit);
    at = FN(place_at)(at.x + h);
    c = FN(chord_there)(l, lune, &at);
    h = FN(chord_step)(l, lune, whole, r, &at, &c, &bend);
    limit = K(0.03) * at.x * (lune ? l->per_tip_sine : K(1.0));
    h = MIN(MAX(h, -limit), limit);

    length = c.length - h * (c.sine * c.slope - K(0.5) * h * bend);
    dx = -sigma * h;
    odd = dx * (K(1.0) - dx * dx * (K(0.166666666666666667)));
    even = dx * dx * (K(0.5) - dx * dx * K(0.0416666666666666667));
    sine = at.sine + at.cosine * odd - at.sine * even;
    at.cosine = at.cosine - at.sine * odd - at.cosine * even;
    at.sine = sine;
    if (lune) {
        c.sine = at.cosine - l->tip_cosine * (at.sine * l->per_tip_sine);
        c.cosine = l->tip_cosine * at.cosine + l->tip_sine * at.sine;
    } else {
        c.sine = at.cosine;
        c.cosine = at.sine;
    }
    c.length = length;
    return c;
}

/* The point at the share u (rest = 1 - u) of the chord with the share r of the area beyond it. */
PSC_LANE void FN(clipped_point)(const struct FN(psc_lobe) *l, int lune, real u, real rest, real r,
                                real side, struct FN(psc_point) *p)
{
    const int whole = !lune && r < l->whole;
    const struct FN(chord) c = FN(chord_solve)(l, lune, whole, r);
    const real half = l->sin_a * l->sin_b * c.cosine, upright = l->sin_b * c.cosine;
    const real length = whole ? K(2.0) * half : l->chord_unit * c.length;
    const real step = u * length, y = side * (l->tip_y * c.sine);
    const real power = (step * l->per_a) * ((K(2.0) * half - step) * l->per_a);

    if (lune) {
        /* From the end on the horizon, at x = cos psi: z^2 = cos^2 psi - x^2. */
        const real to_end = rest * length, sc = l->sin_a * c.cosine;
        const real cos_psi = SQRT(l->cos_a * l->cos_a + sc * sc);
        const real end = l->del - y * y / (K(1.0) + cos_psi);
        real up;

        FN(lift)(l, 0, end - to_end, y, to_end * (K(2.0) * cos_psi - to_end), p);
        up = l->sin_b * l->per_a * p->height;
        p->power = power;
        p->across = l->sin_a * SQRT(up * up - power);
    } else {
        const real high = l->cos_a * l->sin_b, zl = high + l->zc * c.cosine;
        const real zr = whole ? high - l->zc * c.cosine : K(0.0);

        FN(chord_point)(l, 0, -half, y, length, zl, zr, u, rest, p);
        p->power = whole ? K(4.0) * u * rest * (upright * upright) : power;
        p->across = whole ? -l->sin_b * (rest * zl + u * zr) : l->cos_b * step - l->sin_b * zl;
    }
}

PSC_LANE void FN(parallel_lune)(const struct FN(psc_lobe) *l, real u, real v,
                                struct FN(psc_point) *p)
{
    FN(clipped_point)(l, 1, u, K(1.0) - u, K(2.0) * MIN(v, K(1.0) - v),
                      COPYSIGN(K(1.0), v - K(0.5)), p);
}

PSC_LANE void FN(parallel_both)(const struct FN(psc_lobe) *l, real u, real v,
                                struct FN(psc_point) *p)
{
    FN(clipped_point)(l, 0, u, K(1.0) - u, K(2.0) * MIN(v, K(1.0) - v),
                      COPYSIGN(K(1.0), v - K(0.5)), p);
}

/*
 * Low distortion: the square is laid over the disk [SC97], and a point of the disk is read as
 * the place on a chord: the chord that cuts off the same share of the disk, the same share of
 * the chord.
 */
PSC_LANE void FN(disk_to_chord)(real u, real v, real *share, real *rest, real *r, real *side)
{
    real cosine, sine, versine, radius, margin, p, q, sine_h;
    real outside, square, along, less, more;

    FN(square_to_disk)(u, v, &cosine, &sine, &versine, &radius, &margin);
    p = radius * cosine;
    q = radius * sine;
    outside = margin * (K(1.0) + radius);
    square = outside + p * p;
    sine_h = SQRT(square);
    *r = FN(segment_share)(ABS(q), sine_h, square);
    *r = MIN(*r, K(1.0));
    /* (sine_h +- |p|) / (2 sine_h) without cancellation; the tips of the disk have no chord. */
    along = square > K(0.0) ? ABS(p) / sine_h : K(0.0);
    less = K(0.5) * (square > K(0.0) ? outside / square : K(1.0)) / (K(1.0) + along);
    more = K(0.5) + K(0.5) * along;
    *share = p < K(0.0) ? less : more;
    *rest = p < K(0.0) ? more : less;
    *side = COPYSIGN(K(1.0), q);
}

PSC_LANE void FN(concentric_lune)(const struct FN(psc_lobe) *l, real u, real v,
                                  struct FN(psc_point) *p)
{
    real share, rest, r, side;

    FN(disk_to_chord)(u, v, &share, &rest, &r, &side);
    FN(clipped_point)(l, 1, share, rest, r, side, p);
}

PSC_LANE void FN(concentric_both)(const struct FN(psc_lobe) *l, real u, real v,
                                  struct FN(psc_point) *p)
{
    real share, rest, r, side;

    FN(disk_to_chord)(u, v, &share, &rest, &r, &side);
    FN(clipped_point)(l, 0, share, rest, r, side, p);
}
