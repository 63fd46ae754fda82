/* SPDX-License-Identifier: Apache-2.0 */
/* What is seen of a block of lights, as arrays. Template: see precision.h. */

/* The numbers of psc_disk_world: of a cone and a flat light, and of solid ones. */
#define FLAT_NUMBERS(X)                                                                            \
    X(a) X(ca) X(b) X(cb) X(per_at) X(per_bt) X(ca2) X(cb2) X(mu1) X(mu2) X(quasi_scale)           \
    X(inverse_quasi_scale) X(near) X(far) X(reach) X(total) X(inverse_total) X(flat_b)             \
    X(area_scale) X(area_reach)
#define FLAT_VECTORS(X) X(x) X(y) X(z) X(axis) X(center) X(normal) X(receiver)
#define SOLID_NUMBERS(X) X(far_off) X(beyond) X(unit)
#define SOLID_MATRICES(X) X(solid_axis) X(inverse)

struct FN(psc_disk_views) {
#define ARRAY(name) real name[PSC_BLOCK];
    FLAT_NUMBERS(ARRAY)
    SOLID_NUMBERS(ARRAY)
#undef ARRAY
#define ARRAY(name) real name[3][PSC_BLOCK];
    FLAT_VECTORS(ARRAY)
#undef ARRAY
#define ARRAY(name) real name[3][3][PSC_BLOCK];
    SOLID_MATRICES(ARRAY)
#undef ARRAY
    real turn[2][PSC_BLOCK], side[2][2][PSC_BLOCK], across[2][3][PSC_BLOCK];
    real bend[PSC_BLOCK];       /* cb^2 - ca^2 */
    double quotient[PSC_BLOCK]; /* what rules are chosen by */
    double able[PSC_BLOCK], lit[PSC_BLOCK]; /* of disks, if > 0: this serves them; they are seen */
    struct FN(psc_disk_points) points;
};

PSC_LANE void FN(load_world)(const struct FN(psc_disk_views) *from, size_t e,
                             struct FN(psc_disk_world) *w)
{
    int i, k;

#define LOAD(name) w->name = from->name[e];
    FLAT_NUMBERS(LOAD)
    SOLID_NUMBERS(LOAD)
#undef LOAD
    for (i = 0; i < 3; i++) {
#define LOAD(name) w->name[i] = from->name[i][e];
        FLAT_VECTORS(LOAD)
#undef LOAD
#define LOAD(name) w->name[k][i] = from->name[k][i][e];
        for (k = 0; k < 3; k++) {
            SOLID_MATRICES(LOAD)
        }
        for (k = 0; k < 2; k++)
            LOAD(across)
    }
    for (k = 0; k < 2; k++) {
        w->turn[k] = from->turn[k][e];
        for (i = 0; i < 2; i++)
            LOAD(side)
    }
#undef LOAD
}

PSC_LANE void FN(store_flat)(const struct FN(psc_disk_world) *w, size_t e,
                             struct FN(psc_disk_views) *to)
{
    int i, k;

#define STORE(name) to->name[e] = w->name;
    FLAT_NUMBERS(STORE)
#undef STORE
    for (i = 0; i < 3; i++) {
#define STORE(name) to->name[i][e] = w->name[i];
        FLAT_VECTORS(STORE)
#undef STORE
        for (k = 0; k < 2; k++)
            to->across[k][i][e] = w->across[k][i];
    }
    for (k = 0; k < 2; k++) {
        to->turn[k][e] = w->turn[k];
        for (i = 0; i < 2; i++)
            to->side[k][i][e] = w->side[k][i];
    }
}

PSC_LANE void FN(store_solid)(const struct FN(psc_disk_world) *w, size_t e,
                              struct FN(psc_disk_views) *to)
{
    int i, k;

#define STORE(name) to->name[e] = w->name;
    SOLID_NUMBERS(STORE)
#undef STORE
#define STORE(name) to->name[k][i][e] = w->name[k][i];
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            SOLID_MATRICES(STORE)
        }
#undef STORE
}

/* What rules are chosen by, and of the cone what the world has not. */
PSC_LANE void FN(store_cone)(const struct psc_ellipse *e, enum psc_disk_map map, size_t i,
                             struct FN(psc_disk_views) *to)
{
    to->bend[i] = (real)((e->cb - e->ca) * (e->cb + e->ca));
    to->quotient[i] = rule_quotient(map, e->ca, e->cb);
}

#define RULE_AT_LEAST(i, m, steps, least) quotient >= (least) ? (i) :
static int FN(rule_of)(enum psc_disk_map map, double quotient)
{
    return map == PSC_DISK_PARALLEL ? SPAN_RULES(RULE_AT_LEAST) -1 : DISK_RULES(RULE_AT_LEAST) -1;
}
#undef RULE_AT_LEAST

/* ---- Disks ---- */

/* 0 if all the numbers of an element are finite, else NaN. */
PSC_LANE double FN(not_finite)(const double position[3], const double receiver[3],
                               const double geometry[7])
{
    double sum = geometry[6] * 0.0;
    int i;

    for (i = 0; i < 3; i++)
        sum += ((geometry[i] - position[i]) * 0.0 + geometry[i] * 0.0) +
               (position[i] * 0.0 + geometry[3 + i] * 0.0) + receiver[i] * 0.0;
    return sum;
}

#define POSITIVE(x) ((x) > 0.0 ? 1.0 : 0.0)

/* Element e of disks. */
PSC_LANE void FN(view_disk)(int area, const struct psc_wave *wave, enum psc_disk_map map,
                              size_t e, struct FN(psc_disk_views) *restrict to)
{
    const double position[3] = {wave->position[0][e], wave->position[1][e],
                                wave->position[2][e]};
    const double receiver[3] = {wave->normal[0][e], wave->normal[1][e], wave->normal[2][e]};
    /* beyond all heights where there is no horizon, and for lights of two sides */
    const double bare = wave->facing == PSC_FACING_NONE ? (double)INFINITY : 0.0;
    const double front = wave->one_sided ? 0.0 : 2.0;
    double geometry[7], unit_receiver[3], total, lit, able;
    struct FN(psc_disk_world) w;
    struct psc_disk_look o;
    const struct psc_ellipse *cone = &o.outline.seen;
    int i, k;

    for (k = 0; k < 7; k++)
        geometry[k] = wave->geometry[k][e];
    look_at_disk(position, geometry, &o);
    look_at_horizon(receiver, wave->facing == PSC_FACING_BOTH, &o);
    unit_normal(receiver, unit_receiver);
    /* products of 0 and 1: choices of choices would be branches */
    able = POSITIVE(geometry[6]) * POSITIVE(largest(geometry + 3)) *
           (FN(not_finite)(position, receiver, geometry) == 0.0 ? 1.0 : 0.0);
    able *= POSITIVE(bare + largest(receiver));
    lit = POSITIVE(o.seen) * POSITIVE(front - o.facing) * POSITIVE(bare + (o.middle + o.reach));
    if (area) {
        total = disk_area(geometry[6]);
        able *= POSITIVE(cone->ca - AREA_LEAST);
    } else {
        total = ellipse_solid_angle(cone->a, cone->ca, cone->b, cone->cb, PSC_REGULAR_STEPS);
        able *= POSITIVE(cone->ca) * POSITIVE(total) *
                (cone->ca >= PSC_ELLIPSE_REGULAR * cone->cb ? 1.0 : 0.0);
    }
    FN(cone_world)(cone, o.outline.reach * o.unit, total, 1.0 / total, &w);
    w.near = (real)o.outline.near;
    w.far = (real)o.outline.far;
    for (k = 0; k < 2; k++) {
        w.turn[k] = (real)o.outline.turn[k];
        for (i = 0; i < 2; i++)
            w.side[k][i] = (real)o.outline.side[k][i];
        for (i = 0; i < 3; i++)
            w.across[k][i] = (real)disk_across(&o, geometry[6], k, i);
    }
    for (i = 0; i < 3; i++) {
        w.axis[i] = w.z[i];
        w.center[i] = (real)geometry[i];
        w.normal[i] = (real)o.outward[i];
        w.receiver[i] = (real)unit_receiver[i];
    }
    FN(store_flat)(&w, e, to);
    FN(store_cone)(cone, map, e, to);
    to->able[e] = able;
    to->lit[e] = lit;
}

#define VIEW_LOOP(name, area)                                                                      \
    static void FN(name)(const struct psc_wave *restrict wave, enum psc_disk_map map, size_t n,    \
                         struct FN(psc_disk_views) *restrict to)                                   \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++)                                                                    \
            FN(view_disk)(area, wave, map, e, to);                                  \
    }
VIEW_LOOP(view_disk_cones, 0)
VIEW_LOOP(view_disk_areas, 1)
#undef VIEW_LOOP

static void FN(view_disks)(const struct psc_wave *wave, enum psc_disk_map map,
                           struct FN(psc_disk_views) *to, psc_result *status)
{
    size_t i;

    if (wave->measure == PSC_MEASURE_AREA)
        FN(view_disk_areas)(wave, map, wave->count, to);
    else
        FN(view_disk_cones)(wave, map, wave->count, to);
    for (i = 0; i < wave->count; i++)
        status[i] = !(to->able[i] > 0.0) ? PSC_PENDING
                    : to->lit[i] > 0.0   ? PSC_SUCCESS
                                         : PSC_EMPTY;
}

/* ---- Elliptical disks and ellipsoids, each on its own ---- */

typedef psc_result (*FN(disk_see))(psc_sampler *, const struct psc_request *, const double *);

/* Whether the numbers of an element are ones that a build takes. */
static int FN(wave_checks)(const struct psc_wave *wave, size_t i)
{
    double sum = 0.0;
    int k;

    for (k = 0; k < 3; k++)
        sum += wave->position[k][i] * 0.0 + wave->normal[k][i] * 0.0;
    for (k = 0; k < wave->parts; k++)
        sum += wave->geometry[k][i] * 0.0;
    return sum == 0.0 && (wave->facing == PSC_FACING_NONE || wave->normal[0][i] != 0.0 ||
                          wave->normal[1][i] != 0.0 || wave->normal[2][i] != 0.0);
}

/* Sees element i. */
static psc_result FN(see_element)(const struct psc_wave *wave, FN(disk_see) see, size_t i,
                                  psc_sampler *s)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i],
                                wave->position[2][i]};
    const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
    double geometry[PSC_MAX_GEOMETRY];
    struct psc_request request;
    psc_result result;
    int k;

    if (!FN(wave_checks)(wave, i))
        return PSC_PENDING;
    request.measure = wave->measure;
    request.map = wave->map;
    request.facing = wave->facing;
    request.position = position;
    request.normal = wave->facing == PSC_FACING_NONE ? NULL : normal;
    request.one_sided = wave->one_sided;
    request.table = wave->table;
    request.numbers = wave->parts;
    for (k = 0; k < wave->parts; k++)
        geometry[k] = wave->geometry[k][i];
    result = see(s, &request, geometry);
    return result < 0 ? PSC_PENDING : result;
}

static psc_result FN(view_one)(const struct psc_wave *wave, FN(disk_see) see, size_t i,
                               psc_sampler *s)
{
    const psc_result result = FN(see_element)(wave, see, i, s);

    if (result != PSC_SUCCESS)
        return result;
    if (s->disk.inside || !(s->disk.seen.ca > 0.0))
        return PSC_PENDING;
    disk_head(s, wave->table);
    s->inverse_total = 1.0 / s->total;
    return !(s->total > 0.0)                                              ? PSC_EMPTY
           : wave->measure == PSC_MEASURE_AREA && !AREA_FITS(&s->disk) ? PSC_PENDING
                                                                       : PSC_SUCCESS;
}

static void FN(view_each)(const struct psc_wave *wave, FN(disk_see) see, enum psc_disk_map map,
                          struct FN(psc_disk_views) *to, psc_result *status)
{
    struct FN(psc_disk_world) w;
    psc_sampler s;
    size_t i;

    memset(&w, 0, sizeof w);
    s.measure = wave->measure;
    s.map = wave->map;
    s.facing = wave->facing;
    for (i = 0; i < wave->count; i++) {
        status[i] = FN(view_one)(wave, see, i, &s);
        if (status[i] == PSC_SUCCESS)
            FN(disk_world)(&s, &w);
        FN(store_flat)(&w, i, to);
        FN(store_solid)(&w, i, to);
        if (status[i] == PSC_SUCCESS)
            FN(store_cone)(&s.disk.seen, map, i, to);
    }
}

static void FN(view_ellipticals)(const struct psc_wave *wave, enum psc_disk_map map,
                                 struct FN(psc_disk_views) *to, psc_result *status)
{
    FN(view_each)(wave, elliptical_see, map, to, status);
}

static void FN(view_ellipsoids)(const struct psc_wave *wave, enum psc_disk_map map,
                                struct FN(psc_disk_views) *to, psc_result *status)
{
    FN(view_each)(wave, ellipsoid_see, map, to, status);
}
