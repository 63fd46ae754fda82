/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling by projected solid angle, one sample at a time. Where the integral over s
 * is a series all is in the precision of the kernel, but that a fibre next to a horizon, where
 * the density over s is 0, is found in double; where there are panels all is in double up to the
 * direction. Template: see precision.h.
 */

/* From inside the second side is the mirror image of the first. */
#define FIBRE_MIRROR(light, side) ((light)->inside && (side) == 1 ? K(-1.0) : K(1.0))

PSC_LANE void FN(fibre_world)(const struct FN(psc_disk_world) *w, real mirror, real x, real y,
                              real z, real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = mirror * (w->axis[i] + z * w->z[i]) + (x * w->x[i] + y * w->y[i]);
}

/* The fibre of a series that the horizon does not clip. */
static void FN(find_whole)(const struct psc_fibres *f, const struct FN(psc_sheaf) *sheaf, real u,
                           struct FN(psc_fibre_site) *site)
{
    struct FN(psc_fibre_series) series;
    struct FN(series_view) q;

    (void)series;
    switch (f->rule) {
#define FIND_CASE(i, m, most)                                                                     \
    case i:                                                                                       \
        q = FN(view_of)(SERIES_OF(m, f, &series));                                                \
        FN(series_find)(m, &q, sheaf, f->steps, u, K(1.0) - u, site);                             \
        break;
        PSC_FIBRE_RULES(FIND_CASE)
#undef FIND_CASE
    default: break;
    }
}

static void FN(series_point)(const struct psc_disk_light *l, const struct psc_fibres *f, real u,
                             real v, struct FN(psc_fibre_direction) *d)
{
    const struct FN(fibre_frame) frame = FN(frame_of)(l);
    struct FN(psc_fibre_site) site;
    struct FN(psc_sheaf) rounded;
    const struct FN(psc_sheaf) *const sheaf = SHEAF_OF(f, &rounded);

    (void)rounded;
    if (sheaf->clipped) {
        struct psc_fibre_site_f64 wide;

        find_fibre(f, (double)u, 1.0 - (double)u, &wide);
        FN(round_site)(&wide, &site);
    } else {
        FN(find_whole)(f, sheaf, u, &site);
    }
    if (sheaf->brief)
        FN(place_on_fibre)(sheaf, sheaf->clipped, 1, frame.per, frame.bt, &site, v, d);
    else
        FN(place_on_fibre)(sheaf, sheaf->clipped, 0, frame.per, frame.bt, &site, v, d);
}

static psc_result FN(fibre_sample)(const psc_sampler *s, real u, real v,
                                   FN(psc_light_sample) *out)
{
    const struct psc_disk_light *l = &s->disk;
    struct FN(psc_fibre_direction) d;
    struct FN(psc_disk_world) w;
    real within;
    int side;

    if (s->sides == 0)
        return PSC_EMPTY;
    side = FN(pick_side)(s, u, &within);
    if (SERIES_FITS(l->fibres + side)) {
        FN(series_point)(l, l->fibres + side, within, v, &d);
    } else {
        struct psc_fibre_direction_f64 wide;

        fibre_point(l, side, (double)within, (double)v, &wide);
        FN(round_direction)(&wide, &d);
    }
    FN(disk_world)(s, &w);
    FN(fibre_world)(&w, FIBRE_MIRROR(l, side), d.x, d.y, d.z, out->direction);
    out->pdf = d.height * w.inverse_total;
    out->weight = w.total;
    if (l->inside) {
        FN(inside_hit)(&w, out->direction, out->point, out->normal, &out->distance);
        out->surface[0] = out->surface[1] = K(0.0);
    } else {
        FN(gnomonic_hit)(l->solid, &w, d.uz, d.vz, d.depth, d.margin, out->point, out->normal,
                         &out->distance, out->surface);
    }
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}
