/* SPDX-License-Identifier: Apache-2.0 */
/* Blocks of samples of one build of a flat light with straight edges, in loops that vectorise.
   Template: see precision.h. */

/* n samples of one triangle by solid angle; what does not vary is a loop of its own, so that all
   of them become vector code. plain: built by plain_fan(). */
PSC_LANE void FN(fan_lanes)(const psc_sampler *s, int k, int plain, size_t n,
                            const real *restrict u, const real *restrict v, int surface,
                            struct FN(psc_results) *restrict r)
{
    const struct FN(psc_face) face = FN(face_at)(&s->polygon, k);
    const real normal[3] = {(real)s->polygon.normal[0], (real)s->polygon.normal[1],
                            (real)s->polygon.normal[2]};
    const real pivot[3] = {(real)s->polygon.b[0], (real)s->polygon.b[1], (real)s->polygon.b[2]};
    struct FN(psc_ray_fan) own;
    real b[PSC_BLOCK], a[PSC_BLOCK], c[PSC_BLOCK];
    struct FN(psc_polygon_world) w;
    struct FN(psc_fan) fan;
    size_t i;

    if (plain)
        own = RAY_FAN_OF(&s->polygon.rays);
    else
        fan = FAN_OF(s->polygon.fan + k);
    FN(polygon_world)(s, &w);
    for (i = 0; i < n; i++) {
        struct FN(psc_spot) p;
        real direction[3];

        if (plain) {
            FN(ray_map)(&own, u[i], v[i], &p);
            FN(ray_direction)(&own, pivot, &p, direction);
        } else {
            FN(fan_map)(&fan, u[i], v[i], &p);
            FN(fan_direction)(&fan, &p, direction);
        }
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        b[i] = p.b;
        a[i] = p.a;
        c[i] = p.c;
    }
    FN(weigh_samples)(&w, n, r);
    for (i = 0; surface && i < n; i++) {
        const struct FN(psc_spot) p = {b[i], a[i], c[i]};
        real share[3], distance, point[3], first, second;

        if (plain)
            FN(plain_hit)(&own, &p, share, &distance);
        else
            FN(fan_hit)(&fan, &p, share, share + 1, share + 2, &distance);
        FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
        FN(store_surface)(r, i, point, normal, distance * w.unit, first, second);
    }
}

static void FN(fan_block)(const psc_sampler *s, int k, size_t n, const real *u, const real *v,
                          int surface, struct FN(psc_results) *r)
{
    FN(fan_lanes)(s, k, 0, n, u, v, surface, r);
}

static void FN(plain_block)(const psc_sampler *s, int k, size_t n, const real *u, const real *v,
                            int surface, struct FN(psc_results) *r)
{
    FN(fan_lanes)(s, k, 1, n, u, v, surface, r);
}

/* The same by area. What becomes of the cosine is chosen in a loop of its own, since one that has
   to is no vector code. */
static void FN(flat_block)(const psc_sampler *s, int k, size_t n, const real *restrict u,
                           const real *restrict v, int surface, struct FN(psc_results) *restrict r)
{
    const struct psc_flat flat = s->polygon.flat[k];
    const struct FN(psc_face) face = FN(face_at)(&s->polygon, k);
    const real normal[3] = {(real)s->polygon.normal[0], (real)s->polygon.normal[1],
                            (real)s->polygon.normal[2]};
    const double volume = s->polygon.volume;
    double height[PSC_BLOCK], inverse[PSC_BLOCK];
    struct FN(psc_polygon_world) w;
    size_t i;

    (void)surface;
    FN(polygon_world)(s, &w);
    for (i = 0; i < n; i++) {
        real share[3], direction[3], distance, point[3], first, second;
        struct psc_flat_point p;

        flat_map(&flat, volume, (double)u[i], (double)v[i], &p);
        FN(round_flat)(&p, share, direction, &distance, r->value[PSC_PDF] + i);
        FN(face_point)(&face, share[0], share[1], share[2], point, &first, &second);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        height[i] = p.height;
        inverse[i] = p.inverse;
        FN(store_surface)(r, i, point, normal, distance * w.unit, first, second);
    }
    for (i = 0; i < n; i++)
        r->value[PSC_WEIGHT][i] = (real)(fan_cosine_f64(w.facing, height[i]) * inverse[i]);
}

typedef void (*FN(triangle_block))(const psc_sampler *s, int k, size_t n, const real *u,
                                   const real *v, int surface, struct FN(psc_results) *r);

/* A block of a light of more triangles than one: sorted by triangle, and put back. */
static void FN(sorted_block)(const psc_sampler *s, FN(triangle_block) block, size_t n,
                             const real *u, const real *v, int surface,
                             struct FN(psc_results) *r)
{
    uint32_t index[PSC_MAX_FAN][PSC_BLOCK];
    real within[PSC_BLOCK], su[PSC_BLOCK], sv[PSC_BLOCK];
    size_t count[PSC_MAX_FAN] = {0}, i;
    struct FN(psc_results) part;
    int k, c;

    for (i = 0; i < n; i++) {
        k = FN(pick_triangle)(&s->polygon, u[i], within + i);
        index[k][count[k]++] = (uint32_t)i;
    }
    for (k = 0; k < s->polygon.triangles; k++) {
        for (i = 0; i < count[k]; i++) {
            su[i] = within[index[k][i]];
            sv[i] = v[index[k][i]];
        }
        block(s, k, count[k], su, sv, surface, &part);
        for (c = 0; c < PSC_COMPONENTS; c++)
            if (surface || c < PSC_POINT || c == PSC_WEIGHT)
                for (i = 0; i < count[k]; i++)
                    r->value[c][index[k][i]] = part.value[c][i];
    }
}

static void FN(polygon_side_block)(const psc_sampler *s, int side, size_t n, const real *u,
                                   const real *v, int surface, struct FN(psc_results) *r)
{
    const FN(triangle_block) block =
        s->measure == PSC_MEASURE_AREA      ? FN(flat_block)
        : s->polygon.plain == PSC_PLAIN_FAN ? FN(ray_block)
        : s->polygon.plain                  ? FN(plain_block)
                                            : FN(fan_block);
    size_t i;

    if (s->projected) {
        FN(sector_block)(s, side, n, u, v, surface, r);
        return;
    }
    if (s->map == PSC_MAP_PARALLEL)
        FN(parallel_block)(s, n, u, v, surface, r);
    else if (s->polygon.triangles == 1)
        block(s, 0, n, u, v, surface, r);
    else
        FN(sorted_block)(s, block, n, u, v, surface, r);
    for (i = 0; i < n; i++)
        r->status[i] = r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static void FN(polygon_sample_n)(const psc_sampler *s, size_t count, const FN(psc_input) *uv,
                                 const FN(psc_samples) *out)
{
    FN(sample_sides)(s, count, uv, out, FN(polygon_side_block));
}
