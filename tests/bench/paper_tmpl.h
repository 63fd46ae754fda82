/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The maps of [UG18] as that paper gives them: closed forms for the area cut off by a chord or a
 * radius, inverted by Newton's method with a binary split where it leaves the interval. Numbers
 * in parentheses are the paper's equations, with two corrections: the lune case of (23) takes
 * |A_rE|, since (24) is even in a_x, and (24) is continued beyond a right angle. What depends on
 * the cap alone is computed when built, a lune's interval ends at phi_l instead of pi, and areas
 * in (15) and (23) that cancel are left out. Template: see real.h.
 */
struct FN(paper) {
    real x[3], y[3], z[3]; /* (6) */
    real ax, ay, xe, yl, phi_l, cos2_b;
    int ellipse, lune; /* the cases of section 3.2 */
    real beyond;       /* what the lune adds to the area of the ellipse */
    real half;         /* A_p(a_y) or A_r(pi) */
};

/* (17) */
static inline real FN(segment)(real u, real w)
{
    return R(0.5) * (w * u * sqrt(MAX(R(0), R(1) - u * u)) + asin(MIN(u, R(1))));
}

/* ---- The parallel map, section 4.1 ---- */

static inline real FN(x_min)(const struct FN(paper) *p, real y)
{
    const real c = y / p->ay;

    return p->xe - p->ax * sqrt(MAX(R(0), R(1) - c * c)); /* (13) */
}

static inline real FN(x_max)(const struct FN(paper) *p, real y)
{
    const real c = y / p->ay;

    return p->ellipse || p->yl < y ? p->xe + p->ax * sqrt(MAX(R(0), R(1) - c * c))
                                   : sqrt(R(1) - y * y); /* (14) */
}

static inline real FN(ellipse_slice)(const struct FN(paper) *p, real y)
{
    return p->ax * p->ay * FN(segment)(y / p->ay, R(1)); /* (16) */
}

static inline real FN(circle_slice)(const struct FN(paper) *p, real y)
{
    return FN(segment)(y, R(1)) - p->xe * y; /* (16) */
}

/* (15) */
static inline real FN(parallel_area)(const struct FN(paper) *p, real y)
{
    return p->ellipse || p->yl < y ? R(2) * FN(ellipse_slice)(p, y) + p->beyond
                                   : FN(ellipse_slice)(p, y) + FN(circle_slice)(p, y);
}

static inline real FN(parallel_slope)(const struct FN(paper) *p, real y)
{
    return FN(x_max)(p, y) - FN(x_min)(p, y); /* the integrand of (12) */
}

/* ---- The radial map, section 4.2 ---- */

static inline real FN(ellipse_radius2)(const struct FN(paper) *p, real sine)
{
    return p->ax * p->ax / (R(1) - p->cos2_b * sine * sine);
}

static inline real FN(r_min2)(const struct FN(paper) *p, real phi)
{
    return p->lune ? FN(ellipse_radius2)(p, sin(phi)) : R(0); /* (21) */
}

static inline real FN(r_max2)(const struct FN(paper) *p, real phi)
{
    const real sine = sin(phi);
    real r;

    if (p->ellipse || p->phi_l <= phi)
        return FN(ellipse_radius2)(p, sine);
    r = sqrt(R(1) - p->xe * p->xe * sine * sine) - p->xe * cos(phi);
    return r * r; /* (22) */
}

/* (24); the sine of a rounded pi may be negative */
static inline real FN(ellipse_sector)(const struct FN(paper) *p, real phi)
{
    const real ax = fabs(p->ax);

    return R(0.5) * ax * p->ay * atan2(ax * MAX(sin(phi), R(0)), p->ay * cos(phi));
}

/* (25) */
static inline real FN(circle_sector)(const struct FN(paper) *p, real phi)
{
    const real sine = sin(phi);

    return FN(segment)(sine, p->xe * p->xe) - FN(segment)(p->xe * sine, R(1));
}

/* (23) */
static inline real FN(radial_area)(const struct FN(paper) *p, real phi)
{
    if (p->ellipse || p->phi_l < phi)
        return FN(ellipse_sector)(p, phi) + p->beyond;
    return p->lune ? FN(circle_sector)(p, phi) - FN(ellipse_sector)(p, phi)
                   : FN(circle_sector)(p, phi);
}

static inline real FN(radial_slope)(const struct FN(paper) *p, real phi)
{
    return R(0.5) * (FN(r_max2)(p, phi) - FN(r_min2)(p, phi)); /* the integrand of (20) */
}

/* ---- Inversion, section 4.3 ---- */

/* Stops where the CDF in t = (1 + u) / 2 is within 1e-6; a float may never get there. */
#define CDF_TOLERANCE 1e-6
#define MAX_STEPS 20

static inline real FN(newton_binary)(const struct FN(paper) *p, real u, real top,
                                     real (*area)(const struct FN(paper) *, real),
                                     real (*slope)(const struct FN(paper) *, real))
{
    const real target = u * p->half, tolerance = R(2 * CDF_TOLERANCE) * p->half;
    real low = R(0), high = top, x = u * top;
    int i;

    for (i = 0; i < MAX_STEPS; i++) {
        const real error = area(p, x) - target;
        real next;

        if (fabs(error) <= tolerance)
            break;
        if (error > R(0))
            high = x;
        else
            low = x;
        next = x - error / slope(p, x);
        x = next > low && next < high ? next : R(0.5) * (low + high);
    }
    return x;
}

/* ---- What a renderer calls ---- */

/* 0 if nothing is above the horizon. The normal is a unit vector. */
static inline int FN(paper_build)(struct FN(paper) *p, const real position[3],
                                  const real normal[3], const real *light) /* center, radius */
{
    const real *const center = light, radius = light[3];
    const real w[3] = {center[0] - position[0], center[1] - position[1],
                       center[2] - position[2]};
    const real inverse = R(1) / sqrt(FN(dot)(w, w));
    const real sin_a = radius * inverse, sin_b = FN(dot)(normal, w) * inverse; /* (8) */
    const real cos2_a = MAX(R(0), R(1) - sin_a * sin_a), length2_floor = R(1e-30);
    real length2;
    int i;

    if (sin_a <= -sin_b)
        return 0;
    FN(cross)(normal, w, p->y);
    length2 = FN(dot)(p->y, p->y);
    if (length2 > length2_floor) {
        for (i = 0; i < 3; i++)
            p->y[i] *= R(1) / sqrt(length2);
        FN(cross)(p->y, normal, p->x);
    } else {
        FN(frame)(normal, p->x, p->y);
    }
    p->cos2_b = R(1) - sin_b * sin_b;
    p->ay = sin_a;
    p->ax = sin_a * sin_b;
    p->xe = sqrt(cos2_a * p->cos2_b); /* (9) */
    p->ellipse = sin_a <= sin_b;
    p->lune = sin_b < R(0);
    p->yl = p->phi_l = p->beyond = R(0);
    if (!p->ellipse) {
        const real xl2 = cos2_a / p->cos2_b;

        p->yl = sqrt(MAX(R(0), R(1) - xl2)); /* (11) */
        p->phi_l = atan2(p->yl, sqrt(xl2) - p->xe);
    }
    for (i = 0; i < 3; i++)
        p->z[i] = normal[i];
    return 1;
}

static inline int FN(radial_build)(struct FN(paper) *p, const real position[3],
                                   const real normal[3], const real *light)
{
    if (!FN(paper_build)(p, position, normal, light))
        return 0;
    if (!p->ellipse)
        p->beyond = FN(circle_sector)(p, p->phi_l) - FN(ellipse_sector)(p, p->phi_l);
    p->half = FN(radial_area)(p, p->lune ? p->phi_l : R(PI));
    return p->half > R(0);
}

static inline int FN(parallel_build)(struct FN(paper) *p, const real position[3],
                                     const real normal[3], const real *light)
{
    if (!FN(paper_build)(p, position, normal, light))
        return 0;
    if (!p->ellipse)
        p->beyond = FN(circle_slice)(p, p->yl) - FN(ellipse_slice)(p, p->yl);
    p->half = FN(parallel_area)(p, p->lune ? p->yl : p->ay);
    return p->half > R(0);
}

/* (7), and the density cosine / A */
static inline void FN(paper_finish)(const struct FN(paper) *p, real x, real y, real direction[3],
                                    real *pdf)
{
    const real z = sqrt(MAX(R(0), R(1) - x * x - y * y));

    FN(to_world)(p->x, p->y, p->z, x, y, z, direction);
    *pdf = z / (R(2) * p->half);
}

/* Listing 1 */
static inline void FN(radial_sample)(const struct FN(paper) *p, real s, real t, real direction[3],
                                     real *pdf)
{
    const real u = t < R(0.5) ? R(1) - R(2) * t : R(2) * t - R(1);
    const real phi = p->ellipse ? R(PI) * u
                                : FN(newton_binary)(p, u, p->lune ? p->phi_l : R(PI),
                                                    FN(radial_area), FN(radial_slope));
    const real low = p->ellipse ? R(0) : FN(r_min2)(p, phi);
    const real high = p->ellipse ? R(1) : FN(r_max2)(p, phi);
    const real sine = t < R(0.5) ? -sin(phi) : sin(phi);
    const real cosine = sqrt(R(1) - sine * sine) * (phi <= R(0.5 * PI) ? R(1) : R(-1));
    const real radius = sqrt(s * high + (R(1) - s) * low);

    FN(paper_finish)(p, p->xe + (p->ellipse ? p->ax : R(1)) * radius * cosine,
                     (p->ellipse ? p->ay : R(1)) * radius * sine, direction, pdf);
}

/* (18), (19) */
static inline void FN(parallel_sample)(const struct FN(paper) *p, real s, real t,
                                       real direction[3], real *pdf)
{
    const real u = t < R(0.5) ? R(1) - R(2) * t : R(2) * t - R(1);
    const real y = FN(newton_binary)(p, u, p->lune ? p->yl : p->ay, FN(parallel_area),
                                     FN(parallel_slope));
    const real low = FN(x_min)(p, y), high = FN(x_max)(p, y);

    FN(paper_finish)(p, low + s * (high - low), t < R(0.5) ? -y : y, direction, pdf);
}
