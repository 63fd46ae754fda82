/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

#include "../calls.h"

#define BITS 64
#include "../real.h"
#include "vectors_tmpl.h"
#include "cone_tmpl.h"
#include "paper_tmpl.h"
#include "runs_tmpl.h"

#undef BITS
#define BITS 32
#include "../real.h"
#include "vectors_tmpl.h"
#include "cone_tmpl.h"
#include "paper_tmpl.h"
#include "runs_tmpl.h"

const char *const regime_names[REGIMES] = {"many", "four", "one", "wavefront"};
const char *const regime_texts[REGIMES] = {
    "1024 samples of each build", "4 samples of each build", "1 sample of each build",
    "wavefront: build and sample of each element in one call"};

enum { JOBS_MAX = 1024 };

struct job jobs[JOBS_MAX];
size_t job_count;

typedef size_t (*run)(struct job *job);

/* One row of a table: the same in every case and both precisions. */
static void add_row(enum regime regime, const char *method, const char *how, run f64, run f32,
                    const struct test_technique *what, const struct psc_variant *variant)
{
    int which, bits;

    for (bits = 64; bits >= 32; bits -= 32)
        for (which = 0; which < CASES; which++) {
            struct job *j = &jobs[job_count];

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
            if (what)
                j->technique = make_technique(what->measure, what->map);
            j->variant = variant;
        }
}

static void add_rivals(enum regime regime)
{
    const struct psc_variant *v = variant_best();

    add_row(regime, "copy", "memcpy", run_copy_f64, run_copy_f32, NULL, v);
    add_row(regime, "cone", "libm", run_cone_f64, run_cone_f32, NULL, v);
    add_row(regime, "cone and hit", "libm", run_cone_hit_f64, run_cone_hit_f32, NULL, v);
    add_row(regime, "radial", "paper", run_paper_radial_f64, run_paper_radial_f32, NULL, v);
    add_row(regime, "parallel", "paper", run_paper_parallel_f64, run_paper_parallel_f32, NULL, v);
}

void make_jobs(void)
{
    static const struct {
        const char *name;
        struct test_technique what;
    } methods[] = {
        {"cone", {"", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL}},
        {"radial", {"", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL}},
        {"parallel", {"", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL}},
        {"concentric", {"", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC}},
    };
    enum regime regime;
    size_t m;
    unsigned v;

    for (regime = REGIME_MANY; regime < REGIMES; regime++) {
        add_rivals(regime);
        for (m = 0; m < sizeof methods / sizeof *methods; m++) {
            if (regime != REGIME_WAVEFRONT)
                add_row(regime, methods[m].name, "calls", run_calls_f64, run_calls_f32,
                        &methods[m].what, variant_best());
            if (regime == REGIME_FOUR)
                add_row(regime, methods[m].name, "batch", run_batch_f64, run_batch_f32,
                        &methods[m].what, variant_best());
            for (v = 0; v < variant_count(); v++)
                if ((regime == REGIME_MANY || regime == REGIME_WAVEFRONT) && variant_runs(v))
                    add_row(regime, methods[m].name, variant_name(variant_at(v)),
                            regime == REGIME_MANY ? run_batch_f64 : run_wavefront_f64,
                            regime == REGIME_MANY ? run_batch_f32 : run_wavefront_f32,
                            &methods[m].what, variant_at(v));
        }
    }
}
