/* SPDX-License-Identifier: Apache-2.0 */
/* What is seen of a block of lights, as arrays. Template: see precision.h. */

/* The numbers of psc_disk_world: of a cone and a flat light, and of solid ones. */
#define FLAT_NUMBERS(X)                                                                            \
    X(a) X(ca) X(b) X(cb) X(per_at) X(per_bt) X(ca2) X(cb2) X(mu1) X(mu2) X(quasi_scale)           \
    X(inverse_quasi_scale) X(near) X(far) X(reach) X(total) X(inverse_total) X(flat_b)             \
    X(area_scale) X(area_reach)
#define FLAT_VECTORS(X) X(x) X(y) X(z) X(axis) X(center) X(normal) X(receiver)
#define SOLID_NUMBERS(X) X(far_off) X(beyond) X(unit)
#define SOLID_MATRICES(X) X(solid_axis) X(inverse)

struct FN(psc_disk_views) {
#define ARRAY(name) real name[PSC_BLOCK];
    FLAT_NUMBERS(ARRAY)
    SOLID_NUMBERS(ARRAY)
#undef ARRAY
#define ARRAY(name) real name[3][PSC_BLOCK];
    FLAT_VECTORS(ARRAY)
#undef ARRAY
#define ARRAY(name) real name[3][3][PSC_BLOCK];
    SOLID_MATRICES(ARRAY)
#undef ARRAY
    real turn[2][PSC_BLOCK], side[2][2][PSC_BLOCK], across[2][3][PSC_BLOCK];
    real bend[PSC_BLOCK];       /* cb^2 - ca^2 */
    double quotient[PSC_BLOCK]; /* what rules are chosen by */
    double able[PSC_BLOCK], lit[PSC_BLOCK]; /* if > 0: this serves it; it is seen */
    struct FN(psc_disk_points) points;
};

PSC_LANE void FN(load_world)(const struct FN(psc_disk_views) *from, size_t e,
                             struct FN(psc_disk_world) *w)
{
    int i, k;

#define LOAD(name) w->name = from->name[e];
    FLAT_NUMBERS(LOAD)
    SOLID_NUMBERS(LOAD)
#undef LOAD
    for (i = 0; i < 3; i++) {
#define LOAD(name) w->name[i] = from->name[i][e];
        FLAT_VECTORS(LOAD)
#undef LOAD
#define LOAD(name) w->name[k][i] = from->name[k][i][e];
        for (k = 0; k < 3; k++) {
            SOLID_MATRICES(LOAD)
        }
        for (k = 0; k < 2; k++)
            LOAD(across)
    }
    for (k = 0; k < 2; k++) {
        w->turn[k] = from->turn[k][e];
        for (i = 0; i < 2; i++)
            LOAD(side)
    }
#undef LOAD
}

PSC_LANE void FN(store_flat)(const struct FN(psc_disk_world) *w, size_t e,
                             struct FN(psc_disk_views) *to)
{
    int i, k;

#define STORE(name) to->name[e] = w->name;
    FLAT_NUMBERS(STORE)
#undef STORE
    for (i = 0; i < 3; i++) {
#define STORE(name) to->name[i][e] = w->name[i];
        FLAT_VECTORS(STORE)
#undef STORE
        for (k = 0; k < 2; k++)
            to->across[k][i][e] = w->across[k][i];
    }
    for (k = 0; k < 2; k++) {
        to->turn[k][e] = w->turn[k];
        for (i = 0; i < 2; i++)
            to->side[k][i][e] = w->side[k][i];
    }
}

PSC_LANE void FN(store_solid)(const struct FN(psc_disk_world) *w, size_t e,
                              struct FN(psc_disk_views) *to)
{
    int i, k;

#define STORE(name) to->name[e] = w->name;
    SOLID_NUMBERS(STORE)
#undef STORE
#define STORE(name) to->name[k][i][e] = w->name[k][i];
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            SOLID_MATRICES(STORE)
        }
#undef STORE
}

/* What rules are chosen by, and of the cone what the world has not. */
PSC_LANE void FN(store_cone)(const struct psc_ellipse *e, enum psc_disk_map map, size_t i,
                             struct FN(psc_disk_views) *to)
{
    to->bend[i] = (real)((e->cb - e->ca) * (e->cb + e->ca));
    to->quotient[i] = rule_quotient(map, e->ca, e->cb);
}

#define RULE_AT_LEAST(i, m, steps, least) quotient >= (least) ? (i) :
static int FN(rule_of)(enum psc_disk_map map, double quotient)
{
    return map == PSC_DISK_PARALLEL ? SPAN_RULES(RULE_AT_LEAST) -1 : DISK_RULES(RULE_AT_LEAST) -1;
}
#undef RULE_AT_LEAST
