/* SPDX-License-Identifier: Apache-2.0 */
#include "exact.h"

double power_of_two(int exponent)
{
    const uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

int64_t square_root(int64_t x)
{
    int64_t root = 0, bit = (int64_t)1 << 31;

    for (; bit > 0; bit >>= 1)
        if ((root | bit) * (root | bit) <= x)
            root |= bit;
    return root;
}

int64_t around(uint64_t *state, int64_t n)
{
    return (int64_t)(random_bits(state) % (uint64_t)(2 * n + 1)) - n;
}

/* Matrices of integers whose columns are of one length, at right angles and right-handed. */
static const int64_t turns[4][3][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                       {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                       {{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}},
                                       {{6, -3, 2}, {2, 6, 3}, {-3, -2, 6}}};

static void turn(const int64_t matrix[3][3], const int64_t v[3], double scale, double out[3])
{
    int i;

    for (i = 0; i < 3; i++)
        out[i] =
            (double)(matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2]) * scale;
}

/* The grid is coarse enough for rounding to hide what libraries of mathematics differ in. */
static int64_t to_grid(double x)
{
    return (int64_t)floor(x * 0x1p+20 + 0.5);
}

/* The receiver, in units of the grid. */
static void exact_receiver(uint64_t *state, const struct light *light, int64_t from[3])
{
    const double *corner = light->geometry; /* of polygons; the middle, of others */
    const int shift = random_below(state, 8);
    int i;

    for (i = 0; i < 3; i++)
        from[i] = around(state, (int64_t)1 << (16 + shift));
    switch (random_below(state, 8)) {
    case 0: from[2] = 0; break;                /* in the plane */
    case 1: from[2] = around(state, 1); break; /* close to it */
    case 2: from[2] = around(state, 1 << 10); break;
    case 3: /* over the middle */
        from[0] = from[1] = 0;
        break;
    case 4: /* over a corner */
        for (i = 0; i < 2; i++)
            from[i] = to_grid(corner[i]);
        break;
    default: break;
    }
}

void place_exactly(uint64_t *state, struct light *light, shape_maker *make)
{
    const int64_t(*matrix)[3] = turns[random_below(state, 4)];
    const double scale = power_of_two(random_below(state, 80) - 60);
    const double other = power_of_two(random_below(state, 80) - 60);
    int64_t from[3], shift[3], normal[3];
    double *g = light->geometry, moved[3], v[3];
    const char *part;
    int i;

    make(state, light->what, random_below(state, 2), light->geometry);
    exact_receiver(state, light, from);
    for (i = 0; i < 3; i++) {
        shift[i] = random_below(state, 2) ? around(state, 1 << 20) : 0;
        normal[i] = around(state, 1 << random_below(state, 20));
    }
    if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
        normal[random_below(state, 3)] = 1;
    turn(turns[0], shift, scale, moved);
    turn(matrix, normal, other, light->normal);
    turn(matrix, from, scale, light->position);
    for (i = 0; i < 3; i++)
        light->position[i] += moved[i];
    memcpy(light->middle, moved, sizeof moved);
    light->reach = 0x1p+23 * scale;
    for (part = light->shape->parts; *part; g += part_size(*part), part++) {
        int64_t n[3] = {0, 0, 0};

        for (i = 0; i < part_size(*part); i++)
            n[i] = to_grid(g[i]);
        if (part_size(*part) == 1) {
            g[0] = (double)n[0] * (*part == 'r' ? scale : 0x1p-20);
            continue;
        }
        turn(matrix, n, *part == 'd' ? other : scale, v);
        for (i = 0; i < 3; i++)
            g[i] = v[i] + (*part == 'p' ? moved[i] : 0.0);
    }
}
