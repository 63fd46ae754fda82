/* SPDX-License-Identifier: Apache-2.0 */
/* Wavefronts of triangles by area: one loop that builds and samples, in double as the map is, and
   one that weighs. Template: see precision.h. */

/* Heights of directions above the receivers' planes, and cosines over densities for a cosine of
   1. */
struct FN(psc_flat_heights) {
    double height[PSC_BLOCK], inverse[PSC_BLOCK];
};

PSC_LANE void FN(flat_element)(const struct psc_wave *wave, int one_sided, int has_normal, size_t i,
                               real u, real v, struct FN(psc_flat_heights) *to,
                               struct FN(psc_results) *r)
{
    real share[3], direction[3], distance, point[3], normal[3], first, second;
    double position[3], vertices[9], per_length;
    struct FN(psc_face) face;
    struct psc_plain_flat o;
    struct psc_flat_point p;
    int c, fit;

    load_triangle(wave, i, position, vertices);
    fit = see_plain_flat(position, vertices, vertices + 3, vertices + 6, &o);
    for (c = 0; c < 3; c++)
        o.flat.up[c] = has_normal ? wave->normal[c][i] : 0.0;
    if (has_normal) {
        const double square = dot(o.flat.up, o.flat.up), per_size = 1.0 / __builtin_sqrt(square);

        fit &= is_plain_normal(square);
        scale3(per_size, o.flat.up, o.flat.up);
    }
    flat_map(&o.flat, __builtin_fabs(o.volume), (double)u, (double)v, &p);
    FN(round_flat)(&p, share, direction, &distance, r->value[PSC_PDF] + i);
    FN(load_face)(wave, i, &face);
    FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
    per_length = 1.0 / __builtin_sqrt(dot(o.normal, o.normal));
    for (c = 0; c < 3; c++) {
        r->value[c][i] = direction[c];
        normal[c] = (real)(o.normal[c] * per_length);
    }
    FN(store_surface)(r, i, point, normal, distance, first, second);
    to->height[i] = p.height;
    to->inverse[i] = p.inverse;
    r->status[i] = !fit                                ? PSC_PENDING
                   : one_sided & (o.volume > 0.0) ? PSC_EMPTY
                                                       : PSC_SUCCESS;
}

static void FN(flat_around)(const struct psc_wave *restrict wave, const real *restrict u,
                            const real *restrict v, struct FN(psc_flat_heights) *restrict to,
                            struct FN(psc_results) *restrict r)
{
    const int one_sided = wave->one_sided;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(flat_element)(wave, one_sided, 0, i, u[i], v[i], to, r);
}

static void FN(flat_above)(const struct psc_wave *restrict wave, const real *restrict u,
                           const real *restrict v, struct FN(psc_flat_heights) *restrict to,
                           struct FN(psc_results) *restrict r)
{
    const int one_sided = wave->one_sided;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(flat_element)(wave, one_sided, 1, i, u[i], v[i], to, r);
}

static void FN(triangle_area_wave)(const struct psc_wave *wave, const real *u, const real *v,
                                   struct FN(psc_results) *r)
{
    const enum psc_facing facing = wave->facing;
    struct FN(psc_flat_heights) heights;
    int32_t low = 0;
    size_t i;

    (facing == PSC_FACING_NONE ? FN(flat_around) : FN(flat_above))(wave, u, v, &heights, r);
    for (i = 0; i < wave->count; i++) {
        const real weight =
            (real)(fan_cosine_f64(facing, heights.height[i]) * heights.inverse[i]);

        r->value[PSC_WEIGHT][i] = weight;
        r->status[i] = r->status[i] == PSC_SUCCESS && !(weight > K(0.0)) ? PSC_CULLED
                                                                         : r->status[i];
        low |= !(heights.height[i] > 0x1p-17);
    }
    if (low && facing == PSC_FACING_ONE)
        FN(find_hidden)(wave, r);
}
