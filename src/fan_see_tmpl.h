/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of polygons by solid angle: loops over a block of elements that see the triangles of
 * their fans one after another, and judge whether these are fit for plain arithmetic and parts of a
 * polygon. The lane functions are those of the calls for one. Template: see precision.h.
 */

/* What is known of each element: sums over its triangles, and shares and size of each. */
struct FN(psc_fan_sums) {
    double normal[3][PSC_BLOCK], parts[PSC_BLOCK], doubts[PSC_BLOCK], where[PSC_BLOCK];
    double side[PSC_BLOCK]; /* as many as there are triangles, or minus that: else it is unfit */
    double below[PSC_MAX_FAN][PSC_BLOCK], half[PSC_MAX_FAN][PSC_BLOCK];
    /* Of the vertex of the last triangle that the next one has, too. */
    double square[PSC_BLOCK], size[PSC_BLOCK], along[PSC_BLOCK], reach2[PSC_BLOCK];
    double b2[PSC_BLOCK], b_size[PSC_BLOCK]; /* of the pivot */

    /* The psc_fan_frame, and 1 / parts. */
    double front[3][PSC_BLOCK], first[3][PSC_BLOCK], last[3][PSC_BLOCK], area2[PSC_BLOCK];
    double inverse[PSC_BLOCK];
};

/* What judging corners takes of a vertex: its coordinates and those of the edge that ends there,
   the squares of its spoke and of the edge; and whether it is in the plane, as 0 or 1. */
struct FN(psc_fan_corners) {
    double place[2][PSC_BLOCK], edge[2][PSC_BLOCK], spoke2[PSC_BLOCK], edge2[PSC_BLOCK];
    double flat[PSC_BLOCK];
};

PSC_LANE void FN(load_position)(const struct psc_wave *wave, size_t i, double to[3])
{
    to[0] = wave->position[0][i];
    to[1] = wave->position[1][i];
    to[2] = wave->position[2][i];
}

PSC_LANE void FN(load_normal)(const struct psc_wave *wave, size_t i, double to[3])
{
    to[0] = wave->normal[0][i];
    to[1] = wave->normal[1][i];
    to[2] = wave->normal[2][i];
}

PSC_LANE void FN(load_wave_vertex)(const struct psc_wave *wave, int vertex, size_t i, double to[3])
{
    to[0] = wave->geometry[3 * vertex][i];
    to[1] = wave->geometry[3 * vertex + 1][i];
    to[2] = wave->geometry[3 * vertex + 2][i];
}

PSC_LANE void FN(load3)(const double (*from)[PSC_BLOCK], size_t i, double to[3])
{
    to[0] = from[0][i];
    to[1] = from[1][i];
    to[2] = from[2][i];
}

/* Unfit for plain arithmetic. */
#define UNFIT 0x1p60

/* Of each element the first vertex, and the next one, which no triangle has as its last. */
PSC_LANE void FN(start_fan)(const struct psc_wave *wave, int above, size_t i,
                            struct FN(psc_fan_sums) *to)
{
    double position[3], normal[3], b[3], one[3], square;
    struct psc_fan_pivot pivot;
    struct psc_fan_ray ray;

    FN(load_position)(wave, i, position);
    FN(load_normal)(wave, i, normal);
    FN(load_wave_vertex)(wave, 0, i, b);
    FN(load_wave_vertex)(wave, 1, i, one);
    see_pivot(b, position, &pivot);
    see_ray(&pivot, position, b, one, &ray);
    to->normal[0][i] = to->normal[1][i] = to->normal[2][i] = 0.0;
    to->parts[i] = to->doubts[i] = to->side[i] = 0.0;
    to->b2[i] = pivot.b2;
    to->b_size[i] = pivot.size;
    to->square[i] = ray.square;
    to->size[i] = ray.size;
    to->along[i] = ray.along;
    to->reach2[i] = ray.reach2;
    if (!above)
        return;
    square = dot(normal, normal);
    to->where[i] = where_is(dot(normal, pivot.b), square * pivot.b2) +
                   where_is(dot(normal, ray.to), square * ray.square);
}

/* Adds triangle k. */
PSC_LANE void FN(see_fan)(const struct psc_wave *wave, int above, int k, size_t i,
                          struct FN(psc_fan_sums) *to)
{
    double position[3], normal[3], a[3], b[3], c[3], far[3], half;
    struct psc_fan_ray ray_a, ray_c;
    struct psc_fan_pivot pivot;
    struct psc_fan_sight o;
    int fit;

    FN(load_position)(wave, i, position);
    FN(load_normal)(wave, i, normal);
    FN(load_wave_vertex)(wave, k + 1, i, a);
    FN(load_wave_vertex)(wave, 0, i, b);
    FN(load_wave_vertex)(wave, k + 2, i, c);
    subtract3(b, position, pivot.b);
    pivot.b2 = to->b2[i];
    pivot.size = to->b_size[i];
    subtract3(a, position, ray_a.to);
    subtract3(a, b, ray_a.spoke);
    ray_a.square = to->square[i];
    ray_a.size = to->size[i];
    ray_a.along = to->along[i];
    ray_a.reach2 = to->reach2[i];
    see_ray(&pivot, position, b, c, &ray_c);
    subtract3(c, a, far);
    fit = see_fan_triangle(&pivot, &ray_a, &ray_c, far, &o);
    half = half_of_sight(&o);
    to->square[i] = ray_c.square;
    to->size[i] = ray_c.size;
    to->along[i] = ray_c.along;
    to->reach2[i] = ray_c.reach2;
    to->normal[0][i] += o.normal[0];
    to->normal[1][i] += o.normal[1];
    to->normal[2][i] += o.normal[2];
    to->below[k][i] = to->parts[i];
    to->half[k][i] = half;
    to->parts[i] += half;
    to->doubts[i] += o.doubt;
    to->side[i] += !fit ? 0.0 : o.volume > 0.0 ? 1.0 : -1.0;
    if (above)
        to->where[i] += where_is(dot(normal, ray_c.to), dot(normal, normal) * ray_c.square);
}

/* above: where the light is to the receiver's plane matters. */
#define SEE_FANS(name, above)                                                                  \
    PSC_APART void FN(start_##name)(const struct psc_wave *restrict wave,                      \
                                    struct FN(psc_fan_sums) *restrict to)                      \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(start_fan)(wave, above, i, to);                                                 \
    }                                                                                          \
                                                                                               \
    PSC_APART void FN(see_##name)(const struct psc_wave *restrict wave, int k,                 \
                                  struct FN(psc_fan_sums) *restrict to)                        \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(see_fan)(wave, above, k, i, to);                                                \
    }
SEE_FANS(fans_around, 0)
SEE_FANS(fans_above, 1)
#undef SEE_FANS

PSC_APART void FN(frame_fans)(const struct psc_wave *restrict wave, int triangles,
                              struct FN(psc_fan_sums) *restrict to)
{
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++) {
        double b[3], first[3], last[3], sums[3];
        struct psc_fan_frame frame;
        int fit, c;

        FN(load_wave_vertex)(wave, 0, i, b);
        FN(load_wave_vertex)(wave, 1, i, first);
        FN(load_wave_vertex)(wave, triangles + 1, i, last);
        FN(load3)((const double(*)[PSC_BLOCK])to->normal, i, sums);
        subtract3(first, b, first);
        subtract3(last, b, last);
        fit = find_frame(sums, first, last, &frame) &
              is_sure_fan(triangles, to->doubts[i], to->parts[i]);
        to->side[i] = fit ? to->side[i] : UNFIT;
        to->inverse[i] = 1.0 / to->parts[i];
        to->area2[i] = frame.square;
        PSC_UNROLL
        for (c = 0; c < 3; c++) {
            to->front[c][i] = frame.front[c];
            to->first[c][i] = frame.first[c];
            to->last[c][i] = frame.last[c];
        }
    }
}

PSC_LANE void FN(load_frame)(const struct FN(psc_fan_sums) *from, size_t i,
                             struct psc_fan_frame *frame)
{
    FN(load3)((const double(*)[PSC_BLOCK])from->front, i, frame->front);
    FN(load3)((const double(*)[PSC_BLOCK])from->first, i, frame->first);
    FN(load3)((const double(*)[PSC_BLOCK])from->last, i, frame->last);
    frame->square = from->area2[i];
}

/* Of a vertex from 1 on. */
PSC_APART void FN(place_vertices)(const struct psc_wave *restrict wave, int vertex,
                                  const struct FN(psc_fan_sums) *restrict from,
                                  struct FN(psc_fan_corners) *restrict to)
{
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++) {
        double b[3], before[3], v[3], spoke[3], edge[3], at[2], along[2];
        struct psc_fan_frame frame;

        FN(load_frame)(from, i, &frame);
        FN(load_wave_vertex)(wave, 0, i, b);
        FN(load_wave_vertex)(wave, vertex - 1, i, before);
        FN(load_wave_vertex)(wave, vertex, i, v);
        subtract3(v, b, spoke);
        subtract3(v, before, edge);
        place_on(&frame, spoke, at);
        place_on(&frame, edge, along);
        to->place[0][i] = at[0];
        to->place[1][i] = at[1];
        to->edge[0][i] = along[0];
        to->edge[1][i] = along[1];
        to->spoke2[i] = dot(spoke, spoke);
        to->edge2[i] = dot(edge, edge);
        to->flat[i] = is_in_plane(&frame, v, spoke) ? 1.0 : 0.0;
    }
}

/* Whether the triangle between two vertices turns as a convex polygon does. one: vertex 1; next:
   the vertex after, or the last itself, whose edge does not turn into itself. */
PSC_APART void FN(judge_fans)(const struct FN(psc_fan_corners) *restrict one,
                              const struct FN(psc_fan_corners) *restrict from_a,
                              const struct FN(psc_fan_corners) *restrict from_c,
                              const struct FN(psc_fan_corners) *restrict next, size_t n,
                              struct FN(psc_fan_sums) *restrict to)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const double a[2] = {from_a->place[0][i], from_a->place[1][i]};
        const double c[2] = {from_c->place[0][i], from_c->place[1][i]};
        const double far[2] = {from_c->edge[0][i], from_c->edge[1][i]};
        const double further[2] = {next->edge[0][i], next->edge[1][i]};
        struct psc_fan_frame frame;
        int turns;

        frame.square = to->area2[i];
        turns = fan_turns(&frame, a, c, far, further, one->spoke2[i], from_c->spoke2[i],
                          from_c->edge2[i], next->edge2[i]);
        turns &= (one->flat[i] * from_c->flat[i] != 0.0);
        to->side[i] = turns ? to->side[i] : UNFIT;
    }
}
