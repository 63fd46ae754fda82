/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

#include "disk_paper.h"

#define BITS 64
#include "../real.h"
#include "vectors_tmpl.h"
#include "cone_tmpl.h"
#include "paper_tmpl.h"
#include "polygons_plain_tmpl.h"
#include "runs_tmpl.h"
#include "rivals_tmpl.h"

/* In double precision alone. */
RIVAL(run_disk_newton, spherical_ellipse, 7, disk_build, disk_sample)
RIVAL(run_disk_table_64, spherical_ellipse, 7, disk_build, disk_table_64)
RIVAL(run_disk_table_256, spherical_ellipse, 7, disk_build, disk_table_256)
RIVAL(run_disk_table_1024, spherical_ellipse, 7, disk_build, disk_table_1024)

#undef BITS
#define BITS 32
#include "../real.h"
#include "vectors_tmpl.h"
#include "cone_tmpl.h"
#include "paper_tmpl.h"
#include "polygons_plain_tmpl.h"
#include "runs_tmpl.h"
#include "rivals_tmpl.h"

const char *const regime_names[REGIMES] = {"many", "four", "one", "wavefront"};
const char *const regime_texts[REGIMES] = {
    "1024 samples of each build", "4 samples of each build", "1 sample of each build",
    "wavefront: build and sample of each element in one call"};

enum { JOBS_MAX = 4096 };

struct job jobs[JOBS_MAX];
size_t job_count;

typedef size_t (*run)(struct job *job);

/* One row of a table: the same in every case of the family and both precisions. */
static void add_row(enum family family, enum regime regime, const char *method, const char *how,
                    run f64, run f32, const struct test_technique *what,
                    const struct psc_variant *variant)
{
    int which, bits;

    for (bits = 64; bits >= 32; bits -= 32)
        for (which = 0; which < CASES; which++) {
            struct job *j = &jobs[job_count];

            if (bench_cases[which].family != family || !(bits == 64 ? f64 : f32))
                continue;
            if (regime == REGIME_MANY && which == CASE_CORNELL)
                continue; /* every point is a build of its own there */
            if (++job_count > JOBS_MAX)
                abort();
            j->regime = regime;
            j->method = method;
            j->how = how;
            j->which = which;
            j->bits = bits;
            j->run = bits == 64 ? f64 : f32;
            j->shape = family_shape(family);
            j->numbers = geometry_size(j->shape);
            if (what)
                j->technique = make_technique(what->measure, what->map);
            j->variant = variant;
        }
}

static void add_rivals(enum regime regime)
{
    static const struct {
        enum family family;
        const char *method, *how;
        run f64, f32;
    } rivals[] = {
        {FAMILY_SPHERE, "copy", "memcpy", run_copy_f64, run_copy_f32},
        {FAMILY_SPHERE, "cone", "libm", run_cone_f64, run_cone_f32},
        {FAMILY_SPHERE, "cone and hit", "libm", run_cone_hit_f64, run_cone_hit_f32},
        {FAMILY_SPHERE, "radial", "paper", run_paper_radial_f64, run_paper_radial_f32},
        {FAMILY_SPHERE, "parallel", "paper", run_paper_parallel_f64, run_paper_parallel_f32},
        {FAMILY_DISK, "radial", "Newton", run_disk_newton_f64, NULL},
        {FAMILY_DISK, "radial", "table 64", run_disk_table_64_f64, NULL},
        {FAMILY_DISK, "radial", "table 256", run_disk_table_256_f64, NULL},
        {FAMILY_DISK, "radial", "table 1024", run_disk_table_1024_f64, NULL},
        {FAMILY_TRIANGLE, "Arvo", "paper", run_triangle_arvo_f64, run_triangle_arvo_f32},
        {FAMILY_TRIANGLE, "area", "plain", run_triangle_area_f64, run_triangle_area_f32},
        {FAMILY_RECTANGLE, "UFK", "paper", run_rectangle_ufk_f64, run_rectangle_ufk_f32},
        {FAMILY_RECTANGLE, "area", "plain", run_rectangle_area_f64, run_rectangle_area_f32},
        {FAMILY_POLYGON, "Arvo", "paper", run_pentagon_arvo_f64, run_pentagon_arvo_f32},
        {FAMILY_POLYGON, "area", "plain", run_pentagon_area_f64, run_pentagon_area_f32},
    };
    size_t i;

    for (i = 0; i < sizeof rivals / sizeof *rivals; i++)
        if (family_shape(rivals[i].family))
            add_row(rivals[i].family, regime, rivals[i].method, rivals[i].how, rivals[i].f64,
                    rivals[i].f32, NULL, variant_best());
}

/* All ways to call the library. Instruction sets are compared on spheres. */
static void add_method(enum family family, enum regime regime, const char *name,
                       const struct test_technique *what)
{
    const int arrays = regime == REGIME_MANY || regime == REGIME_WAVEFRONT;
    unsigned v;

    if (regime != REGIME_WAVEFRONT)
        add_row(family, regime, name, "calls", run_calls_f64, run_calls_f32, what,
                variant_best());
    if (regime == REGIME_FOUR)
        add_row(family, regime, name, "batch", run_batch_f64, run_batch_f32, what,
                variant_best());
    for (v = 0; v < variant_count() && arrays; v++)
        if (variant_runs(v) && (family == FAMILY_SPHERE || variant_at(v) == variant_best()))
            add_row(family, regime, name, variant_name(variant_at(v)),
                    regime == REGIME_MANY ? run_batch_f64 : run_wavefront_f64,
                    regime == REGIME_MANY ? run_batch_f32 : run_wavefront_f32, what,
                    variant_at(v));
}

void make_jobs(void)
{
    static const struct test_technique spheres[] = {
        {"cone", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
        {"radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
        {"parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
        {"concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
        {NULL, 0, 0},
    };
    enum regime regime;
    enum family family;

    if (family_shape(FAMILY_DISK))
        make_disk_tables();
    for (regime = REGIME_MANY; regime < REGIMES; regime++) {
        add_rivals(regime);
        for (family = FAMILY_SPHERE; family < FAMILIES; family++) {
            const struct shape *shape = family_shape(family);
            const struct test_technique *what = !shape                    ? NULL
                                                : family == FAMILY_SPHERE ? spheres
                                                                          : shape->techniques;

            for (; what && what->name; what++)
                add_method(family, regime, what->name, what);
        }
    }
}
