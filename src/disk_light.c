/* SPDX-License-Identifier: Apache-2.0 */
#include "disk_light.h"

#include "disk_solve.h"
#include "fibre_solve.h"
#include "segment.h"
#include "square.h"
#include "vector.h"

/* ---- Totals ---- */

psc_result psc_disk_whole_solid_angle(const psc_sampler *s, double *value)
{
    *value = s->disk.inside         ? 4.0 * PSC_PI
             : s->disk.seen.a > 0.0 ? ellipse_total(&s->disk.seen)
                                    : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* Of a sampler by another measure: by a build of what it was built from. */
psc_result psc_disk_projected_solid_angle(const psc_sampler *s, double *value)
{
    const struct psc_disk_light *d = &s->disk;
    psc_sampler_storage storage;
    struct psc_request request;
    psc_sampler *other;
    psc_result result;

    if (s->facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    *value = s->projected && s->sides > 0 ? s->total : 0.0;
    if (s->projected || s->sides == 0)
        return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
    request.measure = PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    request.map = PSC_MAP_PARALLEL;
    request.facing = s->facing;
    request.position = d->given_position;
    request.normal = d->given_normal;
    request.one_sided = 0;
    request.numbers = d->numbers;
    request.table = NULL;
    psc_sampler_init(&storage, sizeof storage, &other);
    result = psc_build_numbers(other, s->shape, &request, d->given);
    *value = other->total;
    return result;
}

psc_result psc_disk_area(const psc_sampler *s, double *value)
{
    if (s->disk.solid)
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    *value = s->disk.area;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_disk_ask_solid_angle(const struct psc_shape_row *shape, const char *kinds,
                                    const double position[3], const double *const parts[],
                                    double *solid_angle)
{
    const psc_technique technique = {.struct_size = sizeof technique, .map = PSC_MAP_PARALLEL};
    const psc_receiver receiver = {sizeof receiver, 0, position, NULL};
    psc_sampler_storage storage;
    psc_sampler *sampler;
    psc_result result;

    if (!solid_angle)
        return PSC_ERROR_NULL_POINTER;
    psc_sampler_init(&storage, sizeof storage, &sampler);
    result = psc_build(sampler, shape, kinds, &technique, &receiver, parts);
    if (result >= 0)
        *solid_angle = sampler->total;
    return result;
}

/* ---- Directions ---- */

/* A direction in the frame of the cone. */
struct seen {
    double x, y, z;
    double u, v;   /* x / tan alpha, y / tan beta */
    double margin; /* z^2 - u^2 - v^2 */
};

/* Whether the direction, rounded by epsilon or a few, is in the cone. */
static int look(const struct psc_ellipse *e, const double direction[3], double epsilon,
                struct seen *d)
{
    const double per_at = e->ca / e->a, per_bt = e->cb / e->b, error = 32.0 * epsilon;
    double gradient;

    d->x = dot(direction, e->x);
    d->y = dot(direction, e->y);
    d->z = dot(direction, e->z);
    d->u = d->x * per_at;
    d->v = d->y * per_bt;
    d->margin = (d->z - ABS(d->u)) * (d->z + ABS(d->u)) - d->v * d->v;
    gradient = SQRT(d->u * per_at * (d->u * per_at) + d->v * per_bt * (d->v * per_bt) +
                    d->z * d->z);
    if (!(d->z > -error) || !(d->margin >= -error * (2.0 * gradient + error * per_bt * per_bt)))
        return 0;
    d->margin = MAX(d->margin, 0.0);
    d->z = MAX(d->z, 0.0);
    return 1;
}

/* The point (q_x, q_y) of the light and what it misses to the outline; returns 1 / D. */
static double light_point(const struct psc_disk_light *l, const struct seen *d, double *qx,
                          double *qy, double *rest)
{
    double inverse;

    boost_f64(l->near, l->far, l->turn[0] * d->u + l->turn[1] * d->v,
              l->turn[0] * d->v - l->turn[1] * d->u, d->z, d->margin, qx, qy, &inverse);
    *rest = MIN(4.0 * d->margin * inverse * inverse, 1.0);
    return inverse;
}

/* The cosine and sine of eta, see ellipse_cdf.h; returns how far out the direction is, (x / a)^2 +
   (y / b)^2. */
static double eccentric(const struct psc_ellipse *e, const struct seen *d, double *c, double *s)
{
    const double p = d->x / e->a, q = d->y / e->b, square = p * p + q * q, r = SQRT(square);

    *c = r > 0.0 ? p / r : 1.0;
    *s = r > 0.0 ? q / r : 0.0;
    return square;
}

/* The height over the horizon that counts of a direction of the light; negative if it is none of
   what is above. */
static double look_above(const psc_sampler *s, const double direction[3], double epsilon,
                         struct seen *d)
{
    const double height = dot(direction, s->disk.receiver);

    if (s->disk.inside)
        d->margin = 1.0;
    else if (!look(&s->disk.seen, direction, epsilon, d))
        return -1.0;
    return s->facing == PSC_FACING_BOTH ? ABS(height) : height;
}

/* By projected solid angle. */
static psc_result invert_fibres(const psc_sampler *s, const double direction[3], double epsilon,
                                double uv[2])
{
    const struct psc_disk_light *l = &s->disk;
    const int side = s->sides == 2 && dot(direction, l->receiver) < 0.0;
    const double sign = l->inside && side == 1 ? -1.0 : 1.0;
    struct psc_fibre_direction_f64 at;
    struct seen d;

    if (look_above(s, direction, epsilon, &d) < -32.0 * epsilon)
        return PSC_OUTSIDE;
    at.x = dot(direction, l->seen.x);
    at.y = dot(direction, l->seen.y);
    at.depth = MAX(sign * dot(direction, l->seen.z), DBL_MIN);
    at.uz = l->inside ? 0.0 : d.u;
    at.vz = l->inside ? 0.0 : d.v;
    at.margin = l->inside ? at.depth * at.depth : d.margin;
    fibre_invert(l, side, &at, uv);
    if (s->sides == 2)
        uv[0] = side == 0 ? uv[0] * s->split : 1.0 - uv[0] * (1.0 - s->split);
    uv[0] = MIN(MAX(uv[0], 0.0), 1.0);
    uv[1] = MIN(MAX(uv[1], 0.0), 1.0);
    return PSC_SUCCESS;
}

double psc_disk_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    const struct psc_disk_light *l = &s->disk;
    double qx, qy, rest, length;
    struct seen d;

    if (s->projected)
        return MAX(look_above(s, direction, epsilon, &d), 0.0) * s->inverse_total;
    if (l->inside)
        return s->inverse_total;
    if (!look(&l->seen, direction, epsilon, &d))
        return 0.0;
    if (l->map == PSC_DISK_QUASI_UNIFORM) {
        const struct psc_ellipse *e = &l->seen;
        double c, s1;

        eccentric(e, &d, &c, &s1);
        return 1.0 / (ellipse_quasi_scale(e) * quasi_share_f64(e->ca * e->ca, e->cb * e->cb,
                                                               ellipse_mu2(e->ca, e->cb), c, s1));
    }
    if (l->map == PSC_DISK_TABULATED) {
        double azimuth;

        return table_cell_at(l, d.x, d.y, &azimuth).density;
    }
    if (l->map < PSC_DISK_AREA_RADIAL)
        return s->inverse_total;
    length = 2.0 * light_point(l, &d, &qx, &qy, &rest);
    return length * length * length / (PSC_PI * l->seen.at * l->seen.bt);
}

/* v of the parallel map and u of the share of both halves with the sign of y. */
static void invert_chord(const psc_sampler *s, const struct seen *d, double uv[2])
{
    const struct psc_ellipse *e = &s->disk.seen;
    double sine, cosine, c, s1, length, half;

    if (!(e->ca > 0.0)) { /* a half space */
        const double angle = angle_of(MAX(d->z, 0.0), ABS(d->y));

        uv[0] = 0.5 + COPYSIGN(angle / PSC_PI, d->y);
        uv[1] = 0.5 * (1.0 + d->x);
        return;
    }
    sine = MIN(ABS(d->v) / d->z, 1.0);
    cosine = SQRT((1.0 - sine) * (1.0 + sine));
    /* tan eta = (ca / cb) tan t */
    c = e->cb * cosine;
    s1 = e->ca * sine;
    length = 1.0 / SQRT(c * c + s1 * s1);
    c *= length;
    s1 *= length;
    half = e->a * c;
    uv[0] = 0.5 + 0.5 * COPYSIGN(chord_share(e, &s->disk.cdf, s->total, c, s1), d->y);
    uv[1] = half > 0.0 ? 0.5 * (1.0 + d->x / half) : 0.5;
}

static void invert_radial(const psc_sampler *s, const struct seen *d, double uv[2])
{
    const struct psc_ellipse *e = &s->disk.seen;
    double defect, versine, c, s1;
    const double square = eccentric(e, d, &c, &s1);
    const double cc = e->ca * c, cs = e->cb * s1, z = SQRT(cc * cc + cs * cs);
    const double inner = MIN(square * (1.0 + z) / (1.0 + d->z), 1.0);
    const double theta =
        s->disk.map == PSC_DISK_QUASI_UNIFORM
            ? angle_of((1.0 + ellipse_mu1(e->ca, e->cb)) * ABS(c), ABS(s1))
            : cdf_theta(&s->disk.cdf, angle_of(ABS(c), ABS(s1)), ABS(c), ABS(s1));

    if (s->disk.map == PSC_DISK_CONCENTRIC) {
        sine_cosine_defects_f64(MIN(theta, 0.5 * PSC_PI), &defect, &versine);
        disk_to_square(COPYSIGN(SQRT(inner) * (1.0 - versine), c),
                       COPYSIGN(SQRT(inner) * (theta - defect), s1), uv, uv + 1);
    } else {
        const double turn = theta * (0.5 / PSC_PI), half = c < 0.0 ? 0.5 - turn : turn;

        uv[0] = s1 < 0.0 ? 1.0 - half : half;
        uv[1] = 1.0 - inner;
    }
}

static void invert_area(const struct psc_disk_light *l, const struct seen *d, double uv[2])
{
    double qx, qy, rest, s, t;

    light_point(l, d, &qx, &qy, &rest);
    s = qx * l->side[0][0] + qy * l->side[1][0];
    t = qx * l->side[0][1] + qy * l->side[1][1];
    if (l->map == PSC_DISK_AREA_CONCENTRIC) {
        disk_to_square(s, t, uv, uv + 1);
    } else if (l->map == PSC_DISK_AREA_RADIAL) {
        uv[0] = unturn(-s, -t);
        uv[1] = rest;
    } else {
        const double sine = MIN(ABS(t), 1.0), square = MAX((1.0 - sine) * (1.0 + sine), 0.0);
        const double half = SQRT(square);
        const double share = segment_share_f64(sine, half, square);

        uv[0] = 0.5 + COPYSIGN(0.5 * (1.0 - share), t);
        uv[1] = half > 0.0 ? 0.5 * (1.0 + s / half) : 0.5;
    }
}

/* All directions. */
static void invert_around(enum psc_disk_map map, const double d[3], double uv[2])
{
    const double inner = d[2] > 0.0 ? 0.5 * (d[0] * d[0] + d[1] * d[1]) / (1.0 + d[2])
                                    : 0.5 * (1.0 - d[2]);

    if (map == PSC_DISK_AROUND_PARALLEL) {
        uv[0] = unturn(d[2], d[1]);
        uv[1] = 0.5 * (1.0 + d[0]);
    } else if (map == PSC_DISK_AROUND_CONCENTRIC) {
        polar_to_square(1, inner, d[0], d[1], uv);
    } else {
        uv[0] = unturn(-d[0], -d[1]);
        uv[1] = d[2] > 0.0 ? 1.0 - inner : 0.5 * (d[0] * d[0] + d[1] * d[1]) / (1.0 - d[2]);
    }
}

psc_result psc_disk_invert(const psc_sampler *s, const double direction[3], double epsilon,
                           double uv[2])
{
    const struct psc_disk_light *l = &s->disk;
    struct seen d;
    int i;

    if (s->projected)
        return invert_fibres(s, direction, epsilon, uv);
    if (l->inside) {
        invert_around(l->map, direction, uv);
    } else if (!look(&l->seen, direction, epsilon, &d)) {
        return PSC_OUTSIDE;
    } else if (l->map >= PSC_DISK_AREA_RADIAL) {
        invert_area(l, &d, uv);
    } else if (l->map == PSC_DISK_PARALLEL) {
        invert_chord(s, &d, uv);
    } else if (l->map == PSC_DISK_TABULATED) {
        table_invert(l, d.x, d.y, (d.x * d.x + d.y * d.y) / (1.0 + d.z), uv);
    } else {
        invert_radial(s, &d, uv);
    }
    for (i = 0; i < 2; i++)
        uv[i] = MIN(MAX(uv[i], 0.0), 1.0);
    return PSC_SUCCESS;
}
