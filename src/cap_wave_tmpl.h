/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of caps: a block of elements is seen in one loop, sorted by what the horizon leaves
 * of each, built and sampled in one loop per kind, and finished in loops over the block. Of a light
 * that the horizon of a two-sided receiver cuts, the side comes first. Errors are left to the calls
 * for one, and so are area measures for receivers inside a sphere. The lane functions are those of
 * the calls for one, so the bits are too. Template: see precision.h.
 */
#if PSC_REAL_BITS == 64
#define WAVE_LOBE(l) l
#else
#define WAVE_LOBE(l) psc_lobe_round(&l)
#endif

/* The elements of one kind, packed. */
struct FN(packed) {
    double sin_a[PSC_BLOCK], cos_a[PSC_BLOCK], sin_b[PSC_BLOCK], cos_b[PSC_BLOCK];
    double q2[PSC_BLOCK], h0[PSC_BLOCK], total[PSC_BLOCK], rise[PSC_BLOCK];
    real u[PSC_BLOCK], v[PSC_BLOCK];
    struct FN(psc_cap_points) points;
    int32_t pairs[PSC_BLOCK]; /* as in psc_cap_points, for doubles, of which the builds are */
};

#define WAVE_LOOP(build, lane, native)                                                         \
    static void FN(wave_##lane)(struct FN(packed) *restrict k, size_t n)                       \
    {                                                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            const struct psc_cap cap = {k->sin_a[i], k->cos_a[i], k->sin_b[i], k->cos_b[i],    \
                                        k->q2[i]};                                             \
            struct psc_lobe_f64 wide;                                                          \
            struct FN(psc_lobe) l;                                                             \
            struct FN(psc_point) p;                                                            \
                                                                                               \
            build(&wide, &cap, k->h0[i]);                                                      \
            l = WAVE_LOBE(wide);                                                               \
            (void)l;                                                                           \
            CAP_NATIVE(native, lane, &l, &wide, k->u[i], k->v[i], &p);                         \
            CAP_STORE(&k->points, i, p);                                                       \
            k->pairs[i] = (int32_t)k->u[i];                                                    \
            k->total[i] = wide.total;                                                          \
            k->rise[i] = wide.rise;                                                            \
        }                                                                                      \
    }
WAVE_LOOP(build_cone, radial_cone, 1)
WAVE_LOOP(build_cone, concentric_cone, 1)
WAVE_LOOP(build_ellipse, radial_ellipse, 1)
WAVE_LOOP(build_radial_both, radial_both, 1)
WAVE_LOOP(build_radial_lune, radial_lune, 0)
WAVE_LOOP(build_ellipse, parallel_ellipse, 1)
WAVE_LOOP(build_chord_both, parallel_both, 1)
WAVE_LOOP(build_chord_lune, parallel_lune, 1)
WAVE_LOOP(build_ellipse, concentric_ellipse, 1)
WAVE_LOOP(build_chord_both, concentric_both, 1)
WAVE_LOOP(build_chord_lune, concentric_lune, 1)
#undef WAVE_LOOP

typedef void (*FN(wave_loop))(struct FN(packed) *, size_t);
#define WAVE_ROW(name, lane, native) FN(wave_##lane),
static const FN(wave_loop) FN(wave_loops)[] = {PSC_CAP_MAPS(WAVE_ROW)};
#undef WAVE_ROW

/* Builds and samples the elements of one kind; their points go back to their places. */
static void FN(wave_kind)(const struct views *o, const real *u, const real *v,
                          const uint32_t *index, size_t n, enum psc_cap_map map,
                          struct FN(psc_cap_points) *to, double *total, double *rise)
{
    struct FN(packed) k;
    size_t j;

    for (j = 0; j < n; j++) {
        const uint32_t i = index[j];

        k.sin_a[j] = o->sin_a[i];
        k.cos_a[j] = o->cos_a[i];
        k.sin_b[j] = o->sign[i] * o->sin_b[i];
        k.cos_b[j] = o->cos_b[i];
        k.q2[j] = o->q2[i];
        k.h0[j] = o->h0[i];
        k.u[j] = u[i];
        k.v[j] = v[i];
    }
    FN(wave_loops)[map](&k, n);
    for (j = 0; j < n; j++) {
        const uint32_t i = index[j];

        to->x[i] = k.points.x[j];
        to->y[i] = k.points.y[j];
        to->z[i] = k.points.z[j];
        to->height[i] = k.points.height[j];
        to->power[i] = k.points.power[j];
        to->across[i] = k.points.across[j];
        total[i] = k.total[j];
        rise[i] = k.rise[j];
    }
}

/* Chooses, by u, a side of each element of KIND_CUT, and leaves the kind, the sign and the u that
   it has there. whole: the total of both sides. */
static void FN(wave_cuts)(struct views *o, const uint32_t *index, size_t n, real *u,
                          double *whole)
{
    real within[PSC_BLOCK], given[PSC_BLOCK];
    int32_t second[PSC_BLOCK];
    struct cuts k;
    size_t j;

    for (j = 0; j < n; j++) {
        const uint32_t i = index[j];

        k.sin_a[j] = o->sin_a[i];
        k.cos_a[j] = o->cos_a[i];
        k.sin_b[j] = o->sin_b[i];
        k.cos_b[j] = o->cos_b[i];
        k.q2[j] = o->q2[i];
        k.h0[j] = o->h0[i];
        given[j] = u[i];
    }
    weigh_cuts(&k, n);
    for (j = 0; j < n; j++)
        second[j] = FN(pick_of_two)(k.above[j] / (k.above[j] + k.below[j]), given[j], &within[j]);
    for (j = 0; j < n; j++) {
        const uint32_t i = index[j];
        const int one = !(k.above[j] > 0.0) | !(k.below[j] > 0.0);
        const int below = one ? !(k.above[j] > 0.0) : second[j];
        const int more = below ? !(o->sin_b[i] >= 0.0) : o->sin_b[i] >= 0.0;

        o->kind[i] = !(k.above[j] + k.below[j] > 0.0) ? KIND_EMPTY
                     : more || k.flat[j] > 0.0        ? KIND_BOTH
                                                      : KIND_LUNE;
        o->sign[i] = below ? -1.0 : 1.0;
        u[i] = one ? given[j] : within[j];
        whole[i] = k.above[j] + k.below[j];
    }
}

/* Of a two-sided receiver inside a sphere, the side that u chooses. */
static void FN(wave_insides)(struct views *o, real *u, double *whole)
{
    size_t j;
    int c;

    for (j = 0; j < o->insides; j++) {
        const uint32_t i = o->inside[j];
        const double sign = FN(pick_of_two)(0.5, u[i], &u[i]) ? -1.0 : 1.0;

        o->sign[i] = o->sin_b[i] = sign; /* either side is seen from above */
        for (c = 0; c < 3; c++)
            o->axis[c][i] = sign * o->normal[c][i];
        whole[i] = 2.0 * PSC_PI;
    }
}

/* The constants of one element, as cap_world() has them for a side. */
PSC_LANE void FN(wave_frame)(const struct views *o, size_t i, int cone,
                             struct FN(psc_cap_world) *w)
{
    const double axis[3] = {o->axis[0][i], o->axis[1][i], o->axis[2][i]};
    const double sideways[3] = {o->sideways[0][i], o->sideways[1][i], o->sideways[2][i]};
    const double normal[3] = {o->normal[0][i], o->normal[1][i], o->normal[2][i]};
    double x[3];
    int c;

    if (cone)
        cross_rounded(sideways, axis, x);
    else
        cross_rounded(sideways, normal, x);
    for (c = 0; c < 3; c++) {
        w->x[c] = (real)x[c];
        w->y[c] = (real)sideways[c];
        w->z[c] = (real)(cone ? axis[c] : o->sign[i] * normal[c]);
        w->axis[c] = (real)axis[c];
    }
}

#define DIRECTION_LOOP(name, cone)                                                             \
    static void FN(name)(const struct psc_wave *restrict wave, const struct views *restrict o, \
                         const struct FN(psc_cap_points) *restrict p,                          \
                         struct FN(psc_results) *restrict r)                                   \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            struct FN(psc_cap_world) w;                                                        \
                                                                                               \
            FN(wave_frame)(o, i, cone, &w);                                                    \
            FN(cap_direction)(&w, p->x[i], p->y[i], p->z[i], &r->value[0][i], &r->value[1][i], \
                              &r->value[2][i]);                                                \
        }                                                                                      \
    }
DIRECTION_LOOP(wave_cone_directions, 1)
DIRECTION_LOOP(wave_projected_directions, 0)
#undef DIRECTION_LOOP

static void FN(wave_densities)(const struct psc_wave *restrict wave, const struct views *restrict o,
                               const struct FN(psc_cap_points) *restrict p,
                               const double *restrict total, const double *restrict rise,
                               struct FN(psc_results) *restrict r)
{
    const int projected = wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    const size_t n = wave->count;
    struct FN(psc_cap_world) w;
    real weight, pdf;
    psc_result status;
    size_t i;

    w.facing = wave->facing;
    w.projected = projected;
    if (projected) {
        for (i = 0; i < n; i++) {
            r->value[PSC_PDF][i] =
                p->height[i] * (real)rise[i] * (real)(1.0 / total[i] * unit_inverse(rise[i]));
            r->value[PSC_WEIGHT][i] = (real)total[i];
        }
        for (i = 0; i < n; i++)
            r->status[i] = o->kind[i] == KIND_PENDING                      ? PSC_PENDING
                           : o->kind[i] == KIND_EMPTY || !(total[i] > 0.0) ? PSC_EMPTY
                                                                           : PSC_SUCCESS;
    } else {
        for (i = 0; i < n; i++) {
            w.total = (real)total[i];
            w.inverse_total = (real)(1.0 / total[i]);
            FN(cap_density)(&w, p->height[i], &pdf, &weight, &status);
            r->value[PSC_PDF][i] = pdf;
            r->value[PSC_WEIGHT][i] = weight;
            r->status[i] = o->kind[i] == KIND_PENDING                      ? PSC_PENDING
                           : o->kind[i] == KIND_EMPTY || !(total[i] > 0.0) ? PSC_EMPTY
                                                                           : status;
        }
    }
}

static void FN(wave_surfaces)(const struct psc_wave *wave, const struct views *o,
                              const struct FN(psc_cap_points) *p, int distant, int area,
                              struct FN(psc_results) *r)
{
    const int cone = wave->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    real(*to)[PSC_BLOCK] = r->value;
    size_t i;

    for (i = 0; i < wave->count; i++) {
        const struct psc_cap cap = {o->sin_a[i], o->cos_a[i], o->sign[i] * o->sin_b[i],
                                    o->cos_b[i], o->q2[i]};
        real direction[3] = {to[0][i], to[1][i], to[2][i]}, point[3], normal[3], distance;
        struct FN(psc_cap_world) w;
        double sin_b = cap.sin_b;
        int c;

        if (o->kind[i] == KIND_BOTH)
            sin_b = MAX(sin_b, 0.0);
        FN(wave_frame)(o, i, cone, &w);
        w.sin_a = (real)cap.sin_a;
        w.cos_a = (real)cap.cos_a;
        w.h0 = (real)o->h0[i];
        w.sin_b = (real)sin_b;
        w.radius = (real)wave->geometry[3][i];
        w.distance = (real)o->distance[i];
        w.projected = !cone;
        w.inside = 0;
        w.distant = distant;
        if (distant)
            w.distance = (real)INFINITY;
        for (c = 0; c < 3; c++)
            w.center[c] = (real)wave->geometry[c][i];
        if (area)
            FN(area_surface)(&w, p->x[i], p->y[i], p->power[i], p->across[i], point, normal,
                             &distance);
        else
            FN(cap_surface)(&w, direction, p->x[i], p->y[i], p->z[i],
                            FN(cap_depth)(&w, p->height[i], p->power[i], p->across[i]), point,
                            normal, &distance);
        FN(store_surface)(r, i, point, normal, distance, K(0.0), K(0.0));
    }
}

/* The same for the receivers inside their spheres, which look at the far side. */
static void FN(wave_far_sides)(const struct psc_wave *wave, const struct views *o,
                               struct FN(psc_results) *r)
{
    real(*to)[PSC_BLOCK] = r->value;
    size_t j;
    int c;

    for (j = 0; j < o->insides; j++) {
        const uint32_t i = o->inside[j];
        real direction[3] = {to[0][i], to[1][i], to[2][i]}, point[3], normal[3], distance;
        struct FN(psc_cap_world) w;

        w.distant = 0;
        w.inside = 1;
        w.radius = (real)wave->geometry[3][i];
        w.slack = (real)(-o->power[i] / (o->radius[i] * o->radius[i]));
        for (c = 0; c < 3; c++) {
            w.center[c] = (real)wave->geometry[c][i];
            w.offset[c] =
                (real)(((double)wave->geometry[c][i] - (double)wave->position[c][i]) *
                       o->scale[i] / o->radius[i]);
        }
        FN(cap_surface)(&w, direction, K(0.0), K(0.0), K(0.0), K(0.0), point, normal, &distance);
        FN(store_surface)(r, i, point, normal, distance, K(0.0), K(0.0));
    }
}

#include "cap_area_wave_tmpl.h"

/* Everything after seeing. */
static void FN(wave_views)(const struct psc_wave *wave, struct views *o, const real *u,
                           const real *v, int distant, struct FN(psc_results) *r)
{
    const int projected = wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    const int both = projected && wave->facing == PSC_FACING_BOTH;
    uint32_t index[KIND_COUNT][PSC_BLOCK], cut[PSC_BLOCK];
    size_t count[KIND_COUNT] = {0}, cuts = 0, i;
    struct FN(psc_cap_points) points;
    double total[PSC_BLOCK], rise[PSC_BLOCK], whole[PSC_BLOCK];
    real within[PSC_BLOCK];
    int kind;

    if (is_area_measure(wave->measure)) {
        FN(wave_areas)(wave, o, u, v, r);
        return;
    }
    if (both) {
        for (i = 0; i < wave->count; i++) {
            within[i] = u[i];
            if (o->kind[i] == KIND_CUT)
                cut[cuts++] = (uint32_t)i;
        }
        FN(wave_cuts)(o, cut, cuts, within, whole);
        FN(wave_insides)(o, within, whole);
        u = within;
    }
    for (i = 0; i < wave->count; i++) {
        const int32_t k = o->kind[i];

        index[k][count[k]++] = (uint32_t)i;
    }
    for (kind = KIND_PENDING; kind <= KIND_EMPTY; kind++)
        for (i = 0; i < count[kind]; i++) {
            const uint32_t j = index[kind][i];

            points.x[j] = points.y[j] = points.z[j] = points.height[j] = points.power[j] = K(0.0);
            points.across[j] = K(0.0);
            total[j] = rise[j] = 1.0;
        }
    for (kind = KIND_CONE; kind < KIND_COUNT; kind++)
        if (count[kind] > 0)
            FN(wave_kind)(o, u, v, index[kind], count[kind],
                          kind == KIND_CONE ? cone_map(wave->map)
                                            : projected_map(wave->map, REGION_OF_KIND(kind)),
                          &points, total, rise);
    if (both) {
        for (i = 0; i < cuts; i++)
            total[cut[i]] = whole[cut[i]];
        for (i = 0; i < o->insides; i++)
            total[o->inside[i]] = whole[o->inside[i]];
    }
    if (projected)
        FN(wave_projected_directions)(wave, o, &points, r);
    else
        FN(wave_cone_directions)(wave, o, &points, r);
    FN(wave_densities)(wave, o, &points, total, rise, r);
    if (wave->surface) {
        FN(wave_surfaces)(wave, o, &points, distant, 0, r);
        FN(wave_far_sides)(wave, o, r);
    }
}

static void FN(sphere_wave)(const struct psc_wave *wave, const real *u, const real *v,
                            struct FN(psc_results) *r)
{
    struct views o;

    if (wave->facing == PSC_FACING_NONE)
        see_spheres_around(wave, &o);
    else
        see_spheres(wave, &o);
    o.insides = 0;
    enter_spheres(wave, &o);
    FN(wave_views)(wave, &o, u, v, 0, r);
}

static void FN(distant_wave)(const struct psc_wave *wave, const real *u, const real *v,
                             struct FN(psc_results) *r)
{
    struct views o;

    if (wave->facing == PSC_FACING_NONE)
        see_caps_around(wave, &o);
    else
        see_caps(wave, &o);
    o.insides = 0;
    FN(wave_views)(wave, &o, u, v, 1, r);
}
