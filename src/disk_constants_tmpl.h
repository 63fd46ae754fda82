/* SPDX-License-Identifier: Apache-2.0 */
/* What samples need of a light that is seen as an elliptic cone, or laid out by its area: lane
   functions. Template: see precision.h. */

/* The constants of a light in the precision of the kernel. */
struct FN(psc_disk_world) {
    real a, ca, b, cb, per_at, per_bt;
    real ca2, cb2, mu1, mu2, quasi_scale, inverse_quasi_scale; /* see quasi_point() */
    real x[3], y[3], z[3], axis[3];
    real near, far, turn[2], side[2][2], reach;
    real center[3], across[2][3], normal[3];
    real receiver[3]; /* its normal */
    real total, inverse_total;
    real flat_x, flat_y, flat_height, flat_a, flat_skew, flat_b; /* see struct psc_laid */
    real area_scale, area_reach;
    real far_off, beyond, solid_axis[3][3], inverse[3][3], unit, offset[3];
    enum psc_facing facing;
    enum psc_disk_map map;
    enum psc_disk_hit hit;
};

/* What follows from the cone, how far the light is and the total of the measure. */
PSC_LANE void FN(cone_world)(const struct psc_ellipse *e, double reach, double total,
                             double inverse_total, struct FN(psc_disk_world) *w)
{
    const double scale = ellipse_quasi_scale(e);
    int i;

    w->a = (real)e->a;
    w->ca = (real)e->ca;
    w->b = (real)e->b;
    w->cb = (real)e->cb;
    w->ca2 = (real)(e->ca * e->ca);
    w->cb2 = (real)(e->cb * e->cb);
    w->mu1 = (real)ellipse_mu1(e->ca, e->cb);
    w->mu2 = (real)ellipse_mu2(e->ca, e->cb);
    w->quasi_scale = (real)scale;
    w->inverse_quasi_scale = (real)(1.0 / scale);
    w->per_at = (real)(e->ca / e->a);
    w->per_bt = (real)(e->cb / e->b);
    w->reach = (real)reach;
    w->total = (real)total;
    w->inverse_total = (real)inverse_total;
    for (i = 0; i < 3; i++) {
        w->x[i] = (real)e->x[i];
        w->y[i] = (real)e->y[i];
        w->z[i] = (real)e->z[i];
    }
}

/* What samples by area need beside the frame. */
PSC_LANE void FN(area_world)(const struct psc_laid *f, double unit, struct FN(psc_disk_world) *w)
{
    w->flat_x = (real)f->x;
    w->flat_y = (real)f->y;
    w->flat_height = (real)f->height;
    w->flat_a = (real)f->a;
    w->flat_skew = (real)f->skew;
    w->flat_b = (real)f->b;
    w->area_scale = (real)f->scale;
    w->area_reach = (real)unit;
}

/* By elements: see copy3(). */
PSC_LANE void FN(narrow3)(const double from[3], real to[3])
{
    to[0] = (real)from[0];
    to[1] = (real)from[1];
    to[2] = (real)from[2];
}

/* What cones have and samples by area. */
PSC_LANE void FN(light_world)(const psc_sampler *s, struct FN(psc_disk_world) *w)
{
    const struct psc_disk_light *d = &s->disk;
    int k;

    w->facing = s->facing;
    w->map = d->map;
    w->hit = disk_hit_of(d->map, d->solid);
    FN(narrow3)(d->axis, w->axis);
    FN(narrow3)(d->center, w->center);
    FN(narrow3)(d->normal, w->normal);
    FN(narrow3)(d->receiver, w->receiver);
    for (k = 0; k < 2; k++) {
        w->side[k][0] = (real)d->side[k][0];
        w->side[k][1] = (real)d->side[k][1];
        FN(narrow3)(d->across[k], w->across[k]);
    }
}

/* Of a flat light by area. */
PSC_LANE void FN(flat_world)(const psc_sampler *s, struct FN(psc_disk_world) *w)
{
    const struct psc_disk_light *d = &s->disk;

    FN(area_world)(&d->laid, d->reach, w);
    FN(light_world)(s, w);
    FN(narrow3)(d->seen.x, w->x);
    FN(narrow3)(d->seen.y, w->y);
    FN(narrow3)(d->seen.z, w->z);
}

PSC_LANE void FN(disk_world)(const psc_sampler *s, struct FN(psc_disk_world) *w)
{
    const struct psc_disk_light *d = &s->disk;
    int k;

    if (s->measure == PSC_MEASURE_AREA) {
        FN(flat_world)(s, w);
        return;
    }
    FN(cone_world)(&d->seen, d->reach, s->total, s->inverse_total, w);
    FN(light_world)(s, w);
    w->near = (real)d->near;
    w->far = (real)d->far;
    w->turn[0] = (real)d->turn[0];
    w->turn[1] = (real)d->turn[1];
    w->far_off = (real)d->far_off;
    w->beyond = (real)d->beyond;
    w->unit = (real)d->unit;
    FN(narrow3)(d->offset, w->offset);
    for (k = 0; k < 3; k++) {
        FN(narrow3)(d->solid_axis[k], w->solid_axis[k]);
        FN(narrow3)(d->inverse[k], w->inverse[k]);
    }
}
