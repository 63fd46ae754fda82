/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From a point in the frame of a cone to the world: direction, density and weight, and where the
 * direction meets the light. Lane functions. Template: see precision.h.
 */

PSC_LANE void FN(disk_direction)(const struct FN(psc_disk_world) *w,
                                 const struct FN(psc_disk_point) *p, real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = w->axis[i] + ((p->x * w->x[i] + p->y * w->y[i]) + p->z * w->z[i]);
}

/* The cosine that counts; without a normal there is none, and 1 stands for it. */
PSC_LANE real FN(disk_cosine)(enum psc_facing facing, const struct FN(psc_disk_world) *w,
                              const real direction[3])
{
    const real height = (direction[0] * w->receiver[0] + direction[1] * w->receiver[1]) +
                        direction[2] * w->receiver[2];

    return facing == PSC_FACING_NONE  ? K(1.0)
           : facing == PSC_FACING_ONE ? MAX(height, K(0.0))
                                      : ABS(height);
}

/* By area: distance squared over the cosine at the light takes that to solid angle. */
PSC_LANE void FN(disk_density)(enum psc_disk_density density, const struct FN(psc_disk_world) *w,
                               const struct FN(psc_disk_point) *p, real cosine, real *pdf,
                               real *weight)
{
    if (density == PSC_DISK_BY_AREA) {
        const real cube = p->rest * p->rest * p->rest;

        *pdf = cube / w->area_scale;
        *weight = cosine * (w->area_scale / cube);
    } else if (density == PSC_DISK_QUASI) {
        const real share = FN(quasi_share)(w->ca2, w->cb2, w->mu2, p->c, p->s);

        *pdf = w->inverse_quasi_scale / share;
        *weight = cosine * (w->quasi_scale * share);
    } else {
        *pdf = w->inverse_total;
        *weight = cosine * w->total;
    }
}

/* The hit of an ellipsoid from inside, where the direction has the inverse row products `w`. */
PSC_LANE void FN(solid_normal)(const struct FN(psc_disk_world) *w, const real unit[3],
                               real point[3], real normal[3])
{
    real length;
    int i;

    for (i = 0; i < 3; i++) {
        point[i] = w->center[i] + ((unit[0] * w->solid_axis[0][i] + unit[1] * w->solid_axis[1][i]) +
                                   unit[2] * w->solid_axis[2][i]);
        normal[i] = (unit[0] * w->inverse[0][i] + unit[1] * w->inverse[1][i]) +
                    unit[2] * w->inverse[2][i];
    }
    length = K(1.0) / SQRT((normal[0] * normal[0] + normal[1] * normal[1]) + normal[2] * normal[2]);
    for (i = 0; i < 3; i++)
        normal[i] *= length;
}

PSC_LANE void FN(inside_hit)(const struct FN(psc_disk_world) *w, const real direction[3],
                             real point[3], real normal[3], real *distance)
{
    real unit[3], b = K(0.0), square = K(0.0), root, t;
    int i;

    for (i = 0; i < 3; i++) {
        unit[i] = (direction[0] * w->inverse[i][0] + direction[1] * w->inverse[i][1]) +
                  direction[2] * w->inverse[i][2];
        b += unit[i] * w->offset[i];
        square += unit[i] * unit[i];
    }
    root = SQRT(b * b + square * w->beyond);
    t = b >= K(0.0) ? (b + root) / square : w->beyond / (root - b);
    for (i = 0; i < 3; i++)
        unit[i] = t * unit[i] - w->offset[i];
    FN(solid_normal)(w, unit, point, normal);
    *distance = t * w->unit;
}

/*
 * The hit of a light seen from outside, from U z, V z, z and z^2 (1 - U^2 - V^2) of
 * ellipse_view.h. The near side of an ellipsoid (solid) follows from the point of the elliptical
 * disk with the same outline: in units in which it is the unit sphere at the distance C, with r
 * the root of 1 - q^2 and lambda = sqrt(C^2 - 1) / (C + r), the normal is lambda (q_x, q_y) across
 * and -(1 + C r) / (C + r) along.
 */
PSC_LANE void FN(gnomonic_hit)(int solid, const struct FN(psc_disk_world) *w, real x, real y,
                               real height, real margin, real point[3], real normal[3], real *distance,
                               real surface[2])
{
    real qx, qy, inverse;
    int i;

    FN(boost)(w->near, w->far, w->turn[0] * x + w->turn[1] * y, w->turn[0] * y - w->turn[1] * x,
              height, margin, &qx, &qy, &inverse);
    *distance = K(2.0) * w->reach * inverse;
    if (solid) {
        const real r = MIN(K(2.0) * SQRT(margin) * inverse, K(1.0));
        const real share = K(1.0) / (w->far_off + r), lambda = w->beyond * share;
        const real unit[3] = {lambda * qx, lambda * qy, -(K(1.0) + w->far_off * r) * share};

        FN(solid_normal)(w, unit, point, normal);
        *distance = *distance * lambda;
        surface[0] = surface[1] = K(0.0);
        return;
    }
    for (i = 0; i < 3; i++) {
        point[i] = w->center[i] + (qx * w->across[0][i] + qy * w->across[1][i]);
        normal[i] = w->normal[i];
    }
    surface[0] = qx * w->side[0][0] + qy * w->side[1][0];
    surface[1] = qx * w->side[0][1] + qy * w->side[1][1];
}

PSC_LANE void FN(outside_hit)(enum psc_disk_hit hit, const struct FN(psc_disk_world) *w,
                              const struct FN(psc_disk_point) *p, real point[3], real normal[3],
                              real *distance, real surface[2])
{
    real height, margin;

    if (hit == PSC_DISK_HIT_CHORD || hit == PSC_DISK_HIT_SOLID_CHORD)
        FN(chord_depth)(w->ca, w->cb, p, &height, &margin);
    else
        FN(cone_depth)(w->ca, w->cb, p, &height, &margin);
    FN(gnomonic_hit)(hit == PSC_DISK_HIT_SOLID || hit == PSC_DISK_HIT_SOLID_CHORD, w,
                     p->x * w->per_at, p->y * w->per_bt, height, margin, point, normal, distance,
                     surface);
}

PSC_LANE void FN(area_hit)(const struct FN(psc_disk_world) *w, const struct FN(psc_disk_point) *p,
                           real point[3], real normal[3], real *distance, real surface[2])
{
    int i;

    *distance = p->rest * w->area_reach;
    for (i = 0; i < 3; i++) {
        point[i] = w->center[i] + (p->c * w->across[0][i] + p->s * w->across[1][i]);
        normal[i] = w->normal[i];
    }
    surface[0] = p->c * w->side[0][0] + p->s * w->side[1][0];
    surface[1] = p->c * w->side[0][1] + p->s * w->side[1][1];
}

PSC_LANE void FN(disk_hit)(enum psc_disk_hit hit, const struct FN(psc_disk_world) *w,
                           const struct FN(psc_disk_point) *p, const real direction[3],
                           real point[3], real normal[3], real *distance, real surface[2])
{
    if (hit == PSC_DISK_HIT_INSIDE) {
        FN(inside_hit)(w, direction, point, normal, distance);
        surface[0] = surface[1] = K(0.0);
    } else if (hit == PSC_DISK_HIT_AREA) {
        FN(area_hit)(w, p, point, normal, distance, surface);
    } else {
        FN(outside_hit)(hit, w, p, point, normal, distance, surface);
    }
}
