/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of polygons by solid angle: when all triangles of each fan are seen, loops over the
 * elements choose the one that u falls to, build and sample it. The lane functions are those of the
 * calls for one, so the bits are too. What takes exact products is left to these. Template: see
 * precision.h.
 */
#include "fan_see_tmpl.h"

/* The triangles that samples fall to. */
struct FN(psc_picked_fans) {
    double number[PSC_BLOCK], below[PSC_BLOCK], own_half[PSC_BLOCK];
    double vertex_a[3][PSC_BLOCK], vertex_c[3][PSC_BLOCK];
#define RAY_NUMBER(name) real name[PSC_BLOCK];
#define RAY_VECTOR(name) real name[3][PSC_BLOCK];
    PSC_RAY_FIELDS(RAY_NUMBER, RAY_VECTOR)
#undef RAY_NUMBER
#undef RAY_VECTOR
    real b[3][PSC_BLOCK], up[3][PSC_BLOCK], unit[PSC_BLOCK], pdf[PSC_BLOCK], total[PSC_BLOCK];
    real within[PSC_BLOCK];
    int32_t status[PSC_BLOCK];
};

/* ---- Building those that samples fall to ---- */

/* Takes triangle k where u is beyond its beginning; k from 1 on, after the first. */
PSC_APART void FN(pick_fans)(const struct FN(psc_fan_sums) *restrict from, int k, size_t n,
                             const real *restrict u, struct FN(psc_picked_fans) *restrict to)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const double below = (double)(real)(from->below[k][i] * from->inverse[i]);
        const int taken = (double)u[i] >= below;

        to->number[i] = taken ? (double)k : to->number[i];
        to->below[i] = taken ? below : to->below[i];
        to->own_half[i] = taken ? from->half[k][i] : to->own_half[i];
    }
}

/* Their vertices: by numbers that differ, so this is no vector code. */
static void FN(fetch_vertices)(const struct psc_wave *wave, struct FN(psc_picked_fans) *to)
{
    size_t i;
    int c;

    for (i = 0; i < wave->count; i++) {
        const real *const *const a = wave->geometry + 3 * ((int)to->number[i] + 1);

        for (c = 0; c < 3; c++) {
            to->vertex_a[c][i] = a[c][i];
            to->vertex_c[c][i] = a[3 + c][i];
        }
    }
}

PSC_LANE void FN(build_picked)(const struct psc_wave *wave, int has_normal, int triangles,
                               const struct FN(psc_fan_sums) *from, const real *u, size_t i,
                               struct FN(psc_picked_fans) *to)
{
    const double parts = from->parts[i], total = 2.0 * parts;
    double position[3], normal[3], a[3], b[3], c[3], far[3], square = 1.0, per_size;
    struct psc_fan_pivot pivot;
    struct psc_fan_ray ray_a, ray_c;
    struct psc_fan_sight o;
    struct psc_ray_fan_f64 wide;
    struct FN(psc_ray_fan) fan;
    int fit, hidden, k;
    real within;

    FN(load_position)(wave, i, position);
    FN(load_wave_vertex)(wave, 0, i, b);
    FN(load3)((const double(*)[PSC_BLOCK])to->vertex_a, i, a);
    FN(load3)((const double(*)[PSC_BLOCK])to->vertex_c, i, c);
    see_pivot(b, position, &pivot);
    see_ray(&pivot, position, b, a, &ray_a);
    see_ray(&pivot, position, b, c, &ray_c);
    subtract3(c, a, far);
    see_fan_triangle(&pivot, &ray_a, &ray_c, far, &o);
    build_ray_fan(&pivot, &ray_a, &ray_c, &o, &wide);
    wide.half = to->own_half[i];
    fan = RAY_FAN_OF(&wide);
#define RAY_NUMBER(name) to->name[i] = fan.name;
#define RAY_VECTOR(name)           \
    to->name[0][i] = fan.name[0];  \
    to->name[1][i] = fan.name[1];  \
    to->name[2][i] = fan.name[2];
    PSC_RAY_FIELDS(RAY_NUMBER, RAY_VECTOR)
#undef RAY_NUMBER
#undef RAY_VECTOR
    within = (u[i] - (real)to->below[i]) * (real)(parts / to->own_half[i]);
    to->within[i] = MIN(within, K(1.0));
    to->unit[i] = (real)pivot.size;
    to->pdf[i] = (real)(1.0 / total);
    to->total[i] = (real)total;

    FN(load_normal)(wave, i, normal);
    fit = __builtin_fabs(from->side[i]) == (double)triangles;
    hidden = wave->one_sided & (from->side[i] < 0.0);
    if (has_normal) {
        square = dot(normal, normal);
        fit &= (square > 0x1p-320) & (square < 0x1p320);
    }
    if (has_normal && wave->facing == PSC_FACING_ONE) {
        fit &= from->where[i] < NEAR_PLANE;
        hidden |= from->where[i] == (triangles + 2) * BELOW_PLANE;
    }
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;
    per_size = 1.0 / __builtin_sqrt(square);
    PSC_UNROLL
    for (k = 0; k < 3; k++) {
        to->b[k][i] = (real)pivot.unit[k];
        to->up[k][i] = has_normal ? (real)(per_size * normal[k]) : K(0.0);
    }
}

#define BUILD_PICKED(name, has_normal)                                                         \
    PSC_APART void FN(name)(const struct psc_wave *restrict wave, int triangles,               \
                            const struct FN(psc_fan_sums) *restrict from,                      \
                            const real *restrict u, struct FN(psc_picked_fans) *restrict to)   \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(build_picked)(wave, has_normal, triangles, from, u, i, to);                     \
    }
BUILD_PICKED(build_picked_around, 0)
BUILD_PICKED(build_picked_above, 1)
#undef BUILD_PICKED

/* ---- Sampling them ---- */

PSC_LANE void FN(load_picked)(const struct FN(psc_picked_fans) *from, size_t i,
                              struct FN(psc_ray_fan) *fan)
{
#define RAY_NUMBER(name) fan->name = from->name[i];
#define RAY_VECTOR(name)             \
    fan->name[0] = from->name[0][i]; \
    fan->name[1] = from->name[1][i]; \
    fan->name[2] = from->name[2][i];
    PSC_RAY_FIELDS(RAY_NUMBER, RAY_VECTOR)
#undef RAY_NUMBER
#undef RAY_VECTOR
}

/* The triangle in world space, and where it is on the surface. */
PSC_LANE void FN(face_of_picked)(const struct psc_wave *wave, int triangles,
                                 const struct FN(psc_fan_sums) *sums,
                                 const struct FN(psc_picked_fans) *from, size_t i,
                                 struct FN(psc_ray_face) *face)
{
    const int at_first = from->number[i] == 0.0, at_last = from->number[i] == triangles - 1.0;
    double b[3], a[3], c[3], first[3], last[3], place_a[2], place_c[2];
    int k;

    FN(load_wave_vertex)(wave, 0, i, b);
    FN(load3)((const double(*)[PSC_BLOCK])from->vertex_a, i, a);
    FN(load3)((const double(*)[PSC_BLOCK])from->vertex_c, i, c);
    FN(load3)((const double(*)[PSC_BLOCK])sums->first, i, first);
    FN(load3)((const double(*)[PSC_BLOCK])sums->last, i, last);
    subtract3(a, b, a);
    subtract3(c, b, c);
    place_a[0] = at_first ? 1.0 : dot(first, a);
    place_a[1] = at_first ? 0.0 : dot(last, a);
    place_c[0] = at_last ? 0.0 : dot(first, c);
    place_c[1] = at_last ? 1.0 : dot(last, c);
    PSC_UNROLL
    for (k = 0; k < 3; k++) {
        face->pivot[k] = (real)b[k];
        face->edge_a[k] = (real)a[k];
        face->edge_c[k] = (real)c[k];
    }
    PSC_UNROLL
    for (k = 0; k < 2; k++) {
        face->place_a[k] = (real)place_a[k];
        face->place_c[k] = (real)place_c[k];
    }
}

static void FN(sample_picked)(const struct psc_wave *restrict wave, int triangles,
                              const struct FN(psc_fan_sums) *restrict sums,
                              const struct FN(psc_picked_fans) *restrict f,
                              const real *restrict v, struct FN(psc_results) *restrict r)
{
    const enum psc_facing facing = wave->facing;
    const size_t n = wave->count;
    real at_b[PSC_BLOCK], at_a[PSC_BLOCK], at_c[PSC_BLOCK];
    size_t i;

    for (i = 0; i < n; i++) {
        const real b[3] = {f->b[0][i], f->b[1][i], f->b[2][i]};
        struct FN(psc_ray_fan) fan;
        struct FN(psc_spot) p;
        real direction[3];

        FN(load_picked)(f, i, &fan);
        FN(ray_map)(&fan, f->within[i], v[i], &p);
        FN(ray_direction)(&fan, b, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        at_b[i] = p.b;
        at_a[i] = p.a;
        at_c[i] = p.c;
    }
    for (i = 0; i < n; i++) {
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        const real up[3] = {f->up[0][i], f->up[1][i], f->up[2][i]};

        r->value[PSC_PDF][i] = f->pdf[i];
        r->value[PSC_WEIGHT][i] =
            f->total[i] * FN(fan_cosine)(facing, FN(fan_height)(up, direction));
    }
    for (i = 0; i < n; i++)
        r->status[i] = f->status[i] != PSC_SUCCESS        ? f->status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
    for (i = 0; wave->surface && i < n; i++) {
        const struct FN(psc_spot) p = {at_b[i], at_a[i], at_c[i]};
        const real normal[3] = {(real)sums->front[0][i], (real)sums->front[1][i],
                                (real)sums->front[2][i]};
        real a, c, distance, point[3], place[2];
        struct FN(psc_ray_fan) fan;
        struct FN(psc_ray_face) face;

        FN(face_of_picked)(wave, triangles, sums, f, i, &face);
        FN(load_picked)(f, i, &fan);
        FN(ray_hit)(&fan, &p, &a, &c, &distance);
        FN(ray_point)(&face, a, c, point, place);
        FN(store_surface)(r, i, point, normal, distance * f->unit[i], place[0], place[1]);
    }
}

static void FN(polygon_wave)(const struct psc_wave *wave, const real *u, const real *v,
                             struct FN(psc_results) *r)
{
    const int vertices = wave->parts / 3, triangles = vertices - 2;
    const int above = wave->facing == PSC_FACING_ONE;
    struct FN(psc_picked_fans) picked;
    struct FN(psc_fan_corners) corners[PSC_MAX_VERTICES];
    struct FN(psc_fan_sums) sums;
    int k;

    if (wave->measure != PSC_MEASURE_SOLID_ANGLE) {
        FN(pending_wave)(wave, u, v, r);
        return;
    }
    (above ? FN(start_fans_above) : FN(start_fans_around))(wave, &sums);
    for (k = 0; k < triangles; k++)
        (above ? FN(see_fans_above) : FN(see_fans_around))(wave, k, &sums);
    FN(frame_fans)(wave, triangles, &sums);
    for (k = 1; k < vertices; k++)
        FN(place_vertices)(wave, k, &sums, corners + k);
    for (k = 0; k < triangles; k++)
        FN(judge_fans)(corners + 1, corners + k + 1, corners + k + 2,
                       corners + MIN(k + 3, triangles + 1), wave->count, &sums);
    memset(picked.number, 0, sizeof picked.number);
    memset(picked.below, 0, sizeof picked.below);
    memcpy(picked.own_half, sums.half[0], sizeof picked.own_half);
    for (k = 1; k < triangles; k++)
        FN(pick_fans)(&sums, k, wave->count, u, &picked);
    FN(fetch_vertices)(wave, &picked);
    if (wave->facing == PSC_FACING_NONE)
        FN(build_picked_around)(wave, triangles, &sums, u, &picked);
    else
        FN(build_picked_above)(wave, triangles, &sums, u, &picked);
    FN(sample_picked)(wave, triangles, &sums, &picked, v, r);
}
