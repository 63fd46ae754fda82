/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From a ring to sectors. Its edges that run counterclockwise around the zenith bound it outwards,
 * those that run clockwise inwards; both chains begin and end on the same azimuths, where radial
 * edges may lie between. Without an inner chain the zenith is in the light.
 */
#ifndef PSC_SRC_SECTOR_CHAIN_H
#define PSC_SRC_SECTOR_CHAIN_H

#include "ring.h"
#include "sector_build.h"

/* How much higher than U the zenith counts as: 1 / W^2 is less than rounding. */
#define PSC_ZENITH_RISE 0x1p60

/* What is left of an edge of a chain, in the order of azimuths: from p to q, across = p x q. p is
   share[0] of the light's point at the edge's beginning and share[1] of that at its end, q is
   share_q of the latter. */
struct psc_chain_edge {
    struct psc_ring_point p, q;
    double across[3], share[2], share_q;
    int from, to; /* points of the ring */
};

/* (p, q, r), the triple product: in proportion to the area between their coordinates on the light's
   surface; without these, the smaller error of two. */
static inline double triple(const struct psc_receiver_view *view, const struct psc_ring_point *p,
                            const struct psc_ring_point *q, const double across[3],
                            const struct psc_ring_point *r)
{
    double e1[3], e2[3], normal[3];

    if (view->place && !(p->own | q->own | r->own)) {
        ring_place_step(view, p, q, e1);
        ring_place_step(view, p, r, e2);
        return view->volume * product_difference(e1[0], e2[1], e1[1], e2[0]);
    }
    ring_step(view, p, q, e1);
    ring_step(view, p, r, e2);
    cross(e1, e2, normal);
    return dot(p->p, p->p) * (dot(e1, e1) * dot(e2, e2)) < dot(across, across) * dot(r->p, r->p)
               ? dot(p->p, normal)
               : dot(across, r->p);
}

static inline void take_edge(const struct psc_ring *ring, int from, int to, const double edge[3],
                             double sign, struct psc_chain_edge *o)
{
    int c;

    o->p = ring->point[from];
    o->q = ring->point[to];
    for (c = 0; c < 3; c++)
        o->across[c] = edge[c] * sign;
    o->share[0] = o->p.scale;
    o->share[1] = 0.0;
    o->share_q = o->q.scale;
    o->from = from;
    o->to = to;
}

/* A point a p + b q of an edge, and its shares; W there is `rise` higher than U, and is `multiple`
   of the point that the cut was asked for by, or over. */
struct psc_chain_cut {
    struct psc_ring_point at;
    double a, b, share[2], rise, multiple;
};

static inline void point_on(const struct psc_receiver_view *view, const struct psc_chain_edge *e,
                            struct psc_chain_cut *cut)
{
    const struct psc_ring_point *const near = cut->a < cut->b ? &e->q : &e->p;
    const double share = cut->a < cut->b ? -cut->a : cut->b;
    double step[3], place[2] = {0.0, 0.0};
    int c;

    ring_step(view, &e->p, &e->q, step);
    if (view->place)
        ring_place_step(view, &e->p, &e->q, place);
    for (c = 0; c < 3; c++) {
        cut->at.p[c] = cut->a * e->p.p[c] + cut->b * e->q.p[c];
        cut->at.offset[c] = near->offset[c] + share * step[c];
    }
    for (c = 0; c < 2; c++)
        cut->at.place[c] = near->place[c] + share * place[c];
    cut->at.at = near->at;
    cut->at.own = e->p.own | e->q.own;
    cut->share[0] = cut->a * e->share[0];
    cut->share[1] = cut->a * e->share[1] + cut->b * e->share_q;
}

/* Cuts an outer edge where the inner chain's vertex j is above it; whether it has any width. */
static inline int cut_outer(const struct psc_receiver_view *view,
                            const struct psc_chain_edge *o, const struct psc_ring_point *j,
                            struct psc_chain_cut *cut)
{
    const double to_q = cross2(view, j, &o->q), from_p = cross2(view, &o->p, j), k = o->across[2];
    const double near = MAX(to_q, 0.0), far = MAX(from_p, 0.0), sum = near + far;

    if (!(k > 0.0 && sum > 0.0))
        return 0;
    cut->a = near / sum;
    cut->b = far / sum;
    point_on(view, o, cut);
    if (dot(cut->at.p, cut->at.p) >= 0.01 * (cut->a * cut->a) * dot(o->p.p, o->p.p)) {
        cut->rise = triple(view, &o->p, &o->q, o->across, j) / sum;
        cut->multiple = k / sum;
    } else {
        /* The ends are nearly antipodal: from their plane. */
        cut->a = near / k;
        cut->b = far / k;
        point_on(view, o, cut);
        cut->at.own = 1;
        cut->at.p[0] = j->p[0];
        cut->at.p[1] = j->p[1];
        cut->at.p[2] = -(o->across[0] * j->p[0] + o->across[1] * j->p[1]) / k;
        cut->rise = j->p[2] - cut->at.p[2];
        cut->multiple = 1.0;
    }
    return 1;
}

/* Cuts an inner edge where it is above the outer chain's vertex q. */
static inline int cut_inner(const struct psc_receiver_view *view,
                            const struct psc_chain_edge *e, const struct psc_ring_point *q,
                            struct psc_chain_cut *cut)
{
    const double to_q = cross2(view, q, &e->q), from_p = cross2(view, &e->p, q), k = e->across[2];
    const double near = MAX(to_q, 0.0), far = MAX(from_p, 0.0), sum = near + far;

    if (!(k > 0.0 && sum > 0.0))
        return 0;
    cut->a = near / sum;
    cut->b = far / sum;
    point_on(view, e, cut);
    cut->rise = -triple(view, &e->p, &e->q, e->across, q) / k;
    cut->multiple = sum / k;
    return 1;
}

/* Leaves of an edge what is beyond a cut. */
static inline void shorten(struct psc_chain_edge *e, const struct psc_chain_cut *cut)
{
    int c;

    e->p = cut->at;
    e->share[0] = cut->share[0];
    e->share[1] = cut->share[1];
    for (c = 0; c < 3; c++)
        e->across[c] *= cut->a;
}

/* Shares of an edge at its end, as shares of the next edge at its beginning. */
static inline void begin_edge(double share[2])
{
    share[0] += share[1];
    share[1] = 0.0;
}

/* What the far end j of radial edges is higher than u, on the same azimuth and at the same
   distance from the zenith's axis; *share: W as a multiple of j. */
static inline double radial_rise(const struct psc_receiver_view *view,
                                 const struct psc_ring_point *u, const struct psc_ring_point *j,
                                 double *share)
{
    const double length = SQRT(u->p[0] * u->p[0] + u->p[1] * u->p[1]);
    const double other = SQRT(j->p[0] * j->p[0] + j->p[1] * j->p[1]);
    double e[3], across[3], rise;

    ring_step(view, u, j, e);
    cross(u->p, e, across);
    rise = SQRT(dot(across, across)) / other;
    *share = length / other;
    if (rise <= PSC_ZENITH_RISE * length)
        return rise;
    *share = PSC_ZENITH_RISE * length / j->p[2];
    return PSC_ZENITH_RISE * length;
}

/* The end of a sector at u: shares of the outer edge, rise of W and its shares. */
static inline void set_end(const double u[3], const double outer[2], double rise,
                           const double inner[2], struct psc_sector_end *end)
{
    const double inverse = 1.0 / SQRT(dot(u, u));
    int c;

    for (c = 0; c < 3; c++)
        end->u[c] = u[c] * inverse;
    for (c = 0; c < 2; c++) {
        end->outer[c] = outer[c] * inverse;
        end->inner[c] = inner[c] * inverse;
    }
    end->d = MAX(rise, 0.0) * inverse;
}

/* The sector between two ends, made from the points a and b of the outer edge; across = a x b. */
static inline void emit_sector(struct psc_sectors *to, const struct psc_sector_end *first,
                               const struct psc_sector_end *second, const double a[3],
                               const double b[3], const double across[3], double share,
                               const int corner[4])
{
    const double inverse = share / (SQRT(dot(a, a)) * SQRT(dot(b, b)));
    struct psc_sector_wide wide;
    int c;

    wide.a = *first;
    wide.b = *second;
    for (c = 0; c < 3; c++)
        wide.across[c] = across[c] * inverse;
    if (wide.across[2] > 0.0)
        add_sector(to, &wide, corner);
}

PSC_LANE int ring_next(const struct psc_ring *ring, int i)
{
    return i + 1 < ring->count ? i + 1 : 0;
}

PSC_LANE int ring_last(const struct psc_ring *ring, int i)
{
    return i > 0 ? i - 1 : ring->count - 1;
}

/* The light's point at the zenith, from the triangle of the ring's fan that holds it: shares of its
   corners; returns how high it is. */
static inline double find_zenith(const struct psc_receiver_view *view,
                                 const struct psc_ring *ring, int corner[3], double share[3])
{
    double best = -DBL_MAX, sum = 0.0, height = 0.0;
    int i, c;

    corner[0] = 0;
    corner[1] = 1;
    for (i = 1; i + 1 < ring->count; i++) {
        const double across = cross2(view, ring->point + i + 1, ring->point);
        const double before = cross2(view, ring->point, ring->point + i);
        const double least = MIN(across, before);

        corner[1] = least > best ? i : corner[1];
        best = MAX(least, best);
    }
    corner[2] = corner[1] + 1;
    for (c = 0; c < 3; c++) {
        const double opposite = cross2(view, ring->point + corner[(c + 1) % 3],
                                       ring->point + corner[(c + 2) % 3]);

        share[c] = MAX(opposite, 0.0);
        height += share[c] * ring->point[corner[c]].p[2];
        share[c] *= ring->point[corner[c]].scale;
        sum += share[c];
    }
    for (c = 0; c < 3; c++)
        share[c] /= sum;
    return height / sum;
}

/* Sectors of a light that holds the zenith; that is corner number `zenith`, at the height high. */
static inline void zenith_sectors(const struct psc_ring *ring, int base, int zenith, double high,
                                  struct psc_sectors *to)
{
    int i;

    for (i = 0; i < ring->count; i++) {
        const int next = ring_next(ring, i);
        const struct psc_ring_point *const p = ring->point + i, *const q = ring->point + next;
        const int corner[4] = {base + i, base + next, zenith, zenith};
        const double first[2] = {p->scale, 0.0}, second[2] = {0.0, q->scale};
        const double rise_p = PSC_ZENITH_RISE * SQRT(dot(p->p, p->p));
        const double rise_q = PSC_ZENITH_RISE * SQRT(dot(q->p, q->p));
        const double inner_p[2] = {rise_p / high, 0.0}, inner_q[2] = {rise_q / high, 0.0};
        struct psc_sector_end a, b;

        set_end(p->p, first, rise_p, inner_p, &a);
        set_end(q->p, second, rise_q, inner_q, &b);
        emit_sector(to, &a, &b, p->p, q->p, ring->edge[i], 1.0, corner);
    }
}

/* The edges that bound a ring outwards, first to last in its order, and those that bound it
   inwards; whether there are such. Edges between the two are radial, to rounding. */
static inline int find_chains(const struct psc_ring *ring, int outer[2], int inner[2])
{
    double most = 0.0, least = 0.0;
    int i, out = -1, in = -1;

    outer[0] = outer[1] = inner[0] = inner[1] = 0;
    for (i = 0; i < ring->count; i++) {
        const double *const g = ring->edge[i];
        const double slope = g[2] / length_of(g[0], g[1], g[2]);

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

/* Sectors of a light that the zenith is outside of: between the ends of edges of either chain, in
   the order of azimuths. `base` is the corner number of the ring's first point. */
static inline void chain_sectors(const struct psc_receiver_view *view,
                                 const struct psc_ring *ring, const int chain_o[2],
                                 const int chain_i[2], int base, struct psc_sectors *to)
{
    struct psc_chain_edge o, e; /* of the outer and the inner chain */
    struct psc_sector_end first, second;
    int at_o = chain_o[0], at_i = chain_i[1];
    double share[2], rise, multiple = 1.0;

    take_edge(ring, at_o, ring_next(ring, at_o), ring->edge[at_o], 1.0, &o);
    take_edge(ring, ring_next(ring, at_i), at_i, ring->edge[at_i], -1.0, &e);
    rise = o.from == e.from ? 0.0 : radial_rise(view, &o.p, &e.p, &multiple);
    share[0] = e.share[0] * multiple;
    share[1] = 0.0;
    set_end(o.p.p, o.share, rise, share, &first);
    for (;;) {
        const int corner[4] = {base + o.from, base + o.to, base + e.from, base + e.to};
        const int last_o = at_o == chain_o[1], last_i = at_i == chain_i[0];
        const double turn = cross2(view, &o.q, &e.q);
        const int outer_first = !last_o && (last_i || turn > 0.0);
        const int inner_first = !last_i && (last_o || turn < 0.0);
        const double end_o[2] = {0.0, o.share_q};
        double inner[2];

        if (outer_first) {
            struct psc_chain_cut cut;

            if (cut_inner(view, &e, &o.q, &cut)) {
                inner[0] = cut.share[0] * cut.multiple;
                inner[1] = cut.share[1] * cut.multiple;
                set_end(o.q.p, end_o, cut.rise, inner, &second);
                emit_sector(to, &first, &second, o.p.p, o.q.p, o.across, 1.0, corner);
                shorten(&e, &cut);
                first = second;
            }
            at_o = ring_next(ring, at_o);
            take_edge(ring, at_o, ring_next(ring, at_o), ring->edge[at_o], 1.0, &o);
            begin_edge(first.outer);
        } else if (inner_first) {
            struct psc_chain_cut cut;

            if (cut_outer(view, &o, &e.q, &cut)) {
                inner[0] = 0.0;
                inner[1] = e.share_q * cut.multiple;
                set_end(cut.at.p, cut.share, cut.rise, inner, &second);
                emit_sector(to, &first, &second, o.p.p, cut.at.p, o.across, cut.b, corner);
                shorten(&o, &cut);
                first = second;
            }
            at_i = ring_last(ring, at_i);
            take_edge(ring, ring_next(ring, at_i), at_i, ring->edge[at_i], -1.0, &e);
            begin_edge(first.inner);
        } else {
            rise = o.to == e.to ? 0.0 : radial_rise(view, &o.q, &e.q, &multiple);
            inner[0] = 0.0;
            inner[1] = e.share_q * (o.to == e.to ? 1.0 : multiple);
            set_end(o.q.p, end_o, rise, inner, &second);
            emit_sector(to, &first, &second, o.p.p, o.q.p, o.across, 1.0, corner);
            if (last_o && last_i)
                return;
            at_o = ring_next(ring, at_o);
            at_i = ring_last(ring, at_i);
            take_edge(ring, at_o, ring_next(ring, at_o), ring->edge[at_o], 1.0, &o);
            take_edge(ring, ring_next(ring, at_i), at_i, ring->edge[at_i], -1.0, &e);
            first = second;
            begin_edge(first.outer);
            begin_edge(first.inner);
        }
    }
}

#endif
