/* SPDX-License-Identifier: Apache-2.0 */
/*
 * path REFERENCE: tests a path tracer that samples its lights by the library. Every technique must
 * give the picture that directions of the BSDF alone give, and a table tells what each gains where.
 * path --reference SAMPLES: prints that picture, which took no call of the library, for REFERENCE.
 * path --picture FILE WIDTH SAMPLES [MEASURE...]: renders a picture, in PPM, by these measures of
 * the lights, the last for all others: area, solid angle or projected solid angle, which it is if
 * there are none.
 */
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "../../tap.h"
#include "tracer.hpp"

namespace {

constexpr int columns = 4, rows = 3, tiles = columns * rows;
constexpr psc_measure measures[] = {PSC_MEASURE_AREA, PSC_MEASURE_SOLID_ANGLE,
                                    PSC_MEASURE_PROJECTED_SOLID_ANGLE};
constexpr const char *measure_names[] = {"area", "solid angle", "projected solid angle"};

/* A measure for each light. */
Settings choose(const Scene &scene, Strategy strategy,
                const std::array<psc_measure, lights> &measure)
{
    Settings settings = {strategy, {}};
    for (int l = 0; l < lights; l++)
        settings.technique[l] = scene.light[l].technique(measure[l]);
    return settings;
}

/* The same measure for every light that offers it. */
Settings everywhere(const Scene &scene, Strategy strategy, psc_measure measure)
{
    std::array<psc_measure, lights> all;
    all.fill(measure);
    return choose(scene, strategy, all);
}

/* Means over tiles of the picture and their standard errors, light by light. */
struct Picture {
    double mean[tiles][lights], error[tiles][lights];
};

Picture render(const Scene &scene, const Settings &settings, int samples, std::uint64_t seed,
               Agreement *agreement = nullptr)
{
    Picture picture;
    for (int t = 0; t < tiles; t++) {
        Random random(seed * tiles + std::uint64_t(t));
        double sum[lights] = {}, squares[lights] = {};
        for (int i = 0; i < samples; i++) {
            const float x = (float(t % columns) + random()) / columns;
            const float y = (float(t / columns) + random()) / rows;
            int first;
            const Radiance l = trace(scene, settings, x, y, random, first, agreement);
            for (int k = 0; k < lights; k++) {
                sum[k] += l[k];
                squares[k] += double(l[k]) * l[k];
            }
        }
        for (int k = 0; k < lights; k++) {
            const double mean = sum[k] / samples;
            picture.mean[t][k] = mean;
            picture.error[t][k] =
                std::sqrt(std::fmax(0.0, squares[k] / samples - mean * mean) / (samples - 1));
        }
    }
    return picture;
}

void print(const Picture &picture)
{
    for (int t = 0; t < tiles; t++)
        for (int k = 0; k < lights; k++)
            std::printf("%.6g %.3g%c", picture.mean[t][k], picture.error[t][k],
                        k + 1 < lights ? ' ' : '\n');
}

bool read(const char *path, Picture &picture)
{
    std::FILE *file = std::fopen(path, "r");
    bool ok = file != nullptr;
    for (int t = 0; ok && t < tiles; t++)
        for (int k = 0; k < lights; k++)
            ok = std::fscanf(file, "%lf %lf", &picture.mean[t][k], &picture.error[t][k]) == 2;
    if (file)
        std::fclose(file);
    return ok;
}

/* A measure for each light, from their names; false if one is none. */
bool read(int count, char **names, std::array<psc_measure, lights> &measure)
{
    measure.fill(PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    for (int l = 0; count > 0 && l < lights; l++) {
        const char *name = names[l < count ? l : count - 1];
        int m = 0;
        while (m < 3 && std::strcmp(name, measure_names[m]) != 0)
            m++;
        if (m == 3)
            return false;
        measure[l] = measures[m];
    }
    return count <= lights;
}

double square(double x)
{
    return x * x;
}

/* Whether two pictures differ by no more than their errors: in tiles, and in the whole of each
   light, where a small bias would add up. */
void compare(const Picture &a, const Picture &b, const char *name)
{
    double chi = 0, worst = 0, bias = 0;
    int n = 0;
    for (int k = 0; k < lights; k++) {
        double difference = 0, variance = 0;
        for (int t = 0; t < tiles; t++) {
            const double d = a.mean[t][k] - b.mean[t][k];
            const double v = square(a.error[t][k]) + square(b.error[t][k]);
            difference += d;
            variance += v;
            if (v > 0) {
                chi += d * d / v;
                worst = std::fmax(worst, std::fabs(d) / std::sqrt(v));
                n++;
            }
        }
        bias = std::fmax(bias, std::fabs(difference) / std::sqrt(variance));
    }
    tap_ok(n > tiles && chi < n + 4 * std::sqrt(2.0 * n) && worst < 5 && bias < 3.5,
           "%s: chi-square %.2f, worst tile %.1f and worst light %.1f standard errors", name,
           chi / n, worst, bias);
}

/* ---- No technique changes the picture */

void unbiased(const Scene &scene, const Picture &reference)
{
    const int samples = 20000;
    Agreement agreement[3];
    std::string name;

    for (const Light &light : scene.light)
        if (!light.offered(PSC_MEASURE_PROJECTED_SOLID_ANGLE))
            tap_note("%s: solid angle for projected solid angle, which it does not offer",
                     light.name);
    for (int m = 0; m < 3; m++) {
        name = std::string(measure_names[m]);
        const Settings light = everywhere(scene, Strategy::light, measures[m]);
        const Settings mis = everywhere(scene, Strategy::mis, measures[m]);
        compare(render(scene, light, samples, 1), reference,
                (name + ", next-event estimation").c_str());
        compare(render(scene, mis, samples, 2, &agreement[m]), reference, (name + ", MIS").c_str());
    }
    compare(render(scene,
                   choose(scene, Strategy::mis,
                          {PSC_MEASURE_VISIBLE_AREA, PSC_MEASURE_SOLID_ANGLE, PSC_MEASURE_AREA,
                           PSC_MEASURE_PROJECTED_SOLID_ANGLE}),
                   samples, 3),
            reference, "a measure for each light, MIS");

    for (int m = 0; m < 3; m++) {
        const Agreement &a = agreement[m];
        tap_ok(a.samples > 100000 && double(a.pdf_differs) < 1e-2 * double(a.samples),
               "%s: the pdf of a sample is that of its direction; %ld of %ld, at the limb, are not "
               "in float",
               measure_names[m], a.pdf_differs, a.samples);
        tap_ok(a.directions > 100000 && double(a.support_differs) < 1e-4 * double(a.directions),
               "%s: directions have a pdf where they hit the light, but for %ld of %ld",
               measure_names[m], a.support_differs, a.directions);
    }
}

/* ---- Errors fall as the square root of the number of samples */

void converges(const Scene &scene, const Picture &reference)
{
    const Settings settings = everywhere(scene, Strategy::mis, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    double error[3];

    for (int i = 0; i < 3; i++) {
        const int samples = 32 << (3 * i);
        double sum = 0;
        for (std::uint64_t seed = 4; seed < 12; seed++) {
            const Picture picture = render(scene, settings, samples, seed);
            for (int t = 0; t < tiles; t++)
                for (int k = 0; k < lights; k++)
                    sum += square(picture.mean[t][k] - reference.mean[t][k]);
        }
        error[i] = std::sqrt(sum / (8 * tiles * lights));
        tap_note("%4d samples: error %.4f", samples, error[i]);
    }
    tap_ok(error[0] > 2 * error[1] && error[1] > 2 * error[2] && error[0] < 16 * error[2],
           "the error falls by sqrt(8) when there are 8 times as many samples");
}

/* ---- What each technique gains where */

constexpr int techniques = 7;
using Table = std::array<std::array<std::array<double, techniques>, lights>, MATERIALS>;

/* Standard deviation of one sample of direct light, relative to the mean over a material. */
Table noise(const Scene &scene)
{
    constexpr int points = 1000, samples = 32;
    Table table = {};
    double mean[MATERIALS][lights] = {}; /* of all techniques, which are unbiased */
    for (int technique = 0; technique < techniques; technique++) {
        double variance[MATERIALS][lights] = {}, seen[MATERIALS][lights] = {}, n[MATERIALS] = {};
        Settings settings = technique == 0
                                ? everywhere(scene, Strategy::bsdf, PSC_MEASURE_AREA)
                                : everywhere(scene,
                                             technique % 2 ? Strategy::light : Strategy::mis,
                                             measures[(technique - 1) / 2]);
        settings.bounces = 1;
        for (int p = 0; p < points; p++) {
            Random where(1000000u + unsigned(p)), random(2000000u + unsigned(p));
            const float x = where(), y = where();
            double sum[lights] = {}, squares[lights] = {};
            int first = -1;
            for (int i = 0; i < samples; i++) {
                const Radiance l = trace(scene, settings, x, y, random, first);
                for (int k = 0; k < lights; k++) {
                    sum[k] += l[k];
                    squares[k] += double(l[k]) * l[k];
                }
            }
            if (first < 0)
                continue;
            n[first]++;
            for (int k = 0; k < lights; k++) {
                seen[first][k] += sum[k] / samples;
                variance[first][k] += (squares[k] - sum[k] * sum[k] / samples) / (samples - 1);
            }
        }
        for (int m = 0; m < MATERIALS; m++)
            for (int k = 0; k < lights; k++) {
                table[m][k][technique] = std::sqrt(variance[m][k] / n[m]);
                mean[m][k] += seen[m][k] / n[m] / techniques;
            }
    }
    for (int m = 0; m < MATERIALS; m++)
        for (int k = 0; k < lights; k++)
            for (double &entry : table[m][k])
                entry /= mean[m][k];
    return table;
}

void gains(const Scene &scene)
{
    const Table table = noise(scene);
    double sum[MATERIALS][techniques] = {};

    tap_note("Noise of one sample of direct light, relative to its mean: next-event, MIS");
    tap_note("%-14s %-10s %6s %13s %13s %21s", "", "", "BSDF", "area", "solid angle",
             "projected solid angle");
    for (int m = 0; m < MATERIALS; m++)
        for (int k = 0; k < lights; k++) {
            const auto &row = table[m][k];
            tap_note("%-14s %-10s %6.2f  %5.2f %5.2f   %5.2f %5.2f           %5.2f %5.2f",
                     scene.material[m].name, scene.light[k].name, row[0], row[1], row[2], row[3],
                     row[4], row[5], row[6]);
            for (int t = 0; t < techniques; t++)
                sum[m][t] += square(row[t]);
        }
    enum { BSDF, AREA, AREA_MIS, SOLID, PROJECTED = 5 };
    bool gained = sum[FLOOR][SOLID] < 0.8 * sum[FLOOR][AREA];
    for (int k = 0; k < lights; k++)
        if (scene.light[k].offered(PSC_MEASURE_PROJECTED_SOLID_ANGLE))
            gained &= table[FLOOR][k][PROJECTED] < 0.9 * table[FLOOR][k][SOLID]; /* the knot is left */
    tap_ok(gained, "on the diffuse floor, projected solid angle beats solid angle beats area");
    tap_ok(table[FLOOR][0][AREA_MIS] < 0.8 * table[FLOOR][0][AREA]
               && table[FLOOR][0][AREA_MIS] < 0.8 * table[FLOOR][0][BSDF],
           "below the sphere, MIS beats area and the BSDF alone");
}

/* ---- */

bool paint(const Scene &scene, const Settings &settings, const char *path, int size, int samples)
{
    const int height = size * 3 / 4;
    std::FILE *file = std::fopen(path, "wb");
    if (!file)
        return false;
    std::fprintf(file, "P6 %d %d 255\n", size, height);
    for (int p = 0; p < size * height; p++) {
        Random random{std::uint64_t(p)};
        Vector color;
        for (int i = 0; i < samples; i++) {
            const float x = (float(p % size) + random()) / float(size);
            const float y = (float(p / size) + random()) / float(height);
            int first;
            const Radiance l = trace(scene, settings, x, y, random, first);
            Vector sample;
            for (int k = 0; k < lights; k++)
                sample = sample + l[k] * scene.light[k].color;
            /* Clamped before the mean, so that edges of lights stay smooth. */
            color = color + 1 / float(samples) * Vector{std::fmin(sample.x, 1.0f),
                                                        std::fmin(sample.y, 1.0f),
                                                        std::fmin(sample.z, 1.0f)};
        }
        for (float c : {color.x, color.y, color.z})
            std::fputc(int(255 * std::pow(c, 1 / 2.2f) + 0.5f), file);
    }
    return std::fclose(file) == 0;
}

} // namespace

int main(int argc, char **argv)
{
    const Scene scene;
    Picture reference;

    if (argc == 3 && std::strcmp(argv[1], "--reference") == 0) {
        const Settings settings = everywhere(scene, Strategy::bsdf, PSC_MEASURE_AREA);
        print(render(scene, settings, std::atoi(argv[2]), 0));
        return 0;
    }
    std::array<psc_measure, lights> wanted;
    if (argc >= 5 && std::strcmp(argv[1], "--picture") == 0 && read(argc - 5, argv + 5, wanted))
        return !paint(scene, choose(scene, Strategy::mis, wanted), argv[2], std::atoi(argv[3]),
                      std::atoi(argv[4]));
    if (argc != 2 || !read(argv[1], reference)) {
        std::fprintf(stderr, "usage: path REFERENCE\n"
                             "       path --reference SAMPLES\n"
                             "       path --picture FILE WIDTH SAMPLES [MEASURE...]\n");
        return 2;
    }
    unbiased(scene, reference);
    converges(scene, reference);
    gains(scene);
    return tap_done();
}
