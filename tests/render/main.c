/* SPDX-License-Identifier: Apache-2.0 */
/* Renders direct light from lights of every shape by every technique and compares them: the
   evaluation of Urena and Georgiev, Stratified Sampling of Projected Spherical Caps, EGSR 2018,
   section 5, and the scenes of Guillen et al., Area-Preserving Parameterizations for Spherical
   Ellipses, EGSR 2017. */
#include "evaluate.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char usage[] =
    "Usage: render [options] [scene...]\n"
    "Renders the scenes (all of them, if none is named) by every technique that their lights\n"
    "offer, writes pictures and prints tables that compare them. Fails if samples do not\n"
    "converge to what is exact, or if unoccluded light by projected solid angle is not\n"
    "noise-free to rounding.\n"
    "\n"
    "  -o, --output DIR     where pictures go; made if missing (render-output)\n"
    "  -w, --width N        pixels across each picture (192)\n"
    "  -n, --samples N      most samples a pixel in the error curves, at least 4 (16)\n"
    "  -r, --reference N    samples of the reference at each of a pixel's 4 hits, from 16 (64)\n"
    "  -p, --points SET     sobol (Owen-scrambled) or jittered (sobol)\n"
    "  -s, --seed N         another seed, another noise (1)\n"
    "  -k, --repeat N       times are medians of this many runs, at most 32 (3)\n"
    "  -t, --threads N      at most 64 (as many as there are processors)\n"
    "  -h, --help           this text\n"
    "\n"
    "Scenes:";

void progress(const char *name, double fraction)
{
    static int shown = -1;
    const int tty = isatty(STDERR_FILENO), percent = (int)(100 * fraction);

    if (percent / (tty ? 1 : 20) != shown)
        fprintf(stderr, tty ? "\r%s: %d%%\033[K" : "%s: %d%%\n", name, percent);
    shown = percent / (tty ? 1 : 20);
    if (fraction < 1)
        return;
    if (tty)
        fprintf(stderr, "\r\033[K");
    shown = -1;
}

const char *output_path(const options *o, const char *name, const char *ending)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s%s", o->output, name, ending);
    return path;
}

static void print_usage(FILE *to)
{
    scene s;
    fputs(usage, to);
    for (int i = 0; i < SCENE_COUNT; ++i) {
        scene_make(&s, i);
        fprintf(to, " %s", s.name);
    }
    fputs("\n", to);
}

static int wrong(const char *what, const char *value)
{
    fprintf(stderr, "render: %s: %s; try --help\n", what, value);
    return EXIT_FAILURE;
}

/* Reads a whole number from low to high; returns 0 if the text is not one. */
static int read_number(const char *text, unsigned long low, unsigned long high, unsigned *number)
{
    char *end;
    errno = 0;
    const unsigned long n = strtoul(text, &end, 10);
    *number = (unsigned)n;
    return *text >= '0' && *text <= '9' && !*end && !errno && n >= low && n <= high;
}

static int read_options(int argc, char **argv, options *o)
{
    static const struct option names[] = {
        {"output", 1, NULL, 'o'}, {"width", 1, NULL, 'w'},  {"samples", 1, NULL, 'n'},
        {"reference", 1, NULL, 'r'}, {"points", 1, NULL, 'p'}, {"seed", 1, NULL, 's'},
        {"repeat", 1, NULL, 'k'}, {"threads", 1, NULL, 't'}, {"help", 0, NULL, 'h'},
        {NULL, 0, NULL, 0}};
    int option, good = 1;

    while ((option = getopt_long(argc, argv, "o:w:n:r:p:s:k:t:h", names, NULL)) != -1) {
        switch (option) {
        case 'o': o->output = optarg; break;
        case 'w': good = read_number(optarg, 16, 4096, &o->width); break;
        case 'n': good = read_number(optarg, 4, 128, &o->samples); break;
        case 'r': good = read_number(optarg, 16, 65536, &o->reference); break;
        case 's': good = read_number(optarg, 0, UINT32_MAX, &o->seed); break;
        case 'k': good = read_number(optarg, 1, 32, &o->repeat); break;
        case 't': good = read_number(optarg, 1, 64, &o->threads); break;
        case 'p':
            o->set = strcmp(optarg, "jittered") ? POINTS_SOBOL : POINTS_JITTERED;
            good = o->set == POINTS_JITTERED || !strcmp(optarg, "sobol");
            break;
        case 'h': print_usage(stdout); exit(EXIT_SUCCESS);
        default: print_usage(stderr); return 0;
        }
        if (!good) {
            wrong("not a value that this option takes", optarg);
            return 0;
        }
    }
    return 1;
}

/* The picture that says it all, if both of its scenes were rendered. */
static void write_gallery(const options *o, panel pictures[SCENE_COUNT][GALLERY])
{
    static const char *const headings[2 * GALLERY] = {
        "solid angle", "projected solid angle", "no occluders: solid angle",
        "projected solid angle"};
    panel row[2 * GALLERY];

    if (!pictures[0][0].pixels || !pictures[1][0].pixels)
        return;
    for (int i = 0; i < 2 * GALLERY; ++i) {
        row[i] = pictures[i / GALLERY][i % GALLERY];
        snprintf(row[i].heading, sizeof row[i].heading, "%s", headings[i]);
    }
    const char *path = output_path(o, "gallery", ".png");
    sheet_write(path, "Cornell box, four spherical lights, one sample per light and pixel", row, 1,
                2 * GALLERY);
    printf("\nwrote %s: one sample a pixel, with and without occluders\n", path);
}

int main(int argc, char **argv)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    options o = {.width = 192, .reference = 64, .samples = 16, .repeat = 3, .seed = 1,
                 .threads = processors < 1 ? 1 : processors > 64 ? 64 : (unsigned)processors,
                 .output = "render-output"};
    panel pictures[SCENE_COUNT][GALLERY] = {0};
    int wanted[SCENE_COUNT] = {0};
    unsigned failures = 0;

    setvbuf(stdout, NULL, _IOLBF, 0); /* in step with the progress, wherever both go */
    if (!read_options(argc, argv, &o))
        return EXIT_FAILURE;
    for (int k = optind; k < argc; ++k) {
        scene s;
        int i = 0;
        for (; i < SCENE_COUNT; ++i) {
            scene_make(&s, i);
            if (!strcmp(argv[k], s.name))
                break;
        }
        if (i == SCENE_COUNT)
            return wrong("no such scene", argv[k]);
        wanted[i] = 1;
    }
    if (mkdir(o.output, 0777) && errno != EEXIST)
        return wrong("cannot make the output directory", strerror(errno));

    printf("Direct light, %s points, seed %u, one sample per light and camera ray, f32 wavefront "
           "calls.\nTimes are processor time for sampling and shadow rays, summed over %u "
           "thread%s; camera\nrays are shared and not counted. effic. = 1 / (MSE x time). RMS* = "
           "RMS error over that of\nthe first technique given the same time. Below 1 is better "
           "but for effic.\n",
           o.set == POINTS_SOBOL ? "Owen-scrambled Sobol" : "jittered", o.seed, o.threads,
           o.threads > 1 ? "s" : "");
    for (int i = 0; i < SCENE_COUNT; ++i)
        if (optind == argc || wanted[i])
            failures += evaluate(&o, i, pictures[i]);
    write_gallery(&o, pictures);
    for (int i = 0; i < SCENE_COUNT; ++i)
        for (int k = 0; k < GALLERY; ++k)
            free(pictures[i][k].pixels);
    if (failures)
        printf("\n%u claim%s did not hold.\n", failures, failures > 1 ? "s" : "");
    return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
