/* SPDX-License-Identifier: Apache-2.0 */
#include "place.h"

#include <math.h>

/* Distance of two places, once round a circle or along a line; NaN stays NaN. */
static double apart(int periodic, quad a, quad b)
{
    double d = (double)quad_abs(a - b);
    return periodic && d > 0.5 ? fabs(1.0 - d) : d;
}

/* What is left of an error when some of it is open. */
static double beyond(double error, double open)
{
    return error <= open ? 0.0 : error - open;
}

static int in_chords(const struct test_technique *what)
{
    return what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE && what->map != PSC_MAP_RADIAL;
}

static int goes_round(const struct test_technique *what, const struct reference *r)
{
    return !in_chords(what) && (what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE ||
                                r->visible != REFERENCE_LUNE);
}

static void locate(const struct test_technique *what, const struct reference *r,
                   const struct place_sample *sample, const quad number[3], quad st[2])
{
    quad offset[3];

    sample->offset(sample->context, number, offset);
    if (what->measure == PSC_MEASURE_SOLID_ANGLE)
        reference_cone(r, offset[0], offset[1], offset[2], st);
    else if (in_chords(what))
        reference_parallel(r, offset[0], offset[1], st);
    else
        reference_radial(r, offset[0], offset[1], st);
}

/* How far the rounding of the sample lets its place be from where it is. Where that is far, it is
   not the sum of what the roundings of single numbers do: then anything. */
static void openness(const struct test_technique *what, const struct reference *r,
                     const struct place_sample *sample, const quad here[2], double open[2])
{
    int periodic = goes_round(what, r), i, j, sign;

    open[0] = open[1] = 0.0;
    for (j = 0; j < 3; j++) {
        double most[2] = {0.0, 0.0};
        for (sign = -1; sign <= 1; sign += 2) {
            quad moved[3] = {sample->number[0], sample->number[1], sample->number[2]}, there[2];
            moved[j] += sign * (quad)sample->rounding[j];
            locate(what, r, sample, moved, there);
            for (i = 0; i < 2; i++) {
                double d = apart(i == 1 && periodic, there[i], here[i]);
                most[i] = d <= most[i] ? most[i] : d < 1.0 / 16.0 ? d : HUGE_VAL;
            }
        }
        for (i = 0; i < 2; i++)
            open[i] += most[i];
    }
}

void place_polar_error(psc_map map, double u, double v, const quad here[2], const double open[2],
                       double error[2])
{
    quad s = u, t = v, pq[2];

    if (map == PSC_MAP_CONCENTRIC) {
        reference_disk(u, v, pq);
        s = pq[0] * pq[0] + pq[1] * pq[1];
        t = (1 + quad_atan2(pq[1], pq[0]) / quad_pi()) / 2;
    }
    error[0] = beyond(apart(0, here[0], s), open[0]);
    error[1] = s > 0 ? beyond(apart(1, here[1], t), open[1]) : 0.0;
    if (map == PSC_MAP_CONCENTRIC)
        error[1] *= (double)quad_sqrt(s);
}

void place_error(const struct test_technique *what, const struct reference *r, double u, double v,
                 const struct place_sample *sample, double error[2])
{
    int periodic = goes_round(what, r), i;
    quad here[2], st[2], pq[2];
    double open[2];

    for (i = 0; i < 3; i++)
        if (!(quad_abs(sample->number[i]) <= 2)) {
            error[0] = error[1] = HUGE_VAL;
            return;
        }
    locate(what, r, sample, sample->number, here);
    openness(what, r, sample, here, open);
    if (what->measure == PSC_MEASURE_SOLID_ANGLE) {
        place_polar_error(what->map, u, v, here, open, error);
        return;
    }
    if (in_chords(what) && sample->exact_t)
        open[1] = 0.0;
    st[0] = u;
    st[1] = v;
    if (what->map == PSC_MAP_CONCENTRIC)
        reference_concentric(u, v, st);
    for (i = 0; i < 2; i++)
        error[i] = beyond(apart(i == 1 && periodic, here[i], st[i]), open[i]);
    if (periodic && u == 0.0)
        error[1] = 0.0;
    if ((in_chords(what) || !periodic) && (st[1] == 0 || st[1] == 1))
        error[0] = 0.0;
    if (what->map == PSC_MAP_CONCENTRIC) {
        reference_disk(u, v, pq);
        error[0] *= (double)quad_sqrt((1 - pq[1]) * (1 + pq[1]));
    }
}
