/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, rectangles and polygons wherever they are hard: from 1e-16 of a steradian and less to
 * 2 pi, needles, the receiver next to an edge, a vertex or the plane. Totals and the place of each
 * sample in the unit square are compared with 113-bit quadrature of positive densities, of which
 * no step is one of the library's: for fans that of the angle at the first vertex, 1 - cos of the
 * arc to the far side, where the library has a closed form of excess and side; for rectangles that
 * of strips.
 *
 * A sample tells its place by its direction, which is rounded, and where the light is small by its
 * coordinates on the surface too; but those of a polygon are of one plane, in which rounding does
 * not leave its vertices. How far rounding carries the place is no error, and where that is far,
 * nothing is.
 */
#include "quad.h"
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 240, SAMPLES = 3, VERTICES = 16, NODES = 16 };

static const double cdf_bound[2] = {3e-7, 1e-14};

static quad qdot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void qcross(const quad a[3], const quad b[3], quad c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static quad qlength(const quad v[3])
{
    return quad_sqrt(qdot(v, v));
}

/* ---- Quadrature: Gauss's, on panels ---- */

static quad node[NODES / 2], weight[NODES / 2];

/* Roots of Legendre's polynomial by Newton's steps. */
static void make_rule(void)
{
    int i, k, step;

    for (i = 0; i < NODES / 2; i++) {
        quad x = quad_cos(quad_pi() * (4 * i + 3) / (4 * NODES + 2)), slope = 1;

        for (step = 0; step < 8; step++) {
            quad p = x, before = 1;

            for (k = 2; k <= NODES; k++) {
                const quad next = ((2 * k - 1) * x * p - (k - 1) * before) / k;

                before = p;
                p = next;
            }
            slope = NODES * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        node[i] = x;
        weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

typedef quad density(const void *context, quad x);

static quad rule(density *f, const void *context, quad from, quad to)
{
    const quad middle = (from + to) / 2, half = (to - from) / 2;
    quad sum = 0;
    int i;

    for (i = 0; i < NODES / 2; i++)
        sum += weight[i] * (f(context, middle - half * node[i]) +
                            f(context, middle + half * node[i]));
    return half * sum;
}

/* Of a density that changes within a distance from `zero` and beyond it like a power: panels there
   are as long as their distance. */
static quad integral(density *f, const void *context, quad zero, quad distance, quad from, quad to)
{
    quad sum = 0, reach = distance, before = 0;
    int side;

    for (; from < to && (before < quad_abs(from - zero) || before < quad_abs(to - zero));
         reach *= 2) {
        for (side = -1; side <= 1; side += 2) {
            const quad near = zero + side * before, far = zero + side * reach;
            quad a = side < 0 ? far : near, b = side < 0 ? near : far;

            a = a < from ? from : a;
            b = b > to ? to : b;
            sum += a < b ? rule(f, context, a, b) : 0;
        }
        before = reach;
    }
    return sum;
}

/* ---- Lights as the receiver sees them ---- */

/* A triangle a, b, c of a fan: frame at b, and the far plane in it. */
struct corner {
    quad b[3], toward_a[3], toward_c[3]; /* of length 1 */
    quad end;                            /* angle at b */
    quad along_a, along_c, height;       /* of the normal of a and c */
    quad turn, slope; /* where the far side is a quarter turn off, and how steeply it gets there */
    quad total;
};

struct fan {
    int corners;
    struct corner corner[VERTICES - 2];
};

struct strip {
    quad x[3], y[3], z[3], x0, x1, y0, y1, h;
    quad total;
};

/* 1 - cos of the arc from b at an angle to the far side. */
static quad far_side(const void *context, quad angle)
{
    const struct corner *c = context;
    const quad x = c->along_a * quad_cos(angle) + c->along_c * quad_sin(angle);
    const quad length = quad_sqrt(x * x + c->height * c->height);

    return x > 0 ? c->height * c->height / (length * (length + x)) : (length - x) / length;
}

static quad fan_integral(const struct corner *o, quad to)
{
    const quad half_turn = quad_pi();
    quad sum = 0;
    int k;

    for (k = -1; k <= 1; k++) {
        const quad zero = o->turn + k * half_turn;
        const quad from = zero - half_turn / 2, until = zero + half_turn / 2;

        sum += integral(far_side, o, zero, o->slope, from < 0 ? 0 : from, until < to ? until : to);
    }
    return sum;
}

/* Whether anything is seen of it. Products are of edges, which are exact. */
static int make_corner(const quad a[3], const quad b[3], const quad c[3], struct corner *o)
{
    const quad length = qlength(b);
    quad ab[3], ac[3], bc[3], plane[3], n[3], sign, along;
    int i;

    for (i = 0; i < 3; i++) {
        o->b[i] = b[i] / length;
        ab[i] = b[i] - a[i];
        ac[i] = c[i] - a[i];
        bc[i] = c[i] - b[i];
    }
    qcross(a, ab, plane);
    along = qlength(plane);
    if (!(along > 0))
        return 0;
    sign = qdot(bc, plane) < 0 ? -1 : 1;
    for (i = 0; i < 3; i++)
        o->toward_c[i] = sign * plane[i] / along;
    qcross(o->b, plane, o->toward_a);
    for (i = 0; i < 3; i++)
        o->toward_a[i] /= along;
    o->end = quad_atan2(qdot(bc, o->toward_c), qdot(bc, o->toward_a));
    qcross(a, ac, n);
    o->height = qdot(ab, n) / length;
    sign = o->height > 0 ? -1 : 1;
    o->along_a = sign * qdot(o->toward_a, n);
    o->along_c = sign * qdot(o->toward_c, n);
    o->height = quad_abs(o->height);
    if (!(o->height > 0 && o->end > 0))
        return 0;
    o->turn = quad_atan2(o->along_a, -o->along_c);
    o->turn -= o->turn > quad_pi() / 2 ? quad_pi() : 0;
    o->turn += o->turn < -quad_pi() / 2 ? quad_pi() : 0;
    o->slope = o->height / quad_sqrt(o->along_a * o->along_a + o->along_c * o->along_c);
    o->total = fan_integral(o, o->end);
    return 1;
}

/* The solid angle of a strip across, per length along it. */
static quad strip_density(const void *context, quad x)
{
    const struct strip *s = context;
    const quad d2 = x * x + s->h * s->h;

    return s->h / d2 * (s->y1 / quad_sqrt(d2 + s->y1 * s->y1) -
                        s->y0 / quad_sqrt(d2 + s->y0 * s->y0));
}

static void make_strip(const quad corner[3], const quad u[3], const quad v[3], struct strip *s)
{
    const quad width = qlength(u), along = qdot(u, v) / (width * width);
    quad across[3], n[3], length;
    int i;

    for (i = 0; i < 3; i++)
        across[i] = v[i] - along * u[i];
    length = qlength(across);
    qcross(u, across, n);
    for (i = 0; i < 3; i++) {
        s->x[i] = u[i] / width;
        s->y[i] = across[i] / length;
        s->z[i] = n[i] / (width * length);
    }
    s->x0 = qdot(corner, s->x);
    s->y0 = qdot(corner, s->y);
    s->x1 = s->x0 + width;
    s->y1 = s->y0 + length;
    s->h = qdot(corner, s->z);
    if (s->h < 0)
        for (i = 0; i < 3; i++)
            s->z[i] = -s->z[i];
    s->h = quad_abs(s->h);
    s->total = s->h > 0 ? integral(strip_density, s, 0, s->h, s->x0, s->x1) : 0;
}

/* ---- Places: of a vector, and how far they are open when it turns by an angle ---- */

static quad clamp(quad x, quad low, quad high)
{
    return x < low ? low : x > high ? high : x;
}

static void place_in_fan(const struct fan *f, const quad w[3], double turn, quad uv[2],
                         double open[2])
{
    const struct corner *c = f->corner;
    const quad length = qlength(w);
    quad total = 0, before = 0, least = 8, angle = 0, a, b, across, versine, f0, f1, f2, step;
    int i;

    for (i = 0; i < f->corners; i++) {
        const struct corner *k = &f->corner[i];
        const quad at = quad_atan2(qdot(w, k->toward_c), qdot(w, k->toward_a));
        const quad past = at < 0 ? at + 2 * quad_pi() - k->end : at - k->end;
        const quad beyond = at < 0 ? (past < -at ? past : -at) : past > 0 ? past : 0;

        if (beyond < least) {
            least = beyond;
            c = k;
            before = total;
            angle = at < 0 ? (past < -at ? k->end : 0) : past > 0 ? k->end : at;
        }
        total += k->total;
    }
    a = qdot(w, c->toward_a);
    b = qdot(w, c->b) / length;
    across = quad_sqrt(a * a + quad_square(qdot(w, c->toward_c))) / length;
    versine = b > 0 ? across * across / (1 + b) : 1 - b;
    step = across > turn ? turn / across : quad_pi();
    f0 = far_side(c, angle);
    f1 = far_side(c, clamp(angle - step, 0, c->end));
    f2 = far_side(c, clamp(angle + step, 0, c->end));
    uv[0] = (before + fan_integral(c, angle)) / total;
    uv[1] = versine / f0;
    open[0] = (double)(step * fmax(fmax((double)f0, (double)f1), (double)f2) / total);
    open[1] = (double)(turn * (across + turn) / f0 + quad_abs(versine / f1 - versine / f0) +
                       quad_abs(versine / f2 - versine / f0));
}

static quad strip_place(const struct strip *s, quad x, quad y)
{
    const quad d2 = x * x + s->h * s->h;
    const quad low = s->y0 / quad_sqrt(d2 + s->y0 * s->y0);

    return (y / quad_sqrt(d2 + y * y) - low) / (s->y1 / quad_sqrt(d2 + s->y1 * s->y1) - low);
}

/* The point of the light that a vector leads to; `turn` of it moves that. */
static void place_in_strip(const struct strip *s, const quad w[3], double turn, quad uv[2],
                           double open[2])
{
    const quad z = qdot(w, s->z), length = qlength(w);
    const quad x = clamp(s->h * qdot(w, s->x) / z, s->x0, s->x1);
    const quad y = clamp(s->h * qdot(w, s->y) / z, s->y0, s->y1);
    const quad step = turn * length / z;
    const quad dx = step * (s->h + quad_abs(x)), dy = step * (s->h + quad_abs(y));
    quad most = strip_density(s, x);
    int i;

    if (!(z > 2 * turn * length)) { /* the plane itself, to rounding */
        uv[0] = uv[1] = 0;
        open[0] = open[1] = HUGE_VAL;
        return;
    }

    uv[0] = integral(strip_density, s, 0, s->h, s->x0, x) / s->total;
    uv[1] = strip_place(s, x, y);
    open[0] = open[1] = 0.0;
    for (i = 0; i < 4; i++) {
        const quad there = clamp(x + (i % 2 ? dx : -dx), s->x0, s->x1);
        const quad moved = strip_place(s, there, clamp(y + (i / 2 ? dy : -dy), s->y0, s->y1));

        most = strip_density(s, there) > most ? strip_density(s, there) : most;
        open[1] = fmax(open[1], (double)quad_abs(moved - uv[1]));
    }
    open[0] = (double)(dx * most / s->total);
}

/* ---- A light, and all that is known of it ---- */

struct subject {
    const struct light *light;
    int is_strip;
    struct fan fan;
    struct strip strip;
    quad total;
    quad origin[3], first[3], second[3]; /* of the coordinates on the surface */
    double size;                         /* angle that it fills, as a sine, about */
    double elevation;                    /* sine of that of a vertex over the light's plane */
};

static int make_subject(const struct light *light, struct subject *o)
{
    const int n = part_count(light->shape), rectangle = light->shape->shape == PSC_SHAPE_RECTANGLE;
    const int triangle = light->shape->shape == PSC_SHAPE_TRIANGLE;
    quad v[VERTICES][3], plane[3], extent, nearest;
    int i, c;

    o->light = light;
    o->is_strip = rectangle && light->what->map == PSC_MAP_PARALLEL;
    for (i = 0; i < n; i++)
        for (c = 0; c < 3; c++)
            v[i][c] = light->geometry[3 * i + c] -
                      (rectangle && i > 0 ? 0 : (quad)light->position[c]);
    for (c = 0; c < 3; c++) {
        o->origin[c] = v[0][c];
        o->first[c] = rectangle ? v[1][c] : v[1][c] - v[0][c];
        o->second[c] = rectangle ? v[2][c] : v[n - 1][c] - v[0][c];
    }
    nearest = qlength(v[0]);
    extent = qlength(o->first) + qlength(o->second);
    for (i = 1; i < n && !rectangle; i++) {
        const quad away = qlength(v[i]);

        nearest = away < nearest ? away : nearest;
    }
    o->size = (double)(extent / nearest);
    qcross(o->first, o->second, plane);
    o->elevation = (double)(quad_abs(qdot(v[0], plane)) / (qlength(plane) * qlength(v[0])));
    if (o->is_strip) {
        make_strip(v[0], v[1], v[2], &o->strip);
        o->total = o->strip.total;
        return o->total > 0;
    }
    if (rectangle) {
        quad along = qdot(v[1], v[2]) / qdot(v[1], v[1]);

        for (c = 0; c < 3; c++) {
            const quad across = v[2][c] - along * v[1][c];

            v[1][c] += v[0][c];
            v[2][c] = v[1][c] + across;
            v[3][c] = v[0][c] + across;
        }
    }
    o->fan.corners = 0;
    o->total = 0;
    for (i = 1; i + 1 < (rectangle ? 4 : n); i++) {
        struct corner *k = &o->fan.corner[o->fan.corners];

        if (triangle ? !make_corner(v[0], v[1], v[2], k) : !make_corner(v[i], v[0], v[i + 1], k))
            continue;
        o->fan.corners++;
        o->total += k->total;
    }
    return o->total > 0;
}

struct errors {
    struct worst total, u[2], v[2], surface_u[2], surface_v[2];
    long odd;
};

static void check_place(const struct subject *o, const quad w[3], double turn, double u, double v,
                        struct worst *in_u, struct worst *in_v, int bits)
{
    quad here[2];
    double open[2];

    if (o->is_strip)
        place_in_strip(&o->strip, w, turn, here, open);
    else
        place_in_fan(&o->fan, w, turn, here, open);
    if (open[0] > 1.0 / 16.0 || open[1] > 1.0 / 16.0)
        return;
    worst_add(in_u, fmax(fabs((double)(here[0] - (quad)u)) - open[0], 0.0), "%s f%d u %a v %a",
              describe_light(o->light), bits, u, v);
    worst_add(in_v, fmax(fabs((double)(here[1] - (quad)v)) - open[1], 0.0), "%s f%d u %a v %a",
              describe_light(o->light), bits, u, v);
}

static void check_sample(const struct subject *o, const psc_sampler *sampler, int wide, double u,
                         double v, struct errors *e)
{
    const double unit = wide ? 0x1p-53 : 0x1p-24;
    psc_light_sample_f64 s;
    quad w[3];
    int c;

    if (!wide) {
        u = (float)u;
        v = (float)v;
    }
    memset(&s, 0xff, sizeof s);
    sample_any(wide ? 64 : 32, sampler, u, v, &s);
    if (!(fabs(dot(s.direction, s.direction) - 1.0) < 16.0 * unit && s.pdf >= 0.0 &&
          s.weight >= 0.0 && s.distance > 0.0))
        e->odd++;
    for (c = 0; c < 3; c++)
        w[c] = s.direction[c];
    check_place(o, w, 6.0 * unit, u, v, &e->u[wide], &e->v[wide], wide ? 64 : 32);
    if (o->size > 0.1 || part_count(o->light->shape) > 3)
        return;
    for (c = 0; c < 3; c++)
        w[c] = o->origin[c] + s.surface[0] * o->first[c] + s.surface[1] * o->second[c];
    check_place(o, w, 6.0 * unit * o->size, u, v, &e->surface_u[wide], &e->surface_v[wide],
                wide ? 64 : 32);
}

/* Next to a vertex or an edge, at a distance in proportion to its length. */
static void come_close(uint64_t *seed, struct light *light)
{
    const double away = random_log(seed, 1e-12, 1e-2) * light->reach;
    const int n = part_count(light->shape), rectangle = light->shape->shape == PSC_SHAPE_RECTANGLE;
    const int i = random_below(seed, n), j = (i + 1) % n;
    const double share = random_below(seed, 2) ? 0.0 : random_uniform(seed);
    const double *g = light->geometry;
    double aside[3];
    int c;

    random_unit(seed, aside);
    for (c = 0; c < 3; c++) {
        const double start = rectangle ? g[c] : g[3 * i + c];
        const double edge = rectangle ? g[3 + 3 * (i % 2) + c] : g[3 * j + c] - g[3 * i + c];

        light->position[c] = start + share * edge + away * aside[c];
    }
}

static void sweep(const struct shape *shape, const struct test_technique *what)
{
    static struct errors e;
    static struct subject o;
    uint64_t seed = 300;
    int i, j, wide;

    memset(&e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        double total = 0.0;

        random_hard_light(&seed, shape, what, &light);
        light.technique_flags = 0;
        light.has_normal = 0;
        light.flags = 0;
        if (i % 3 == 0)
            come_close(&seed, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS || !make_subject(&light, &o))
            continue;
        psc_sampler_total(s.sampler, &total);
        /* two words tell a height down to 1e-32 of a length */
        if (o.elevation > 1e-16)
            worst_add(&e.total, fabs((double)(total / o.total - 1)), "%s", describe_light(&light));
        for (j = 0; j < SAMPLES; j++) {
            const double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (wide = 0; wide < 2; wide++)
                check_sample(&o, s.sampler, wide, u, v, &e);
        }
    }
    worst_report(&e.total, 2e-15, "%s, %s: solid angle, relative", shape->name, what->name);
    tap_ok(e.odd == 0, "%s, %s: %ld samples are none", shape->name, what->name, e.odd);
    for (wide = 0; wide < 2; wide++) {
        const int bits = wide ? 64 : 32;

        worst_report(&e.u[wide], cdf_bound[wide], "%s, %s, f%d: CDF in u", shape->name,
                     what->name, bits);
        worst_report(&e.v[wide], cdf_bound[wide], "%s, %s, f%d: CDF in v", shape->name,
                     what->name, bits);
        if (part_count(shape) > 3)
            continue;
        worst_report(&e.surface_u[wide], cdf_bound[wide], "%s, %s, f%d: CDF in u, on the surface",
                     shape->name, what->name, bits);
        worst_report(&e.surface_v[wide], cdf_bound[wide], "%s, %s, f%d: CDF in v, on the surface",
                     shape->name, what->name, bits);
    }
}

int main(void)
{
    static const struct shape *const those[] = {&shape_triangle, &shape_rectangle, &shape_polygon5};
    const struct test_technique *what;
    size_t i;

    make_rule();
    for (i = 0; i < sizeof those / sizeof *those; i++)
        for (FOR_TECHNIQUES(those[i], what))
            if (what->measure == PSC_MEASURE_SOLID_ANGLE)
                sweep(those[i], what);
    return tap_done();
}
