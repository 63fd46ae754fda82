/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Elements of a wavefront that a first loop left pending: put together into a shorter wave for
 * another loop, and put back. Template: see precision.h.
 */
struct FN(psc_pending) {
    struct psc_wave wave;
    uint32_t index[PSC_BLOCK];
    real u[PSC_BLOCK], v[PSC_BLOCK];
    struct FN(psc_results) results;
};

/* Returns whether there are any. */
static int FN(gather_pending)(const struct psc_wave *wave, const real *u, const real *v,
                              const struct FN(psc_results) *r, struct FN(psc_pending) *to)
{
    real *room = to->wave.numbers;
    int32_t pending = 0;
    size_t n = 0, i;
    int c;

    for (i = 0; i < wave->count; i++)
        pending |= r->status[i] == PSC_PENDING;
    if (!pending)
        return 0;
    for (i = 0; i < wave->count; i++) {
        to->index[n] = (uint32_t)i;
        n += r->status[i] == PSC_PENDING;
    }
    to->wave.measure = wave->measure;
    to->wave.map = wave->map;
    to->wave.facing = wave->facing;
    to->wave.one_sided = wave->one_sided;
    to->wave.table = wave->table;
    to->wave.parts = wave->parts;
    to->wave.count = n;
    to->wave.surface = wave->surface;
    to->wave.weight = wave->weight;
    for (c = 0; c < 6 + wave->parts; c++, room += n) {
        const real *const from = c < 3   ? wave->position[c]
                                 : c < 6 ? wave->normal[c - 3]
                                         : wave->geometry[c - 6];

        for (i = 0; i < n; i++)
            room[i] = from[to->index[i]];
        *(c < 3   ? to->wave.position + c
          : c < 6 ? to->wave.normal + (c - 3)
                  : to->wave.geometry + (c - 6)) = room;
    }
    for (i = 0; i < n; i++) {
        to->u[i] = u[to->index[i]];
        to->v[i] = v[to->index[i]];
    }
    return 1;
}

static void FN(scatter_pending)(const struct FN(psc_pending) *from, struct FN(psc_results) *r)
{
    const size_t n = from->wave.count;
    size_t i;
    int c;

    for (c = 0; c < PSC_COMPONENTS; c++)
        if (from->wave.surface || c < PSC_POINT || c == PSC_WEIGHT)
            for (i = 0; i < n; i++)
                r->value[c][from->index[i]] = from->results.value[c][i];
    for (i = 0; i < n; i++)
        r->status[from->index[i]] = from->results.status[i];
}
