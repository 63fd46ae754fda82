/* SPDX-License-Identifier: Apache-2.0 */
/* What is seen of a block of lights, as arrays. Template: see precision.h. */

/* The numbers of psc_disk_world: of a cone, of samples by area, and of solid lights. */
#define CONE_NUMBERS(X)                                                                            \
    X(a) X(ca) X(b) X(cb) X(per_at) X(per_bt) X(ca2) X(cb2) X(mu1) X(mu2) X(quasi_scale)           \
    X(inverse_quasi_scale) X(near) X(far) X(reach) X(total) X(inverse_total)
#define AREA_NUMBERS(X)                                                                            \
    X(flat_x) X(flat_y) X(flat_height) X(flat_a) X(flat_skew) X(flat_b) X(area_scale) X(area_reach)
#define LIGHT_VECTORS(X) X(x) X(y) X(z) X(axis) X(center) X(normal) X(receiver)
#define SOLID_NUMBERS(X) X(far_off) X(beyond) X(unit)
#define SOLID_MATRICES(X) X(solid_axis) X(inverse)

struct FN(psc_disk_views) {
#define ARRAY(name) real name[PSC_BLOCK];
    CONE_NUMBERS(ARRAY)
    AREA_NUMBERS(ARRAY)
    SOLID_NUMBERS(ARRAY)
#undef ARRAY
#define ARRAY(name) real name[3][PSC_BLOCK];
    LIGHT_VECTORS(ARRAY)
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
    CONE_NUMBERS(LOAD)
    AREA_NUMBERS(LOAD)
    SOLID_NUMBERS(LOAD)
#undef LOAD
    for (i = 0; i < 3; i++) {
#define LOAD(name) w->name[i] = from->name[i][e];
        LIGHT_VECTORS(LOAD)
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

/* What cones have and samples by area. */
PSC_LANE void FN(store_light)(const struct FN(psc_disk_world) *w, size_t e,
                              struct FN(psc_disk_views) *to)
{
    int i, k;

    for (i = 0; i < 3; i++) {
#define STORE(name) to->name[i][e] = w->name[i];
        LIGHT_VECTORS(STORE)
#undef STORE
        for (k = 0; k < 2; k++)
            to->across[k][i][e] = w->across[k][i];
    }
    for (k = 0; k < 2; k++)
        for (i = 0; i < 2; i++)
            to->side[k][i][e] = w->side[k][i];
}

PSC_LANE void FN(store_area)(const struct FN(psc_disk_world) *w, size_t e,
                             struct FN(psc_disk_views) *to)
{
    FN(store_light)(w, e, to);
#define STORE(name) to->name[e] = w->name;
    AREA_NUMBERS(STORE)
#undef STORE
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

/* With what rules are chosen by. */
PSC_LANE void FN(store_cone)(const struct FN(psc_disk_world) *w, const struct psc_ellipse *e,
                             enum psc_disk_map map, size_t i, struct FN(psc_disk_views) *to)
{
    int k;

    FN(store_light)(w, i, to);
#define STORE(name) to->name[i] = w->name;
    CONE_NUMBERS(STORE)
#undef STORE
    for (k = 0; k < 2; k++)
        to->turn[k][i] = w->turn[k];
    to->bend[i] = (real)((e->cb - e->ca) * (e->cb + e->ca));
    to->quotient[i] = rule_quotient(map, e->ca, e->cb);
}

#define RULE_AT_LEAST(i, m, steps, least) quotient >= (least) ? (i) :
static int FN(rule_of)(enum psc_disk_map map, double quotient)
{
    return map == PSC_DISK_PARALLEL ? SPAN_RULES(RULE_AT_LEAST) -1 : DISK_RULES(RULE_AT_LEAST) -1;
}
#undef RULE_AT_LEAST
