/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors and totals of elliptic cones sampled by projected solid angle, over random cones built
 * from angles: semi-arcs from 1e-8 to a hair under a right angle, aspects down to 1e-8, horizons to
 * within 1e-12 of the highest and of the lowest fibre; from samples as offsets from the axis.
 *
 * The reference is 113-bit quadrature over the angle psi of a fibre's plane. The ends of a fibre
 * are roots of the equation of the cone; what lies between them, chi + sin chi cos chi. Panels get
 * shorter by 4 towards both ends and towards where an end of a fibre crosses the middle.
 */
#include "arcs.h"
#include "calls.h"
#include "gauss.h"
#include "random.h"
#include "worst.h"

enum { CONES = 250, SAMPLES = 3, GRADES = 26, PANELS = 6 * GRADES + 8 };

/* Of the total: the horizon is four rounded numbers here. */
static const double cdf_bound[2] = {3e-7, 1e-14}, total_bound = 5e-15;

struct cone {
    double alpha, beta, up[2], gap;
    int lower;
    quad at, bt, f[2];
    quad top;                   /* psi of the highest fibre */
    quad horizon;               /* and of the horizon */
    quad a, b, c;               /* of the roots */
    int panels;
    quad edge[PANELS], above[PANELS]; /* downwards: where a panel ends, the integral up to there */
};

/* The tangents of chi at both ends of the fibre at psi. */
static void fibre_ends(const struct cone *k, quad psi, quad tangent[2])
{
    const quad s = quad_sin(psi), c = quad_cos(psi), b = k->b * s, square = k->a * c * c - k->c * s * s;
    const quad root = square > 0 ? quad_sqrt(square) : 0;

    tangent[0] = (-b - root) / k->a;
    tangent[1] = (-b + root) / k->a;
}

/* The integral of 2 cos^2 between two angles given by tangents. */
static quad chord(quad from, quad to)
{
    return quad_atan2(to - from, 1 + from * to) +
           (to - from) * (1 - from * to) / ((1 + from * from) * (1 + to * to));
}

static quad density(const struct cone *k, quad psi)
{
    quad tangent[2];

    fibre_ends(k, psi, tangent);
    return quad_sin(psi - k->horizon) * chord(tangent[0], tangent[1]) / 2;
}

static quad integral(const struct cone *k, quad from, quad to)
{
    quad sum = 0;
    int i;

    for (i = 0; i < GAUSS_NODES; i++)
        sum += gauss_weight(i) * density(k, from + (to - from) * gauss_node(i));
    return (to - from) * sum;
}

static void add_panel(struct cone *k, quad edge)
{
    const int n = k->panels;

    k->edge[n] = edge;
    k->above[n] = n == 0 ? 0 : k->above[n - 1] + integral(k, edge, k->edge[n - 1]);
    k->panels = n + 1;
}

/* Downwards. */
static void add_graded(struct cone *k, quad to)
{
    const quad from = k->edge[k->panels - 1], half = (from - to) / 2;
    quad part = 1;
    int i;

    for (i = 0; i < GRADES - 1; i++)
        part /= 4;
    for (i = 0; i < GRADES; i++, part *= 4)
        add_panel(k, from - half * part);
    for (i = 0; i < GRADES - 1; i++) {
        part = i == 0 ? (quad)1 / 4 : part / 4;
        add_panel(k, to + half * part);
    }
    add_panel(k, to);
}

static void make_cone(struct cone *k)
{
    const quad length = quad_sqrt(quad_square(k->up[0]) + quad_square(k->up[1]));
    const quad f0 = k->up[0] / length, f1 = k->up[1] / length, gap = k->gap;
    quad middle, end;
    int i;

    k->f[0] = f0;
    k->f[1] = f1;
    k->at = quad_sin(k->alpha) / quad_cos(k->alpha);
    k->bt = quad_sin(k->beta) / quad_cos(k->beta);
    /* ((-T f1 + s f0) / at)^2 + ((T f0 + s f1) / bt)^2 = c^2 */
    k->a = quad_square(f1 / k->at) + quad_square(f0 / k->bt);
    k->b = f0 * f1 * (1 / quad_square(k->bt) - 1 / quad_square(k->at));
    k->c = quad_square(1 / (k->at * k->bt));
    k->top = quad_atan2(quad_sqrt(k->a), quad_sqrt(k->c));
    k->horizon = k->lower ? -k->top - gap : k->top - gap;
    end = k->horizon > -k->top ? k->horizon : -k->top;
    middle = quad_atan2(1, quad_sqrt(quad_square(f0 / k->at) + quad_square(f1 / k->bt)));
    k->panels = 0;
    add_panel(k, k->top);
    for (i = 0; i < 2; i++) {
        const quad at = i == 0 ? middle : -middle;

        if (at < k->edge[k->panels - 1] && at > end)
            add_graded(k, at);
    }
    add_graded(k, end);
}

/* (u, v) of the direction axis + offset. */
static void place(const struct cone *k, const quad offset[3], quad uv[2])
{
    const quad x = offset[0], y = offset[1], z = 1 + offset[2];
    const quad up = x * k->f[0] + y * k->f[1], across = y * k->f[0] - x * k->f[1];
    const quad tangent = across / quad_sqrt(up * up + z * z);
    quad psi = quad_atan2(up, z), ends[2], t;
    int i = 1;

    psi = psi > k->top ? k->top : psi < k->edge[k->panels - 1] ? k->edge[k->panels - 1] : psi;
    while (i < k->panels - 1 && psi < k->edge[i])
        i++;
    uv[0] = (k->above[i - 1] + integral(k, psi, k->edge[i - 1])) / k->above[k->panels - 1];
    fibre_ends(k, psi, ends);
    t = tangent < ends[0] ? ends[0] : tangent > ends[1] ? ends[1] : tangent;
    uv[1] = ends[1] > ends[0] ? chord(ends[0], t) / chord(ends[0], ends[1]) : 0;
}

/* What the roundings of the sample move its place by. */
static void openness(const struct cone *k, const quad offset[3], const double rounding[3],
                     const quad here[2], double open[2])
{
    int i, j, sign;

    open[0] = open[1] = 0.0;
    for (j = 0; j < 3; j++) {
        double most[2] = {0.0, 0.0};

        for (sign = -1; sign <= 1; sign += 2) {
            quad moved[3] = {offset[0], offset[1], offset[2]}, there[2];

            moved[j] += sign * (quad)rounding[j];
            place(k, moved, there);
            for (i = 0; i < 2; i++)
                {
                const double moved_by = (double)quad_abs(there[i] - here[i]);

                /* beyond that it is not the sum of what the roundings do: then anything */
                most[i] = moved_by <= most[i] ? most[i] : moved_by < 1.0 / 16.0 ? moved_by : HUGE_VAL;
            }
        }
        for (i = 0; i < 2; i++)
            open[i] += most[i];
    }
}

/* What is left of an error when some of it is open; NaN stays NaN. */
static double beyond(quad found, double expected, double open)
{
    const double error = (double)quad_abs(found - expected) - open;

    return error < 0.0 ? 0.0 : error;
}

static void random_cone(uint64_t *seed, struct cone *k)
{
    const double right = 0x1.921fb54442d18p+0, turn = random_between(seed, 0.0, 6.2831853);
    double m, range;

    k->alpha = random_below(seed, 3) == 0 ? right * (1.0 - random_log(seed, 1e-9, 1.0))
                                          : random_log(seed, 1e-8, right);
    k->beta = k->alpha * (random_below(seed, 4) == 0 ? 1.0 : random_log(seed, 1e-8, 1.0));
    k->up[0] = cos(turn);
    k->up[1] = sin(turn);
    switch (k->alpha < 1.5 ? random_below(seed, 8) : 2) {
    case 0: k->up[0] *= random_log(seed, 1e-9, 1.0); break;
    case 1: k->up[1] *= random_log(seed, 1e-9, 1.0); break;
    default: break;
    }
    m = hypot(k->up[0], k->up[1]);
    m = atan(hypot(tan(k->alpha) * k->up[0], tan(k->beta) * k->up[1]) / m);
    range = 0.9 * (right - m); /* the axis is no higher than the zenith */
    k->lower = random_below(seed, 2);
    if (!k->lower)
        k->gap = m * (random_below(seed, 2) ? random_uniform(seed) : random_log(seed, 1e-12, 1.0));
    else if (random_below(seed, 2))
        k->gap = -m * random_log(seed, 1e-12, 1.0);
    else
        k->gap = fmin(random_below(seed, 2) ? range * random_uniform(seed) : m * random_log(seed, 1e-12, 1.0), range);
}

int main(void)
{
    struct worst u_error[2] = {{0}}, v_error[2] = {{0}}, total_error = {0};
    uint64_t seed = 210;
    int i, j, bits;

    for (i = 0; i < CONES; i++) {
        const char *text = "cone %d: alpha %a beta %a upwards %a %a lower %d gap %a u %a v %a f%d";
        struct test_sampler s;
        struct cone k;
        double total = NAN;

        random_cone(&seed, &k);
        make_cone(&k);
        if (!(k.above[k.panels - 1] > 0))
            continue;
        psc_build_ellipse_above(make_sampler(&s), k.alpha, k.beta, k.up, k.lower, k.gap);
        psc_sampler_total(s.sampler, &total);
        worst_add(&total_error, (double)quad_abs(total / k.above[k.panels - 1] - 1), text, i,
                  k.alpha, k.beta, k.up[0], k.up[1], k.lower, k.gap, 0.0, 0.0, 64);
        for (j = 0; j < SAMPLES; j++) {
            const double u = (float)random_coordinate(&seed), v = (float)random_coordinate(&seed);

            for (bits = 32; bits <= 64; bits += 32) {
                const double unit = bits == 64 ? 0x1p-53 : 0x1p-24;
                const int wide = bits == 64;
                double offset[3] = {NAN, NAN, NAN}, rounding[3], open[2];
                quad exact[3], here[2];
                float f[3];
                int c;

                if (wide) {
                    psc_sample_cone_offset_f64(s.sampler, u, v, offset);
                } else {
                    psc_sample_cone_offset_f32(s.sampler, (float)u, (float)v, f);
                    for (c = 0; c < 3; c++)
                        offset[c] = f[c];
                }
                for (c = 0; c < 3; c++)
                    exact[c] = offset[c];
                /* eight roundings of a direction in the cone, each way */
                rounding[0] = 16.0 * unit * sin(k.alpha);
                rounding[1] = 16.0 * unit * sin(k.beta);
                rounding[2] = 16.0 * unit * fabs(offset[2]);
                place(&k, exact, here);
                openness(&k, exact, rounding, here, open);
                worst_add(&u_error[wide], beyond(here[0], u, open[0]), text, i, k.alpha, k.beta,
                          k.up[0], k.up[1], k.lower, k.gap, u, v, bits);
                if (u > 0.0 && (u < 1.0 || k.horizon > -k.top)) /* else the fibre is a point */
                    worst_add(&v_error[wide], beyond(here[1], v, open[1]), text, i, k.alpha,
                              k.beta, k.up[0], k.up[1], k.lower, k.gap, u, v, bits);
            }
        }
    }
    worst_report(&total_error, total_bound, "total, relative");
    for (i = 0; i < 2; i++) {
        worst_report(&u_error[i], cdf_bound[i], "f%d: CDF in u", i ? 64 : 32);
        worst_report(&v_error[i], cdf_bound[i], "f%d: CDF in v", i ? 64 : 32);
    }
    return tap_done();
}
