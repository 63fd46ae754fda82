/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Time that this process was given, so that others on the machine do not count. */
static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

double time_job(struct job *job)
{
    size_t samples = 0, i;
    double start;

    variant_use(job->variant);
    start = now();
    for (i = 0; i < job->repeat; i++)
        samples += job->run(job);
    return (now() - start) / (double)samples;
}

void calibrate_job(struct job *job)
{
    double start;

    variant_use(job->variant);
    for (job->repeat = 1;; job->repeat *= 2) {
        start = now();
        time_job(job);
        if (now() - start >= SLICE || job->repeat > 1u << 20)
            return;
    }
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

int measure_jobs(size_t rounds)
{
    size_t i, round;
    double *times = malloc(job_count * rounds * sizeof *times);

    if (!times)
        return 0;
    for (i = 0; i < job_count; i++) {
        jobs[i].times = times + i * rounds;
        calibrate_job(&jobs[i]);
    }
    for (round = 0; round < rounds; round++)
        for (i = 0; i < job_count; i++)
            jobs[i].times[round] = time_job(&jobs[i]);
    for (i = 0; i < job_count; i++) {
        qsort(jobs[i].times, rounds, sizeof *times, compare);
        jobs[i].median = jobs[i].times[rounds / 2];
        jobs[i].low = jobs[i].times[rounds / 4];
        jobs[i].high = jobs[i].times[3 * rounds / 4];
        jobs[i].times = NULL;
    }
    free(times);
    return 1;
}

double median_of(enum regime regime, const char *method, const char *how, int which, int bits)
{
    double best = 0.0;
    size_t i;

    for (i = 0; i < job_count; i++) {
        const struct job *j = &jobs[i];

        if (j->regime == regime && j->which == which && j->bits == bits &&
            !strcmp(j->method, method) && (!how || !strcmp(j->how, how)) &&
            (best == 0.0 || j->median < best))
            best = j->median;
    }
    return best == 0.0 && bits == 32 ? median_of(regime, method, how, which, 64) : best;
}
