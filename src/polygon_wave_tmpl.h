/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of triangles by solid angle: a loop in double that sees and builds a block of
 * elements, then loops that sample it. The lane functions are those of the calls for one, so the
 * bits are too. What is left to those: errors, lights without size, area, and other shapes.
 * Template: see precision.h.
 */
#define WAVE_NUMBER(name) real name[PSC_BLOCK];
#define WAVE_VECTOR(name) real name[3][PSC_BLOCK];
struct FN(psc_fans) {
    PSC_FAN_FIELDS(WAVE_NUMBER, WAVE_VECTOR)
    real pdf[PSC_BLOCK], total[PSC_BLOCK], unit[PSC_BLOCK];
    real normal[3][PSC_BLOCK], up[3][PSC_BLOCK];
    int32_t status[PSC_BLOCK];
};

/* Element i: what becomes of it, and its constants. */
PSC_LANE void FN(build_element)(const struct psc_wave *wave, int has_normal, size_t i,
                                struct FN(psc_fans) *to)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i], wave->position[2][i]};
    const double normal[3] = {has_normal ? wave->normal[0][i] : 0.0,
                              has_normal ? wave->normal[1][i] : 0.0,
                              has_normal ? wave->normal[2][i] : 0.0};
    const double vertices[9] = {wave->geometry[0][i], wave->geometry[1][i], wave->geometry[2][i],
                                wave->geometry[3][i], wave->geometry[4][i], wave->geometry[5][i],
                                wave->geometry[6][i], wave->geometry[7][i], wave->geometry[8][i]};
    const double square = dot(normal, normal), size = has_normal ? __builtin_sqrt(square) : 1.0;
    struct psc_plain_triangle seen;
    struct psc_fan_f64 wide;
    struct FN(psc_fan) fan;
    double length, total, inverse;
    int c, fit, hidden, horizon = PSC_CASE_NO_HORIZON;

    fit = see_plain_triangle(position, vertices, &seen);
    if (has_normal)
        horizon = see_plain_horizon(&seen, normal, square, size);
    fit &= horizon >= 0;
    plain_fan(&seen, &wide);
    total = 2.0 * seen.half;
    hidden = (wave->facing == PSC_FACING_ONE) & (horizon == PSC_CASE_EMPTY);
    hidden |= wave->one_sided & (seen.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;

    fan = FAN_OF(&wide);
#define WAVE_STORE_NUMBER(name) to->name[i] = fan.name;
#define WAVE_STORE_VECTOR(name)          \
    to->name[0][i] = fan.name[0];        \
    to->name[1][i] = fan.name[1];        \
    to->name[2][i] = fan.name[2];
    PSC_FAN_FIELDS(WAVE_STORE_NUMBER, WAVE_STORE_VECTOR)
    to->pdf[i] = (real)(1.0 / total);
    to->total[i] = (real)total;
    to->unit[i] = (real)seen.size_b;
    length = __builtin_sqrt(dot(seen.normal, seen.normal));
    inverse = 1.0 / (size * length);
    for (c = 0; c < 3; c++) {
        to->up[c][i] = (real)(normal[c] * (length * inverse));
        to->normal[c][i] = (real)(seen.normal[c] * (size * inverse));
    }
}

PSC_LANE void FN(load_fan)(const struct FN(psc_fans) *from, size_t i, struct FN(psc_fan) *fan)
{
#define WAVE_LOAD_NUMBER(name) fan->name = from->name[i];
#define WAVE_LOAD_VECTOR(name)           \
    fan->name[0] = from->name[0][i];     \
    fan->name[1] = from->name[1][i];     \
    fan->name[2] = from->name[2][i];
    PSC_FAN_FIELDS(WAVE_LOAD_NUMBER, WAVE_LOAD_VECTOR)
    FN(plain_constants)(fan);
}

static void FN(build_around)(const struct psc_wave *restrict wave, struct FN(psc_fans) *restrict to)
{
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_element)(wave, 0, i, to);
}

static void FN(build_above)(const struct psc_wave *restrict wave, struct FN(psc_fans) *restrict to)
{
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_element)(wave, 1, i, to);
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
        const real up[3] = {f->up[0][i], f->up[1][i], f->up[2][i]};
        real direction[3];

        FN(load_fan)(f, i, &fan);
        FN(fan_map)(&fan, u[i], v[i], &p);
        FN(fan_direction)(&fan, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = f->pdf[i];
        r->value[PSC_WEIGHT][i] = f->total[i] * FN(fan_cosine)(facing, FN(fan_height)(up, direction));
        b[i] = p.b;
        a[i] = p.a;
        c[i] = p.c;
    }
    for (i = 0; i < n; i++)
        r->status[i] = f->status[i] != PSC_SUCCESS               ? f->status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
    for (i = 0; wave->surface && i < n; i++) {
        const struct FN(psc_spot) p = {b[i], a[i], c[i]};
        const real normal[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
        real share[3], distance, point[3], first, second;
        struct FN(psc_face) face = {.s_b = K(1.0), .t_c = K(1.0)};
        struct FN(psc_fan) fan;
        int k;

        for (k = 0; k < 3; k++) {
            face.pivot[k] = (real)wave->geometry[3 + k][i];
            face.edge_a[k] = (real)(wave->geometry[k][i] - wave->geometry[3 + k][i]);
            face.edge_c[k] = (real)(wave->geometry[6 + k][i] - wave->geometry[3 + k][i]);
        }
        FN(load_fan)(f, i, &fan);
        FN(plain_hit)(&fan, &p, share, share + 1, share + 2, &distance);
        FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
        FN(store_surface)(r, i, point, normal, distance * f->unit[i], first, second);
    }
}

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

    if (wave->measure != PSC_MEASURE_SOLID_ANGLE) {
        FN(pending_wave)(wave, u, v, r);
        return;
    }
    if (wave->facing == PSC_FACING_NONE)
        FN(build_around)(wave, &fans);
    else
        FN(build_above)(wave, &fans);
    FN(sample_elements)(wave, &fans, u, v, r);
}
