/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

/* One ratio of two jobs, and how large or small it is meant to be. */
struct side {
    const char *method, *how; /* how NULL: the kernel that the library takes */
};

static const struct bar {
    const char *text;
    enum regime regime, regime_under;
    struct side over, under;
    unsigned cases; /* a set of 1 << case */
    int bits;       /* 32, 64 or both (96) */
    double bound;
    int at_least;
} bars[] = {
#define IN(regime) REGIME_##regime, REGIME_##regime
#define ELLIPSE (1u << CASE_ELLIPSE)
#define MIXED (1u << CASE_MIXED | 1u << CASE_SUN)
#define LUNES (1u << CASE_LUNE | 1u << CASE_THIN)
#define OWN {"radial", NULL}
#define CONE {"cone", NULL}
#define OF_PAPER {"radial", "paper"}
    {"radial at most 1.3 cones", IN(MANY), OWN, CONE, ELLIPSE, 96, 1.3, 0},
    {"radial at most 2 cones", IN(MANY), OWN, CONE, MIXED, 32, 2.0, 0},
    {"radial at most 4 cones", IN(MANY), OWN, CONE, MIXED, 64, 4.0, 0},
    {"radial at most 10 cones", IN(MANY), OWN, CONE, LUNES, 64, 10.0, 0},
    {"radial 20 times as fast as the paper", IN(MANY), OF_PAPER, OWN, MIXED, 96, 20.0, 1},
    {"radial 10 times as fast as the paper", IN(MANY), OF_PAPER, OWN, LUNES, 96, 10.0, 1},
    {"parallel 3 times as fast as the paper", IN(MANY), {"parallel", "paper"},
     {"parallel", NULL}, ELLIPSE | MIXED | LUNES, 96, 3.0, 1},
    {"concentric at most 1.5 radial", IN(MANY), {"concentric", NULL}, OWN,
     ELLIPSE | MIXED | LUNES, 96, 1.5, 0},
    {"radial at most 1.2 libm cones", IN(ONE), {"radial", "calls"}, {"cone", "libm"}, ELLIPSE,
     96, 1.2, 0},
    {"radial 2.5 times as fast as the paper", IN(ONE), OF_PAPER, {"radial", "calls"}, MIXED,
     96, 2.5, 1},
    {"radial 1.5 times as fast as the paper", IN(ONE), OF_PAPER, {"radial", "calls"}, LUNES,
     96, 1.5, 1},
    {"parallel no slower than the paper", IN(ONE), {"parallel", "paper"},
     {"parallel", "calls"}, ELLIPSE | MIXED | LUNES, 96, 1.0, 1},
    {"radial at most 2.5 cones", IN(WAVEFRONT), OWN, CONE, 1u << CASE_CORNELL, 32, 2.5, 0},
#define DISKS (1u << CASE_DISK | 1u << CASE_DISK_SMALL)
#define ALL_DISKS (DISKS | 1u << CASE_DISK_WIDE)
#define ELLIPSES (1u << CASE_ELLIPSE_DISK | 1u << CASE_ELLIPSE_DISK_SMALL)
#define ALL_ELLIPSES (ELLIPSES | 1u << CASE_ELLIPSE_DISK_WIDE)
#define ELLIPSOIDS (1u << CASE_ELLIPSOID | 1u << CASE_ELLIPSOID_SMALL)
#define PROJECTED_CONES                                                               \
    (DISKS | 1u << CASE_DISK_CUT | ELLIPSES | 1u << CASE_ELLIPSE_DISK_CUT | ELLIPSOIDS | \
     1u << CASE_ELLIPSOID_CUT)
#define CONCENTRIC {"solid angle, concentric", NULL}
#define CHORDS {"solid angle, parallel", NULL}
#define DISK_AREA {"area, concentric", NULL}
#define FIBRES {"projected solid angle, parallel", NULL}
#define FIBRE_CALLS {"projected solid angle, parallel", "calls"}
    {"concentric at most 1.3 areas", IN(MANY), CONCENTRIC, DISK_AREA, ALL_DISKS | ALL_ELLIPSES, 32,
     1.3, 0},
    {"concentric at most 1.5 areas", IN(MANY), CONCENTRIC, DISK_AREA, ALL_DISKS | ALL_ELLIPSES, 64,
     1.5, 0},
    {"parallel at most 10 areas", IN(MANY), CHORDS, DISK_AREA, ALL_DISKS | ALL_ELLIPSES, 96, 10.0,
     0},
    {"concentric 100 times as fast as Newton", IN(MANY), {"radial", "Newton"}, CONCENTRIC,
     ALL_DISKS, 96, 100.0, 1},
    {"concentric faster than a table of 64", IN(MANY), {"radial", "table 64"}, CONCENTRIC,
     ALL_DISKS, 96, 1.0, 1},
    {"concentric faster than a table of 1024", IN(MANY), {"radial", "table 1024"}, CONCENTRIC,
     ALL_DISKS, 96, 1.0, 1},
    {"concentric faster than the library's table", IN(MANY), {"solid angle, tabulated", NULL},
     CONCENTRIC, ALL_DISKS | ALL_ELLIPSES | ELLIPSOIDS, 96, 1.0, 1},
    {"concentric at most 5 areas", IN(ONE), {"solid angle, concentric", "calls"},
     {"area, concentric", "calls"}, DISKS | ELLIPSES, 32, 5.0, 0},
    {"concentric at most 4 areas", IN(WAVEFRONT), CONCENTRIC, DISK_AREA, DISKS | ELLIPSES, 32, 4.0,
     0},
    {"projected at most 300 ns", IN(MANY), FIBRE_CALLS, {NULL, NULL}, PROJECTED_CONES, 64, 300.0,
     0},
    {"projected, with build, at most 1300 ns", IN(ONE), FIBRE_CALLS, {NULL, NULL},
     PROJECTED_CONES, 64, 1300.0, 0},
    {"projected batch 5 times as fast as calls", IN(MANY), FIBRE_CALLS, FIBRES, PROJECTED_CONES, 32,
     5.0, 1},
#define TRIANGLES (1u << CASE_TRIANGLE | 1u << CASE_TRIANGLE_SMALL | 1u << CASE_TRIANGLE_WIDE)
#define PROJECTED_TRIANGLES (TRIANGLES | 1u << CASE_TRIANGLE_CUT)
#define ARVO {"solid angle, radial", NULL}
#define ARVO_CALLS {"solid angle, radial", "calls"}
#define PROJECTED {"projected solid angle, radial", NULL}
#define PROJECTED_CALLS {"projected solid angle, radial", "calls"}
#define RECTANGLES (1u << CASE_RECTANGLE | 1u << CASE_RECTANGLE_SMALL | 1u << CASE_RECTANGLE_WIDE)
#define POLYGONS (1u << CASE_POLYGON | 1u << CASE_POLYGON_SMALL | 1u << CASE_POLYGON_WIDE)
#define PROJECTED_RECTANGLES (RECTANGLES | 1u << CASE_RECTANGLE_CUT)
#define PROJECTED_POLYGONS (POLYGONS | 1u << CASE_POLYGON_CUT)
#define UFK {"solid angle, parallel", NULL}
#define UFK_CALLS {"solid angle, parallel", "calls"}
    {"triangle faster than the paper", IN(ONE), {"Arvo", "paper"}, ARVO_CALLS, TRIANGLES, 96,
     1.0, 1},
    {"triangle batch at most 0.2 calls", IN(MANY), ARVO, ARVO_CALLS, TRIANGLES, 32, 0.2, 0},
    {"triangle at most 0.15 builds and samples", REGIME_WAVEFRONT, REGIME_ONE, ARVO, ARVO_CALLS,
     TRIANGLES, 32, 0.15, 0},
    {"projected at most 6 solid angles", IN(MANY), PROJECTED_CALLS, ARVO_CALLS,
     PROJECTED_TRIANGLES | PROJECTED_RECTANGLES | PROJECTED_POLYGONS, 64, 6.0, 0},
    {"projected batch at most 0.5 calls", IN(MANY), PROJECTED, PROJECTED_CALLS,
     PROJECTED_TRIANGLES | PROJECTED_RECTANGLES | PROJECTED_POLYGONS, 96, 0.5, 0},
    {"rectangle faster than the paper", IN(ONE), {"UFK", "paper"}, UFK_CALLS, RECTANGLES, 96, 1.0,
     1},
    {"rectangle batch at most 0.3 calls", IN(MANY), UFK, UFK_CALLS, RECTANGLES, 32, 0.3, 0},
    {"rectangle at most 0.3 builds and samples", REGIME_WAVEFRONT, REGIME_ONE, UFK, UFK_CALLS,
     RECTANGLES, 32, 0.3, 0},
    {"polygon faster than the paper", IN(ONE), {"Arvo", "paper"}, ARVO_CALLS, POLYGONS, 96, 1.0,
     1},
    {"polygon batch at most 0.3 calls", IN(MANY), ARVO, ARVO_CALLS, POLYGONS, 32, 0.3, 0},
    {"polygon at most 0.3 builds and samples", REGIME_WAVEFRONT, REGIME_ONE, ARVO, ARVO_CALLS,
     POLYGONS, 32, 0.3, 0},
};

/* Whether the paper's method came close to the tolerance that it was given. */
static int held(const char *method, int which, int bits)
{
    const struct cdf_error *e;

    for (e = cdf_errors; e < cdf_errors + CDF_ERRORS; e++)
        if (e->which == which && e->bits == bits && !strcmp(e->method, method))
            return e->paper <= 3e-6;
    return 0;
}

/* In single precision the paper's method is the fastest that holds the tolerance: in many cases
   only that in double does. */
static double paper_median(enum regime regime, const char *method, int which, int bits)
{
    const double wide = median_of(regime, method, "paper", which, 64);
    const double own = median_of(regime, method, "paper", which, bits);

    return held(method, which, bits) && own < wide ? own : wide;
}

/* ns, or 1 without a method, where the bar is a time. */
static double side_median(enum regime regime, const struct side *s, int which, int bits)
{
    if (!s->method)
        return 1.0;
    if (s->how && !strcmp(s->how, "paper") && bench_cases[which].family == FAMILY_SPHERE)
        return paper_median(regime, s->method, which, bits);
    return median_of(regime, s->method, s->how ? s->how : variant_name(variant_best()), which,
                     bits);
}

static void each_bar(FILE *to, void (*print)(FILE *, const struct bar *, int which, int bits,
                                             double ratio, int met))
{
    size_t i;
    int which, bits;

    for (i = 0; i < sizeof bars / sizeof *bars; i++)
        for (which = 0; which < CASES; which++)
            for (bits = 64; bits >= 32; bits -= 32)
                if (bars[i].cases & 1u << which && bars[i].bits & bits &&
                    family_shape(bench_cases[which].family)) {
                    const struct bar *b = &bars[i];
                    const double ratio = side_median(b->regime, &b->over, which, bits) /
                                         side_median(b->regime_under, &b->under, which, bits);

                    print(to, b, which, bits, ratio,
                          b->at_least ? ratio >= b->bound : ratio <= b->bound);
                }
}

static void check_side(const struct bar *b, enum regime regime, const struct side *s, int which)
{
    size_t i;

    for (i = 0; s->method && i < job_count; i++)
        if (jobs[i].regime == regime && jobs[i].which == which &&
            !strcmp(jobs[i].method, s->method) &&
            !strcmp(jobs[i].how, s->how ? s->how : variant_name(variant_best())))
            break;
    if (s->method && i == job_count) {
        fprintf(stderr, "bar \"%s\", %s: no job %s/%s/%s\n", b->text, bench_cases[which].name,
                regime_names[regime], s->method, s->how ? s->how : variant_name(variant_best()));
        exit(1);
    }
}

void check_bars(void)
{
    size_t i;
    int which;

    for (i = 0; i < sizeof bars / sizeof *bars; i++)
        for (which = 0; which < CASES; which++)
            if (bars[i].cases & 1u << which && family_shape(bench_cases[which].family)) {
                check_side(&bars[i], bars[i].regime, &bars[i].over, which);
                check_side(&bars[i], bars[i].regime_under, &bars[i].under, which);
            }
}

static void print_row(FILE *to, const struct bar *b, int which, int bits, double ratio, int met)
{
    fprintf(to, "%-10s%-44s%-13s f%d%9.2f   %s\n", regime_names[b->regime], b->text,
            bench_cases[which].name, bits, ratio, met ? "met" : "not met");
}

void print_bars(FILE *to)
{
    fputs("\nbars: what is aimed at, and the ratio of medians\n\n", to);
    each_bar(to, print_row);
}

static void print_object(FILE *to, const struct bar *b, int which, int bits, double ratio, int met)
{
    static int count;

    fprintf(to, "%s\n  {\"regime\": \"%s\", \"bar\": \"%s\", \"case\": \"%s\", \"bits\": %d, "
                "\"ratio\": %.3f, \"met\": %s}",
            count++ ? "," : "", regime_names[b->regime], b->text,
            bench_cases[which].name, bits, ratio, met ? "true" : "false");
}

void print_bars_json(FILE *to)
{
    each_bar(to, print_object);
}
