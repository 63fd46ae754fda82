/* SPDX-License-Identifier: Apache-2.0 */
/* Wavefronts of spheres by area, in the middle of cap_wave_tmpl.h. Template: see precision.h. */

#define AREA_WAVE(lane, concentric)                                                            \
    static void FN(wave_##lane)(const struct psc_wave *restrict wave,                          \
                                const struct views *restrict o, const real *restrict u,        \
                                const real *restrict v,                                        \
                                struct FN(psc_cap_points) *restrict to,                        \
                                double *restrict total)                                        \
    {                                                                                          \
        const int visible = wave->measure == PSC_MEASURE_VISIBLE_AREA;                         \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            const double radius = wave->geometry[3][i];                                        \
            struct FN(psc_point) p;                                                            \
            struct psc_lobe_f64 l;                                                             \
            real pdf, inverse;                                                                 \
                                                                                               \
            l.sin_b = o->sin_b[i];                                                             \
            l.cos_b = o->cos_b[i];                                                             \
            area_build(&l, o->far[i], o->radius[i], o->power[i], visible);                     \
            FN(area_lane)(concentric, &l, u[i], v[i], &p, &pdf, &inverse);                     \
            CAP_STORE(to, i, p);                                                               \
            to->pdf[i] = pdf;                                                                  \
            to->inverse[i] = inverse;                                                          \
            total[i] = l.total_area * (radius * radius);                                       \
        }                                                                                      \
    }
AREA_WAVE(radial_area, 0)
AREA_WAVE(concentric_area, 1)
#undef AREA_WAVE

typedef void (*FN(area_wave))(const struct psc_wave *, const struct views *, const real *,
                              const real *, struct FN(psc_cap_points) *, double *);
static const FN(area_wave) FN(area_waves)[] = {FN(wave_radial_area), FN(wave_concentric_area)};

/* All elements in their places: those that are empty or pending give numbers that no one reads. */
static void FN(wave_areas)(const struct psc_wave *wave, const struct views *o, const real *u,
                           const real *v, struct FN(psc_results) *r)
{
    struct FN(psc_cap_points) points;
    struct FN(psc_cap_world) w;
    double total[PSC_BLOCK];
    size_t i;

    FN(area_waves)[wave->map != PSC_MAP_RADIAL](wave, o, u, v, &points, total);
    FN(wave_cone_directions)(wave, o, &points, r);
    w.facing = wave->facing;
    for (i = 0; i < wave->count; i++) {
        real weight;
        const psc_result status =
            FN(area_density)(&w, points.height[i], points.inverse[i], &weight);

        r->value[PSC_PDF][i] = points.pdf[i];
        r->value[PSC_WEIGHT][i] = weight;
        r->status[i] = o->kind[i] == KIND_PENDING                      ? PSC_PENDING
                       : o->kind[i] == KIND_EMPTY || !(total[i] > 0.0) ? PSC_EMPTY
                                                                       : status;
    }
    if (wave->surface)
        FN(wave_surfaces)(wave, o, &points, 0, 1, r);
}
