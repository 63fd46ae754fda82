/* SPDX-License-Identifier: Apache-2.0 */
/* Random numbers that are the same everywhere: SplitMix64 with a seed that each test names. */
#ifndef PSC_TESTS_RANDOM_H
#define PSC_TESTS_RANDOM_H

#include <math.h>
#include <stdint.h>

static inline uint64_t random_bits(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* In [0, 1), with 53 bits. */
static inline double random_uniform(uint64_t *state)
{
    return (double)(random_bits(state) >> 11) * 0x1p-53;
}

static inline double random_between(uint64_t *state, double low, double high)
{
    return low + (high - low) * random_uniform(state);
}

/* Between two positive numbers, evenly in the logarithm. */
static inline double random_log(uint64_t *state, double low, double high)
{
    return low * pow(high / low, random_uniform(state));
}

static inline int random_below(uint64_t *state, int n)
{
    return (int)(random_bits(state) % (uint64_t)n);
}

/* A coordinate of the unit square: anywhere, near an end or the middle, or on one of them. */
static inline double random_coordinate(uint64_t *state)
{
    double x = random_uniform(state);

    switch (random_below(state, 8)) {
    case 0: x = random_log(state, 1e-16, 1.0); break;
    case 1: x = 1.0 - random_log(state, 1e-16, 1.0); break;
    case 2: x = 0.5 + (x < 0.5 ? -0.5 : 0.5) * random_log(state, 1e-16, 1.0); break;
    case 3: x = 0.5 * random_below(state, 3); break;
    default: break;
    }
    return x;
}

/* A unit vector, to rounding. */
static inline void random_unit(uint64_t *state, double v[3])
{
    double z = random_between(state, -1.0, 1.0);
    double phi = random_between(state, 0.0, 6.283185307179586), r = sqrt((1.0 - z) * (1.0 + z));

    v[0] = r * cos(phi);
    v[1] = r * sin(phi);
    v[2] = z;
}

#endif
