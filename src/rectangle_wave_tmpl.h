/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of rectangles along their edges: a loop in double that sees, builds and samples a
 * block of elements, then one for densities. The lane functions are those of the calls for one, so the
 * bits are too. What is left to those: errors, lights without size, and the other maps. Template:
 * see precision.h.
 */

/* What the loop leaves of each element. */
struct FN(psc_rectangles) {
    double distance[PSC_BLOCK], cosine[PSC_BLOCK], volume[PSC_BLOCK], total[PSC_BLOCK];
    double half[PSC_BLOCK]; /* half the solid angle */
    int32_t status[PSC_BLOCK];
};

PSC_LANE void FN(rectangle_element)(const struct psc_wave *wave, int area, int has_normal, size_t i,
                                    real u, real v, struct FN(psc_rectangles) *to,
                                    struct FN(psc_results) *r)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i], wave->position[2][i]};
    const double normal[3] = {has_normal ? wave->normal[0][i] : 0.0,
                              has_normal ? wave->normal[1][i] : 0.0,
                              has_normal ? wave->normal[2][i] : 0.0};
    const double g[9] = {wave->geometry[0][i], wave->geometry[1][i], wave->geometry[2][i],
                         wave->geometry[3][i], wave->geometry[4][i], wave->geometry[5][i],
                         wave->geometry[6][i], wave->geometry[7][i], wave->geometry[8][i]};
    struct psc_polygon_view view;
    struct psc_rectangle_words words;
    struct psc_rectangle f;
    struct psc_triangle_view seen;
    double scaled[3], up[3], height[4], sums[3], length, unit, finite, size;
    real share[2], direction[3], point[3], front[3];
    int c, fit, hidden;

    fit = rectangle_words(position, g, &view, &words, &size);
    see_horizon(has_normal ? normal : NULL, &view, scaled, up, height);
    rectangle_see(&words, &f, &seen);
    f.start = words.corner;
    f.along = words.u;
    f.across = words.v;
    unit = 1.0 / view.scale;
    for (c = 0; c < 3; c++) {
        f.corner[c] = g[c];
        f.edge_u[c] = g[3 + c];
        f.edge_v[c] = words.v.high[c] * unit;
    }
    FN(rectangle_lane)(&f, up, area, u, v, share, direction, to->distance + i, to->cosine + i);
    FN(rectangle_point)(&f, share, point);
    for (c = 0; c < 3; c++)
        sums[c] = -2.0 * seen.normal[c];
    length = __builtin_sqrt(dot(sums, sums));
    to->volume[i] = __builtin_fabs(-2.0 * seen.volume);
    to->half[i] = f.half;
    to->total[i] = area ? 0.5 * length * unit * unit : 2.0 * f.half;
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
            FN(rectangle_element)(wave, area, has_normal, i, u[i], v[i], to, r);               \
    }
RECTANGLE_WAVE(rectangles_around, 0, 0)
RECTANGLE_WAVE(rectangles_above, 0, 1)
RECTANGLE_WAVE(rectangle_areas_around, 1, 0)
RECTANGLE_WAVE(rectangle_areas_above, 1, 1)
#undef RECTANGLE_WAVE

static void FN(rectangle_finish)(const struct psc_wave *restrict wave, int area,
                                 const struct FN(psc_rectangles) *restrict from,
                                 struct FN(psc_results) *restrict r)
{
    const enum psc_facing facing = wave->facing;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(rectangle_density)(area, from->volume[i], from->total[i], facing, from->distance[i],
                              from->cosine[i], r->value[PSC_PDF] + i, r->value[PSC_WEIGHT] + i);
    for (i = 0; i < n; i++)
        r->status[i] = !(from->half[i] > 0.0 && from->total[i] > 0.0) ? PSC_PENDING
                       : from->status[i] != PSC_SUCCESS               ? from->status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
}

static void FN(rectangle_wave)(const struct psc_wave *wave, const real *u, const real *v,
                               struct FN(psc_results) *r)
{
    const int area = wave->measure == PSC_MEASURE_AREA, around = wave->facing == PSC_FACING_NONE;
    struct FN(psc_rectangles) all;

    if (wave->map != PSC_MAP_PARALLEL) {
        FN(pending_wave)(wave, u, v, r);
        return;
    }
    if (area)
        (around ? FN(rectangle_areas_around) : FN(rectangle_areas_above))(wave, u, v, &all, r);
    else
        (around ? FN(rectangles_around) : FN(rectangles_above))(wave, u, v, &all, r);
    FN(rectangle_finish)(wave, area, &all, r);
}
