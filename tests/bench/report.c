/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <string.h>

static const struct bench_family *family_of(int which)
{
    return &bench_families[bench_cases[which].family];
}

static int counts_builds(enum regime regime)
{
    return regime == REGIME_FOUR || regime == REGIME_ONE;
}

/* What the figures of a regime are compared with. */
static double baseline(const struct job *j)
{
    const struct bench_family *f = family_of(j->which);

    return median_of(j->regime, f->baseline,
                     counts_builds(j->regime) ? f->baseline_how : variant_name(variant_best()),
                     j->which, j->bits);
}

static void print_machine(FILE *to, const struct machine *machine, size_t rounds)
{
    size_t counts[6];
    unsigned v;

    fprintf(to, "cpu:      %s\ncompiler: %s\nflags:    %s\n", machine->cpu, machine->compiler,
            machine->flags);
    fprintf(to, "library:  0x%x, kernels", (unsigned)psc_version());
    for (v = 0; v < variant_count(); v++)
        fprintf(to, " %s%s", variant_name(variant_at(v)), variant_runs(v) ? "" : " (not on this cpu)");
    fprintf(to, ", of which it takes %s\n", variant_name(variant_best()));
    fprintf(to, "rounds:   %zu, medians of CPU time, ns per sample with direction and pdf\n",
            rounds);
    for (v = 0; v < CASES; v++)
        if (family_shape(bench_cases[v].family))
            fprintf(to, "%-10s %s\n", bench_cases[v].name, bench_cases[v].text);
    if (!family_shape(FAMILY_SPHERE))
        return;
    count_cornell(counts);
    fprintf(to, "cornell:  %zu elements: %zu below the horizon, %zu ellipse, %zu ellipse and "
                "lune, %zu lune, %zu inside\n",
            stages_f64[CASE_CORNELL].count, counts[PSC_CASE_EMPTY], counts[PSC_CASE_ELLIPSE],
            counts[PSC_CASE_ELLIPSE_AND_LUNE], counts[PSC_CASE_LUNE], counts[PSC_CASE_INSIDE]);
}

/* Rows of a table are neighbours in the list of jobs. */
static void print_table(FILE *to, enum family family, enum regime regime, int bits)
{
    const struct bench_family *f = &bench_families[family];
    const char *method = "", *how = "";
    size_t i;
    int c;

    fprintf(to, "\n%ss, %s, f%d: ns per sample, times %s (%s)\n\n%-32s", f->shape,
            regime_texts[regime], bits, f->text, counts_builds(regime) ? f->baseline_how : "library",
            "");
    for (c = 0; c < CASES; c++)
        if (bench_cases[c].family == family && !(c == CASE_CORNELL && regime == REGIME_MANY))
            fprintf(to, "%14s", bench_cases[c].name);
    for (i = 0; i < job_count; i++) {
        const struct job *j = &jobs[i];
        char label[64];

        if (j->regime != regime || j->bits != bits || bench_cases[j->which].family != family)
            continue;
        if (strcmp(method, j->method) != 0 || strcmp(how, j->how) != 0) {
            snprintf(label, sizeof label, "%s, %s", j->method, j->how);
            fprintf(to, "\n%-32s", label);
            method = j->method;
            how = j->how;
        }
        fprintf(to, "%8.*f %5.2f", j->median < 10.0 ? 2 : 1, j->median,
                j->median / baseline(j));
    }
    fputc('\n', to);
}

static void print_errors(FILE *to)
{
    const struct cdf_error *e;
    int c;

    fprintf(to, "\nlargest CDF error of the directions returned, paper's method / library\n\n%-24s",
            "");
    for (c = 0; c < CASE_CORNELL; c++)
        fprintf(to, "%18s", bench_cases[c].name);
    for (e = cdf_errors; e < cdf_errors + CDF_ERRORS; e++) {
        if (e->which == 0)
            fprintf(to, "\n%-20s f%d", e->method, e->bits);
        fprintf(to, " %8.1e /%7.0e", e->paper, e->library);
    }
    fputc('\n', to);
}

void print_tables(FILE *to, const struct machine *machine, size_t rounds)
{
    enum family family;
    enum regime regime;
    int bits;

    print_machine(to, machine, rounds);
    for (family = FAMILY_SPHERE; family < FAMILIES; family++)
        for (regime = REGIME_MANY; regime < REGIMES; regime++)
            for (bits = 64; bits >= 32 && family_shape(family); bits -= 32)
                print_table(to, family, regime, bits);
    if (family_shape(FAMILY_SPHERE))
        print_errors(to);
    print_bars(to);
}

/* A string of JSON; what is printed here has no other character that needs an escape. */
static void print_string(FILE *to, const char *s)
{
    fputc('"', to);
    for (; *s; s++)
        fprintf(to, *s == '"' || *s == '\\' ? "\\%c" : "%c", *s);
    fputc('"', to);
}

void print_json(FILE *to, const struct machine *machine, size_t rounds)
{
    size_t i;

    fputs("{\"cpu\": ", to);
    print_string(to, machine->cpu);
    fputs(", \"compiler\": ", to);
    print_string(to, machine->compiler);
    fputs(", \"flags\": ", to);
    print_string(to, machine->flags);
    fprintf(to, ", \"kernel\": \"%s\", \"rounds\": %zu,\n\"jobs\": [", variant_name(variant_best()),
            rounds);
    for (i = 0; i < job_count; i++) {
        const struct job *j = &jobs[i];

        fprintf(to, "%s\n  {\"shape\": \"%s\", \"regime\": \"%s\", \"method\": \"%s\", \"how\": \"%s\", "
                    "\"case\": \"%s\", \"bits\": %d, \"ns\": %.4g, \"quartiles\": [%.4g, %.4g]}",
                i ? "," : "", j->shape->name, regime_names[j->regime], j->method, j->how,
                bench_cases[j->which].name, j->bits, j->median, j->low, j->high);
    }
    fputs("],\n\"cdf_errors\": [", to);
    for (i = 0; i < CDF_ERRORS && family_shape(FAMILY_SPHERE); i++) {
        const struct cdf_error *e = &cdf_errors[i];

        fprintf(to, "%s\n  {\"method\": \"%s\", \"case\": \"%s\", \"bits\": %d, \"paper\": %.3g, "
                    "\"library\": %.3g}",
                i ? "," : "", e->method, bench_cases[e->which].name, e->bits, e->paper,
                e->library);
    }
    fputs("],\n\"bars\": [", to);
    print_bars_json(to);
    fputs("]}\n", to);
}
