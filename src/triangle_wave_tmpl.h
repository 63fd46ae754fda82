/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of triangles by solid angle: a loop in double that sees and builds a block of
 * elements, then loops that sample it. The lane functions are those of the calls for one, so the
 * bits are too. What takes exact products goes another way (triangle_exact_wave_tmpl.h); what is
 * left to the calls for one: errors, lights without size, and projected solid angle.
 * Template: see precision.h.
 */

/* Rows of which no two begin at the same place of a page: loads would wait for stores to others. */
#undef PSC_ROW
#define PSC_ROW (PSC_BLOCK + 16)

/* Constants of a block, of those that vary: the second lot is for hits on the light alone. */
struct FN(psc_fans) {
    real half[PSC_ROW], cos_a[PSC_ROW], near[PSC_ROW], far[PSC_ROW];
    real b[3][PSC_ROW], toward_a[3][PSC_ROW], toward_c[3][PSC_ROW], up[3][PSC_BLOCK];
    real pdf[PSC_ROW];
    double sine[PSC_ROW], cosine[PSC_ROW]; /* of half */
    int32_t status[PSC_ROW];

    real per_along[PSC_ROW], per_above[PSC_ROW], slant[PSC_ROW], less_a[PSC_ROW];
    real less_c[PSC_ROW], unit[PSC_ROW], normal[3][PSC_ROW];
};

PSC_LANE void load_triangle(const struct psc_wave *wave, size_t i, double position[3],
                            double vertices[9])
{
    int k;

    PSC_UNROLL
    for (k = 0; k < 3; k++)
        position[k] = wave->position[k][i];
    PSC_UNROLL
    for (k = 0; k < 9; k++)
        vertices[k] = wave->geometry[k][i];
}

/* Element i: what becomes of it, and its constants. The receiver's plane is not looked at yet. */
PSC_LANE void FN(build_element)(const struct psc_wave *wave, int one_sided, int surface, size_t i,
                                struct FN(psc_fans) *to)
{
    struct psc_plain_triangle seen;
    struct psc_ray_fan_f64 wide;
    struct FN(psc_ray_fan) fan;
    double position[3], vertices[9], per_length;
    int c, fit, hidden;

    load_triangle(wave, i, position, vertices);
    fit = see_plain_triangle(position, vertices, vertices + 3, vertices + 6, &seen);
    hidden = one_sided & (seen.sight.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;
    plain_fan(&seen, &wide);
    fan = RAY_FAN_OF(&wide);
    to->sine[i] = seen.sight.sine;
    to->cosine[i] = seen.sight.cosine;
    to->cos_a[i] = fan.cos_a;
    to->near[i] = fan.near;
    to->far[i] = fan.far;
    for (c = 0; c < 3; c++) {
        to->b[c][i] = (real)seen.pivot.unit[c];
        to->toward_a[c][i] = fan.toward_a[c];
        to->toward_c[c][i] = fan.toward_c[c];
    }
    if (!surface)
        return;
    to->per_along[i] = fan.per_along;
    to->per_above[i] = fan.per_above;
    to->slant[i] = fan.slant;
    to->less_a[i] = fan.less_a;
    to->less_c[i] = fan.less_c;
    to->unit[i] = (real)seen.pivot.size;
    per_length = 1.0 / __builtin_sqrt(dot(seen.sight.normal, seen.sight.normal));
    for (c = 0; c < 3; c++)
        to->normal[c][i] = (real)(seen.sight.normal[c] * per_length);
}

static void FN(build_elements)(const struct psc_wave *restrict wave,
                               struct FN(psc_fans) *restrict to)
{
    const int one_sided = wave->one_sided;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_element)(wave, one_sided, 0, i, to);
}

/* The same with what hits on the light take. */
static void FN(build_whole_elements)(const struct psc_wave *restrict wave,
                                     struct FN(psc_fans) *restrict to)
{
    const int one_sided = wave->one_sided;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_element)(wave, one_sided, 1, i, to);
}

/* Apart from the rest, whose chains of operations are long enough. */
static void FN(find_halves)(size_t n, struct FN(psc_fans) *restrict to)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const double half = half_of(to->cosine[i], to->sine[i]);

        to->half[i] = (real)half;
        to->pdf[i] = (real)(1.0 / (2.0 * half));
    }
}

#include "triangle_weigh_tmpl.h"

/* The triangle in world space. */
PSC_LANE void FN(load_face)(const struct psc_wave *wave, size_t i, struct FN(psc_face) *face)
{
    int k;

    PSC_UNROLL
    for (k = 0; k < 3; k++) {
        const double a = wave->geometry[k][i], b = wave->geometry[3 + k][i];
        const double c = wave->geometry[6 + k][i];

        face->pivot[k] = (real)b;
        face->edge_a[k] = (real)(a - b);
        face->edge_c[k] = (real)(c - b);
    }
    face->s_a = face->s_c = face->t_a = face->t_b = K(0.0);
    face->s_b = face->t_c = K(1.0);
}

static void FN(sample_elements)(const struct psc_wave *restrict wave,
                                const struct FN(psc_fans) *restrict f, const real *restrict u,
                                const real *restrict v, struct FN(psc_results) *restrict r)
{
    const size_t n = wave->count;
    real b[PSC_BLOCK], a[PSC_BLOCK], c[PSC_BLOCK];
    size_t i;

    for (i = 0; i < n; i++) {
        real pivot[3], direction[3];
        struct FN(psc_ray_fan) fan;
        struct FN(psc_spot) p;
        int k;

        fan.half = f->half[i];
        fan.cos_a = f->cos_a[i];
        fan.near = f->near[i];
        fan.far = f->far[i];
        PSC_UNROLL
        for (k = 0; k < 3; k++) {
            pivot[k] = f->b[k][i];
            fan.toward_a[k] = f->toward_a[k][i];
            fan.toward_c[k] = f->toward_c[k][i];
        }
        FN(ray_map)(&fan, u[i], v[i], &p);
        FN(ray_direction)(&fan, pivot, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = f->pdf[i];
        b[i] = p.b;
        a[i] = p.a;
        c[i] = p.c;
    }
    for (i = 0; wave->surface && i < n; i++) {
        const struct FN(psc_spot) p = {b[i], a[i], c[i]};
        const real normal[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
        real share[3], distance, point[3], first, second;
        struct FN(psc_ray_fan) fan;
        struct FN(psc_face) face;

        FN(load_face)(wave, i, &face);
        fan.per_along = f->per_along[i];
        fan.per_above = f->per_above[i];
        fan.slant = f->slant[i];
        fan.less_a = f->less_a[i];
        fan.less_c = f->less_c[i];
        FN(plain_hit)(&fan, &p, share, &distance);
        FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
        FN(store_surface)(r, i, point, normal, distance * f->unit[i], first, second);
    }
}

/* Which lights are wholly below the plane. */
static void FN(find_hidden)(const struct psc_wave *restrict wave,
                            struct FN(psc_results) *restrict r)
{
    const size_t n = wave->count;
    double where[PSC_BLOCK];
    size_t i;

    for (i = 0; i < n; i++) {
        const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
        double position[3], vertices[9], a[3], b[3], c[3], size;

        load_triangle(wave, i, position, vertices);
        subtract3(vertices, position, a);
        subtract3(vertices + 3, position, b);
        subtract3(vertices + 6, position, c);
        size = __builtin_sqrt(dot(normal, normal) * ((dot(a, a) + dot(b, b)) + dot(c, c)));
        where[i] = see_plain_horizon(a, b, c, normal, size);
    }
    for (i = 0; i < n; i++)
        if (r->status[i] == PSC_SUCCESS || r->status[i] == PSC_CULLED)
            r->status[i] = where[i] < 0.0                ? PSC_PENDING
                           : where[i] == PSC_CASE_EMPTY ? PSC_EMPTY
                                                        : r->status[i];
}

#include "triangle_exact_wave_tmpl.h"
#include "triangle_area_wave_tmpl.h"

static void FN(triangle_wave)(const struct psc_wave *wave, const real *u, const real *v,
                              struct FN(psc_results) *r)
{
    struct FN(psc_fans) fans;
    psc_result all = PSC_PENDING;
    int32_t low = 0;
    int judged;
    size_t i;

    if (wave->measure != PSC_MEASURE_SOLID_ANGLE) {
        (wave->measure == PSC_MEASURE_AREA ? FN(triangle_area_wave) : FN(pending_wave))(wave, u, v,
                                                                                        r);
        return;
    }
    (wave->surface ? FN(build_whole_elements) : FN(build_elements))(wave, &fans);
    FN(find_halves)(wave->count, &fans);
    FN(sample_elements)(wave, &fans, u, v, r);
    judged = wave->facing != PSC_FACING_NONE && !wave->weight &&
             FN(judge_elements)(wave, &fans, r, &all);
    if (judged && all == PSC_SUCCESS)
        return;
    if (!judged) {
        FN(find_normals)(wave, &fans);
        FN(weigh_elements)(wave->facing, wave->count, (const real(*)[PSC_BLOCK])fans.up, fans.half,
                           fans.status, r);
    }
    FN(exact_elements)(wave, u, v, r);
    if (wave->facing != PSC_FACING_ONE)
        return;
    /* What rounding may have put above the plane is still next to it. */
    for (i = 0; i < wave->count; i++)
        low |= judged ? r->status[i] == PSC_CULLED
                      : !(r->value[PSC_WEIGHT][i] > K(0x1p-17) * fans.half[i]);
    if (low)
        FN(find_hidden)(wave, r);
}
