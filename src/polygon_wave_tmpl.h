/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of triangles by solid angle: a loop in double that sees and builds a block of
 * elements, then loops that sample it. The lane functions are those of the calls for one, so the
 * bits are too. What takes exact products goes another way (polygon_exact_wave_tmpl.h); what is
 * left to the calls for one: errors, lights without size, area, and other shapes.
 * Template: see precision.h.
 */

/* Constants of a block, of those that vary: the second lot is for hits on the light alone. */
struct FN(psc_fans) {
    real half[PSC_BLOCK], cos_a[PSC_BLOCK], near[PSC_BLOCK], far[PSC_BLOCK];
    real b[3][PSC_BLOCK], toward_a[3][PSC_BLOCK], toward_c[3][PSC_BLOCK], up[3][PSC_BLOCK];
    real pdf[PSC_BLOCK], total[PSC_BLOCK];
    int32_t status[PSC_BLOCK];

    real share_a[PSC_BLOCK], share_c[PSC_BLOCK], slant[PSC_BLOCK], cos_ab[PSC_BLOCK];
    real cos_bc[PSC_BLOCK], per_a[PSC_BLOCK], per_c[PSC_BLOCK], unit[PSC_BLOCK];
    real normal[3][PSC_BLOCK];
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

/* Element i: what becomes of it, and its constants. Whether the receiver sees anything of the light
   above its plane is not looked at yet. */
PSC_LANE void FN(build_element)(const struct psc_wave *wave, int one_sided, int has_normal,
                                int surface, size_t i, struct FN(psc_fans) *to)
{
    struct psc_plain_triangle seen;
    struct psc_fan_f64 wide;
    struct FN(psc_fan) fan;
    double position[3], vertices[9], normal[3], square = 1.0, length, inverse;
    int c, fit, hidden;

    load_triangle(wave, i, position, vertices);
    for (c = 0; c < 3; c++)
        normal[c] = has_normal ? wave->normal[c][i] : 0.0;
    fit = see_plain_triangle(position, vertices, &seen);
    if (has_normal) {
        square = dot(normal, normal);
        fit &= is_plain_normal(square);
    }
    hidden = one_sided & (seen.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;
    plain_fan(&seen, &wide);
    fan = FAN_OF(&wide);
    to->half[i] = fan.half;
    to->cos_a[i] = fan.cos_a;
    to->near[i] = fan.near;
    to->far[i] = fan.far;
    to->total[i] = (real)(2.0 * seen.half);
    to->pdf[i] = (real)(1.0 / (2.0 * seen.half));
    length = __builtin_sqrt(dot(seen.normal, seen.normal));
    inverse = 1.0 / (__builtin_sqrt(square) * length);
    for (c = 0; c < 3; c++) {
        to->b[c][i] = fan.b[c];
        to->toward_a[c][i] = fan.toward_a[c];
        to->toward_c[c][i] = fan.toward_c[c];
        to->up[c][i] = (real)(normal[c] * (length * inverse));
    }
    if (!surface)
        return;
    to->share_a[i] = fan.share_a;
    to->share_c[i] = fan.share_c;
    to->slant[i] = fan.slant;
    to->cos_ab[i] = fan.cos_ab;
    to->cos_bc[i] = fan.cos_bc;
    to->per_a[i] = fan.per_a;
    to->per_c[i] = fan.per_c;
    to->unit[i] = (real)seen.size_b;
    for (c = 0; c < 3; c++)
        to->normal[c][i] = (real)(seen.normal[c] * (__builtin_sqrt(square) * inverse));
}

/* One loop for each of what there is and what is wanted. */
#define BUILD_LOOP(name, has_normal, surface)                                                  \
    static void FN(name)(const struct psc_wave *restrict wave, struct FN(psc_fans) *restrict to) \
    {                                                                                          \
        const int one_sided = wave->one_sided;                                                 \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(build_element)(wave, one_sided, has_normal, surface, i, to);                    \
    }
BUILD_LOOP(build_around, 0, 0)
BUILD_LOOP(build_above, 1, 0)
BUILD_LOOP(build_around_whole, 0, 1)
BUILD_LOOP(build_above_whole, 1, 1)
#undef BUILD_LOOP

/* Density, weight and status of samples whose directions are there. */
PSC_LANE void FN(weigh_elements)(enum psc_facing facing, size_t n,
                                 const real (*restrict normal)[PSC_BLOCK],
                                 const real *restrict pdf, const real *restrict total,
                                 const int32_t *restrict status, struct FN(psc_results) *restrict r)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        const real up[3] = {normal[0][i], normal[1][i], normal[2][i]};
        const real height = FN(fan_height)(up, direction);

        r->value[PSC_PDF][i] = pdf[i];
        r->value[PSC_WEIGHT][i] = total[i] * FN(fan_cosine)(facing, height);
    }
    for (i = 0; i < n; i++)
        r->status[i] = status[i] != PSC_SUCCESS           ? status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
}

/* The triangle in world space. */
PSC_LANE void FN(load_face)(const struct psc_wave *wave, size_t i, struct FN(psc_face) *face)
{
    int k;

    PSC_UNROLL
    for (k = 0; k < 3; k++) {
        face->pivot[k] = (real)wave->geometry[3 + k][i];
        face->edge_a[k] = (real)(wave->geometry[k][i] - wave->geometry[3 + k][i]);
        face->edge_c[k] = (real)(wave->geometry[6 + k][i] - wave->geometry[3 + k][i]);
    }
    face->s_a = face->s_c = face->t_a = face->t_b = K(0.0);
    face->s_b = face->t_c = K(1.0);
}

static void FN(sample_elements)(const struct psc_wave *restrict wave,
                                const struct FN(psc_fans) *restrict f, const real *restrict u,
                                const real *restrict v, struct FN(psc_results) *restrict r)
{
    const enum psc_facing facing = wave->facing;
    const size_t n = wave->count;
    real b[PSC_BLOCK], a[PSC_BLOCK], c[PSC_BLOCK];
    size_t i;

    for (i = 0; i < n; i++) {
        struct FN(psc_fan) fan;
        struct FN(psc_spot) p;
        real direction[3];
        int k;

        fan.half = f->half[i];
        fan.cos_a = f->cos_a[i];
        fan.near = f->near[i];
        fan.far = f->far[i];
        PSC_UNROLL
        for (k = 0; k < 3; k++) {
            fan.b[k] = f->b[k][i];
            fan.toward_a[k] = f->toward_a[k][i];
            fan.toward_c[k] = f->toward_c[k][i];
        }
        FN(plain_constants)(&fan);
        FN(fan_map)(&fan, u[i], v[i], &p);
        FN(fan_direction)(&fan, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        b[i] = p.b;
        a[i] = p.a;
        c[i] = p.c;
    }
    FN(weigh_elements)(facing, n, (const real(*)[PSC_BLOCK])f->up, f->pdf, f->total, f->status, r);
    for (i = 0; wave->surface && i < n; i++) {
        const struct FN(psc_spot) p = {b[i], a[i], c[i]};
        const real normal[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
        real share[3], distance, point[3], first, second;
        struct FN(psc_face) face;
        struct FN(psc_fan) fan;

        FN(load_face)(wave, i, &face);
        fan.share_a = f->share_a[i];
        fan.share_c = f->share_c[i];
        fan.slant = f->slant[i];
        fan.cos_ab = f->cos_ab[i];
        fan.cos_bc = f->cos_bc[i];
        fan.per_a = f->per_a[i];
        fan.per_c = f->per_c[i];
        FN(plain_hit)(&fan, &p, share, share + 1, share + 2, &distance);
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

#include "polygon_exact_wave_tmpl.h"

/* Leaves a block to the calls for one. */
static void FN(pending_wave)(const struct psc_wave *wave, const real *u, const real *v,
                             struct FN(psc_results) *r)
{
    size_t i;

    (void)u, (void)v;
    for (i = 0; i < wave->count; i++)
        r->status[i] = PSC_PENDING;
}

static void FN(triangle_wave)(const struct psc_wave *wave, const real *u, const real *v,
                              struct FN(psc_results) *r)
{
    struct FN(psc_fans) fans;
    int32_t low = 0;
    size_t i;

    if (wave->measure != PSC_MEASURE_SOLID_ANGLE) {
        FN(pending_wave)(wave, u, v, r);
        return;
    }
    if (wave->facing == PSC_FACING_NONE)
        (wave->surface ? FN(build_around_whole) : FN(build_around))(wave, &fans);
    else
        (wave->surface ? FN(build_above_whole) : FN(build_above))(wave, &fans);
    FN(sample_elements)(wave, &fans, u, v, r);
    FN(exact_elements)(wave, u, v, r);
    if (wave->facing != PSC_FACING_ONE)
        return;
    /* What rounding may have put above the plane is still next to it. */
    for (i = 0; i < wave->count; i++)
        low |= !(r->value[PSC_WEIGHT][i] > K(0x1p-18) * fans.total[i]);
    if (low)
        FN(find_hidden)(wave, r);
}
