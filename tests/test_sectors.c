/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Polygons by projected solid angle against 113-bit arithmetic: totals, and the place in the unit
 * square of samples, over sizes from 1e-8 to 2 and needles to 1e-8, with the zenith inside, next to
 * an edge and outside, the horizon cutting and touching.
 *
 * The reference cuts the polygon by planes (horizon, and those through the receiver's normal that
 * bound an azimuth) and adds up Lambert's boundary integral, which the library uses nowhere; that
 * in turn is compared with quadrature of cosine times cosine over squared distance on the light.
 *
 * Lights are made of integers times powers of two, flat without rounding. A sample is taken at its
 * word by its texture coordinates where the light is small, by its direction where it is large,
 * each of which may be some units in its last place off.
 */
#include "calls.h"
#include "quad.h"
#include "random.h"
#include "worst.h"

enum { MOST = 16, ROOM = 40, LIGHTS = 1500, SAMPLES = 6 };

struct flat_light {
    int n;
    double v[MOST][3], normal[3];
    double size, thin;
    int exactly; /* at an edge, or touching, to rounding: on which side is not said */
    const char *kind;
};

typedef quad vector[3];

static quad quad_dot(const quad *a, const quad *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void quad_cross(const quad *a, const quad *b, quad *to)
{
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

/* ---- The reference ---- */

/* The part of a polygon with plane.p >= 0. */
static int cut(int n, vector *p, const quad *plane)
{
    vector q[ROOM];
    int i, c, m = 0;

    for (i = 0; i < n; i++) {
        const int next = (i + 1) % n;
        const quad a = quad_dot(plane, p[i]), b = quad_dot(plane, p[next]);

        if (a >= 0)
            memcpy(q[m++], p[i], sizeof q[0]);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
            for (c = 0; c < 3; c++)
                q[m][c] = (p[i][c] * b - p[next][c] * a) / (b - a);
            m++;
        }
    }
    memcpy(p, q, (size_t)m * sizeof q[0]);
    return m;
}

/* theta / sin theta - 1 of sine and cosine: by its series in the square of the sine where the
   quotient would cancel. */
static quad arc_excess(quad sine, quad cosine)
{
    quad square = sine * sine, term = 1, sum = 0;
    int i;

    if (cosine < 0.9)
        return sine > 0 ? quad_atan2(sine, cosine) / sine - 1 : 0;
    for (i = 1; i < 60; i++) {
        term *= square * (2 * i - 1) / (2 * i);
        sum += term / (2 * i + 1);
    }
    return sum;
}

/* Projected solid angle for a normal of length 1; the order of vertices does not matter. Of the
   integral, sum of theta (a x b).n / sin theta for directions a and b, what small polygons cancel
   is taken off: a and b are a first direction and a small vector each. */
static quad lambert(int n, vector *p, const quad *normal)
{
    quad sum = 0, length[ROOM];
    vector u[ROOM], e[ROOM];
    int i, c;

    for (i = 0; i < n; i++)
        length[i] = quad_sqrt(quad_dot(p[i], p[i]));
    for (i = 0; i < n; i++) {
        quad longer = 0;

        for (c = 0; c < 3; c++)
            longer += (p[i][c] - p[0][c]) * (p[i][c] + p[0][c]) / (length[i] + length[0]);
        for (c = 0; c < 3; c++) {
            u[i][c] = p[i][c] / length[i];
            e[i][c] = ((p[i][c] - p[0][c]) - u[0][c] * longer) / length[i];
        }
    }
    for (i = 0; i < n; i++) {
        const int next = (i + 1) % n;
        vector step, across;

        quad_cross(e[i], e[next], across);
        sum += quad_dot(across, normal);
        for (c = 0; c < 3; c++)
            step[c] = e[next][c] - e[i][c];
        quad_cross(u[i], step, across);
        sum += arc_excess(quad_sqrt(quad_dot(across, across)), quad_dot(u[i], u[next])) *
               quad_dot(across, normal);
    }
    return quad_abs(sum) / 2;
}

/* What a receiver at the origin sees. */
struct seen {
    int n;
    vector p[ROOM], normal, x, y; /* p above the horizon; x, y across the normal */
    quad total;
    int first_u;         /* the zenith is inside: azimuths count from this point */
    int around;
};

static quad azimuth_cross(const struct seen *s, const quad *a, const quad *b)
{
    return quad_dot(a, s->x) * quad_dot(b, s->y) - quad_dot(a, s->y) * quad_dot(b, s->x);
}

static void see(const struct flat_light *light, int flip, struct seen *s)
{
    vector e1, e2, across;
    quad length = 0, turn;
    int i, c, left = 1;

    for (c = 0; c < 3; c++)
        length += quad_square(light->normal[c]);
    for (c = 0; c < 3; c++)
        s->normal[c] = (flip ? -1 : 1) * light->normal[c] / quad_sqrt(length);
    s->n = light->n;
    for (i = 0; i < light->n; i++)
        for (c = 0; c < 3; c++)
            s->p[i][c] = light->v[i][c];
    /* Any frame, its y counterclockwise from x seen from above; from below, mirrored. */
    for (c = 0; c < 3; c++)
        e1[c] = c == (quad_abs(s->normal[0]) > 0.5);
    quad_cross(s->normal, e1, s->x);
    length = quad_sqrt(quad_dot(s->x, s->x));
    for (c = 0; c < 3; c++)
        s->x[c] /= length;
    quad_cross(s->normal, s->x, s->y);
    for (c = 0; flip && c < 3; c++)
        s->y[c] = -s->y[c];
    /* Counterclockwise around the zenith, the first vertex staying where it is. */
    for (c = 0; c < 3; c++) {
        e1[c] = s->p[1][c] - s->p[0][c];
        e2[c] = s->p[light->n - 1][c] - s->p[0][c];
    }
    quad_cross(e1, e2, across);
    turn = quad_dot(across, s->p[0]);
    if ((turn < 0) != flip)
        for (i = 1; i < s->n - i; i++) {
            vector swap;

            memcpy(swap, s->p[i], sizeof swap);
            memcpy(s->p[i], s->p[s->n - i], sizeof swap);
            memcpy(s->p[s->n - i], swap, sizeof swap);
        }
    s->n = cut(s->n, s->p, s->normal);
    s->total = lambert(s->n, s->p, s->normal);
    for (i = 0; i < s->n; i++)
        left &= azimuth_cross(s, s->p[i], s->p[(i + 1) % s->n]) >= 0;
    s->around = left;
}

/* Projected solid angle at azimuths from that of a to that of b, at most half a turn. */
static quad wedge(const struct seen *s, const quad *a, const quad *b, int open)
{
    vector p[ROOM], plane;
    int n = s->n, c;

    memcpy(p, s->p, sizeof p);
    for (c = 0; c < 3; c++)
        plane[c] = quad_dot(b, s->y) * s->x[c] - quad_dot(b, s->x) * s->y[c];
    n = cut(n, p, plane);
    if (!open) {
        for (c = 0; c < 3; c++)
            plane[c] = quad_dot(a, s->x) * s->y[c] - quad_dot(a, s->y) * s->x[c];
        n = cut(n, p, plane);
    }
    return lambert(n, p, s->normal);
}

/* The place of a direction of any length in the unit square. */
static void place(const struct seen *s, const quad *d, quad uv[2])
{
    const quad xy = quad_square(quad_dot(d, s->x)) + quad_square(quad_dot(d, s->y));
    quad low = 2, high = 0, rho2 = xy / quad_dot(d, d);
    int i, c;

    if (!s->around)
        uv[0] = wedge(s, d, d, 1) / s->total;
    else if (azimuth_cross(s, s->p[0], d) >= 0)
        uv[0] = wedge(s, s->p[0], d, 0) / s->total;
    else
        uv[0] = 1 - wedge(s, d, s->p[0], 0) / s->total;
    for (i = 0; i < s->n; i++) {
        const int next = (i + 1) % s->n;
        const quad a = azimuth_cross(s, d, s->p[i]), b = azimuth_cross(s, d, s->p[next]);
        quad along, r2;
        vector q;

        if (a == b || (a > 0) == (b > 0))
            continue;
        for (c = 0; c < 3; c++)
            q[c] = (s->p[i][c] * b - s->p[next][c] * a) / (b - a);
        along = quad_dot(q, s->x) * quad_dot(d, s->x) + quad_dot(q, s->y) * quad_dot(d, s->y);
        if (along < 0)
            continue;
        r2 = (quad_square(quad_dot(q, s->x)) + quad_square(quad_dot(q, s->y))) / quad_dot(q, q);
        low = r2 < low ? r2 : low;
        high = r2 > high ? r2 : high;
    }
    low = s->around ? 0 : low;
    uv[1] = high > low ? (rho2 - low) / (high - low) : NAN;
}

/* ---- Lights ---- */

/* x rounded to a multiple of step. */
static double to_grid(double x, double step)
{
    return floor(x / step + 0.5) * step;
}

static double power_below(double x)
{
    int e;

    frexp(x, &e);
    return ldexp(1.0, e - 1);
}

enum { ABOVE, ZENITH_INSIDE, ZENITH_AT_EDGE, HORIZON_CUTS, HORIZON_TOUCHES, CLOSE, KINDS };
static const char *const kinds[KINDS] = {"above",        "zenith inside",   "zenith at an edge",
                                         "horizon cuts", "horizon touches", "close"};

/* Weights of the vertices that add up to a point inside. */
static void point_inside(uint64_t *state, const struct flat_light *light, double q[3])
{
    double sum = 0.0, weight;
    int i, c;

    q[0] = q[1] = q[2] = 0.0;
    for (i = 0; i < light->n; i++) {
        weight = random_between(state, 0.1, 1.0);
        sum += weight;
        for (c = 0; c < 3; c++)
            q[c] += weight * light->v[i][c];
    }
    for (c = 0; c < 3; c++)
        q[c] /= sum;
}

/* A normal to q, but for `off`. */
static void normal_across(uint64_t *state, const double q[3], double off, double normal[3])
{
    double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2], along;
    int c;

    random_unit(state, normal);
    along = (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) / length;
    for (c = 0; c < 3; c++)
        normal[c] += (off - along) * q[c];
}

static void choose_normal(uint64_t *state, int kind, double size, struct flat_light *light)
{
    const int i = random_below(state, light->n), next = (i + 1) % light->n;
    const double least = kind == ZENITH_AT_EDGE ? 1e-12 : 1e-16;
    const double tiny = light->exactly ? 0.0
                        : (random_below(state, 2) ? -1.0 : 1.0) * random_log(state, least, 0.1);
    double q[3], t;
    int c;

    point_inside(state, light, q);
    switch (kind) {
    case ABOVE:
        random_unit(state, light->normal);
        t = random_between(state, 0.0, 2.0);
        for (c = 0; c < 3; c++)
            light->normal[c] = q[c] + t * light->normal[c];
        break;
    case ZENITH_INSIDE: memcpy(light->normal, q, sizeof q); break;
    case ZENITH_AT_EDGE:
        t = random_uniform(state);
        for (c = 0; c < 3; c++) {
            light->normal[c] = light->v[i][c] + t * (light->v[next][c] - light->v[i][c]);
            light->normal[c] += tiny * (q[c] - light->normal[c]);
        }
        break;
    case HORIZON_CUTS: normal_across(state, q, 0.0, light->normal); break;
    case HORIZON_TOUCHES:
        normal_across(state, light->v[i], tiny * size, light->normal);
        break;
    default: random_unit(state, light->normal); break;
    }
}

/* A polygon of vertices around an ellipse, `size` long and some share of that wide. */
static void make_light(uint64_t *state, struct flat_light *light)
{
    static const int counts[] = {3, 3, 4, 5, 8, 16};
    const int n = counts[random_below(state, 6)], kind = random_below(state, KINDS);
    const int needle = random_below(state, 3) == 0;
    const double size = kind == CLOSE ? random_log(state, 1.0, 100.0)
                        : n == 3 || !needle ? random_log(state, 1e-8, 2.0)
                                            : random_log(state, 1e-4, 2.0);
    const double least = n == 3 ? 1e-8 : 1e-3;
    const double thin = needle ? random_log(state, least, 1.0) : 1.0, step = power_below(size);
    double center[3], e[2][3];
    int i, c;

    light->n = n;
    light->kind = kinds[kind];
    light->size = size;
    light->thin = thin;
    light->exactly = random_below(state, 4) == 0;
    random_unit(state, center);
    random_unit(state, e[0]);
    random_unit(state, e[1]);
    /* Few bits each, so that all products and sums are exact. */
    for (c = 0; c < 3; c++) {
        center[c] = to_grid(center[c], 0x1p-12);
        e[0][c] = to_grid(e[0][c], 0x1p-9) * step;
        e[1][c] = to_grid(e[1][c], 0x1p-9) * step * power_below(thin);
    }
    for (i = 0; i < n; i++) {
        const double angle = 6.283185307179586 * (i + 0.6 * random_uniform(state)) / n;
        const double x = to_grid(cos(angle), 0x1p-12), y = to_grid(sin(angle), 0x1p-12);

        for (c = 0; c < 3; c++)
            light->v[i][c] = center[c] + (x * e[0][c] + y * e[1][c]);
    }
    choose_normal(state, kind, size, light);
}

static const char *describe(const struct flat_light *light, double u, double v)
{
    static char text[400];
    int n, i;

    n = snprintf(text, sizeof text, "%s, n %d, u %a v %a normal %a %a %a:", light->kind, light->n,
                 u, v, light->normal[0], light->normal[1], light->normal[2]);
    for (i = 0; i < light->n && n < (int)sizeof text - 80; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, " %a %a %a", light->v[i][0],
                      light->v[i][1], light->v[i][2]);
    return text;
}

/* ---- The sweep ---- */

/* The direction of a sample: its own, or that of the point of its texture coordinates; each number
   moved by `shift` of itself, or the `moved`-th alone when that is not negative. */
static void take_direction(const struct flat_light *light, const psc_light_sample_f64 *sample,
                           int moved, quad shift, quad *d)
{
    const int by_surface = light->size < 0.05, last = light->n - 1;
    quad number[3];
    int c;

    for (c = 0; c < 3; c++)
        number[c] = by_surface ? (c < 2 ? sample->surface[c] : 0.0) : sample->direction[c];
    if (moved >= 0)
        number[moved] += number[moved] * shift;
    for (c = 0; c < 3; c++)
        d[c] = by_surface ? light->v[0][c] + number[0] * ((quad)light->v[1][c] - light->v[0][c]) +
                                number[1] * ((quad)light->v[last][c] - light->v[0][c])
                          : number[c];
}

/* The point of the square on one of the sides, joined as the library does; *turn is what u may be
   more or less where it counts around the zenith, else 0. */
static void place_on(const struct seen side[2], quad split, int below, const quad *d, quad uv[2],
                     quad *turn)
{

    place(side + below, d, uv);
    if (split > 0)
        uv[0] = below ? 1 - uv[0] * (1 - split) : uv[0] * split;
    *turn = side[below].around ? (below ? 1 - split : split) : 0;
}

static quad distance(quad a, quad b, quad turn)
{
    const quad straight = quad_abs(a - b);

    return turn > 0 && turn - straight < straight ? quad_abs(turn - straight) : straight;
}

/* Error of a sample beyond what rounding its numbers explains. v is not defined where the
   direction is beside the light by less than its rounding. */
static void sample_error(const struct flat_light *light, const struct seen side[2], int sides,
                         int bits, const psc_light_sample_f64 *sample, double u, double v,
                         double error[2])
{
    const quad rounding = bits == 64 ? 4 * 0x1p-53 : 1.5 * 0x1p-24;
    const quad split = sides == 2 ? side[0].total / (side[0].total + side[1].total) : 1;
    const int below = sides == 2 && (u > split || split == 0);
    quad at[2], turn, allowed[2] = {0, 0};
    vector d;
    int i, k;

    take_direction(light, sample, -1, 0, d);
    place_on(side, split, below, d, at, &turn);
    for (i = 0; i < 3; i++) {
        quad moved[2][2], unused;

        take_direction(light, sample, i, rounding, d);
        place_on(side, split, below, d, moved[0], &unused);
        take_direction(light, sample, i, -rounding, d);
        place_on(side, split, below, d, moved[1], &unused);
        for (k = 0; k < 2; k++) {
            const quad up = distance(moved[0][k], at[k], k ? 0 : turn);
            const quad down = distance(moved[1][k], at[k], k ? 0 : turn);

            allowed[k] += up > down ? up : down;
        }
    }
    for (k = 0; k < 2; k++) {
        const quad miss = distance(at[k], k ? v : u, k ? 0 : turn) - allowed[k];

        error[k] = miss > 0 ? (double)miss : 0.0;
    }
    /* At the zenith there is no azimuth, and where the azimuths begin and end the light may have
       no width. */
    if ((turn > 0 || light->kind == kinds[ZENITH_AT_EDGE]) && v < 1e-4)
        error[0] = 0.0;
    if ((below ? 1 - u < 1e-4 * (1 - split) || u - split < 1e-4 * (1 - split)
                            : u < 1e-4 * split || split - u < 1e-4 * split))
        error[1] = 0.0;
    if (!(at[0] == at[0]))
        error[0] = NAN;
}

/* How much less exact results are for slivers: a tenth of length over width, of the light and as it
   is seen; and of lights that are not known to be flat, in what is seen above the horizon. */
static double sliver(const struct flat_light *light, double expected)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const double size = light->size < 1.0 ? light->size : 1.0, square = size * size;
    double solid_angle = 0.0;

    psc_polygon_solid_angle(origin, (size_t)light->n, light->v[0], sizeof light->v[0],
                            &solid_angle);
    return 1.0 + 0.1 * (square / solid_angle + 1.0 / light->thin) +
           (light->n > 3 ? 0.02 * square / expected : 0.0);
}

static void sweep(void)
{
    struct worst total, place_error[2][2];
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL);
    static const double origin[3] = {0.0, 0.0, 0.0};
    uint64_t seed = 5;
    long empty = 0;
    int i, j, bits;

    memset(&total, 0, sizeof total);
    memset(place_error, 0, sizeof place_error);
    for (i = 0; i < LIGHTS; i++) {
        const int sides = 1 + random_below(&seed, 2);
        struct flat_light light;
        struct seen side[2];
        struct test_sampler s;
        psc_receiver receiver;
        psc_result result;
        quad expected;
        double found, scale;

        make_light(&seed, &light);
        receiver = make_receiver(origin, light.normal, sides == 2 ? PSC_RECEIVER_TWO_SIDED : 0);
        see(&light, 0, side);
        see(&light, 1, side + 1);
        expected = side[0].total + (sides == 2 ? side[1].total : 0);
        result = psc_build_polygon(make_sampler(&s), &technique, &receiver, (size_t)light.n,
                                   light.v[0], sizeof light.v[0]);
        psc_sampler_total(s.sampler, &found);
        if (!(expected > 0)) {
            empty++;
            tap_ok(result == PSC_EMPTY, "nothing is seen: %s", describe(&light, 0.0, 0.0));
            continue;
        }
        scale = sliver(&light, (double)expected);
        worst_add(&total,
                  result == PSC_SUCCESS ? (double)quad_abs(found / expected - 1) / scale : NAN,
                  "%s", describe(&light, 0.0, 0.0));
        /* Where the zenith is on an edge, rounding says where azimuths begin. */
        if (light.kind == kinds[ZENITH_AT_EDGE] && (light.exactly || light.thin < 1.0))
            continue;
        for (j = 0; j < SAMPLES && result == PSC_SUCCESS; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (bits = 64; bits >= 32; bits -= 32) {
                psc_light_sample_f64 sample;
                double error[2];
                int k;

                if (bits == 32) {
                    u = (float)u;
                    v = (float)v;
                }
                sample.direction[0] = NAN;
                sample_any(bits, s.sampler, u, v, &sample);
                sample_error(&light, side, sides, bits, &sample, u, v, error);
                for (k = 0; k < 2; k++)
                    worst_add(&place_error[bits == 64][k], error[k] / scale, "%s",
                              describe(&light, u, v));
            }
        }
    }
    tap_note("%ld lights of which nothing is seen", empty);
    worst_report(&total, 3e-14, "total, relative");
    for (bits = 32; bits <= 64; bits += 32) {
        const double bound = bits == 64 ? 3e-14 : 3e-7;

        worst_report(&place_error[bits == 64][0], bound, "f%d: CDF in u", bits);
        worst_report(&place_error[bits == 64][1], bound, "f%d: CDF in v", bits);
    }
}

/* Cosine times cosine over squared distance, over the triangles of a fan, by Simpson's rule along
   and across each. */
static double by_quadrature(const struct flat_light *light)
{
    enum { STEPS = 64 };
    double sum = 0.0;
    int i, j, k, c;

    for (i = 1; i + 1 < light->n; i++) {
        const double *const a = light->v[0], *const b = light->v[i], *const d = light->v[i + 1];
        double e[2][3], across[3];

        for (c = 0; c < 3; c++) {
            e[0][c] = b[c] - a[c];
            e[1][c] = d[c] - b[c];
        }
        across[0] = e[0][1] * e[1][2] - e[0][2] * e[1][1];
        across[1] = e[0][2] * e[1][0] - e[0][0] * e[1][2];
        across[2] = e[0][0] * e[1][1] - e[0][1] * e[1][0];
        for (j = 0; j <= STEPS; j++)
            for (k = 0; k <= STEPS; k++) {
                const double s = (double)j / STEPS, t = (double)k / STEPS;
                const double weight = (j == 0 || j == STEPS ? 1 : 2 + 2 * (j & 1)) *
                                      (k == 0 || k == STEPS ? 1 : 2 + 2 * (k & 1)) /
                                      (9.0 * STEPS * STEPS);
                double square = 0.0, height = 0.0, facing = 0.0;

                for (c = 0; c < 3; c++) {
                    const double p = a[c] + s * (e[0][c] + t * e[1][c]);

                    square += p * p;
                    height += p * light->normal[c];
                    facing += p * across[c];
                }
                sum += weight * s * fabs(facing) * height / (square * square);
            }
    }
    return sum / sqrt(light->normal[0] * light->normal[0] + light->normal[1] * light->normal[1] +
                      light->normal[2] * light->normal[2]);
}

static void compare_reference(void)
{
    struct worst worst = {0.0, 0, ""};
    uint64_t seed = 6;
    int i, c;

    while (worst.count < 20) {
        struct flat_light light;
        double least = INFINITY;
        struct seen side;

        make_light(&seed, &light);
        for (i = 0; i < light.n; i++) {
            double height = 0.0;

            for (c = 0; c < 3; c++)
                height += light.normal[c] * light.v[i][c];
            least = fmin(least, height);
        }
        if (least <= 0.0 || light.size < 0.1 || light.size > 0.5)
            continue;
        see(&light, 0, &side);
        worst_add(&worst, fabs(by_quadrature(&light) / (double)side.total - 1.0), "%s",
                  describe(&light, 0.0, 0.0));
    }
    worst_report(&worst, 1e-6, "the reference against quadrature on the light");
}

int main(void)
{
    compare_reference();
    sweep();
    return tap_done();
}
