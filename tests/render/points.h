/* SPDX-License-Identifier: Apache-2.0 */
/* Points of the unit square for the samples of one pixel and light. */
#ifndef POINTS_H
#define POINTS_H

#include <stdint.h>

typedef enum point_set { POINTS_SOBOL, POINTS_JITTERED } point_set;

/* A bijection whose output bits each depend on all input bits. */
static inline uint32_t mix(uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x9e3779b1u;
    x = (x ^ (x >> 15)) * 0x85ebca77u;
    return x ^ (x >> 16);
}

static inline uint32_t reverse_bits(uint32_t x)
{
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
    return x << 16 | x >> 16;
}

/* Owen scrambling of a reversed fraction: a bijection in which each bit is flipped or not by
   what the bits below it, the more significant digits, are. Multiples of even numbers have that
   property [Laine and Karras, Stratified sampling for stochastic transparency, 2011]. */
static inline uint32_t scramble(uint32_t x, uint32_t seed)
{
    x += seed;
    x ^= x * 0xd3a2646cu;
    x ^= x * (seed >> 5 | 1) << 1;
    x ^= x * 0x8f1bbcdcu;
    x ^= x * 0x5a827998u;
    return x;
}

/* The second coordinate of the Sobol sequence is the first one after Pascal's triangle modulo 2,
   which is the Kronecker power of [1 1; 0 1]: five steps instead of 32. */
static inline uint32_t pascal(uint32_t x)
{
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ x >> 16;
}

static inline float fraction(uint32_t x)
{
    return (float)(x >> 8) * 0x1p-24f;
}

/* Point number index of a set of count, another set for each key; over all keys, each point by
   itself is uniform. */
static inline void point(point_set set, uint32_t index, uint32_t count, uint32_t key, float uv[2])
{
    if (set == POINTS_SOBOL) {
        uv[0] = fraction(reverse_bits(scramble(index, mix(key))));
        uv[1] = fraction(reverse_bits(scramble(pascal(index), mix(~key))));
    } else {
        uint32_t rows = 1;
        while (4 * rows * rows <= count && count % (2 * rows) == 0)
            rows *= 2;
        const uint32_t columns = count / rows, cell = (index + mix(key)) % count;
        uv[0] = ((float)(cell / rows) + fraction(mix(key + 2 * index))) / (float)columns;
        uv[1] = ((float)(cell % rows) + fraction(mix(key + 2 * index + 1))) / (float)rows;
    }
}

#endif
