/* SPDX-License-Identifier: Apache-2.0 */
/* Wavefronts of lights that are seen as an elliptic cone: from points to results, in loops.
   Template: see precision.h. */

PSC_LANE void FN(wave_densities)(enum psc_disk_density density, enum psc_facing facing, size_t n,
                                 const struct FN(psc_disk_views) *restrict o,
                                 struct FN(psc_results) *restrict r)
{
    size_t e;

    for (e = 0; e < n; e++) {
        const struct FN(psc_disk_point) p = FN(load_point)(&o->points, e);
        struct FN(psc_disk_world) w;
        real direction[3];

        FN(load_world)(o, e, &w);
        FN(disk_direction)(&w, &p, direction);
        r->value[0][e] = direction[0];
        r->value[1][e] = direction[1];
        r->value[2][e] = direction[2];
        FN(disk_density)(density, &w, &p, FN(disk_cosine)(facing, &w, direction),
                         &r->value[PSC_PDF][e], &r->value[PSC_WEIGHT][e]);
    }
}

#define WAVE_DENSITY(name, density)                                                                \
    static void FN(name)(enum psc_facing facing, size_t n,                                         \
                         const struct FN(psc_disk_views) *o, struct FN(psc_results) *r)            \
    {                                                                                              \
        if (facing == PSC_FACING_NONE)                                                             \
            FN(wave_densities)(density, PSC_FACING_NONE, n, o, r);                                 \
        else if (facing == PSC_FACING_ONE)                                                         \
            FN(wave_densities)(density, PSC_FACING_ONE, n, o, r);                                  \
        else                                                                                       \
            FN(wave_densities)(density, PSC_FACING_BOTH, n, o, r);                                 \
    }
WAVE_DENSITY(wave_constant, PSC_DISK_CONSTANT)
WAVE_DENSITY(wave_by_area, PSC_DISK_BY_AREA)
WAVE_DENSITY(wave_by_quasi, PSC_DISK_QUASI)
#undef WAVE_DENSITY

#define WAVE_HITS(name, hit)                                                                       \
    static void FN(name)(size_t n, const struct FN(psc_disk_views) *restrict o,                    \
                         struct FN(psc_results) *restrict r)                                       \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            const struct FN(psc_disk_point) p = FN(load_point)(&o->points, e);                     \
            const real direction[3] = {r->value[0][e], r->value[1][e], r->value[2][e]};            \
            real point[3], normal[3], distance, surface[2];                                        \
            struct FN(psc_disk_world) w;                                                           \
                                                                                                   \
            FN(load_world)(o, e, &w);                                                              \
            FN(disk_hit)(hit, &w, &p, direction, point, normal, &distance, surface);               \
            FN(store_surface)(r, e, point, normal, distance, surface[0], surface[1]);              \
        }                                                                                          \
    }
WAVE_HITS(wave_hits_flat, PSC_DISK_HIT_FLAT)
WAVE_HITS(wave_hits_chord, PSC_DISK_HIT_CHORD)
WAVE_HITS(wave_hits_solid, PSC_DISK_HIT_SOLID)
WAVE_HITS(wave_hits_solid_chord, PSC_DISK_HIT_SOLID_CHORD)
WAVE_HITS(wave_hits_area, PSC_DISK_HIT_AREA)
#undef WAVE_HITS

static void FN(wave_results)(const struct psc_wave *wave, enum psc_disk_map map, int solid,
                             const struct FN(psc_disk_views) *o, struct FN(psc_results) *r)
{
    const size_t n = wave->count;
    size_t i;

    switch (disk_density_of(map)) {
    case PSC_DISK_BY_AREA: FN(wave_by_area)(wave->facing, n, o, r); break;
    case PSC_DISK_QUASI: FN(wave_by_quasi)(wave->facing, n, o, r); break;
    default: FN(wave_constant)(wave->facing, n, o, r); break;
    }
    for (i = 0; i < n; i++)
        if (r->status[i] == PSC_SUCCESS && !(r->value[PSC_WEIGHT][i] > K(0.0)))
            r->status[i] = PSC_CULLED;
    if (!wave->surface)
        return;
    switch (disk_hit_of(map, solid)) {
    case PSC_DISK_HIT_CHORD: FN(wave_hits_chord)(n, o, r); break;
    case PSC_DISK_HIT_SOLID: FN(wave_hits_solid)(n, o, r); break;
    case PSC_DISK_HIT_SOLID_CHORD: FN(wave_hits_solid_chord)(n, o, r); break;
    case PSC_DISK_HIT_AREA: FN(wave_hits_area)(n, o, r); break;
    default: FN(wave_hits_flat)(n, o, r); break;
    }
}
