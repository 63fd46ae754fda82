/* SPDX-License-Identifier: Apache-2.0 */
/* What is seen of the elements of a block, in loops that vectorise. Template: see precision.h. */

#define POSITIVE(x) ((x) > 0.0 ? 1.0 : 0.0)

/* An element of a wavefront in plain numbers. */
struct FN(psc_element) {
    double position[3], receiver[3], geometry[PSC_DISK_NUMBERS];
    double able; /* 0 if numbers are not finite, or there is a receiver without a direction */
};

PSC_LANE void FN(load_element)(const struct psc_wave *wave, int parts, size_t e,
                               struct FN(psc_element) *o)
{
    /* beyond all heights where there is no horizon */
    const double bare = wave->facing == PSC_FACING_NONE ? (double)INFINITY : 0.0;
    double sum = 0.0;
    int i;

    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        o->position[i] = wave->position[i][e];
        o->receiver[i] = wave->normal[i][e];
    }
    PSC_UNROLL
    for (i = 0; i < parts; i++)
        o->geometry[i] = wave->geometry[i][e];
    for (i = 0; i < 3; i++)
        sum += ((o->geometry[i] - o->position[i]) * 0.0 + o->position[i] * 0.0) +
               o->receiver[i] * 0.0;
    for (i = 0; i < parts; i++)
        sum += o->geometry[i] * 0.0;
    /* products of 0 and 1: choices of choices would be branches */
    o->able = (sum == 0.0 ? 1.0 : 0.0) * POSITIVE(bare + largest(o->receiver));
}

/* 1 if the light is above a horizon, given the height of its centre and how far it goes around. */
PSC_LANE double FN(is_above)(const struct psc_wave *wave, double middle, double reach)
{
    const double bare = wave->facing == PSC_FACING_NONE ? (double)INFINITY : 0.0;

    return POSITIVE(bare + (middle + reach));
}

/* 1 if a flat light shows a side that is lit; facing is -1 for its front. */
PSC_LANE double FN(is_lit)(const struct psc_wave *wave, double facing)
{
    return POSITIVE((wave->one_sided ? 0.0 : 2.0) - facing);
}

PSC_LANE void FN(wave_receiver)(const struct FN(psc_element) *from, struct FN(psc_disk_world) *w)
{
    double receiver[3];
    int i;

    unit_normal(from->receiver, receiver);
    for (i = 0; i < 3; i++) {
        w->center[i] = (real)from->geometry[i];
        w->receiver[i] = (real)receiver[i];
    }
}

/* The cone of element e; w has what is the light's own. */
PSC_LANE void FN(wave_cone)(const struct FN(psc_element) *from, enum psc_disk_map map,
                            const struct psc_outline *o, double unit, double able, size_t e,
                            struct FN(psc_disk_world) *w, struct FN(psc_disk_views) *to)
{
    const struct psc_ellipse *cone = &o->seen;
    const double total =
        ellipse_solid_angle(cone->a, cone->ca, cone->b, cone->cb, PSC_REGULAR_STEPS);
    int i, k;

    FN(cone_world)(cone, o->reach * unit, total, 1.0 / total, w);
    w->near = (real)o->near;
    w->far = (real)o->far;
    for (k = 0; k < 2; k++) {
        w->turn[k] = (real)o->turn[k];
        for (i = 0; i < 2; i++)
            w->side[k][i] = (real)o->side[k][i];
    }
    for (i = 0; i < 3; i++)
        w->axis[i] = w->z[i];
    FN(wave_receiver)(from, w);
    FN(store_cone)(w, cone, map, e, to);
    to->able[e] = able * from->able * (POSITIVE(cone->ca) * POSITIVE(total) *
                                       (cone->ca >= PSC_ELLIPSE_REGULAR * cone->cb ? 1.0 : 0.0));
}

/* The same of a light by area. */
PSC_LANE void FN(wave_area)(const struct FN(psc_element) *from, const double frame[3][3],
                            const struct psc_laid *f, double unit, double able, size_t e,
                            struct FN(psc_disk_world) *w, struct FN(psc_disk_views) *to)
{
    int i;

    FN(area_world)(f, unit, w);
    for (i = 0; i < 3; i++) {
        w->x[i] = (real)frame[0][i];
        w->y[i] = (real)frame[1][i];
        w->z[i] = (real)frame[2][i];
        w->axis[i] = K(0.0);
    }
    w->side[0][0] = w->side[1][1] = K(1.0);
    w->side[0][1] = w->side[1][0] = K(0.0);
    FN(wave_receiver)(from, w);
    FN(store_area)(w, e, to);
    to->able[e] = able * from->able * POSITIVE(f->height - AREA_LEAST);
}

PSC_LANE void FN(view_disk)(int area, const struct psc_wave *wave, enum psc_disk_map map, size_t e,
                            struct FN(psc_disk_views) *to)
{
    struct FN(psc_disk_world) w;
    struct FN(psc_element) from;
    struct psc_disk_look o;
    double radius, able, frame[3][3];
    struct psc_laid laid;
    int i, k;

    FN(load_element)(wave, 7, e, &from);
    radius = from.geometry[6];
    able = POSITIVE(radius) * POSITIVE(largest(from.geometry + 3));
    face_disk(from.position, from.geometry, &o);
    look_at_horizon(from.receiver, wave->facing == PSC_FACING_BOTH, &o);
    to->lit[e] = POSITIVE(o.height) * FN(is_lit)(wave, o.facing) *
                 FN(is_above)(wave, o.middle, o.reach);
    for (i = 0; i < 3; i++)
        w.normal[i] = (real)o.outward[i];
    if (area) {
        lay_disk(&o, frame, &laid);
        for (i = 0; i < 3; i++)
            for (k = 0; k < 2; k++)
                w.across[k][i] = (real)(radius * o.axes[k][i]);
        FN(wave_area)(&from, (const double(*)[3])frame, &laid, o.unit, able, e, &w, to);
    } else {
        look_at_disk(&o);
        for (i = 0; i < 3; i++)
            for (k = 0; k < 2; k++)
                w.across[k][i] = (real)disk_across(&o, radius, k, i);
        FN(wave_cone)(&from, map, &o.outline, o.unit, able * POSITIVE(o.seen), e, &w, to);
    }
}

PSC_LANE void FN(view_elliptical)(int area, const struct psc_wave *wave, enum psc_disk_map map,
                                  size_t e, struct FN(psc_disk_views) *to)
{
    struct FN(psc_disk_world) w;
    struct FN(psc_element) from;
    struct psc_ellipse_look o;
    double middle, reach, frame[3][3];
    struct psc_laid laid;
    int i, k;

    FN(load_element)(wave, 9, e, &from);
    face_ellipse(from.position, from.geometry, &o);
    see_horizon(from.receiver, wave->facing == PSC_FACING_BOTH, o.offset,
                (const double(*)[3])o.axes, 2, &middle, &reach);
    to->lit[e] = POSITIVE(o.height) * FN(is_lit)(wave, o.facing) *
                 FN(is_above)(wave, middle, reach);
    for (i = 0; i < 3; i++)
        w.normal[i] = (real)o.outward[i];
    if (area) {
        lay_ellipse(&o, frame, &laid);
        for (i = 0; i < 3; i++)
            for (k = 0; k < 2; k++)
                w.across[k][i] = (real)from.geometry[3 + 3 * k + i];
        FN(wave_area)(&from, (const double(*)[3])frame, &laid, o.unit, POSITIVE(o.area), e, &w, to);
    } else {
        look_at_ellipse(1, &o);
        for (i = 0; i < 3; i++)
            for (k = 0; k < 2; k++)
                w.across[k][i] = (real)ellipse_across(&o, k, i);
        FN(wave_cone)(&from, map, &o.outline, o.unit, POSITIVE(o.area) * POSITIVE(o.seen), e, &w,
                      to);
    }
}

/* From outside. */
PSC_LANE void FN(view_ellipsoid)(const struct psc_wave *wave, enum psc_disk_map map, size_t e,
                                 struct FN(psc_disk_views) *to)
{
    struct FN(psc_disk_world) w;
    struct FN(psc_element) from;
    struct psc_ellipsoid_look o;
    double middle, reach;
    int i, k;

    FN(load_element)(wave, 12, e, &from);
    look_at_ellipsoid(from.position, from.geometry, &o);
    look_from_outside(1, &o);
    see_horizon(from.receiver, wave->facing == PSC_FACING_BOTH, o.offset,
                (const double(*)[3])o.axes, 3, &middle, &reach);
    turn_pair((const double(*)[2])o.outline.side, o.solid_axis);
    turn_pair((const double(*)[2])o.outline.side, o.inverse);
    w.far_off = (real)o.far_off;
    w.beyond = (real)o.outer;
    w.unit = (real)o.unit;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++) {
            w.solid_axis[k][i] = (real)(o.solid_axis[k][i] * o.unit);
            w.inverse[k][i] = (real)o.inverse[k][i];
        }
        for (k = 0; k < 2; k++)
            w.across[k][i] = w.solid_axis[k][i];
        w.normal[i] = K(0.0);
    }
    FN(store_solid)(&w, e, to);
    to->lit[e] = FN(is_above)(wave, middle, reach);
    FN(wave_cone)(&from, map, &o.outline, o.unit,
                  POSITIVE(o.square) * POSITIVE(o.outline.seen.bt), e, &w, to);
}
#undef POSITIVE

#define VIEW_LOOP(name, view)                                                                      \
    static void FN(name)(const struct psc_wave *restrict wave, enum psc_disk_map map, size_t n,    \
                         struct FN(psc_disk_views) *restrict to)                                   \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++)                                                                    \
            view;                                                                                  \
    }
VIEW_LOOP(view_disk_cones, FN(view_disk)(0, wave, map, e, to))
VIEW_LOOP(view_disk_areas, FN(view_disk)(1, wave, map, e, to))
VIEW_LOOP(view_elliptical_cones, FN(view_elliptical)(0, wave, map, e, to))
VIEW_LOOP(view_elliptical_areas, FN(view_elliptical)(1, wave, map, e, to))
VIEW_LOOP(view_ellipsoid_cones, FN(view_ellipsoid)(wave, map, e, to))
#undef VIEW_LOOP

typedef void (*FN(view_loop))(const struct psc_wave *wave, enum psc_disk_map map, size_t n,
                              struct FN(psc_disk_views) *to);

static void FN(view_all)(const struct psc_wave *wave, FN(view_loop) loop, enum psc_disk_map map,
                         struct FN(psc_disk_views) *to, psc_result *status)
{
    size_t i;

    loop(wave, map, wave->count, to);
    for (i = 0; i < wave->count; i++)
        status[i] = !(to->able[i] > 0.0) ? PSC_PENDING
                    : to->lit[i] > 0.0   ? PSC_SUCCESS
                                         : PSC_EMPTY;
}
