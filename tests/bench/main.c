/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

static int usage(const char *program)
{
    fprintf(stderr,
            "usage: %s [--quick] [--rounds N] [--json FILE] [--shape SHAPE] [--only JOB]\n"
            "Times the library's sampling against that of others and prints ratios.\n"
            "  --quick      fewer rounds: noisier\n"
            "  --rounds N   how often everything is timed, 41 unless told\n"
            "  --json FILE  also writes all figures to FILE (- for the output, in place of the "
            "tables)\n"
            "  --shape SHAPE  times lights of that shape alone: sphere, disk, ellipse, ellipsoid,\n"
            "               triangle, rectangle or 5-gon\n"
            "  --only JOB   runs one job for a second, for a profiler to look at: its regime,\n"
            "               method, calls, case and bits, as in one/radial/calls/ellipse/64\n",
            program);
    return 2;
}

/* The job of a name, for a second. */
static int run_only(const char *name)
{
    char own[128];
    size_t i, run;

    for (i = 0; i < job_count; i++) {
        struct job *j = &jobs[i];

        snprintf(own, sizeof own, "%s/%s/%s/%s/%d", regime_names[j->regime], j->method, j->how,
                 bench_cases[j->which].name, j->bits);
        if (strcmp(own, name) != 0)
            continue;
        calibrate_job(j);
        for (run = 0; run < (size_t)(1e9 / SLICE); run++)
            time_job(j);
        printf("%s: %.3g ns per sample\n", name, time_job(j));
        return 0;
    }
    fprintf(stderr, "no such job: %s\n", name);
    return 2;
}

int main(int argc, char **argv)
{
    struct machine machine;
    const char *json = NULL, *only = NULL;
    size_t rounds = 41;
    FILE *file;
    int i;

    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--quick"))
            rounds = 9;
        else if (!strcmp(argv[i], "--rounds") && i + 1 < argc)
            rounds = strtoul(argv[++i], NULL, 10);
        else if (!strcmp(argv[i], "--json") && i + 1 < argc)
            json = argv[++i];
        else if (!strcmp(argv[i], "--shape") && i + 1 < argc && choose_family(argv[i + 1]))
            i++;
        else if (!strcmp(argv[i], "--only") && i + 1 < argc)
            only = argv[++i];
        else
            return usage(argv[0]);
    }
    if (rounds == 0)
        return usage(argv[0]);
    describe_machine(&machine);
    make_stages();
    make_jobs();
    if (only)
        return run_only(only);
    check_bars();
    if (!measure_jobs(rounds)) {
        fprintf(stderr, "%s: out of memory\n", argv[0]);
        return 1;
    }
    if (family_shape(FAMILY_SPHERE))
        measure_errors();
    if (!json || strcmp(json, "-") != 0)
        print_tables(stdout, &machine, rounds);
    if (json) {
        file = strcmp(json, "-") == 0 ? stdout : fopen(json, "w");
        if (!file) {
            perror(json);
            return 1;
        }
        print_json(file, &machine, rounds);
        if (file != stdout && fclose(file) != 0) {
            perror(json);
            return 1;
        }
    }
    return 0;
}
