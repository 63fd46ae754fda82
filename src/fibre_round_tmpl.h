/* SPDX-License-Identifier: Apache-2.0 */
/* What the build has in double of fibres, rounded to the precision of a kernel. Template: see
   precision.h. */

#if PSC_REAL_BITS == 64
#define SERIES_FITS_SHEAF(sheaf) 1
#define SHEAF_BRIEF(sheaf) ((sheaf)->brief)
#define SERIES_OF(m, f, to) (&(f)->series)
#define SHEAF_OF(f, to) (&(f)->sheaf)
#else
/* Squares of what is in the light's size must be numbers. */
#define SERIES_FITS_SHEAF(sheaf) ((sheaf)->width > 1e-15 && (sheaf)->sin_m > 1e-15)
#define SHEAF_BRIEF(sheaf) ((sheaf)->brief_f32)
#define SERIES_OF(m, f, to) FN(round_series)(m, &(f)->series, to)
#define SHEAF_OF(f, to) FN(round_sheaf)(&(f)->sheaf, to)

static const struct FN(psc_sheaf) *FN(round_sheaf)(const struct psc_sheaf_f64 *from,
                                                   struct FN(psc_sheaf) *to)
{
    int i;

    for (i = 0; i < 2; i++) {
        to->f[i] = (real)from->f[i];
        to->turn[i] = (real)from->turn[i];
    }
    to->sin_m = (real)from->sin_m;
    to->cos_m = (real)from->cos_m;
    to->shear = (real)from->shear;
    to->width = (real)from->width;
    to->nz = (real)from->nz;
    to->nf = (real)from->nf;
    to->end = (real)from->end;
    to->rest = (real)from->rest;
    to->cos_end = (real)from->cos_end;
    to->clipped = from->clipped;
    to->brief = to->brief_f32 = SHEAF_BRIEF(from);
    return to;
}

PSC_LANE const struct FN(psc_fibre_series) *
FN(round_series)(int n, const struct psc_fibre_series_f64 *from, struct FN(psc_fibre_series) *to)
{
    int i, k;

    to->mean = (real)from->mean;
    for (k = 0; k < 2; k++)
        for (i = 0; i < PSC_START_TERMS; i++)
            to->start[k][i] = (real)from->start[k][i];
    PSC_KEEP_LOOP
    for (i = 0; i < n; i++) {
        to->even[i] = (real)from->even[i];
        to->odd[i] = (real)from->odd[i];
        to->even_integral[i] = (real)from->even_integral[i];
        to->odd_integral[i] = (real)from->odd_integral[i];
        to->even_slope[i] = (real)from->even_slope[i];
        to->odd_slope[i] = (real)from->odd_slope[i];
    }
    return to;
}
#endif

#define SERIES_FITS(f) ((f)->rule >= 0 && SERIES_FITS_SHEAF(&(f)->sheaf))

static void FN(round_direction)(const struct psc_fibre_direction_f64 *from,
                                struct FN(psc_fibre_direction) *to)
{
    to->x = (real)from->x;
    to->y = (real)from->y;
    to->z = (real)from->z;
    to->depth = (real)from->depth;
    to->uz = (real)from->uz;
    to->vz = (real)from->vz;
    to->margin = (real)from->margin;
    to->height = (real)from->height;
}

PSC_LANE void FN(round_site)(const struct psc_fibre_site_f64 *from, struct FN(psc_fibre_site) *to)
{
    to->sine = (real)from->sine;
    to->cosine = (real)from->cosine;
    to->rise = (real)from->rise;
}

/* What the coordinates of a cone need of it. */
struct FN(fibre_frame) {
    real per[2], bt;
};

static struct FN(fibre_frame) FN(frame_of)(const struct psc_disk_light *l)
{
    const struct FN(fibre_frame) frame = {
        {(real)(l->seen.ca / l->seen.a), (real)(l->seen.cb / l->seen.b)}, (real)l->seen.bt};

    return frame;
}
