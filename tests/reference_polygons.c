/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_polygons.h"

#include "gauss.h"

quad reference_dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void reference_cross(const quad a[3], const quad b[3], quad c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

quad reference_length(const quad v[3])
{
    return quad_sqrt(reference_dot(v, v));
}

/* ---- Quadrature: Gauss's, on panels ---- */

typedef quad density(const void *context, quad x);

static quad rule(density *f, const void *context, quad from, quad to)
{
    quad sum = 0;
    int i;

    for (i = 0; i < GAUSS_NODES; i++)
        sum += gauss_weight(i) * f(context, from + (to - from) * gauss_node(i));
    return (to - from) * sum;
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

/* 1 - cos of the arc from b at an angle to the far side. */
static quad far_side(const void *context, quad angle)
{
    const struct reference_corner *c = context;
    const quad x = c->along_a * quad_cos(angle) + c->along_c * quad_sin(angle);
    const quad length = quad_sqrt(x * x + c->height * c->height);

    return x > 0 ? c->height * c->height / (length * (length + x)) : (length - x) / length;
}

static quad fan_integral(const struct reference_corner *o, quad to)
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
int reference_corner(const quad a[3], const quad b[3], const quad c[3], struct reference_corner *o)
{
    const quad length = reference_length(b);
    quad ab[3], ac[3], bc[3], plane[3], n[3], sign, along;
    int i;

    for (i = 0; i < 3; i++) {
        o->b[i] = b[i] / length;
        ab[i] = b[i] - a[i];
        ac[i] = c[i] - a[i];
        bc[i] = c[i] - b[i];
    }
    reference_cross(a, ab, plane);
    along = reference_length(plane);
    if (!(along > 0))
        return 0;
    sign = reference_dot(bc, plane) < 0 ? -1 : 1;
    for (i = 0; i < 3; i++)
        o->toward_c[i] = sign * plane[i] / along;
    reference_cross(o->b, plane, o->toward_a);
    for (i = 0; i < 3; i++)
        o->toward_a[i] /= along;
    o->end = quad_atan2(reference_dot(bc, o->toward_c), reference_dot(bc, o->toward_a));
    reference_cross(a, ac, n);
    o->height = reference_dot(ab, n) / length;
    sign = o->height > 0 ? -1 : 1;
    o->along_a = sign * reference_dot(o->toward_a, n);
    o->along_c = sign * reference_dot(o->toward_c, n);
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
    const struct reference_strip *s = context;
    const quad d2 = x * x + s->h * s->h;

    return s->h / d2 * (s->y1 / quad_sqrt(d2 + s->y1 * s->y1) -
                        s->y0 / quad_sqrt(d2 + s->y0 * s->y0));
}

void reference_strip(const quad corner[3], const quad u[3], const quad v[3],
                     struct reference_strip *s)
{
    const quad width = reference_length(u), along = reference_dot(u, v) / (width * width);
    quad across[3], n[3], length;
    int i;

    for (i = 0; i < 3; i++)
        across[i] = v[i] - along * u[i];
    length = reference_length(across);
    reference_cross(u, across, n);
    for (i = 0; i < 3; i++) {
        s->x[i] = u[i] / width;
        s->y[i] = across[i] / length;
        s->z[i] = n[i] / (width * length);
    }
    s->x0 = reference_dot(corner, s->x);
    s->y0 = reference_dot(corner, s->y);
    s->x1 = s->x0 + width;
    s->y1 = s->y0 + length;
    s->h = reference_dot(corner, s->z);
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

/* The far side at an angle from the beginning of triangle i, which may be in another, or the end
   next to it. */
static quad far_side_from(const struct reference_fan *f, int i, quad angle)
{
    for (; angle < 0 && i > 0; i--)
        angle += f->corner[i - 1].end;
    for (; angle > f->corner[i].end && i + 1 < f->corners; i++)
        angle -= f->corner[i].end;
    return far_side(&f->corner[i], clamp(angle, 0, f->corner[i].end));
}

void reference_in_fan(const struct reference_fan *f, const quad w[3], double turn, quad uv[2],
                         double open[2])
{
    const struct reference_corner *c = f->corner;
    const quad length = reference_length(w);
    quad total = 0, before = 0, least = 8, angle = 0, a, b, across, versine, f0, f1, f2, step;
    int i, found = 0;

    for (i = 0; i < f->corners; i++) {
        const struct reference_corner *k = &f->corner[i];
        const quad at = quad_atan2(reference_dot(w, k->toward_c), reference_dot(w, k->toward_a));
        const quad past = at < 0 ? at + 2 * quad_pi() - k->end : at - k->end;
        const quad beyond = at < 0 ? (past < -at ? past : -at) : past > 0 ? past : 0;

        if (beyond < least) {
            least = beyond;
            c = k;
            found = i;
            before = total;
            angle = at < 0 ? (past < -at ? k->end : 0) : past > 0 ? k->end : at;
        }
        total += k->total;
    }
    a = reference_dot(w, c->toward_a);
    b = reference_dot(w, c->b) / length;
    across = quad_sqrt(a * a + quad_square(reference_dot(w, c->toward_c))) / length;
    versine = b > 0 ? across * across / (1 + b) : 1 - b;
    step = across > turn ? turn / across : quad_pi();
    f0 = far_side(c, angle);
    f1 = far_side_from(f, found, angle - step);
    f2 = far_side_from(f, found, angle + step);
    uv[0] = (before + fan_integral(c, angle)) / total;
    uv[1] = versine / f0;
    /* At the vertex itself every direction around it is right. */
    open[0] = across > turn
                  ? (double)(step * fmax(fmax((double)f0, (double)f1), (double)f2) / total)
                  : HUGE_VAL;
    open[1] = (double)(turn * (across + turn) / f0 + quad_abs(versine / f1 - versine / f0) +
                       quad_abs(versine / f2 - versine / f0));
}

static quad strip_place(const struct reference_strip *s, quad x, quad y)
{
    const quad d2 = x * x + s->h * s->h;
    const quad low = s->y0 / quad_sqrt(d2 + s->y0 * s->y0);

    return (y / quad_sqrt(d2 + y * y) - low) / (s->y1 / quad_sqrt(d2 + s->y1 * s->y1) - low);
}

/* The point of the light that a vector leads to; `turn` of it moves that. */
void reference_in_strip(const struct reference_strip *s, const quad w[3], double turn, quad uv[2],
                           double open[2])
{
    const quad z = reference_dot(w, s->z), length = reference_length(w);
    const quad x = clamp(s->h * reference_dot(w, s->x) / z, s->x0, s->x1);
    const quad y = clamp(s->h * reference_dot(w, s->y) / z, s->y0, s->y1);
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
