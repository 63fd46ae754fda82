/* SPDX-License-Identifier: Apache-2.0 */
#include "reference.h"

#include "gauss.h"

typedef quad density(const struct reference *r, quad tau);

static quad panel(const struct reference *r, density *f, quad from, quad to)
{
    quad sum = 0;
    int i;

    for (i = 0; i < GAUSS_NODES; i++)
        sum += gauss_weight(i) * f(r, from + (to - from) * gauss_node(i));
    return (to - from) * sum;
}

/* Panel j covers the distances 4^-j to 4^-(j+1) of the whole from the far end. All densities
   below are smooth on that scale: their poles lie no nearer than the far end does, so that 24
   nodes leave an error of about 3.6^-48. The densities fall towards that end, so that what lies
   beyond a negligible panel is negligible too. */
static quad panel_start(const struct reference_integral *integral, int j)
{
    quad share = 1;

    while (j-- > 0)
        share /= 4;
    return integral->end - integral->end * share;
}

static void integrate(const struct reference *r, density *f, quad end,
                      struct reference_integral *integral)
{
    const double enough = 1e-26;
    quad more = 1;
    int j;

    integral->end = end;
    integral->below[0] = 0;
    for (j = 0; j < REFERENCE_PANELS && more > enough * integral->below[j]; j++) {
        more = panel(r, f, panel_start(integral, j), panel_start(integral, j + 1));
        integral->below[j + 1] = integral->below[j] + more;
        integral->panels = j + 1;
    }
}

static quad integral_to(const struct reference *r, density *f,
                        const struct reference_integral *integral, quad x)
{
    int j = 0;

    while (j < integral->panels && panel_start(integral, j + 1) <= x)
        j++;
    if (j == integral->panels)
        return integral->below[j];
    return integral->below[j] + panel(r, f, panel_start(integral, j), x);
}

/* tau = tan(theta / 2) makes sines and cosines rational. */
static quad half_tangent(quad sine, quad cosine)
{
    return sine / (quad_sqrt(sine * sine + cosine * cosine) + cosine);
}

/* Height of the edge of the cap above the horizon, for b < 0, where it is in front. */
static quad edge_height(const struct reference *r, quad one_minus_cos_theta)
{
    quad z = r->rise - r->cb * r->sa * one_minus_cos_theta;
    return z > 0 ? z : 0;
}

static quad chord_length(const struct reference *r, quad cos_theta, quad one_minus_cos_theta)
{
    quad x_max = quad_sqrt(quad_square(r->ca) + quad_square(r->sa * cos_theta));
    quad x_e = r->ca * r->cb, a_x = r->sa * r->sb;

    if (r->visible == REFERENCE_LUNE)
        return quad_square(edge_height(r, one_minus_cos_theta)) / (x_max + x_e - a_x * cos_theta);
    return (quad_square(r->sa * cos_theta) + quad_square(r->ca * r->sb)) / (x_max + x_e) +
           a_x * cos_theta;
}

/* Equation 12: chords up to the tip, by tau of y = sa sin theta. */
static quad chord_density(const struct reference *r, quad tau)
{
    quad w = 1 + tau * tau, c = (1 - tau * tau) / w;
    return chord_length(r, c, 2 * tau * tau / w) * r->sa * c * 2 / w;
}

/* Beyond the tip the chords are those of the ellipse: 2 a_x cos theta long. */
static quad ellipse_chords(const struct reference *r, quad theta)
{
    quad x = 2 * theta;
    return r->sa * r->sa * r->sb * (x + quad_sin(x)) / 2;
}

/* On the ray through the point (cos psi, sin psi) of the horizon, seen from the centre of the
   ellipse: its squared length, and the part of that which lies in the region. */
static quad ray(const struct reference *r, quad x, quad y, quad *inside)
{
    quad r_max2 = x * x + y * y, x_e = r->ca * r->cb;

    *inside = r_max2;
    if (r->visible == REFERENCE_LUNE) {
        quad ellipse = quad_sqrt(x * x + quad_square(r->sb * y));
        quad cos_theta = x / ellipse, sin_theta = -r->sb * y / ellipse;
        quad z_e = edge_height(r, sin_theta * sin_theta / (1 + cos_theta));
        quad r_max = quad_sqrt(r_max2), r_min = r->sa * -r->sb * r_max / ellipse;
        *inside = z_e * z_e * (r_max + r_min) / (r_max + r_min + 2 * x_e * x / r_max);
    }
    return r_max2;
}

/* The centre of the ellipse lies this far inside the horizon. */
static quad centre_depth(const struct reference *r)
{
    return (quad_square(r->sa) + quad_square(r->ca * r->sb)) / (1 + r->ca * r->cb);
}

/* Equation 20 with (r_max dphi) = (1 - x_e cos psi) / r_max dpsi, by tau of psi. */
static quad sector_density(const struct reference *r, quad tau)
{
    quad w = 1 + tau * tau, versine = 2 * tau * tau / w, depth = centre_depth(r), inside;
    quad r_max2 = ray(r, depth - versine, 2 * tau / w, &inside);
    quad turn = depth + r->ca * r->cb * versine;
    return turn / 2 * (inside / r_max2) * 2 / w;
}

/* Sector of the ellipse from theta to pi: the affine image of one of a circle. */
static quad ellipse_sector(const struct reference *r, quad theta)
{
    return r->sa * r->sa * r->sb * (quad_pi() - theta) / 2;
}

static void complete(struct reference *r, quad q2)
{
    quad b = quad_abs(r->sb), q = quad_sqrt(q2 > 0 ? q2 : 0);

    r->height = r->sa * r->sa / (1 + r->ca);
    r->rise = q2 / (r->sa * r->cb + r->ca * b);
    r->theta_tip = quad_atan2(q, r->ca * b);
    r->visible = q2 <= 0   ? r->sb > 0 ? REFERENCE_ELLIPSE : REFERENCE_EMPTY
                 : r->sb < 0 ? REFERENCE_LUNE
                             : REFERENCE_BOTH;
    r->half = 0;
    if (r->visible == REFERENCE_ELLIPSE)
        r->half = ellipse_sector(r, 0);
    if (r->visible == REFERENCE_LUNE || r->visible == REFERENCE_BOTH) {
        /* the tip at (ca, q) / cb; as seen from the origin, and on the ellipse */
        integrate(r, sector_density, half_tangent(q, r->ca), &r->sectors);
        integrate(r, chord_density, half_tangent(q, r->ca * b), &r->chords);
        r->half = r->chords.below[r->chords.panels];
        if (r->visible == REFERENCE_BOTH)
            r->half += ellipse_chords(r, quad_pi() / 2) - ellipse_chords(r, r->theta_tip);
    }
}

void reference_from_angles(struct reference *r, double alpha, double beta)
{
    quad a = alpha, b = beta < 0 ? -beta : beta;
    quad straight = quad_acos(0) - a; /* also for the double nearest to a right angle */

    r->sa = quad_cos(straight);
    r->ca = quad_sin(straight);
    r->cb = quad_sin(quad_acos(0) - b);
    r->sb = beta < 0 ? -quad_sin(b) : quad_sin(b);
    if (alpha < 0.5)
        r->sa = quad_sin(a);
    complete(r, quad_sin(a - b) * quad_sin(a + b));
}

void reference_from_sphere(struct reference *r, quad w, quad h, quad rho)
{
    quad d2 = w * w + h * h, d = quad_sqrt(d2);

    r->sa = rho / d;
    r->ca = quad_sqrt(d2 - rho * rho) / d;
    r->sb = h / d;
    r->cb = w / d;
    complete(r, (rho - quad_abs(h)) * (rho + quad_abs(h)) / d2);
}

quad reference_total(const struct reference *r)
{
    return 2 * r->half;
}

static quad signed_t(quad share, quad y)
{
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return y < 0 ? (1 - share) / 2 : (1 + share) / 2;
}

void reference_radial(const struct reference *r, quad dx, quad y, quad st[2])
{
    quad x = dx + r->cb * r->height, a_x = r->sa * r->sb, side = quad_abs(y), share;
    quad length2 = x * x + y * y, length = quad_sqrt(length2), depth = centre_depth(r);
    quad tip_x = r->ca * r->sb * r->sb, tip_y = r->sa * quad_sin(r->theta_tip) * r->cb;

    if (r->visible == REFERENCE_ELLIPSE ||
        (r->visible == REFERENCE_BOTH && x * tip_y < side * tip_x)) {
        share = 1 - ellipse_sector(r, quad_atan2(side / r->sa, x / a_x)) / r->half;
        st[0] = quad_square(x / a_x) + quad_square(y / r->sa);
    } else {
        quad x_e = r->ca * r->cb, c = length > 0 ? x / length : 1;
        quad s = length > 0 ? side / length : 0, inside;
        quad within = depth * (1 + x_e);
        quad r_max = within / (quad_sqrt(c * c + s * s * within) + x_e * c);
        quad tau = half_tangent(r_max * s, x_e + r_max * c);
        quad r_max2 = ray(r, r_max * c, r_max * s, &inside);
        share = integral_to(r, sector_density, &r->sectors, tau) / r->half;
        st[0] = 1 - (r_max2 - length2) / inside;
    }
    st[1] = signed_t(share, y);
}

void reference_parallel(const struct reference *r, quad dx, quad y, quad st[2])
{
    quad x = dx + r->cb * r->height, a_x = r->sa * r->sb;
    quad sine = quad_abs(y) / r->sa, cosine, theta, area, x_min, chord;

    sine = sine > 1 ? 1 : sine;
    cosine = quad_sqrt((1 - sine) * (1 + sine));
    theta = quad_atan2(sine, cosine);
    x_min = -a_x * cosine;
    if (r->visible == REFERENCE_ELLIPSE) {
        area = ellipse_chords(r, theta);
        chord = 2 * a_x * cosine;
    } else if (r->visible == REFERENCE_BOTH && theta > r->theta_tip) {
        area = r->half - ellipse_chords(r, quad_pi() / 2) + ellipse_chords(r, theta);
        chord = 2 * a_x * cosine;
    } else {
        area = integral_to(r, chord_density, &r->chords, half_tangent(sine, cosine));
        chord = chord_length(r, cosine, sine * sine / (1 + cosine));
    }
    st[0] = (x - x_min) / chord;
    st[1] = signed_t(area / r->half, y);
}

/* ---- Samples */

typedef quad area_function(const struct reference *r, quad x);

static quad chords_to(const struct reference *r, quad tau)
{
    return integral_to(r, chord_density, &r->chords, tau);
}

static quad sectors_to(const struct reference *r, quad tau)
{
    return integral_to(r, sector_density, &r->sectors, tau);
}

/* Where a growing function with a known slope reaches an area: Newton's steps, and halving where
   they leave the interval or do not shrink it. */
static quad solve(const struct reference *r, area_function *area, density *slope, quad low,
                  quad high, quad target)
{
    quad x = (low + high) / 2, before = high - low;
    int i;

    for (i = 0; i < 300 && high > low; i++) {
        quad off = area(r, x) - target, step;

        if (off > 0)
            high = x;
        else
            low = x;
        step = off / slope(r, x);
        if (!(x - step > low && x - step < high && quad_abs(step) < before / 2))
            step = x - (low + high) / 2;
        before = quad_abs(step);
        if (x - step == x)
            break;
        x -= step;
    }
    return x;
}

/* The direction whose projection is (x, y), relative to the ellipse's centre. Its height is known
   from where the horizon is, or a negative number; then it follows from the unit length. */
static void lift(const struct reference *r, quad x, quad y, quad height2, quad offset[3])
{
    quad x_e = r->ca * r->cb, z2 = centre_depth(r) * (1 + x_e) - 2 * x_e * x - x * x - y * y;

    if (height2 >= 0)
        z2 = height2;
    offset[0] = x - r->cb * r->height;
    offset[1] = y;
    offset[2] = quad_sqrt(z2 > 0 ? z2 : 0) - r->sb;
}

static quad ellipse_chords_slope(const struct reference *r, quad theta)
{
    quad c = quad_cos(theta);
    return 2 * r->sa * r->sa * r->sb * c * c;
}

/* The part of the half that lies between the middle and t. */
static quad area_before(const struct reference *r, quad t)
{
    return r->half * quad_abs(2 * t - 1);
}

/* Whether an area that lies before t is bounded by the horizon. */
static int before_tip(const struct reference *r, const struct reference_integral *integral,
                      quad target)
{
    return r->visible == REFERENCE_LUNE ||
           (r->visible == REFERENCE_BOTH && target <= integral->below[integral->panels]);
}

void reference_parallel_sample(const struct reference *r, quad s, quad t, quad offset[3])
{
    quad target = area_before(r, t), x_e = r->ca * r->cb, sine, cosine, x, chord, height2 = -1;
    /* The last chord is the ellipse's end, be the area beyond the tip less than quadrature sees. */
    int last = (t == 0 || t == 1) && r->visible == REFERENCE_BOTH;

    if (!last && before_tip(r, &r->chords, target)) {
        quad tau = solve(r, chords_to, chord_density, 0, r->chords.end, target);
        quad w = 1 + tau * tau;
        sine = 2 * tau / w;
        cosine = (1 - tau * tau) / w;
        chord = chord_length(r, cosine, 2 * tau * tau / w);
        x = s * chord - r->sa * r->sb * cosine;
        height2 = (1 - s) * chord * (2 * (x_e + x) + (1 - s) * chord);
    } else {
        quad first = r->visible == REFERENCE_ELLIPSE ? 0 : r->theta_tip;
        quad skipped = r->visible == REFERENCE_ELLIPSE ? 0 : r->chords.below[r->chords.panels];
        quad theta = last ? quad_acos(0)
                          : solve(r, ellipse_chords, ellipse_chords_slope, first, quad_acos(0),
                                  target - skipped + ellipse_chords(r, first));
        sine = quad_sin(theta);
        cosine = quad_cos(theta);
        chord = 2 * r->sa * r->sb * cosine;
        x = s * chord - r->sa * r->sb * cosine;
    }
    lift(r, x, t < 1 / (quad)2 ? -r->sa * sine : r->sa * sine, height2, offset);
}

void reference_radial_sample(const struct reference *r, quad s, quad t, quad offset[3])
{
    quad target = area_before(r, t), x_e = r->ca * r->cb, x, y, height2 = -1;

    if (before_tip(r, &r->sectors, target)) {
        quad tau = solve(r, sectors_to, sector_density, 0, r->sectors.end, target);
        quad w = 1 + tau * tau, inside, r_max2, scale;

        x = centre_depth(r) - 2 * tau * tau / w;
        y = 2 * tau / w;
        r_max2 = ray(r, x, y, &inside);
        scale = quad_sqrt(1 - (1 - s) * inside / r_max2);
        height2 = (1 - s) * inside * (1 + 2 * x_e * x / (r_max2 * (1 + scale)));
        x *= scale;
        y *= scale;
    } else {
        quad theta = quad_pi() - 2 * (r->half - target) / (r->sa * r->sa * r->sb);
        x = quad_sqrt(s) * r->sa * r->sb * quad_cos(theta);
        y = quad_sqrt(s) * r->sa * quad_sin(theta);
    }
    lift(r, x, t < 1 / (quad)2 ? -y : y, height2, offset);
}

/* ---- Disks and cones */

void reference_disk(double u, double v, quad pq[2])
{
    quad a = 2 * (quad)u - 1, b = 2 * (quad)v - 1, radius, angle;

    if (quad_abs(a) > quad_abs(b)) {
        radius = a;
        angle = quad_pi() / 4 * (b / a);
    } else {
        radius = b;
        angle = b == 0 ? 0 : quad_pi() / 2 - quad_pi() / 4 * (a / b);
    }
    pq[0] = radius * quad_cos(angle);
    pq[1] = radius * quad_sin(angle);
}

void reference_concentric(double u, double v, quad st[2])
{
    quad pq[2], chord, h;

    reference_disk(u, v, pq);
    chord = quad_sqrt((1 - pq[1]) * (1 + pq[1]));
    h = quad_atan2(chord, quad_abs(pq[1]));
    st[0] = chord > 0 ? (1 + pq[0] / chord) / 2 : 1 / (quad)2;
    st[1] = signed_t(1 - (h - quad_sin(2 * h) / 2) * 2 / quad_pi(), pq[1]);
}

void reference_cone(const struct reference *r, quad dx, quad y, quad dz, quad st[2])
{
    /* the azimuth is taken about the axis, from the direction (sin b, 0, -cos b) */
    quad up = r->sb * dx - r->cb * dz;
    quad h = (dx * dx + y * y + dz * dz) / 2;

    st[0] = h / r->height;
    st[1] = (1 + quad_atan2(y, up) / quad_pi()) / 2;
}
