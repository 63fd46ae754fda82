/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The benchmark: jobs that all take samples of the same lights, run in turn over and over, so
 * that what else the machine does falls on all of them alike; medians, and ratios of medians.
 */
#ifndef PSC_TESTS_BENCH_H
#define PSC_TESTS_BENCH_H

#include <stddef.h>
#include <stdio.h>

#include "../shapes.h"
#include "../variants.h"

/* ---- The lights that are sampled: stage.c, cornell.c ---- */

/* Shapes that are compared with each other and share their rivals. */
enum family { FAMILY_SPHERE, FAMILY_DISK, FAMILY_ELLIPSE, FAMILY_ELLIPSOID, FAMILY_TRIANGLE,
              FAMILY_RECTANGLE, FAMILY_POLYGON, FAMILIES };

extern const struct bench_family {
    const char *shape; /* as the table of shapes calls it */
    /* What ratios are to: a method of the library, and whose it is when builds count. */
    const char *baseline, *baseline_how, *text;
} bench_families[FAMILIES];

/* The one family to time, by its shape's name; 0 if there is none such. All, unless told. */
int choose_family(const char *shape);

/* The shape of a family; NULL if the library has none such, or it is not to be timed. */
const struct shape *family_shape(enum family family);

/* Lights that fill a half-angle, their middle at one elevation, seen by receivers of all
   orientations and scales, or the mix that the surfaces of a Cornell box see of four spheres. */
enum {
    CASE_ELLIPSE, CASE_MIXED, CASE_LUNE, CASE_THIN, CASE_SUN, CASE_CORNELL,
    CASE_DISK, CASE_DISK_SMALL, CASE_DISK_WIDE, CASE_DISK_CUT,
    CASE_ELLIPSE_DISK, CASE_ELLIPSE_DISK_SMALL, CASE_ELLIPSE_DISK_WIDE, CASE_ELLIPSE_DISK_CUT,
    CASE_ELLIPSOID, CASE_ELLIPSOID_SMALL, CASE_ELLIPSOID_WIDE, CASE_ELLIPSOID_CUT,
    CASE_TRIANGLE, CASE_TRIANGLE_SMALL, CASE_TRIANGLE_WIDE, CASE_TRIANGLE_CUT,
    CASE_RECTANGLE, CASE_RECTANGLE_SMALL, CASE_RECTANGLE_WIDE, CASE_RECTANGLE_CUT,
    CASE_POLYGON, CASE_POLYGON_SMALL, CASE_POLYGON_WIDE, CASE_POLYGON_CUT,
    CASES
};

extern const struct bench_case {
    enum family family;
    const char *name, *text;
    double alpha, beta;
} bench_cases[CASES];

enum { STAGE_MANY = 1024, STAGE_MAX = 4096, LIGHT_MAX = 15 };

/* Elements in separate arrays, not a power of two apart. */
#define STAGE(bits, type)                                                         \
    struct stage_f##bits {                                                        \
        size_t count;                                                             \
        type position[3][STAGE_MAX + 40], normal[3][STAGE_MAX + 40];               \
        type light[LIGHT_MAX][STAGE_MAX + 40]; /* the numbers of the geometry */   \
        type u[STAGE_MAX + 40], v[STAGE_MAX + 40];                                \
        type direction[3][STAGE_MAX + 40], pdf[STAGE_MAX + 40]; /* what comes out */ \
    };
STAGE(32, float)
STAGE(64, double)

extern struct stage_f32 stages_f32[CASES];
extern struct stage_f64 stages_f64[CASES];

void make_stages(void);

/* Element i of the Cornell mix. */
void place_in_cornell(uint64_t *state, size_t i, struct light *light);

/* How many elements of the Cornell mix are in each psc_case. */
void count_cornell(size_t counts[6]);

/* ---- The jobs: jobs.c ---- */

enum regime { REGIME_MANY, REGIME_FOUR, REGIME_ONE, REGIME_WAVEFRONT, REGIMES };

extern const char *const regime_names[REGIMES], *const regime_texts[REGIMES];

struct job {
    enum regime regime;
    const char *method; /* what is sampled, and by whom */
    const char *how;    /* which calls, or the instruction set of the loop */
    int which, bits;
    size_t (*run)(struct job *job); /* returns the number of samples */
    const struct shape *shape;
    int numbers; /* of its geometry */
    psc_technique technique;
    const struct psc_variant *variant;
    size_t turn; /* which light is next */

    size_t repeat;            /* runs in one timing */
    double *times;            /* ns per sample, one of each round; sorted in the end */
    double median, low, high; /* and the quartiles */
};

extern struct job jobs[];
extern size_t job_count;

void make_jobs(void);

/* ---- Timing: measure.c ---- */

#define SLICE 4e5 /* ns of one timing, of which the clock is a small part */

/* Sets repeat so that a timing takes a slice; also warms up. */
void calibrate_job(struct job *job);

/* One timing: ns per sample. */
double time_job(struct job *job);

/* Runs every job in each round, in turns; fills the medians. 0 if memory runs out. */
int measure_jobs(size_t rounds);

/* The median of a job, or 0 if there is none such; how NULL: of the fastest way. A rival that
   needs double precision has one median for both. */
double median_of(enum regime regime, const char *method, const char *how, int which, int bits);

/* ---- CDF errors: errors.c ---- */

/* The largest errors in t of samples of a case, told by the library's inverse. */
struct cdf_error {
    const char *method;
    int which, bits;
    double paper, library;
};

/* Of two maps, in both precisions, for the cases of spheres before the mix. */
enum { CDF_ERRORS = 2 * 2 * CASE_CORNELL };

extern struct cdf_error cdf_errors[CDF_ERRORS];

void measure_errors(void);

/* ---- What is printed: machine.c, report.c, bars.c ---- */

struct machine {
    char cpu[128];
    const char *compiler, *flags;
};

void describe_machine(struct machine *machine);
void print_tables(FILE *to, const struct machine *machine, size_t rounds);
void print_json(FILE *to, const struct machine *machine, size_t rounds);

/* The bars: ratios that the kernels are meant to reach; the check ends the program if one is of a
   job that there is not. */
void check_bars(void);
void print_bars(FILE *to);
void print_bars_json(FILE *to);

#endif
