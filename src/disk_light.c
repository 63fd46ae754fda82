/* SPDX-License-Identifier: Apache-2.0 */
/* Questions to samplers of disks, elliptical disks and ellipsoids, one at a time. */
#include "disk_light.h"

#include "disk_inverse.h"

/* ---- Totals ---- */

/* Of a sampler that has it not: by a build of what it was built from. */
static psc_result ask_again(const psc_sampler *s, psc_measure measure, psc_map map, double *value)
{
    const struct psc_disk_light *d = &s->disk;
    const int projected = measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    psc_sampler_storage storage;
    struct psc_request request;
    psc_sampler *other;
    psc_result result;

    request.measure = measure;
    request.map = map;
    request.facing = projected ? s->facing : PSC_FACING_NONE;
    request.position = d->given_position;
    request.normal = projected ? d->given_normal : NULL;
    request.one_sided = 0;
    request.numbers = d->numbers;
    request.table = NULL;
    psc_sampler_init(&storage, sizeof storage, &other);
    result = psc_build_numbers(other, s->shape, &request, d->given);
    *value = other->total;
    return result;
}

psc_result psc_disk_whole_solid_angle(const psc_sampler *s, double *value)
{
    if (s->measure == PSC_MEASURE_AREA && s->sides > 0)
        return ask_again(s, PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM, value);
    *value = s->disk.inside         ? 4.0 * PSC_PI
             : s->disk.seen.a > 0.0 ? ellipse_total(&s->disk.seen)
                                    : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_disk_projected_solid_angle(const psc_sampler *s, double *value)
{
    if (s->facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    if (!s->projected && s->sides > 0)
        return ask_again(s, PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL, value);
    *value = s->sides > 0 ? s->total : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_disk_area(const psc_sampler *s, double *value)
{
    if (s->disk.solid)
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    *value = s->disk.area;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_disk_ask_solid_angle(const struct psc_shape_row *shape, const char *kinds,
                                    const double position[3], const double *const parts[],
                                    double *solid_angle)
{
    const psc_technique technique = {.struct_size = sizeof technique, .map = PSC_MAP_QUASI_UNIFORM};
    const psc_receiver receiver = {sizeof receiver, 0, position, NULL};
    psc_sampler_storage storage;
    psc_sampler *sampler;
    psc_result result;

    if (!solid_angle)
        return PSC_ERROR_NULL_POINTER;
    psc_sampler_init(&storage, sizeof storage, &sampler);
    result = psc_build(sampler, shape, kinds, &technique, &receiver, parts);
    if (result >= 0)
        *solid_angle = sampler->total;
    return result;
}

/* ---- Directions ---- */

double psc_disk_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    const struct psc_disk_light *l = &s->disk;
    struct seen d;
    double length;

    if (s->projected)
        return MAX(look_above(s, direction, epsilon, &d), 0.0) * s->inverse_total;
    if (l->inside)
        return s->inverse_total;
    if (s->measure == PSC_MEASURE_AREA) {
        if (!look_laid(l, direction, epsilon, &d))
            return 0.0;
        length = l->laid.height / d.z;
        return length * length * length / l->laid.scale;
    }
    if (!look(&l->seen, direction, epsilon, &d))
        return 0.0;
    if (l->map == PSC_DISK_QUASI_UNIFORM) {
        const struct psc_ellipse *e = &l->seen;
        double c, s1;

        eccentric(e, &d, &c, &s1);
        return 1.0 / (ellipse_quasi_scale(e) * quasi_share_f64(e->ca * e->ca, e->cb * e->cb,
                                                               ellipse_mu2(e->ca, e->cb), c, s1));
    }
    if (l->map == PSC_DISK_TABULATED) {
        double azimuth;

        return table_cell_at(l, d.x, d.y, &azimuth).density;
    }
    return s->inverse_total;
}

psc_result psc_disk_invert(const psc_sampler *s, const double direction[3], double epsilon,
                           double uv[2])
{
    const struct psc_disk_light *l = &s->disk;
    struct seen d;
    int i;

    if (s->projected)
        return invert_fibres(s, direction, epsilon, uv);
    if (l->inside) {
        invert_around(l->map, direction, uv);
    } else if (s->measure == PSC_MEASURE_AREA) {
        if (!look_laid(l, direction, epsilon, &d))
            return PSC_OUTSIDE;
        invert_area(l, &d, uv);
    } else if (!look(&l->seen, direction, epsilon, &d)) {
        return PSC_OUTSIDE;
    } else if (l->map == PSC_DISK_PARALLEL) {
        invert_chord(s, &d, uv);
    } else if (l->map == PSC_DISK_TABULATED) {
        table_invert(l, d.x, d.y, (d.x * d.x + d.y * d.y) / (1.0 + d.z), uv);
    } else {
        invert_radial(s, &d, uv);
    }
    for (i = 0; i < 2; i++)
        uv[i] = MIN(MAX(uv[i], 0.0), 1.0);
    return PSC_SUCCESS;
}
