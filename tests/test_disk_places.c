/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors of the maps of disks, elliptical disks and ellipsoids from their geometry: sizes and
 * distances over sixteen decades, receivers next to the rim, to the plane and to the surface.
 *
 * A sample is where its texture coordinates, or its normal on an ellipsoid, say that it is: these
 * hold the light's size. In 113 bits that is a direction in the frame of the cone, whose axes are
 * the eigenvectors of the sum of a a' over the semi-axes a less c c', c being the centre. What the
 * rounding of the numbers moves the place by is no error.
 */
#include "cone_shares.h"
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 40, SAMPLES = 2 };

/* Each number may be so many half units in its last place off. */
#define ROUNDINGS 16.0

static const double cdf_bound[2] = {3e-7, 1e-14};

/* A light from the receiver, and its cone: axis[2] is in the middle, axis[0] along the wider
   arc. */
struct view {
    int solid;
    quad center[3], axes[3][3], axis[3][3];
    quad even; /* how far the two semi-arcs are from equal */
    struct cone cone;
};

static quad quad_dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void quad_cross(const quad a[3], const quad b[3], quad to[3])
{
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

/* Eigenvectors, the columns of v, of a symmetric matrix, which becomes diagonal: Jacobi's
   rotations. */
static void diagonalise(quad m[3][3], quad v[3][3])
{
    int sweep, p, q, i;

    for (p = 0; p < 3; p++)
        for (q = 0; q < 3; q++)
            v[p][q] = p == q;
    for (sweep = 0; sweep < 40; sweep++)
        for (p = 0; p < 2; p++)
            for (q = p + 1; q < 3; q++) {
                quad angle, t, c, s;

                if (m[p][q] == 0)
                    continue;
                angle = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                t = (angle < 0 ? -1 : 1) / (quad_abs(angle) + quad_sqrt(1 + angle * angle));
                c = 1 / quad_sqrt(1 + t * t);
                s = c * t;
                for (i = 0; i < 3; i++) {
                    const quad a = m[i][p], b = m[i][q];

                    m[i][p] = c * a - s * b;
                    m[i][q] = s * a + c * b;
                }
                for (i = 0; i < 3; i++) {
                    const quad a = m[p][i], b = m[q][i];

                    m[p][i] = c * a - s * b;
                    m[q][i] = s * a + c * b;
                }
                for (i = 0; i < 3; i++) {
                    const quad a = v[i][p], b = v[i][q];

                    v[i][p] = c * a - s * b;
                    v[i][q] = s * a + c * b;
                }
            }
}

/* Semi-axes of the light: of a disk as its texture has them. */
static void semi_axes(const struct light *light, quad axes[3][3])
{
    const double *g = light->geometry;
    int i, k;

    memset(axes, 0, sizeof(quad[3][3]));
    if (light->shape == &shape_disk) {
        const int first = fabs(g[3]) > fabs(g[4]);
        const quad n[3] = {g[3], g[4], g[5]};
        const quad s[3] = {first ? -n[2] : 0, first ? 0 : n[2], first ? n[0] : -n[1]};
        quad t[3];

        quad_cross(n, s, t);
        for (i = 0; i < 3; i++) {
            axes[0][i] = g[6] * s[i] / quad_sqrt(quad_dot(s, s));
            axes[1][i] = g[6] * t[i] / quad_sqrt(quad_dot(t, t));
        }
        return;
    }
    for (k = 0; k < part_count(light->shape) - 1; k++)
        for (i = 0; i < 3; i++)
            axes[k][i] = g[3 + 3 * k + i];
}

static void view_light(const struct light *light, struct view *view)
{
    quad m[3][3], v[3][3], square[2];
    int i, j, k, order[3] = {0, 1, 2};

    view->solid = !light->shape->flat;
    semi_axes(light, view->axes);
    for (i = 0; i < 3; i++)
        view->center[i] = (quad)light->geometry[i] - light->position[i];
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            m[i][j] = -view->center[i] * view->center[j];
            for (k = 0; k < 3; k++)
                m[i][j] += view->axes[k][i] * view->axes[k][j];
        }
    diagonalise(m, v);
    /* the negative one last, the larger of the others first */
    for (i = 0; i < 3; i++)
        for (j = 0; j < 2; j++)
            if (m[order[j]][order[j]] < m[order[j + 1]][order[j + 1]]) {
                const int swap = order[j];

                order[j] = order[j + 1];
                order[j + 1] = swap;
            }
    for (i = 0; i < 3; i++) {
        view->axis[0][i] = v[i][order[0]];
        view->axis[2][i] = v[i][order[2]];
    }
    if (quad_dot(view->axis[2], view->center) < 0)
        for (i = 0; i < 3; i++)
            view->axis[2][i] = -view->axis[2][i];
    quad_cross(view->axis[2], view->axis[0], view->axis[1]);
    for (k = 0; k < 2; k++)
        square[k] = -m[order[k]][order[k]] / m[order[2]][order[2]]; /* tan^2 */
    view->even = 1 - square[1] / square[0];
    view->cone = cone_of(quad_sqrt(square[0] / (1 + square[0])), 1 / quad_sqrt(1 + square[0]),
                         quad_sqrt(square[1] / (1 + square[1])), 1 / quad_sqrt(1 + square[1]));
}

/* From texture coordinates or a normal to the point seen from the receiver. */
static void point_of(const struct view *view, const quad number[3], quad point[3])
{
    quad unit[3] = {number[0], number[1], 0}, length;
    int i, k;

    if (view->solid) {
        for (k = 0; k < 3; k++)
            unit[k] = quad_dot(view->axes[k], number);
        length = quad_sqrt(quad_dot(unit, unit));
        for (k = 0; k < 3; k++)
            unit[k] /= length;
    }
    for (i = 0; i < 3; i++) {
        point[i] = view->center[i];
        for (k = 0; k < 3; k++)
            point[i] += unit[k] * view->axes[k][i];
    }
}

/* Where in the square a sample is, and of the parallel map how far off along its chord; sign: the x
   axis of a cone has none of its own. */
static void place(psc_map map, const struct view *view, int sign, double v, const quad number[3],
                  quad place[2])
{
    quad point[3], offset[3], length;
    int i;

    point_of(view, number, point);
    length = quad_sqrt(quad_dot(point, point));
    for (i = 0; i < 3; i++)
        offset[i] = quad_dot(view->axis[i], point) / length;
    for (i = 0; i < 2; i++)
        offset[i] = sign * offset[i];
    if (map == PSC_MAP_PARALLEL) {
        offset[2] -= 1;
        chord_place(&view->cone, v, offset, place);
    } else {
        const quad square = offset[0] * offset[0] + offset[1] * offset[1];

        polar_place(&view->cone, offset,
                    offset[2] > 0 ? square / (1 + offset[2]) : 1 - offset[2], place);
    }
}

static void place_error(psc_map map, const struct view *view, int sign, double unit, double u,
                        double v, const quad number[3], double error[2])
{
    quad wanted = u, outwards = 1 - (quad)v, here[2], there[2];
    int i, k, way;

    if (map == PSC_MAP_CONCENTRIC)
        square_to_polar(u, v, &outwards, &wanted);
    place(map, view, sign, v, number, here);
    if (map == PSC_MAP_PARALLEL) {
        error[0] = (double)quad_abs(here[0] - u);
        error[1] = (double)quad_abs(here[1]);
    } else {
        error[0] = around(here[0], wanted) * (double)outwards;
        error[1] = (double)quad_abs(here[1] - outwards);
    }
    for (i = 0; i < (view->solid ? 3 : 2); i++) {
        double most[2] = {0.0, 0.0};

        for (way = -1; way <= 1; way += 2) {
            quad moved[3] = {number[0], number[1], number[2]};

            moved[i] += way * ROUNDINGS * unit * quad_abs(moved[i]);
            place(map, view, sign, v, moved, there);
            for (k = 0; k < 2; k++) {
                const double motion = k == 0 && map != PSC_MAP_PARALLEL
                                          ? around(there[k], here[k]) * (double)outwards
                                          : (double)quad_abs(there[k] - here[k]);

                most[k] = fmax(most[k], motion);
            }
        }
        for (k = 0; k < 2; k++) /* a place that turns with the rounding tells nothing */
            error[k] -= most[k] < 1.0 / 16.0 ? most[k] : HUGE_VAL;
    }
    /* a frame of nearly equal axes is turned by its own rounding */
    for (k = 0; k < 2; k++)
        error[k] = fmax(error[k], 0.0) * fmin(1.0, (double)view->even);
}

static void sweep(const struct shape *shape, const struct test_technique *what)
{
    struct worst first[2], second[2];
    uint64_t seed = 300;
    int i, j, k, wide;

    memset(first, 0, sizeof first);
    memset(second, 0, sizeof second);
    for (i = 0; i < LIGHTS; i++) {
        /* not on the surface of solid ones: that is half of all directions */
        const int where = random_below(&seed, shape->flat ? PLACE_GRAZING + 1 : PLACE_GRAZING);
        struct test_sampler s;
        struct light light;
        struct view view;

        place_light(&seed, shape, what, where, HORIZON_ABOVE, FACING_NONE, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        view_light(&light, &view);
        for (j = 0; j < SAMPLES; j++) {
            double u = random_uniform(&seed), v = random_uniform(&seed);

            for (wide = 1; wide >= 0; wide--) {
                const double unit = wide ? 0x1p-53 : 0x1p-24;
                psc_light_sample_f64 sample;
                double error[2][2];
                quad number[3];
                int best;

                if (!wide && where == PLACE_CLOSE)
                    continue; /* points as near as the receiver differ by less than floats do */
                if (!wide) {
                    u = (float)u;
                    v = (float)v;
                }
                sample_any(wide ? 64 : 32, s.sampler, u, v, &sample);
                for (k = 0; k < 3; k++)
                    number[k] = view.solid ? sample.normal[k] : k < 2 ? sample.surface[k] : 0.0;
                for (k = 0; k < 2; k++)
                    place_error(what->map, &view, 1 - 2 * k, unit, u, v, number, error[k]);
                best = fmax(error[1][0], error[1][1]) < fmax(error[0][0], error[0][1]);
                worst_add(&first[wide], error[best][0], "%s u %a v %a", describe_light(&light), u,
                          v);
                worst_add(&second[wide], error[best][1], "%s u %a v %a", describe_light(&light), u,
                          v);
            }
        }
    }
    for (wide = 0; wide < 2; wide++) {
        const char *bits = wide ? "f64" : "f32";

        worst_report(&first[wide], cdf_bound[wide], "%s, %s, %s: CDF of the sector or chord",
                     shape->name, what->name, bits);
        worst_report(&second[wide], cdf_bound[wide], "%s, %s, %s: CDF in it", shape->name,
                     what->name, bits);
    }
}

int main(void)
{
    static const struct shape *const cones[] = {&shape_disk, &shape_ellipse, &shape_ellipsoid};
    const struct test_technique *what;
    size_t i;

    for (i = 0; i < sizeof cones / sizeof *cones; i++)
        for (FOR_TECHNIQUES(cones[i], what))
            if (what->measure == PSC_MEASURE_SOLID_ANGLE && what->map <= PSC_MAP_CONCENTRIC)
                sweep(cones[i], what);
    return tap_done();
}
