/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From a ring to sectors. Its edges that run counterclockwise around the zenith bound it outwards,
 * those that run clockwise inwards; both chains begin and end on the same azimuths, where radial
 * edges may lie between. Without an inner chain the zenith is in the light: see sector_zenith.h.
 */
#ifndef PSC_SRC_SECTOR_CHAIN_H
#define PSC_SRC_SECTOR_CHAIN_H

#include "ring.h"
#include "sector_build.h"

/* How much higher than U the zenith counts as: 1 / W^2 is less than rounding. */
#define PSC_ZENITH_RISE 0x1p60

/* An edge of a chain in the order of azimuths: from p to q, points number `from` and `to` of the
   ring; across = p x q. */
struct psc_chain_edge {
    const struct psc_ring_point *p, *q;
    double across[3];
    int from, to;
};

PSC_LANE void take_edge(const struct psc_ring *ring, int from, int to, const double edge[3],
                        double sign, struct psc_chain_edge *o)
{
    o->p = ring->point[from];
    o->q = ring->point[to];
    scale3(sign, edge, o->across);
    o->from = from;
    o->to = to;
}

/* The ends of a sector and what lies between: u and d as in psc_sector_end are still lengths of
   the light's points. U is weight outer[0] of the outer edge's p and outer[1] of its q. */
struct psc_chain_end {
    double u[3], rise, outer[2], inner[2];
    double inverse; /* 1 / |u| */
    int of_inner; /* it is at the azimuth of a point of the inner chain */
    double per;   /* then: its x and y times z of the outer edge's p x q times this are U's */
};

/* Of a plain build: keeps in mind whether rounding may have had a say in z of the product of a
   point with the edge from p to q, which is to be divided by. */
PSC_LANE void doubt_across(const struct psc_ring_point *p, const struct psc_ring_point *q,
                           double across, struct psc_sectors *to)
{
    double step[3];

    plain_step(p, q, step);
    to->doubtful |= !(across * across > to->reach * dot(step, step));
}

PSC_LANE void end_at(const double u[3], struct psc_chain_end *end)
{
    copy3(u, end->u);
    end->inverse = 1.0 / SQRT(dot(u, u));
}

/* U over the inner chain's point j: between the ends of the outer edge, on the azimuth of j.
   to_q and from_p are z of j x q and of p x j. Whether the edge has any width. x and y are those of
   j, since the ends may be nearly antipodal; heights add up. */
PSC_LANE int end_at_inner(int plain, const struct psc_chain_edge *o,
                          const struct psc_ring_point *j, double to_q, double from_p,
                          struct psc_chain_end *end, struct psc_sectors *to)
{
    const double near = MAX(to_q, 0.0), far = MAX(from_p, 0.0), k = o->across[2];
    const double per = 1.0 / (near + far);
    double u[3];

    if (!(k > 0.0 && near + far >= DBL_MIN))
        return 0;
    if (plain)
        doubt_across(o->p, o->q, near + far, to);
    end->outer[0] = near * per;
    end->outer[1] = far * per;
    end->inner[0] = 0.0;
    end->inner[1] = k * per;
    u[0] = j->p.high[0] * end->inner[1];
    u[1] = j->p.high[1] * end->inner[1];
    u[2] = end->outer[0] * o->p->p.high[2] + end->outer[1] * o->q->p.high[2];
    end_at(u, end);
    end->rise = ring_volume(plain, o->p, o->q, j) * per;
    end->of_inner = 1;
    end->per = per;
    return 1;
}

/* W over the outer edge's end q: between the ends i and j of the inner edge, of which to_j and
   from_i are z of q x j and of i x q. */
PSC_LANE int end_at_outer(int plain, const struct psc_chain_edge *o,
                          const struct psc_chain_edge *e, double to_j, double from_i,
                          struct psc_chain_end *end, struct psc_sectors *to)
{
    const double near = MAX(to_j, 0.0), far = MAX(from_i, 0.0), k = e->across[2];

    if (!(k > 0.0 && near + far > 0.0))
        return 0;
    if (plain)
        doubt_across(e->p, e->q, k, to);
    end_at(o->q->p.high, end);
    end->outer[0] = 0.0;
    end->outer[1] = 1.0;
    end->inner[0] = near / k;
    end->inner[1] = far / k;
    end->rise = -ring_volume(plain, e->p, e->q, o->q) / k;
    end->of_inner = 0;
    return 1;
}

/* U at one end of radial edges, W at the other, j; weights for the q of both chains. */
PSC_LANE void end_at_both(int plain, const struct psc_ring_point *u,
                          const struct psc_ring_point *j, struct psc_chain_end *end,
                          struct psc_sectors *to)
{
    const double *const at = u->p.high, *const other = j->p.high;
    double length, reach, across[3];

    end_at(at, end);
    end->outer[0] = end->inner[0] = 0.0;
    end->outer[1] = end->inner[1] = 1.0;
    end->of_inner = 0;
    end->rise = 0.0;
    if (u == j)
        return;
    /* What j is higher at the distance of u from the zenith's axis. */
    length = SQRT(at[0] * at[0] + at[1] * at[1]);
    reach = SQRT(other[0] * other[0] + other[1] * other[1]);
    to->doubtful |= plain && !(reach * reach > to->reach);
    ring_cross(plain, u, j, across);
    end->rise = SQRT(dot(across, across)) / reach;
    end->inner[1] = length / reach;
    if (end->rise <= PSC_ZENITH_RISE * length)
        return;
    end->rise = PSC_ZENITH_RISE * length;
    end->inner[1] = end->rise / other[2];
}

/* z of U_a x U_b of the outer edge: as a share of that of its ends. */
PSC_LANE double share_between(const struct psc_chain_edge *o, const struct psc_chain_edge *e,
                                   const struct psc_chain_end *a, const struct psc_chain_end *b)
{
    const double whole = o->across[2], inner = e->across[2];

    if (a->of_inner && b->of_inner)
        return (inner * a->per) * (whole * b->per);
    return a->of_inner ? a->outer[0] : b->of_inner ? b->outer[1] : 1.0;
}

/* The sector between two ends; across = share times that of the outer edge. */
PSC_LANE void emit_sector(struct psc_sectors *to, const struct psc_chain_end *first,
                               const struct psc_chain_end *second, const double across[3],
                               double share, const int corner[4])
{
    const double per_a = first->inverse, per_b = second->inverse;
    struct psc_sector_wide wide;
    int c;

    scale3(per_a, first->u, wide.a.u);
    scale3(per_b, second->u, wide.b.u);
    wide.a.d = MIN(MAX(first->rise, 0.0) * per_a, PSC_ZENITH_RISE);
    wide.b.d = MIN(MAX(second->rise, 0.0) * per_b, PSC_ZENITH_RISE);
    PSC_UNROLL
    for (c = 0; c < 2; c++) {
        wide.a.outer[c] = first->outer[c] * per_a;
        wide.a.inner[c] = first->inner[c] * per_a;
        wide.b.outer[c] = second->outer[c] * per_b;
        wide.b.inner[c] = second->inner[c] * per_b;
    }
    scale3(share * (per_a * per_b), across, wide.across);
    if (wide.across[2] > 0.0)
        add_sector(to, &wide, corner);
}

/* Of a number for the q of an edge, the same for the p of the next. */
static inline void begin_edge(double weight[2])
{
    weight[0] += weight[1];
    weight[1] = 0.0;
}

/* The edges that bound a ring outwards, first to last in its order, and those that bound it
   inwards; whether there are such. Edges between the two are radial, to rounding. */
PSC_LANE int find_chains(int plain, const struct psc_ring *ring, int outer[2], int inner[2])
{
    double most = 0.0, least = 0.0;
    int i, out = -1, in = -1;

    outer[0] = outer[1] = inner[0] = inner[1] = 0;
    for (i = 0; i < ring->count; i++) {
        const double *const g = ring->edge[i];
        /* That which is known best, unless all are. */
        const double slope = plain ? g[2] : g[2] / length_of(g[0], g[1], g[2]);

        out = slope > most ? i : out;
        most = MAX(slope, most);
        in = slope < least ? i : in;
        least = MIN(slope, least);
    }
    if (out < 0 || in < 0)
        return 0;
    for (i = in; !(ring->edge[i][2] > 0.0); i = ring_next(ring, i))
        inner[1] = ring->edge[i][2] < 0.0 ? i : inner[1];
    outer[0] = i;
    for (i = out; !(ring->edge[i][2] < 0.0); i = ring_next(ring, i))
        outer[1] = ring->edge[i][2] > 0.0 ? i : outer[1];
    inner[0] = i;
    return 1;
}

PSC_LANE void swap_ends(struct psc_chain_end **a, struct psc_chain_end **b)
{
    struct psc_chain_end *const was = *a;

    *a = *b;
    *b = was;
}

/* Sectors of a light that the zenith is outside of: between the ends of edges of either chain, in
   the order of azimuths. `base` is the corner number of the ring's first point. */
PSC_LANE void chain_sectors(int plain, const struct psc_ring *ring, const int chain_o[2],
                            const int chain_i[2], int base, struct psc_sectors *to)
{
    struct psc_chain_edge o, e; /* of the outer and the inner chain */
    struct psc_chain_end ends[2], *first = ends, *second = ends + 1;
    int at_o = chain_o[0], at_i = chain_i[1];

    take_edge(ring, at_o, ring_next(ring, at_o), ring->edge[at_o], 1.0, &o);
    take_edge(ring, ring_next(ring, at_i), at_i, ring->edge[at_i], -1.0, &e);
    end_at_both(plain, o.p, e.p, first, to);
    begin_edge(first->outer);
    begin_edge(first->inner);
    for (;;) {
        const int corner[4] = {base + o.from, base + o.to, base + e.from, base + e.to};
        const int last_o = at_o == chain_o[1], last_i = at_i == chain_i[0];
        const double turn = cross2(plain, o.q, e.q);
        const int outer_first = !last_o && (last_i || turn > 0.0);
        const int inner_first = !last_i && (last_o || turn < 0.0);
        int wide = 1;

        if (outer_first)
            wide = end_at_outer(plain, &o, &e, turn, cross2(plain, e.p, o.q), second, to);
        else if (inner_first)
            wide = end_at_inner(plain, &o, e.q, -turn, cross2(plain, o.p, e.q), second, to);
        else
            end_at_both(plain, o.q, e.q, second, to);
        if (wide) {
            emit_sector(to, first, second, o.across, share_between(&o, &e, first, second), corner);
            swap_ends(&first, &second);
        }
        if (!outer_first && !inner_first && last_o && last_i)
            return;
        if (!inner_first) {
            at_o = ring_next(ring, at_o);
            take_edge(ring, at_o, ring_next(ring, at_o), ring->edge[at_o], 1.0, &o);
            begin_edge(first->outer);
            first->of_inner = 0;
        }
        if (!outer_first) {
            at_i = ring_last(ring, at_i);
            take_edge(ring, ring_next(ring, at_i), at_i, ring->edge[at_i], -1.0, &e);
            begin_edge(first->inner);
        }
    }
}

#endif
