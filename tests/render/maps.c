/* SPDX-License-Identifier: Apache-2.0 */
/* Draws what the maps do to the unit square and prints how much they distort: figure 5 of Urena
   and Georgiev, Stratified Sampling of Projected Spherical Caps, EGSR 2018. Fails if a map of
   projected solid angle leaves the visible part of the light, or a pdf is not the density that
   the map has. */
#include "maps.h"

#include <stdio.h>
#include <stdlib.h>

/* Of a pdf, relative: what difference quotients leave of the digits. */
static const double density_bound = 1e-6;

void map_check(psc_result result, const char *what)
{
    if (result == PSC_SUCCESS)
        return;
    fprintf(stderr, "maps: %s: %s\n", what, psc_result_string(result));
    exit(EXIT_FAILURE);
}

void map_build(psc_sampler *sampler, const technique_row *column, const map_row *row)
{
    static const double origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const psc_receiver receiver = {sizeof receiver, 0, origin, row->horizon ? up : NULL};
    const psc_technique technique = {.struct_size = sizeof technique, .measure = column->measure,
                                     .map = column->map};
    psc_description description = {.struct_size = sizeof description};

    map_check(row->shape->build(sampler, &technique, &receiver, row->number, map_vectors(row)),
              "building");
    map_check(psc_sampler_describe(sampler, &description), "describing");
    if (description.visibility != row->visibility) {
        fprintf(stderr, "maps: this should be the case of the %s\n", row->name);
        exit(EXIT_FAILURE);
    }
}

/* Returns how many maps have another density than their pdf says. */
static int print_distortions(const map_figure *f)
{
    psc_sampler_storage storage;
    psc_sampler *sampler;
    int wrong = 0;

    map_check(psc_sampler_init(&storage, sizeof storage, &sampler), "making a sampler");
    for (unsigned r = 0; r < f->row_count; ++r)
        for (unsigned c = 0; c < f->column_count; ++c) {
            if (!(f->rows[r].columns >> c & 1))
                continue;
            map_build(sampler, &f->columns[c], &f->rows[r]);
            const distortion d = map_distortion(sampler, f->columns[c].measure);
            printf("  %-18s %-24s %5.2f /%5.2f %9.1f %6.1f %12.1e\n", f->rows[r].name,
                   f->columns[c].name, d.least_distance, d.mean_distance, d.median_ratio,
                   d.high_ratio, d.density);
            wrong += !(d.density < density_bound);
        }
    return wrong;
}

int main(int argc, char **argv)
{
    int strays = 0, wrong = 0;

    if (argc != 2 || argv[1][0] == '-') {
        fprintf(stderr, "Usage: maps DIRECTORY\n"
                        "Draws curves of constant u and v, and a lattice of %d points, as each "
                        "map lays them over a light,\nand prints how much it distorts.\n",
                LATTICE);
        return EXIT_FAILURE;
    }
    for (unsigned i = 0; i < MAP_FIGURES; ++i)
        strays += map_draw(&map_figures[i], argv[1]);
    printf("\nHow a map distorts where its measure is area: distances of the points of a %d-point "
           "lattice to\ntheir nearest neighbours, least and mean, in square roots of total / %d "
           "(0.99 in the unit square);\nratio of the singular values of the Jacobian, median and "
           "95 %%; and, as a check, the worst relative\nerror of the pdf against the "
           "Jacobian.\n\n", LATTICE, LATTICE);
    printf("  %-18s %-24s %12s %9s %6s %12s\n", "light", "map", "least / mean", "median", "95 %",
           "pdf");
    for (unsigned i = 0; i < MAP_FIGURES; ++i)
        wrong += print_distortions(&map_figures[i]);
    if (strays)
        printf("%d samples of projected solid angle are not on the visible part of the light\n",
               strays);
    if (wrong)
        printf("%d maps do not have the density that their pdf states\n", wrong);
    return strays || wrong ? EXIT_FAILURE : EXIT_SUCCESS;
}
