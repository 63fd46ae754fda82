/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Elements of a wavefront of triangles that take exact products: put together, seen, built and
 * sampled by the loops below, and put back. Template: see precision.h.
 */
#define EXACT_NUMBER(name) real name[PSC_BLOCK];
#define EXACT_VECTOR(name) real name[3][PSC_BLOCK];
struct FN(psc_exact_fans) {
    PSC_FAN_FIELDS(EXACT_NUMBER, EXACT_VECTOR)
    real pdf[PSC_BLOCK], unit[PSC_BLOCK];
    real normal[3][PSC_BLOCK], up[3][PSC_BLOCK];
    int32_t status[PSC_BLOCK];
};

/* Element i: what becomes of it, and its constants. */
PSC_LANE void FN(build_exact_element)(const struct psc_wave *wave, int facing_one, int one_sided,
                                      int has_normal, size_t i, struct FN(psc_exact_fans) *to)
{
    struct psc_polygon_view view;
    struct psc_triangle_words words;
    struct psc_triangle_view seen;
    struct psc_fan_f64 wide;
    struct FN(psc_fan) fan;
    double position[3], vertices[9], normal[3], scaled[3], up[3], height[3], length, total, finite;
    int c, fit, hidden, extreme;

    load_triangle(wave, i, position, vertices);
    for (c = 0; c < 3; c++)
        normal[c] = has_normal ? wave->normal[c][i] : 0.0;
    fit = see_polygon(position, 3, vertices, &view);
    see_horizon(has_normal ? normal : NULL, &view, scaled, up, height);
    triangle_words(&view, vertices, 0, 1, 2, &words);
    extreme = see_lengths(&words, &seen);
    see_ordinary_triangle(&words, &seen);
    fan_build(&seen, &words.b, &words.edge_c, &wide);
    total = 2.0 * seen.half;
    /* A NaN fails every comparison, infinity times 0 is one. */
    finite = (dot(position, position) + dot(vertices, vertices)) +
             (dot(vertices + 3, vertices + 3) + dot(vertices + 6, vertices + 6));
    fit &= (finite * 0.0 + dot(normal, normal) * 0.0 == 0.0) & (total > 0.0);
    fit &= !has_normal | (largest(normal) > 0.0);
    fit &= !extreme;
    hidden = facing_one & !(height[0] > 0.0) & !(height[1] > 0.0) & !(height[2] > 0.0);
    hidden |= one_sided & (seen.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;

    fan = FAN_OF(&wide);
#define EXACT_STORE_NUMBER(name) to->name[i] = fan.name;
#define EXACT_STORE_VECTOR(name)         \
    to->name[0][i] = fan.name[0];        \
    to->name[1][i] = fan.name[1];        \
    to->name[2][i] = fan.name[2];
    PSC_FAN_FIELDS(EXACT_STORE_NUMBER, EXACT_STORE_VECTOR)
    to->pdf[i] = (real)(1.0 / total);
    to->unit[i] = (real)(1.0 / view.scale);
    length = 1.0 / seen.twice_area;
    for (c = 0; c < 3; c++) {
        to->up[c][i] = (real)up[c];
        to->normal[c][i] = (real)((0.0 + seen.normal[c]) * length); /* no -0, as in a sum */
    }
}

static void FN(build_exact_around)(const struct psc_wave *restrict wave,
                                   struct FN(psc_exact_fans) *restrict to)
{
    const int one_sided = wave->one_sided;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_exact_element)(wave, 0, one_sided, 0, i, to);
}

static void FN(build_exact_above)(const struct psc_wave *restrict wave,
                                  struct FN(psc_exact_fans) *restrict to)
{
    const int one_sided = wave->one_sided, facing_one = wave->facing == PSC_FACING_ONE;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(build_exact_element)(wave, facing_one, one_sided, 1, i, to);
}

PSC_LANE void FN(load_exact_fan)(const struct FN(psc_exact_fans) *from, size_t i,
                                 struct FN(psc_fan) *fan)
{
#define EXACT_LOAD_NUMBER(name) fan->name = from->name[i];
#define EXACT_LOAD_VECTOR(name)          \
    fan->name[0] = from->name[0][i];     \
    fan->name[1] = from->name[1][i];     \
    fan->name[2] = from->name[2][i];
    PSC_FAN_FIELDS(EXACT_LOAD_NUMBER, EXACT_LOAD_VECTOR)
}

static void FN(sample_exact)(const struct psc_wave *restrict wave,
                             const struct FN(psc_exact_fans) *restrict f, const real *restrict u,
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

        FN(load_exact_fan)(f, i, &fan);
        FN(fan_map)(&fan, u[i], v[i], &p);
        FN(fan_direction)(&fan, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = f->pdf[i];
        b[i] = p.b;
        a[i] = p.a;
        c[i] = p.c;
    }
    FN(weigh_elements)(facing, n, (const real(*)[PSC_BLOCK])f->up, f->half, f->status, r);
    for (i = 0; wave->surface && i < n; i++) {
        const struct FN(psc_spot) p = {b[i], a[i], c[i]};
        const real normal[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
        real share[3], distance, point[3], first, second;
        struct FN(psc_face) face;
        struct FN(psc_fan) fan;

        FN(load_face)(wave, i, &face);
        FN(load_exact_fan)(f, i, &fan);
        FN(fan_hit)(&fan, &p, share, share + 1, share + 2, &distance);
        FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
        FN(store_surface)(r, i, point, normal, distance * f->unit[i], first, second);
    }
}

/* The elements that are still pending. */
static void FN(exact_elements)(const struct psc_wave *wave, const real *u, const real *v,
                               struct FN(psc_results) *r)
{
    struct FN(psc_pending) part;
    struct FN(psc_exact_fans) fans;

    if (!FN(gather_pending)(wave, u, v, r, &part))
        return;
    (wave->facing == PSC_FACING_NONE ? FN(build_exact_around)
                                     : FN(build_exact_above))(&part.wave, &fans);
    FN(sample_exact)(&part.wave, &fans, part.u, part.v, &part.results);
    FN(scatter_pending)(&part, r);
}
