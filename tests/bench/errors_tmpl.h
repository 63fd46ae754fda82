/* SPDX-License-Identifier: Apache-2.0 */
/* Template: see real.h. */

/* How far the place of a direction is from t; the ends of the interval are the same place. What
   lies outside is wrong by as much as can be. */
static double FN(error)(const psc_sampler *sampler, const real direction[3], real t)
{
    const double d[3] = {direction[0], direction[1], direction[2]};
    double uv[2], error;

    if (psc_invert_f64(sampler, d, uv) != PSC_SUCCESS)
        return 0.5;
    error = fabs(uv[1] - (double)t);
    return MIN(error, 1.0 - error);
}

static void FN(measure)(struct cdf_error *e, int parallel)
{
    const struct FN(stage) *s = &FN(stages)[e->which];
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, parallel ? PSC_MAP_PARALLEL : 0);
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    size_t i;

    for (i = 0; i < s->count; i++) {
        const real p[3] = {s->position[0][i], s->position[1][i], s->position[2][i]};
        const real n[3] = {s->normal[0][i], s->normal[1][i], s->normal[2][i]};
        const real c[4] = {s->light[0][i], s->light[1][i], s->light[2][i], s->light[3][i]};
        const double position[3] = {p[0], p[1], p[2]}, normal[3] = {n[0], n[1], n[2]};
        const double center[3] = {c[0], c[1], c[2]};
        const psc_receiver receiver = make_receiver(position, normal, 0);
        struct FN(psc_light_sample) sample;
        struct FN(paper) paper;
        real direction[3], pdf;

        psc_build_sphere(sampler, &technique, &receiver, center, (double)c[3]);
        FN(psc_sample)(sampler, s->u[i], s->v[i], &sample);
        e->library = MAX(e->library, FN(error)(sampler, sample.direction, s->v[i]));
        if (parallel && FN(parallel_build)(&paper, p, n, c))
            FN(parallel_sample)(&paper, s->u[i], s->v[i], direction, &pdf);
        else if (!parallel && FN(radial_build)(&paper, p, n, c))
            FN(radial_sample)(&paper, s->u[i], s->v[i], direction, &pdf);
        else
            memset(direction, 0, sizeof direction);
        e->paper = MAX(e->paper, FN(error)(sampler, direction, s->v[i]));
    }
}
