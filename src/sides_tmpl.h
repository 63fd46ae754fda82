/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Many samples of one build, whatever the family: blocks of inputs, and where both sides of the
 * receiver's plane are sampled, the elements sorted by the side that u falls to. Template: see
 * precision.h.
 */

/* The side that u falls to, of two of which the first has the share split, and u within it: both
   have u = 0 inside and meet at 1, on the horizon. */
PSC_LANE int FN(pick_of_two)(double split, real u, real *within)
{
    const real first = (real)split, second = (real)(1.0 - split);
    /* A second side may be less than rounding. */
    const int i = (u >= first) & (second > K(0.0));

    u = i ? (K(1.0) - u) / second : u / first;
    *within = MIN(u, K(1.0));
    return i;
}

PSC_LANE int FN(pick_side)(const psc_sampler *s, real u, real *within)
{
    if (s->sides == 1) {
        *within = u;
        return 0;
    }
    return FN(pick_of_two)(s->split, u, within);
}

/* Fills the results of n samples, at most a block, of one side: direction, pdf, weight and
   status, and where surface is set all else. */
typedef void (*FN(side_block))(const psc_sampler *s, int side, size_t n, const real *u,
                               const real *v, int surface, struct FN(psc_results) *r);

PSC_LANE void FN(sample_sides)(const psc_sampler *s, size_t count, const FN(psc_input) *uv,
                               const FN(psc_samples) *out, FN(side_block) block)
{
    const int surface = FN(wants_surface)(out);
    real u[PSC_BLOCK], v[PSC_BLOCK], pu[2][PSC_BLOCK], pv[2][PSC_BLOCK];
    struct FN(psc_results) results;
    uint32_t index[2][PSC_BLOCK];
    size_t first, n, i;

    for (first = 0; first < count; first += n) {
        n = MIN(count - first, PSC_BLOCK);
        FN(gather)(uv->component[0], uv->stride, first, n, u);
        FN(gather)(uv->component[1], uv->stride, first, n, v);
        if (s->sides == 1) {
            block(s, 0, n, u, v, surface, &results);
            FN(scatter_values)(out, &results, first, NULL, NULL, n);
            FN(scatter_status)(&out->status, results.status, first, NULL, n);
        } else {
            size_t part[2] = {0, 0};
            int k;

            for (i = 0; i < n; i++) {
                real within;

                k = FN(pick_side)(s, u[i], &within);
                pu[k][part[k]] = within;
                pv[k][part[k]] = v[i];
                index[k][part[k]++] = (uint32_t)i;
            }
            for (k = 0; k < 2; k++) {
                block(s, k, part[k], pu[k], pv[k], surface, &results);
                FN(scatter_values)(out, &results, first, NULL, index[k], part[k]);
                FN(scatter_status)(&out->status, results.status, first, index[k], part[k]);
            }
        }
    }
}
