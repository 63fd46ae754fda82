/* SPDX-License-Identifier: Apache-2.0 */
/* From the four corners of a sector to its constants, and sectors too wide for these to pieces. */
#ifndef PSC_SRC_SECTOR_BUILD_H
#define PSC_SRC_SECTOR_BUILD_H

#include "sector_light.h"

/* Where sectors go, how often one may still be halved, and twice the projected solid angle of
   those of a side. */
struct psc_sectors {
    struct psc_sector *sector;
    struct psc_sector_hit *hit;
    int count, halvings;
    double sum;
    /* Of a plain build: (D / 64)^2 and L^2, see projection_plain.h, and whether it will not do. */
    double reach, wide;
    int doubtful;
};

/* One end of a sector: U of length 1, what W is higher, and their weights as in psc_sector. */
struct psc_sector_end {
    double u[3], d, outer[2], inner[2];
};

/* A sector to be stored: both ends, and U_a x U_b. */
struct psc_sector_wide {
    struct psc_sector_end a, b;
    double across[3];
};

/* |v| for squares that may be less than the smallest number. */
PSC_LANE double length_of(double x, double y, double z)
{
    const double v[3] = {x, y, z}, square = (x * x + y * y) + z * z;
    double scale;

    if (is_fair(square))
        return SQRT(square);
    scale = unit_scale(largest(v));
    x *= scale;
    y *= scale;
    z *= scale;
    return SQRT((x * x + y * y) + z * z) / scale;
}

/* Puts m a + l b for each number of an end, but for u, which has to be of length 1. */
PSC_LANE void between_ends(const struct psc_sector_wide *wide, double m, double l,
                           struct psc_sector_end *to)
{
    const struct psc_sector_end *const a = &wide->a, *const b = &wide->b;
    int i;

    to->d = m * a->d + l * b->d;
    for (i = 0; i < 2; i++) {
        to->outer[i] = m * a->outer[i] + l * b->outer[i];
        to->inner[i] = m * a->inner[i] + l * b->inner[i];
    }
}

/* Cuts a sector at m a + l b, m + l = 1, keeps the first part and gives the second. Where the ends
   are nearly antipodal, the cut is across the difference of the two. */
static inline void cut_sector(struct psc_sector_wide *wide, double m, double l,
                              struct psc_sector_wide *rest)
{
    const double *const a = wide->a.u, *const b = wide->b.u, *const g = wide->across;
    double u[3], length;
    int i;

    for (i = 0; i < 3; i++)
        u[i] = m * a[i] + l * b[i];
    length = SQRT(dot(u, u));
    if (length < 0.5) {
        u[0] = b[1] - a[1];
        u[1] = a[0] - b[0];
        m = (u[0] * b[1] - u[1] * b[0]) / g[2];
        l = (a[0] * u[1] - a[1] * u[0]) / g[2];
        u[2] = m * a[2] + l * b[2];
        length = SQRT(dot(u, u));
    }
    length = 1.0 / length;
    m *= length;
    l *= length;
    *rest = *wide;
    between_ends(wide, m, l, &rest->a);
    for (i = 0; i < 3; i++) {
        rest->a.u[i] = u[i] * length;
        rest->across[i] = g[i] * m;
        wide->across[i] *= l;
    }
    wide->b = rest->a;
}

/* |W|, not cancelled. */
PSC_LANE double length_of_w(const struct psc_sector_end *end)
{
    return SQRT(1.0 + end->d * (2.0 * end->u[2] + end->d));
}

/* Whether U and W stay within reach of the nodes; if not, the shares of a and b to cut at. */
PSC_LANE int fits_sector(const struct psc_sector_wide *wide, const struct psc_sector *s,
                              double cut[2])
{
    const double widest = MAX(s->sine, s->sine_w);
    int i, fits_u = 1, fits_w = 1;

    /* U.U' is at least 1 - versine / 2, and W.W' larger. */
    if (0.25 * widest <= PSC_SECTOR_REACH * (1.0 - 0.5 * s->versine))
        return 1;
    for (i = 0; i < 4; i++) {
        const double h = i & 1 ? 0.25 : -0.25;
        struct psc_sector_place p;
        double x, y;

        sector_place(s, i & 2 ? 0.75 : 0.25, &p);
        x = p.uu + h * p.u1;
        y = x + (p.q + h * p.q1);
        fits_u &= 0.25 * s->sine <= PSC_SECTOR_REACH * x;
        fits_w &= 0.25 * s->sine_w <= PSC_SECTOR_REACH * y;
    }
    if (fits_u) {
        const double a = length_of_w(&wide->a), b = length_of_w(&wide->b);

        cut[0] = b / (a + b);
        cut[1] = a / (a + b);
    } else {
        cut[0] = cut[1] = 0.5;
    }
    return fits_u & fits_w;
}

/* All but the shares up to the nodes; k is not yet a share. */
PSC_LANE void sector_constants(const struct psc_sector_wide *wide, struct psc_sector *s)
{
    const struct psc_sector_end *const a = &wide->a, *const b = &wide->b;
    const double gx = wide->across[0], gy = wide->across[1];
    /* W_a x W_b less U_a x U_b */
    const double dx = b->d * a->u[1] - a->d * b->u[1], dy = a->d * b->u[0] - b->d * a->u[0];
    const double cosine = dot(a->u, b->u);

    s->ax = a->u[0];
    s->ay = a->u[1];
    s->az = a->u[2];
    s->bx = b->u[0];
    s->by = b->u[1];
    s->bz = b->u[2];
    s->da = a->d;
    s->db = b->d;
    s->k = wide->across[2];
    s->sine = length_of(gx, gy, s->k);
    s->sine_w = length_of(gx + dx, gy + dy, s->k);
    s->sine_more = (dx * (2.0 * gx + dx) + dy * (2.0 * gy + dy)) / (s->sine_w + s->sine);
    s->versine = cosine > 0.0 ? s->sine * s->sine / (1.0 + cosine) : 1.0 - cosine;
}

/* A sector that is still too wide when no halvings are left. That takes a polygon that is not
   convex, as one is seen from within the rounding of its own plane: all that is left to see to is
   that its numbers are some. */
static inline void force_sector(struct psc_sector *s)
{
    s->versine = MIN(s->versine, 1.0);
    s->sine = MIN(s->sine, 0.8);
    s->sine_w = s->sine;
    s->sine_more = 0.0;
}

/* Density at an end, where U_z is uz and W_z is uz + d, and half its derivative inwards (1, or -1 at
   the second end). What sector_place() gives is simple there. */
PSC_LANE void sector_rise(const struct psc_sector *s, double uz, double d, double inwards,
                          double *rise, double *bend)
{
    const double slope = s->bz - s->az, gain = s->db - s->da;
    const double q = d * (2.0 * uz + d), q1 = d * (slope + gain) + uz * gain;
    const double u1 = -inwards * s->versine, inverse = 1.0 / (1.0 + q);

    *rise = s->k * q * inverse;
    *bend = inwards * s->k * (q1 - q * (u1 + (u1 + q1) * inverse)) * inverse;
}

/* The integral over each quarter of a sector: all four in the time of one, as vector code. */
PSC_APART void sector_quarters(const struct psc_sector *restrict s, double *restrict mass)
{
    static const double node[4] = {0.25, 0.25, 0.75, 0.75}, step[4] = {-0.25, 0.25, -0.25, 0.25};
    int i;

    for (i = 0; i < 4; i++) {
        struct psc_sector_place p;

        sector_place(s, node[i], &p);
        mass[i] = sector_mass(s, &p, step[i]);
    }
}

/* What is left of the fields when the constants are there, as masses. */
PSC_LANE void sector_masses(struct psc_sector *s, double *sum)
{
    double mass[4];

    sector_quarters(s, mass);
    sector_rise(s, s->az, s->da, 1.0, &s->rise_a, &s->bend_a);
    sector_rise(s, s->bz, s->db, -1.0, &s->rise_b, &s->bend_b);
    s->start = *sum;
    s->quarter = s->start - mass[0];
    s->middle = s->quarter + mass[1];
    s->last = s->middle - mass[2];
    s->end = *sum = s->last + mass[3];
    /* Where W rises steeply the density does so next to the end alone: a cubic with that bend and
       the mass to the middle would fall again before. */
    s->bend_a = MIN(s->bend_a, 12.0 * (s->middle - s->start) - 4.0 * s->rise_a);
    s->bend_b = MIN(s->bend_b, 12.0 * (s->end - s->middle) - 4.0 * s->rise_b);
}

PSC_LANE void sector_hit(const struct psc_sector_wide *wide, const int corner[4],
                              struct psc_sector_hit *hit)
{
    int i;

    for (i = 0; i < 2; i++) {
        hit->outer[0][i] = wide->a.outer[i];
        hit->outer[1][i] = wide->b.outer[i];
        hit->inner[0][i] = wide->a.inner[i];
        hit->inner[1][i] = wide->b.inner[i];
        hit->corner[i] = (unsigned char)corner[i];
        hit->corner[2 + i] = (unsigned char)corner[2 + i];
    }
}

/* A sector whose constants are there. */
PSC_LANE void take_sector(struct psc_sectors *to, const struct psc_sector_wide *wide,
                          const int corner[4])
{
    sector_masses(to->sector + to->count, &to->sum);
    sector_hit(wide, corner, to->hit + to->count);
    to->count++;
}

/* Adds a sector in as many pieces as it needs. */
static void add_pieces(struct psc_sectors *to, const struct psc_sector_wide *wide,
                       const int corner[4])
{
    struct psc_sector_wide stack[PSC_MAX_SECTORS];
    int pending = 1;

    stack[0] = *wide;
    while (pending > 0) {
        struct psc_sector_wide *const top = stack + pending - 1;
        struct psc_sector *const s = to->sector + to->count;
        double cut[2];
        int fits;

        sector_constants(top, s);
        fits = fits_sector(top, s, cut);
        if (!fits && to->halvings > 0) {
            struct psc_sector_wide rest;

            cut_sector(top, cut[0], cut[1], &rest);
            top[1] = *top;
            top[0] = rest;
            pending++;
            to->halvings--;
        } else {
            if (!fits)
                force_sector(s);
            take_sector(to, top, corner);
            pending--;
        }
    }
}

/* Adds a sector. */
PSC_LANE void add_sector(struct psc_sectors *to, const struct psc_sector_wide *wide,
                         const int corner[4])
{
    struct psc_sector *const s = to->sector + to->count;
    double cut[2];

    sector_constants(wide, s);
    if (fits_sector(wide, s, cut))
        take_sector(to, wide, corner);
    else
        add_pieces(to, wide, corner);
}

/* From masses to shares: of all sectors from that number on. */
PSC_LANE void share_sectors(const struct psc_sectors *all, int first)
{
    const double inverse = 1.0 / all->sum;
    struct psc_sector *s;

    for (s = all->sector + first; s < all->sector + all->count; s++) {
        s->k *= inverse;
        s->start *= inverse;
        s->quarter *= inverse;
        s->middle *= inverse;
        s->last *= inverse;
        s->end *= inverse;
        s->rise_a *= inverse;
        s->bend_a *= inverse;
        s->rise_b *= inverse;
        s->bend_b *= inverse;
    }
}

#endif
