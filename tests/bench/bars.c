/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <string.h>

/* One ratio of two jobs of a regime, and how large or small it is meant to be. */
struct side {
    const char *method, *how; /* how NULL: the kernel that the library takes */
};

static const struct bar {
    const char *text;
    enum regime regime;
    struct side over, under;
    unsigned cases; /* a set of 1 << case */
    int bits;       /* 32, 64 or both (96) */
    double bound;
    int at_least;
} bars[] = {
#define ELLIPSE (1u << CASE_ELLIPSE)
#define MIXED (1u << CASE_MIXED | 1u << CASE_SUN)
#define LUNES (1u << CASE_LUNE | 1u << CASE_THIN)
#define OWN {"radial", NULL}
#define CONE {"cone", NULL}
#define OF_PAPER {"radial", "paper"}
    {"radial at most 1.3 cones", REGIME_MANY, OWN, CONE, ELLIPSE, 96, 1.3, 0},
    {"radial at most 2 cones", REGIME_MANY, OWN, CONE, MIXED, 32, 2.0, 0},
    {"radial at most 4 cones", REGIME_MANY, OWN, CONE, MIXED, 64, 4.0, 0},
    {"radial at most 10 cones", REGIME_MANY, OWN, CONE, LUNES, 64, 10.0, 0},
    {"radial 20 times as fast as the paper", REGIME_MANY, OF_PAPER, OWN, MIXED, 96, 20.0, 1},
    {"radial 10 times as fast as the paper", REGIME_MANY, OF_PAPER, OWN, LUNES, 96, 10.0, 1},
    {"parallel 3 times as fast as the paper", REGIME_MANY, {"parallel", "paper"},
     {"parallel", NULL}, ELLIPSE | MIXED | LUNES, 96, 3.0, 1},
    {"concentric at most 1.5 radial", REGIME_MANY, {"concentric", NULL}, OWN,
     ELLIPSE | MIXED | LUNES, 96, 1.5, 0},
    {"radial at most 1.2 libm cones", REGIME_ONE, {"radial", "calls"}, {"cone", "libm"}, ELLIPSE,
     96, 1.2, 0},
    {"radial 2.5 times as fast as the paper", REGIME_ONE, OF_PAPER, {"radial", "calls"}, MIXED,
     96, 2.5, 1},
    {"radial 1.5 times as fast as the paper", REGIME_ONE, OF_PAPER, {"radial", "calls"}, LUNES,
     96, 1.5, 1},
    {"parallel no slower than the paper", REGIME_ONE, {"parallel", "paper"},
     {"parallel", "calls"}, ELLIPSE | MIXED | LUNES, 96, 1.0, 1},
    {"radial at most 2.5 cones", REGIME_WAVEFRONT, OWN, CONE, 1u << CASE_CORNELL, 32, 2.5, 0},
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
static double paper_median(const struct bar *b, const char *method, int which, int bits)
{
    const double wide = median_of(b->regime, method, "paper", which, 64);
    const double own = median_of(b->regime, method, "paper", which, bits);

    return held(method, which, bits) && own < wide ? own : wide;
}

static double side_median(const struct bar *b, const struct side *s, int which, int bits)
{
    if (s->how && !strcmp(s->how, "paper"))
        return paper_median(b, s->method, which, bits);
    return median_of(b->regime, s->method, s->how ? s->how : variant_name(variant_best()), which,
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
                if (bars[i].cases & 1u << which && bars[i].bits & bits) {
                    const struct bar *b = &bars[i];
                    const double ratio = side_median(b, &b->over, which, bits) /
                                         side_median(b, &b->under, which, bits);

                    print(to, b, which, bits, ratio,
                          b->at_least ? ratio >= b->bound : ratio <= b->bound);
                }
}

static void print_row(FILE *to, const struct bar *b, int which, int bits, double ratio, int met)
{
    fprintf(to, "%-10s%-40s%-9s f%d%9.2f   %s\n", regime_names[b->regime], b->text,
            bench_cases[which].name, bits, ratio, met ? "met" : "not met");
}

void print_bars(FILE *to)
{
    fputs("\nbars: what is aimed at, and the ratio of medians\n\n", to);
    each_bar(to, print_row);
}

static void print_object(FILE *to, const struct bar *b, int which, int bits, double ratio, int met)
{
    fprintf(to, "%s\n  {\"regime\": \"%s\", \"bar\": \"%s\", \"case\": \"%s\", \"bits\": %d, "
                "\"ratio\": %.3f, \"met\": %s}",
            b == bars && bits == 64 ? "" : ",", regime_names[b->regime], b->text,
            bench_cases[which].name, bits, ratio, met ? "true" : "false");
}

void print_bars_json(FILE *to)
{
    each_bar(to, print_object);
}
