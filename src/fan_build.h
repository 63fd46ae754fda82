/* SPDX-License-Identifier: Apache-2.0 */
/* From the vertices of a triangle to its solid angle, and to the constants of its maps. */
#ifndef PSC_SRC_FAN_BUILD_H
#define PSC_SRC_FAN_BUILD_H

#include "fan.h"

/* Vertices and edges of a triangle: edge_a and edge_c from B to A and C, edge_ac from A to C. */
struct psc_triangle_words {
    struct psc_word2 a, b, c, edge_a, edge_c, edge_ac;
};

/* e x v, to rounding of the result however small it is. */
PSC_LANE void cross_words(const struct psc_word2 *e, const struct psc_word2 *v, double to[3])
{
    double first[3], second[3];
    int i;

    cross(e->high, v->high, to);
    cross_rounded(e->low, v->high, first);
    cross_rounded(e->high, v->low, second);
    for (i = 0; i < 3; i++)
        to[i] += first[i] + second[i];
}

/* The triangle as sine and cosine functions of it want it. */
struct psc_triangle_view {
    double per_a, per_b, per_c;       /* 1 / length */
    double ab[3], ac[3];              /* a x b / (|a| |b|) and so on: as long as the sine */
    double cos_ab, cos_bc;
    double more_ab, less_ab, more_ac; /* 1 + cos and 1 - cos of sides, none of them cancelled */
    double sin_ab, sin_ac;
    double normal[3], twice_area;     /* (c - b) x (a - b), and its length */
    double volume;                    /* a . (b x c): six times that of the tetrahedron */
    double sine;                      /* |volume| / (|a| |b| |c|) */
    double half, rest;                /* half the solid angle, 0 when nothing is seen; pi - half */
    double cosine;                    /* D below: half is the angle of (cosine, sine) */
};

/* 1 + cosine, from the square of the sine where that would cancel. */
PSC_LANE double one_plus(double cosine, double sine2)
{
    return cosine >= 0.0 ? 1.0 + cosine : sine2 / (1.0 - cosine);
}

/*
 * v . second x first, the volume of a vertex and two edges, from exact products: relative to
 * itself, also for a receiver all but in the plane of the triangle.
 */
PSC_LANE void see_volume(const struct psc_word2 *v, const struct psc_word2 *second,
                         const struct psc_word2 *first, struct psc_triangle_view *o)
{
    double low[3], more[3], less[3], sum = 0.0, error = 0.0;
    int i;

    cross_rounded(second->low, first->high, more);
    cross_rounded(second->high, first->low, less);
    for (i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        double p, pe, q, qe;

        two_product(second->high[j], first->high[k], &p, &pe);
        two_product(second->high[k], first->high[j], &q, &qe);
        two_sum(p, -q, &o->normal[i], &low[i]);
        low[i] += (pe - qe) + (more[i] + less[i]);
    }
    for (i = 0; i < 3; i++) {
        add_product(v->high[i], o->normal[i], &sum, &error);
        error += v->high[i] * low[i] + v->low[i] * o->normal[i];
    }
    o->volume = sum + error;
    for (i = 0; i < 3; i++)
        o->normal[i] += low[i];
    o->twice_area = SQRT(dot(o->normal, o->normal));
}

/* Which of a triangle's vertices and edges its products are taken of. */
struct psc_triangle_factors {
    const struct psc_word2 *ab, *ac, *bc;   /* a or b, a or c, b or c: times the edge between */
    const struct psc_word2 *nearest;        /* a, b or c */
    const struct psc_word2 *second, *first; /* two edges, turning as edge_c and edge_a do */
};

/*
 * The solid angle [OS83]: tan(omega / 2) = N / D with N = |a . (b x c)| and, divided by |a| |b|
 * |c|, D = 1 + cos ab + cos ac + cos bc. That sum cancels for a receiver near an edge. At A,
 *     D |a| = (1 + cos ab)(1 + cos ac) |a| + (a x b).(a x c) / (|a| |b| |c|)
 * has terms as large as D itself unless the side opposite to A is the one whose ends are nearest
 * to antipodal; then the same at B is taken. Errors are below 1e-15 of the result for
 * solid angles from the smallest number to 2 pi.
 */
PSC_LANE void see_by_factors(const struct psc_triangle_words *words,
                             const struct psc_triangle_factors *by, struct psc_triangle_view *o)
{
    const struct psc_word2 *const a = &words->a, *const b = &words->b, *const c = &words->c;
    double cos_ac, sin2_ab, sin2_ac, more, rest;
    int i, opposite, seen;

    cross_words(&words->edge_a, by->ab, o->ab);
    cross_words(by->ac, &words->edge_ac, o->ac);
    for (i = 0; i < 3; i++) {
        o->ab[i] *= o->per_a * o->per_b;
        o->ac[i] *= o->per_a * o->per_c;
    }
    sin2_ab = dot(o->ab, o->ab);
    sin2_ac = dot(o->ac, o->ac);
    o->sin_ab = SQRT(sin2_ab);
    o->sin_ac = SQRT(sin2_ac);
    o->cos_ab = dot(a->high, b->high) * (o->per_a * o->per_b);
    cos_ac = dot(a->high, c->high) * (o->per_a * o->per_c);
    o->cos_bc = dot(b->high, c->high) * (o->per_b * o->per_c);
    more = 1.0 + ABS(o->cos_ab);
    rest = sin2_ab / more;
    o->more_ab = o->cos_ab >= 0.0 ? more : rest;
    o->less_ab = o->cos_ab >= 0.0 ? rest : more;

    see_volume(by->nearest, by->second, by->first, o);
    o->sine = ABS(o->volume) * o->per_a * o->per_b * o->per_c;
    o->more_ac = one_plus(cos_ac, sin2_ac);
    o->cosine = o->more_ab * o->more_ac + dot(o->ab, o->ac);
    opposite = (o->cos_bc < 0.0) & (o->cos_bc < o->cos_ab) & (o->cos_bc < cos_ac);
    if (opposite) {
        double bc[3];

        cross_words(by->bc, &words->edge_c, bc);
        for (i = 0; i < 3; i++)
            bc[i] *= o->per_b * o->per_c;
        o->cosine = o->more_ab * one_plus(o->cos_bc, dot(bc, bc)) - dot(o->ab, bc);
    }
    /* In the plane, or at a vertex, where lengths are 0 and the quotients no numbers. */
    seen = (o->sine > 0.0) & (o->sin_ab > 0.0) & (o->sin_ac > 0.0) & (o->sine <= DBL_MAX);
    o->half = angle_and_rest(seen ? o->cosine : 1.0, seen ? o->sine : 0.0, &o->rest);
}

/* Lengths; whether some are so much larger than others that it matters of which of them the
   products are. */
PSC_LANE int see_lengths(const struct psc_triangle_words *words, struct psc_triangle_view *o)
{
    const double a2 = dot(words->a.high, words->a.high), b2 = dot(words->b.high, words->b.high);
    const double c2 = dot(words->c.high, words->c.high);
    const double ab2 = dot(words->edge_a.high, words->edge_a.high);
    const double bc2 = dot(words->edge_c.high, words->edge_c.high);
    const double ac2 = dot(words->edge_ac.high, words->edge_ac.high);
    const double nearer = MIN(a2, b2), nearest = MIN(nearer, c2);
    const double longer = MAX(ab2, bc2), farther = MAX(a2, b2), farthest = MAX(farther, c2);

    o->per_a = 1.0 / SQRT(a2);
    o->per_b = 1.0 / SQRT(b2);
    o->per_c = 1.0 / SQRT(c2);
    return (nearest < 0x1p-40 * farthest) | (ac2 < 0x1p-16 * longer);
}

PSC_LANE void see_ordinary_triangle(const struct psc_triangle_words *words,
                                    struct psc_triangle_view *o)
{
    const struct psc_triangle_factors by = {&words->b, &words->a,      &words->b,
                                            &words->b, &words->edge_c, &words->edge_a};

    see_by_factors(words, &by, o);
}

/* Of two vertices the product of the edge between them with the nearer one is theirs, and is not
   lost where the receiver is much closer to that; of a needle's edges the long ones' product is
   all but lost. */
static void see_extreme_triangle(const struct psc_triangle_words *words,
                                 struct psc_triangle_view *o)
{
    const double ab2 = dot(words->edge_a.high, words->edge_a.high);
    const double bc2 = dot(words->edge_c.high, words->edge_c.high);
    struct psc_triangle_factors by;

    by.ab = o->per_a > o->per_b ? &words->a : &words->b;
    by.ac = o->per_c > o->per_a ? &words->c : &words->a;
    by.bc = o->per_b > o->per_c ? &words->b : &words->c;
    by.nearest = o->per_c > MAX(o->per_a, o->per_b) ? &words->c : by.ab;
    by.second = &words->edge_ac;
    by.first = ab2 > bc2 ? &words->edge_c : &words->edge_a;
    if (dot(words->edge_ac.high, words->edge_ac.high) >= MAX(ab2, bc2)) {
        by.second = &words->edge_c;
        by.first = &words->edge_a;
    }
    see_by_factors(words, &by, o);
}

PSC_LANE void see_triangle(const struct psc_triangle_words *words, struct psc_triangle_view *o)
{
    if (see_lengths(words, o))
        see_extreme_triangle(words, o);
    else
        see_ordinary_triangle(words, o);
}

/* The constants of the map, in units of the view. */
PSC_LANE void fan_build(const struct psc_triangle_view *o, const struct psc_word2 *b,
                        const struct psc_word2 *edge_c, struct psc_fan_f64 *f)
{
    const double per_sine = 1.0 / o->sin_ab, per_sines = per_sine / o->sin_ac;
    const double side = COPYSIGN(per_sine, o->volume);
    double gap, grow, across[3];
    int i;

    f->half = o->half;
    f->rest = o->rest;
    f->sin_a = o->sine * per_sines;
    f->cos_a = dot(o->ab, o->ac) * per_sines;
    /* sin alpha cos half - cos alpha sin half, of which the cosine's second term cancels */
    f->sin_rest = f->sin_a * o->more_ab * o->more_ac /
                  SQRT(o->sine * o->sine + o->cosine * o->cosine);
    gap = 0.5 * f->sin_a * o->sin_ab;
    grow = MIN(unit_scale(gap), 0x1p62);
    f->near = 0.5 * o->less_ab * grow;
    f->far = 0.5 * o->more_ab * grow;
    gap *= grow;
    f->gap = MAX(gap * gap, 0x1p-1000);

    for (i = 0; i < 3; i++) {
        f->b[i] = b->high[i] * o->per_b;
        across[i] = o->ab[i] * per_sine;
        f->toward_c[i] = o->ab[i] * side;
    }
    cross_rounded(f->b, across, f->toward_a);

    f->share_c = o->sin_ab / o->sine;
    f->share_a = per_sine;
    /* Of c along toward_a: b has none, and its difference to c is exact. */
    f->slant = dot(edge_c->high, f->toward_a) * o->per_c;
    f->cos_ab = o->cos_ab;
    f->cos_bc = o->cos_bc;
    f->per_a = o->per_a;
    f->per_b = o->per_b;
    f->per_c = o->per_c;
}

#endif
