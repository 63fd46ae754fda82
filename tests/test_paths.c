/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Continuity: along a path through the square, or of the receiver and its normal, a sample never
 * jumps. The step in which it moves most is halved again and again, always keeping the half with
 * the larger part of the motion: a jump stays, whatever is continuous goes to nothing.
 */
#include "rays.h"
#include "worst.h"

enum { LIGHTS = 30, POINTS = 6, STEPS = 300, HALVINGS = 36 };

/* Where a path starts and ends: lights that differ in the receiver, and points of the square. */
struct path {
    struct light ends[2];
    double uv[2][2];
};

static double between(double a, double b, double t)
{
    return a + (b - a) * t;
}

/* The direction at t; 0 where nothing is seen. */
static int at(const struct path *path, double t, double direction[3])
{
    struct light light = path->ends[0];
    psc_light_sample_f64 sample;
    struct test_sampler s;
    psc_result result;
    int i;

    for (i = 0; i < 3; i++) {
        light.position[i] = between(path->ends[0].position[i], path->ends[1].position[i], t);
        light.normal[i] = between(path->ends[0].normal[i], path->ends[1].normal[i], t);
    }
    if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
        return 0;
    result = psc_sample_f64(s.sampler, between(path->uv[0][0], path->uv[1][0], t),
                            between(path->uv[0][1], path->uv[1][1], t), &sample);
    memcpy(direction, sample.direction, sizeof sample.direction);
    return result == PSC_SUCCESS || result == PSC_CULLED;
}

static double motion(const struct path *path, double from, double to)
{
    double a[3], b[3], d[3];

    if (!at(path, from, a) || !at(path, to, b))
        return 0.0;
    subtract3(a, b, d);
    return sqrt(dot(d, d));
}

/* What is left of the largest motion when its step has become nothing. */
static double largest_jump(const struct path *path)
{
    double most = -1.0, from = 0.0, step = 1.0 / STEPS;
    int i;

    for (i = 0; i < STEPS; i++) {
        const double m = motion(path, (double)i / STEPS, (i + 1.0) / STEPS);

        if (m > most) {
            most = m;
            from = (double)i / STEPS;
        }
    }
    for (i = 0; i < HALVINGS; i++) {
        step /= 2.0;
        if (motion(path, from + step, from + 2.0 * step) > motion(path, from, from + step))
            from += step;
    }
    return motion(path, from, from + step);
}

/* Lights whose parts are the same, seen by one-sided receivers: two-sided ones share out the
   square among the sides, where there is a jump. Without a normal nothing tells where to begin to
   go around a sphere; a rule that depends on its direction alone must jump somewhere. */
static void make_ends(uint64_t *seed, const struct shape *shape, const struct test_technique *what,
                      int moving, struct path *path)
{
    const int free = is_offered(what, FACING_NONE) && !(moving && shape == &shape_sphere);
    const int facing = free && random_below(seed, 2) ? FACING_NONE : FACING_ONE;
    struct light *a = &path->ends[0], *b = &path->ends[1];
    double to[3], normal[3], room, step[3];
    int i;

    place_light(seed, shape, what, PLACE_ORDINARY, random_below(seed, 2) ? HORIZON_CUT : HORIZON_ANY,
                facing, a);
    *b = *a;
    if (!moving)
        return;
    random_unit(seed, b->normal);
    if (is_distant(shape))
        return;
    /* no farther than half the way to the light or its plane */
    subtract3(a->middle, a->position, to);
    shape->surface(a->geometry, a->position, normal);
    room = shape->flat ? fabs(dot(to, normal))
                       : shape->hit(a->geometry, a->position, to) * sqrt(dot(to, to));
    random_unit(seed, step);
    for (i = 0; i < 3; i++)
        b->position[i] += 0.5 * room * step[i];
}

/* Relative to the angle that the light fills. */
static double size_of(const struct light *light)
{
    double to[3];

    if (is_distant(light->shape))
        return fmin(light->geometry[3], 1.0);
    subtract3(light->middle, light->position, to);
    return fmin(light->reach / sqrt(dot(to, to)), 1.0);
}

static void paths(const struct shape *shape, const struct test_technique *what, int moving)
{
    const double most = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ? shape->azimuth_jumps
                                                                           : shape->jumps;
    const double bound = 1e-4, share = moving ? most : 0.0;
    struct worst worst = {0};
    double jump;
    long jumped = 0;
    uint64_t seed = 180;
    int i, j;

    for (i = 0; i < LIGHTS; i++)
        for (j = 0; j < POINTS; j++) {
            struct path path;
            int k;

            make_ends(&seed, shape, what, moving, &path);
            for (k = 0; k < 4; k++)
                path.uv[k / 2][k % 2] = moving && k > 1 ? path.uv[0][k % 2]
                                                        : random_uniform(&seed);
            jump = largest_jump(&path) / size_of(&path.ends[0]);
            if (share > 0.0 && jump > bound) {
                jumped++;
                continue;
            }
            worst_add(&worst, jump,
                      "%s to position %a %a %a normal %a %a %a, u %a v %a to u %a v %a",
                      describe_light(&path.ends[0]), path.ends[1].position[0],
                      path.ends[1].position[1], path.ends[1].position[2], path.ends[1].normal[0],
                      path.ends[1].normal[1], path.ends[1].normal[2], path.uv[0][0],
                      path.uv[0][1], path.uv[1][0], path.uv[1][1]);
        }
    if (share > 0.0)
        tap_ok(jumped <= share * LIGHTS * POINTS, "%s, %s: %ld paths of %d with a jump",
               shape->name, what->name, jumped, LIGHTS * POINTS);
    worst_report(&worst, bound, "%s, %s: jump along a path of the %s", shape->name, what->name,
                 moving ? "receiver" : "square");
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what)) {
            if (is_tabulated(what))
                continue; /* which does jump */
            paths(shapes[i], what, 0);
            paths(shapes[i], what, 1);
        }
    return tap_done();
}
