/* SPDX-License-Identifier: Apache-2.0 */
#include "evaluate.h"

#include <stdlib.h>
#include <string.h>

/* Pictures are kept at 1 and 4 samples; at these, times are medians. */
enum { PICTURES = 2, REPEATS = 32 };

/* Where what is exact is known, each technique has this share of a reference's samples to get
   there; projected solid angle needs none, for each of its samples is there. */
enum { CHECKS = 4 };

static unsigned check_samples(const options *o, const technique_row *t)
{
    return t->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ? 0 : o->reference / CHECKS;
}

static const unsigned pictured[PICTURES] = {1, 4};

/* An unoccluded estimate is the sum of totals rounded to float, each right within this. */
static const double rounding = 0x1p-23;

typedef struct evaluation {
    const options *options;
    scene scene;
    const technique_row *techniques;
    unsigned technique_count;
    frame frame;
    irradiance reference, light, other;
    double uncertainty; /* of a sampled reference: its own RMS error, from its two halves */
    curve curves[TECHNIQUES];
    double deviation[TECHNIQUES]; /* worst relative one from what is exact */
    double singly[TECHNIQUES];    /* seconds of one sample a pixel by single calls */
    panel panels[PICTURES * (TECHNIQUES + 1)]; /* rows of technique_count + 1 */
    double done, work;
    unsigned failures;
} evaluation;

static void advance(evaluation *e, double samples)
{
    e->done += samples;
    progress(e->scene.name, e->done < e->work ? e->done / e->work : 1);
}

static void fail(evaluation *e, const char *words)
{
    printf("  FAILED: %s\n", words);
    ++e->failures;
}

static sampling sample_with(const evaluation *e, unsigned technique, unsigned count)
{
    const technique_row *row = &e->techniques[technique];
    return (sampling){.technique = {.struct_size = sizeof(psc_technique), .measure = row->measure,
                                    .map = row->map},
                      .set = e->options->set,
                      .seed = e->options->seed,
                      .count = count};
}

static size_t hit_count(const evaluation *e)
{
    return e->frame.first[LAYERS];
}

/* ---- The reference ----------------------------------------------------------------------- */

/* Two independent halves of count samples at each hit. */
static void render_halves(evaluation *e, unsigned technique, unsigned count)
{
    irradiance half[2] = {e->light, e->other};
    for (unsigned h = 0; h < 2; ++h) {
        sampling how = sample_with(e, technique, count / 2);
        how.set = POINTS_SOBOL;
        how.seed = mix(e->options->seed + 0x51ed270bu + h);
        how.every_layer = 1;
        shade(&e->frame, &how, half[h]);
        advance(e, LAYERS * how.count);
    }
}

/* The normal deviate that is as rare as Student's t of a number of degrees of freedom [D. Wallace,
   Bounds on normal approximations to Student's and the chi-square distributions, 1959]. */
static double normal_from_t(double t, double freedom)
{
    return (8 * freedom + 1) / (8 * freedom + 3) * sqrt(freedom * log1p(t * t / freedom));
}

/* How far the mean of the two halves is from what is exact, in standard deviations, in the worst
   of the parts that the hits are cut into. The halves tell the deviation, each hit with one degree
   of freedom; where few hits near a light have most of it, few are all there are [Satterthwaite
   1946]. */
static double worst_bias(const evaluation *e)
{
    const irradiance a = e->light, b = e->other;
    const size_t count = hit_count(e), most = count / 500 + 1, parts = most < 64 ? most : 64;
    double worst = 0;

    for (size_t part = 0; part < parts; ++part) {
        double bias = 0, variance = 0, squares = 0, total = 0;
        for (size_t i = part * count / parts; i < (part + 1) * count / parts; ++i) {
            const double v = (a[i][0] - b[i][0]) * (a[i][0] - b[i][0]) / 4;
            bias += (a[i][0] + b[i][0]) / 2 - e->reference[i][0];
            variance += v;
            squares += v * v;
            total += e->reference[i][0];
        }
        const double t = fabs(bias) / (sqrt(variance) + rounding * total);
        worst = fmax(worst, squares > 0 ? normal_from_t(t, variance * variance / squares) : t);
    }
    return worst;
}

/* Where nothing occludes, what is exact, which samples of every technique must converge to;
   elsewhere many samples of one technique. */
static void make_reference(evaluation *e)
{
    const unsigned best = e->scene.comparison->reference;

    if (e->scene.open) {
        double worst[TECHNIQUES] = {0};
        shade_exactly(&e->frame, e->reference);
        printf("  reference: exact; in the worst part of the picture samples differ from it by, in "
               "standard\n  deviations:");
        for (unsigned t = 0; t < e->technique_count; ++t) {
            const unsigned count = check_samples(e->options, &e->techniques[t]);
            if (count == 0)
                continue;
            render_halves(e, t, count);
            worst[t] = worst_bias(e);
            printf("%s %s %.1f", t ? ";" : "", e->techniques[t].name, worst[t]);
        }
        printf("\n");
        for (unsigned t = 0; t < e->technique_count; ++t)
            if (!(worst[t] < 5))
                fail(e, "samples do not converge to what is exact");
        return;
    }
    render_halves(e, best, e->options->reference);
    e->uncertainty = picture_rms(&e->frame, e->light, e->other, LAYERS, NULL) / 2;
    printf("  reference: %u samples a pixel, %s, their own RMS error %.2g\n",
           LAYERS * (e->options->reference / 2 * 2), e->techniques[best].name, e->uncertainty);
    for (size_t i = 0; i < hit_count(e); ++i)
        for (int c = 0; c < 3; ++c)
            e->reference[i][c] = (e->light[i][c] + e->other[i][c]) / 2;
}

/* ---- Rendering --------------------------------------------------------------------------- */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, unsigned count)
{
    qsort(values, count, sizeof *values, by_size);
    return count % 2 ? values[count / 2] : (values[count / 2 - 1] + values[count / 2]) / 2;
}

/* Infinite for a NaN, and for light where there is exactly none. */
static double worst_deviation(const evaluation *e, unsigned count)
{
    double worst = 0;
    for (unsigned k = 0; k < LAYERS && frame_share(k, count); ++k)
        for (size_t i = e->frame.first[k]; i < e->frame.first[k + 1]; ++i)
            for (int c = 0; c < 3; ++c) {
                const double exact = e->reference[i][c], error = fabs(e->light[i][c] - exact);
                if (error == 0)
                    continue;
                if (!(error / exact < INFINITY))
                    return INFINITY;
                worst = fmax(worst, error / exact);
            }
    return worst;
}

static void keep_panel(evaluation *e, unsigned row, unsigned column, double rms, const char *name)
{
    panel *p = &e->panels[row * (e->technique_count + 1) + column];
    const unsigned count = pictured[row];
    const int sampled = column < e->technique_count;
    const char *digits = rms < 1e-4 ? "RMS %.1e" : "RMS %.4f";

    *p = (panel){.width = e->frame.width, .height = e->frame.height};
    memcpy(p->crops, e->scene.crops, sizeof p->crops);
    p->pixels = picture_make(&e->frame, sampled ? e->light : e->reference,
                             sampled ? count : LAYERS);
    if (!sampled) {
        snprintf(p->heading, sizeof p->heading, "%s", name);
        return;
    }
    snprintf(p->heading, sizeof p->heading, "%s, %u spp", name, count);
    snprintf(p->label, sizeof p->label, digits, rms);
    for (int i = 0; i < 2; ++i)
        snprintf(p->crop_label[i], sizeof p->crop_label[i], digits,
                 picture_rms(&e->frame, e->light, e->reference, count, &e->scene.crops[i]));
}

/* All techniques at this many samples, taken in turn so that the machine's mood is shared. */
static void render(evaluation *e, unsigned count, unsigned row)
{
    double seconds[TECHNIQUES][REPEATS];
    const unsigned repeats = row < PICTURES ? e->options->repeat : 1;

    for (unsigned r = 0; r < repeats; ++r)
        for (unsigned t = 0; t < e->technique_count; ++t) {
            const sampling how = sample_with(e, t, count);
            seconds[t][r] = shade(&e->frame, &how, e->light);
            advance(e, count);
            if (r + 1 < repeats)
                continue;
            curve *c = &e->curves[t];
            c->samples[c->count] = count;
            c->seconds[c->count] = median(seconds[t], repeats);
            c->rms[c->count] = picture_rms(&e->frame, e->light, e->reference, count, NULL);
            if (row < PICTURES)
                keep_panel(e, row, t, c->rms[c->count], e->techniques[t].name);
            if (e->scene.open)
                e->deviation[t] = fmax(e->deviation[t], worst_deviation(e, count));
            ++c->count;
        }
    if (row < PICTURES)
        keep_panel(e, row, e->technique_count, 0, "reference");
}

/* The same by one build call and one sample call a point: the same bits, at another price. */
static void render_singly(evaluation *e)
{
    for (unsigned t = 0; t < e->technique_count; ++t) {
        sampling how = sample_with(e, t, 1);
        shade(&e->frame, &how, e->light);
        how.singly = 1;
        e->singly[t] = shade(&e->frame, &how, e->other);
        advance(e, 2);
        if (memcmp(e->light, e->other, hit_count(e) * sizeof *e->light))
            fail(e, "single calls and wavefront calls differ");
    }
}

/* ---- The table --------------------------------------------------------------------------- */

/* The error of the first technique at any number of samples: a power law between the measured
   ones, and beyond the last of them. */
static double baseline_rms(const curve *c, double samples)
{
    unsigned i = 0;
    while (i + 2 < c->count && c->samples[i + 1] < samples)
        ++i;
    const double power = log(c->rms[i + 1] / c->rms[i]) / log(c->samples[i + 1] / c->samples[i]);
    return c->rms[i] * pow(samples / c->samples[i], power);
}

static void print_table(evaluation *e)
{
    const curve *base = &e->curves[0];

    char heading[64];
    snprintf(heading, sizeof heading, "as a ratio to %s", e->techniques[0].name);
    printf("\n  %29s %35s\n", "", heading);
    printf("  spp  %-22s %9s %9s %9s  %8s %6s %9s %9s\n", "sampling", "RMS error", "seconds",
           "ns/sample", "RMS", "time", "effic.", "RMS*");
    for (unsigned row = 0; row < PICTURES; ++row)
        for (unsigned t = 0; t < e->technique_count; ++t) {
            const curve *c = &e->curves[t];
            unsigned i = 0;
            size_t samples = 0;
            while (c->samples[i] < pictured[row])
                ++i;
            for (unsigned k = 0; k < LAYERS; ++k)
                samples += (e->frame.first[k + 1] - e->frame.first[k]) *
                           frame_share(k, pictured[row]) * e->scene.light_count;
            const double rms = c->rms[i] / base->rms[i], time = c->seconds[i] / base->seconds[i];
            const double equal = c->rms[i] / baseline_rms(base, time * pictured[row]);
            printf("  %3u  %-22s %9.3g %9.4f %9.0f  %8.3g %6.2f %9.3g %9.3g\n", pictured[row],
                   e->techniques[t].name, c->rms[i], c->seconds[i],
                   1e9 * c->seconds[i] / (double)samples, rms, time, 1 / (rms * rms * time), equal);
            if (e->techniques[t].measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE && !(rms < 1))
                fail(e, "projected solid angle has more error at equal samples");
        }
    printf("  by single calls, 1 spp, seconds:");
    for (unsigned t = 0; t < e->technique_count; ++t)
        printf("%s %s %.3f", t ? "," : "", e->techniques[t].name, e->singly[t]);
    printf("\n");
    for (unsigned t = 0; e->scene.open && t < e->technique_count; ++t) {
        if (e->techniques[t].measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            continue;
        printf("  %s: worst relative deviation from what is exact %.2g\n",
               e->techniques[t].name, e->deviation[t]);
        if (!(e->deviation[t] <= rounding))
            fail(e, "not noise-free to rounding");
    }
}

static void write_pictures(const evaluation *e)
{
    char title[160];
    const char *path = output_path(e->options, e->scene.name, ".png");

    snprintf(title, sizeof title, "%s: RMS error against %s", e->scene.title,
             e->scene.open ? "what is exact" : "a converged reference");
    sheet_write(path, title, e->panels, PICTURES, e->technique_count + 1);
    printf("  wrote %s: 1 and 4 samples a pixel, every technique beside the reference\n", path);
    if (!e->scene.open) {
        path = output_path(e->options, e->scene.name, "-rms.png");
        chart_write(path, e->scene.title, e->curves, e->technique_count);
        printf("  wrote %s: error against samples and against time\n", path);
    }
}

unsigned evaluate(const options *o, int number, panel gallery[GALLERY])
{
    evaluation *e = allocate(1, sizeof *e);

    e->options = o;
    scene_make(&e->scene, number);
    e->techniques = e->scene.comparison->row;
    e->technique_count = e->scene.comparison->count;
    frame_make(&e->frame, &e->scene, o->width, o->threads);
    e->reference = allocate(hit_count(e), sizeof *e->reference);
    e->light = allocate(hit_count(e), sizeof *e->light);
    e->other = allocate(hit_count(e), sizeof *e->other);
    for (unsigned t = 0; t < e->technique_count; ++t)
        e->curves[t].name = e->techniques[t].name;
    e->work = (e->scene.open ? 0 : LAYERS * o->reference) + 2 * e->technique_count;
    for (unsigned t = 0; e->scene.open && t < e->technique_count; ++t)
        e->work += LAYERS * check_samples(o, &e->techniques[t]);
    /* Of a scene without occluders there is no chart. */
    const unsigned most = e->scene.open ? pictured[PICTURES - 1] : o->samples;
    for (unsigned n = 1; n <= most; n *= 2)
        e->work += e->technique_count * n * (n == 1 || n == 4 ? o->repeat : 1);

    printf("\n%s\n  %u x %u pixels, %zu light%s\n", e->scene.title, e->frame.width,
           e->frame.height, e->scene.light_count, e->scene.light_count > 1 ? "s" : "");
    make_reference(e);
    for (unsigned n = 1; n <= most; n *= 2)
        render(e, n, n == 1 ? 0 : n == 4 ? 1 : PICTURES);
    render_singly(e);
    print_table(e);
    write_pictures(e);

    for (unsigned i = 0; i < PICTURES * (e->technique_count + 1); ++i)
        if (i < GALLERY)
            gallery[i] = e->panels[i];
        else
            free(e->panels[i].pixels);
    const unsigned failures = e->failures;
    frame_free(&e->frame);
    free(e->reference);
    free(e->light);
    free(e->other);
    free(e);
    return failures;
}
