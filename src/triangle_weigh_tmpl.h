/* SPDX-License-Identifier: Apache-2.0 */
/* Wavefronts of triangles: what the receivers' planes make of samples whose directions are there.
   Template: see precision.h. */

#undef NORMAL_MIN
#undef NORMAL_MAX
#if PSC_BITS == 64
#define NORMAL_MIN 0x1p-320
#define NORMAL_MAX 0x1p320
#else
#define NORMAL_MIN 0x1p-100f
#define NORMAL_MAX 0x1p100f
#endif

/* Statuses where nobody asks for weights: then their signs will do, and normals of any length.
   Returns whether rounding cannot have decided any; *all: PSC_SUCCESS if all are. */
static int FN(judge_elements)(const struct psc_wave *restrict wave,
                              const struct FN(psc_fans) *restrict f,
                              struct FN(psc_results) *restrict r, psc_result *restrict all)
{
    const int facing_one = wave->facing == PSC_FACING_ONE;
    const size_t n = wave->count;
    int32_t near = 0, any = 0;
    size_t i;

    for (i = 0; i < n; i++) {
        const real normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        const real height = FN(fan_height)(normal, direction);
        const real square = FN(fan_height)(normal, normal);

        near |= !((height * height > K(0x1p-30) * square) & (square > NORMAL_MIN) &
                  (square < NORMAL_MAX));
        r->status[i] = f->status[i] != PSC_SUCCESS         ? f->status[i]
                       : facing_one & (height < K(0.0)) ? PSC_CULLED
                                                           : PSC_SUCCESS;
        any |= r->status[i];
    }
    *all = any;
    return !near;
}

/* The receivers' normals, of length 1. */
static void FN(find_normals)(const struct psc_wave *restrict wave, struct FN(psc_fans) *restrict to)
{
    const size_t n = wave->count;
    size_t i;
    int c;

    if (wave->facing == PSC_FACING_NONE) {
        memset(to->up, 0, sizeof to->up);
        return;
    }
    for (i = 0; i < n; i++) {
        const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
        const double square = dot(normal, normal), per_size = 1.0 / __builtin_sqrt(square);

        to->status[i] = is_plain_normal(square) ? to->status[i] : PSC_PENDING;
        for (c = 0; c < 3; c++)
            to->up[c][i] = (real)(normal[c] * per_size);
    }
}

/* Weight and status of samples whose directions are there. */
PSC_LANE void FN(weigh_elements)(enum psc_facing facing, size_t n,
                                 const real (*restrict normal)[PSC_BLOCK],
                                 const real *restrict half, const int32_t *restrict status,
                                 struct FN(psc_results) *restrict r)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        const real up[3] = {normal[0][i], normal[1][i], normal[2][i]};
        const real height = FN(fan_height)(up, direction);

        r->value[PSC_WEIGHT][i] = K(2.0) * half[i] * FN(fan_cosine)(facing, height);
    }
    for (i = 0; i < n; i++)
        r->status[i] = status[i] != PSC_SUCCESS           ? status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
}
