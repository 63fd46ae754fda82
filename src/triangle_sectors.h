/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The sectors of a triangle above the receiver's plane with the zenith outside: from the vertex
 * where azimuths begin, S, to that in the middle, M, and from there to the last, E. What
 * project_view() gives for it, without the ways that these lights do not take.
 */
#ifndef PSC_SRC_TRIANGLE_SECTORS_H
#define PSC_SRC_TRIANGLE_SECTORS_H

#include "projection_plain.h"

/* Numbers of the vertices, and of the edges between them; whether M is on the outer chain, not on
   the inner one. */
struct psc_azimuths {
    int s, m, e, whole, to_m, from_m, m_outside;
};

/* Which these are, by the z of the products of the edges: that of the edge from S to E alone is
   above 0, or that of the edge from E to S alone below. Whether the zenith is outside, and no edge
   vertical. */
PSC_LANE int sort_azimuths(const struct psc_receiver_view *view, struct psc_azimuths *o)
{
    const double flip = view->clockwise ? -1.0 : 1.0;
    const double x = flip * view->edge[0][2], y = flip * view->edge[1][2];
    const double z = flip * view->edge[2][2];
    const int first = x > 0.0, second = y > 0.0, third = z > 0.0;
    const int alone = first == second ? 2 : first == third ? 1 : 0;
    const int next = alone == 2 ? 0 : alone + 1, last = 3 - (alone + next);
    const int forward = (first + second + third == 2) == view->clockwise;

    o->m_outside = first + second + third == 2;
    o->s = forward ? alone : next;
    o->e = forward ? next : alone;
    o->m = last;
    o->whole = alone;
    o->to_m = forward ? last : next;
    o->from_m = forward ? next : last;
    return !(first == second && first == third) && x != 0.0 && y != 0.0 && z != 0.0;
}

/* S or E, as the end number `which` of an outer and of an inner edge; returns 1 / its distance. */
PSC_LANE double corner_end(const double p[3], int which, struct psc_sector_end *o)
{
    const double inverse = 1.0 / SQRT(dot(p, p));

    scale3(inverse, p, o->u);
    o->d = 0.0;
    o->outer[which] = o->inner[which] = inverse;
    o->outer[1 - which] = o->inner[1 - which] = 0.0;
    return inverse;
}

/* Both sectors; whether they are there, or project_view() has to look at it. */
PSC_LANE int triangle_sectors(const struct psc_plain_look *look, struct psc_sectors *to)
{
    const struct psc_receiver_view *const view = &look->view;
    struct psc_sector_wide first, second;
    struct psc_azimuths at;
    double per_s, per_e, per_m, whole, to_m, from_m, parts, per, by_s, by_e, by_m, least;
    double u[3];
    const double *m;

    if (!sort_azimuths(view, &at))
        return 0;
    m = view->point[at.m].p.high;
    whole = ABS(view->edge[at.whole][2]);
    to_m = ABS(view->edge[at.to_m][2]);
    from_m = ABS(view->edge[at.from_m][2]);
    parts = to_m + from_m;
    least = MIN(whole, parts);
    if (!(least * least > 0x1p-8 * look->across * look->longest))
        return 0;
    /* The point between S and E on the azimuth of M, or M there, is as far from the normal as U. */
    per = 1.0 / (at.m_outside ? whole : parts);
    by_s = from_m * per;
    by_e = to_m * per;
    by_m = at.m_outside ? 1.0 : whole * per;
    u[0] = m[0] * by_m;
    u[1] = m[1] * by_m;
    u[2] = at.m_outside ? m[2]
                        : by_s * view->point[at.s].p.high[2] + by_e * view->point[at.e].p.high[2];
    per_m = 1.0 / SQRT(dot(u, u));
    per_s = corner_end(view->point[at.s].p.high, 0, &first.a);
    per_e = corner_end(view->point[at.e].p.high, 1, &second.b);
    scale3(per_m, u, first.b.u);
    first.b.d = ABS(look->volume) * per * per_m;
    by_m *= per_m;
    if (at.m_outside) {
        first.b.outer[0] = second.a.outer[1] = 0.0;
        first.b.outer[1] = second.a.outer[0] = by_m;
        first.b.inner[0] = second.a.inner[0] = by_s * per_m;
        first.b.inner[1] = second.a.inner[1] = by_e * per_m;
        by_s = by_e = 1.0;
    } else {
        first.b.outer[0] = second.a.outer[0] = by_s * per_m;
        first.b.outer[1] = second.a.outer[1] = by_e * per_m;
        first.b.inner[0] = second.a.inner[1] = 0.0;
        first.b.inner[1] = second.a.inner[0] = by_m;
    }
    copy3(first.b.u, second.a.u);
    second.a.d = first.b.d;
    {
        const double *const g = view->edge[at.m_outside ? at.to_m : at.whole];
        const double *const h = view->edge[at.m_outside ? at.from_m : at.whole];

        scale3(COPYSIGN(by_e * (per_s * per_m), g[2]), g, first.across);
        scale3(COPYSIGN(by_s * (per_m * per_e), h[2]), h, second.across);
    }
    {
        const int inside[2][4] = {{at.s, at.e, at.s, at.m}, {at.s, at.e, at.m, at.e}};
        const int outside[2][4] = {{at.s, at.m, at.s, at.e}, {at.m, at.e, at.s, at.e}};

        add_sector(to, &first, at.m_outside ? outside[0] : inside[0]);
        add_sector(to, &second, at.m_outside ? outside[1] : inside[1]);
    }
    return 1;
}

/* What project_view() does, for these triangles. */
PSC_LANE int project_triangle(const struct psc_plain_look *look,
                              const struct psc_projection *what, struct psc_sector_light *o)
{
    struct psc_sectors to = {o->sector, o->hit, 0, PSC_MAX_SECTORS - 3, 0.0, 0.0, 0.0, 0};
    struct psc_sector_side *const side = o->side;
    int i;

    if (!triangle_sectors(look, &to))
        return -1;
    copy3(look->view.frame[0], side->x);
    copy3(look->view.frame[1], side->y);
    copy3(look->view.frame[2], side->z);
    side->total = MIN(0.5 * to.sum, PSC_PI);
    side->sector = side->edge = 0;
    side->sectors = to.count;
    side->edges = 3;
    share_sectors(&to, 0);
    for (i = 0; i < 3; i++) {
        scale3(look->view.clockwise ? -1.0 : 1.0, look->view.edge[i], o->edge[i]);
        vertex_corner(what, i, o, i);
    }
    return 1;
}

#endif
