/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Elements of a wavefront of rectangles along their edges that take exact products: put together,
 * seen, built and sampled, and put back. Template: see precision.h.
 */
PSC_LANE void FN(exact_element)(const struct psc_wave *wave, int area, int has_normal, size_t i,
                                real u, real v, struct FN(psc_rectangles) *to,
                                struct FN(psc_results) *r)
{
    double position[3], normal[3], g[9];
    struct psc_polygon_view view;
    struct psc_rectangle_words words;
    struct psc_rectangle f;
    struct psc_triangle_view seen;
    double edge_v[3], scaled[3], up[3], height[4], sums[3], length, unit, finite, size, total;
    real share[2], direction[3], point[3], front[3];
    int c, fit, hidden;

    load_rectangle(wave, has_normal, i, position, normal, g);
    fit = rectangle_words(position, g, &view, &words, &size);
    see_horizon(has_normal ? normal : NULL, &view, scaled, up, height);
    rectangle_see(&words, &f, &seen);
    f.start = words.corner;
    f.along = words.u;
    f.across = words.v;
    unit = 1.0 / view.scale;
    scale3(unit, words.v.high, edge_v);
    FN(rectangle_lane)(&f, up, area, u, v, share, direction, to->distance + i, to->cosine + i);
    FN(rectangle_point)(g, g + 3, edge_v, share, point);
    for (c = 0; c < 3; c++)
        sums[c] = -2.0 * seen.normal[c];
    length = __builtin_sqrt(dot(sums, sums));
    to->volume[i] = __builtin_fabs(-2.0 * seen.volume);
    total = area ? 0.5 * length * unit * unit : 2.0 * f.half;
    to->total[i] = f.half > 0.0 ? total : 0.0;
    for (c = 0; c < 3; c++)
        front[c] = (real)(sums[c] * (-1.0 / length));
    r->value[0][i] = direction[0];
    r->value[1][i] = direction[1];
    r->value[2][i] = direction[2];
    FN(store_surface)(r, i, point, front, (real)(to->distance[i] * unit), share[0], share[1]);

    /* A NaN fails every comparison, infinity times 0 is one. */
    finite = (dot(position, position) + dot(g, g)) + (dot(g + 3, g + 3) + dot(g + 6, g + 6));
    fit &= (finite * 0.0 + dot(normal, normal) * 0.0 == 0.0);
    fit &= !has_normal | (largest(normal) > 0.0);
    hidden = (wave->facing == PSC_FACING_ONE) & !(height[0] > 0.0) & !(height[1] > 0.0) &
             !(height[2] > 0.0) & !(height[3] > 0.0);
    hidden |= wave->one_sided & (seen.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;
}

#define RECTANGLE_WAVE(name, area, has_normal)                                                 \
    static void FN(name)(const struct psc_wave *restrict wave, const real *restrict u,         \
                         const real *restrict v, struct FN(psc_rectangles) *restrict to,       \
                         struct FN(psc_results) *restrict r)                                   \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(exact_element)(wave, area, has_normal, i, u[i], v[i], to, r);                   \
    }
RECTANGLE_WAVE(exact_rectangles_around, 0, 0)
RECTANGLE_WAVE(exact_rectangles_above, 0, 1)
RECTANGLE_WAVE(exact_areas_around, 1, 0)
RECTANGLE_WAVE(exact_areas_above, 1, 1)
#undef RECTANGLE_WAVE

/* The elements that are still pending. */
static void FN(exact_rectangles)(const struct psc_wave *wave, const real *u, const real *v,
                                 struct FN(psc_results) *r)
{
    const int area = wave->measure == PSC_MEASURE_AREA, around = wave->facing == PSC_FACING_NONE;
    struct FN(psc_rectangles) all;
    struct FN(psc_pending) part;

    if (!FN(gather_pending)(wave, u, v, r, &part))
        return;
    (area ? around ? FN(exact_areas_around) : FN(exact_areas_above)
     : around ? FN(exact_rectangles_around)
              : FN(exact_rectangles_above))(&part.wave, part.u, part.v, &all, &part.results);
    FN(rectangle_finish)(&part.wave, area, &all, &part.results);
    FN(scatter_pending)(&part, r);
}
