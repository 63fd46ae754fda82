/* SPDX-License-Identifier: Apache-2.0 */
#include "contour.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross3(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* out = a + s b */
static void add3(const double a[3], double s, const double b[3], double out[3])
{
    for (int k = 0; k < 3; ++k)
        out[k] = a[k] + s * b[k];
}

/* Two unit vectors across a and each other. */
static void across(const double a[3], double u[3], double v[3])
{
    const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0};
    const double length = sqrt(dot3(a, a));
    cross3(a, fabs(a[0]) > 0.6 * length ? y : x, u);
    const double size = sqrt(dot3(u, u));
    for (int k = 0; k < 3; ++k)
        u[k] /= size;
    cross3(a, u, v);
    for (int k = 0; k < 3; ++k)
        v[k] /= length;
}

/* ---- Outlines ---- */

void disk_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    (void)vectors;
    c->count = 0;
    add3(n, -1, from, c->center);
    across(n + 3, c->u, c->v);
    for (int k = 0; k < 3; ++k) {
        c->u[k] *= n[6];
        c->v[k] *= n[6];
    }
}

void ellipse_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    (void)vectors;
    c->count = 0;
    add3(n, -1, from, c->center);
    memcpy(c->u, n + 3, sizeof c->u);
    memcpy(c->v, n + 6, sizeof c->v);
}

/* Where the ellipsoid is the unit ball, the outline seen from q is the circle of points x with
   x . q = 1. */
void ellipsoid_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    const double *axis[3] = {n + 3, n + 6, n + 9};
    double to[3], q[3], a[3], b[3], dual[3];

    (void)vectors;
    add3(from, -1, n, to);
    for (int k = 0; k < 3; ++k) {
        cross3(axis[(k + 1) % 3], axis[(k + 2) % 3], dual);
        q[k] = dot3(dual, to) / dot3(dual, axis[k]);
    }
    const double square = dot3(q, q), radius = sqrt(1 - 1 / square);
    across(q, a, b);
    c->count = 0;
    for (int k = 0; k < 3; ++k) {
        c->center[k] = c->u[k] = c->v[k] = 0;
        for (int i = 0; i < 3; ++i) {
            c->center[k] += axis[i][k] * q[i] / square;
            c->u[k] += axis[i][k] * a[i] * radius;
            c->v[k] += axis[i][k] * b[i] * radius;
        }
        c->center[k] -= to[k];
    }
}

void polygon_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    c->count = vectors;
    for (size_t i = 0; i < vectors; ++i)
        add3(n + 3 * i, -1, from, c->vertex[i]);
}

void triangle_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    polygon_contour(n, vectors, from, c);
}

void rectangle_contour(const double *n, size_t vectors, const double from[3], contour *c)
{
    (void)vectors;
    c->count = 4;
    add3(n, -1, from, c->vertex[0]);
    add3(c->vertex[0], 1, n + 3, c->vertex[1]);
    add3(c->vertex[1], 1, n + 6, c->vertex[2]);
    add3(c->vertex[0], 1, n + 6, c->vertex[3]);
}

/* ---- Integrals along arcs of an ellipse ---- */

typedef struct integrand {
    double (*f)(const struct integrand *i, const double r[3], const double dr[3]);
    const contour *c;
    const double *normal;           /* of the receiver, or that of the light */
    double extinction, height, top; /* of contour_fluence() */
} integrand;

static double at(const integrand *i, double t)
{
    double r[3], dr[3];
    for (int k = 0; k < 3; ++k) {
        r[k] = i->c->center[k] + cos(t) * i->c->u[k] + sin(t) * i->c->v[k];
        dr[k] = cos(t) * i->c->v[k] - sin(t) * i->c->u[k];
    }
    return i->f(i, r, dr);
}

/* n points, evenly for the whole outline, else by the doubly exponential rule [Takahasi and Mori
   1974]; both gain digits in proportion to n. */
static double sum(const integrand *i, double begin, double end, int n)
{
    const int whole = end - begin > 2 * PI - 1e-12;
    double total = 0;

    for (int k = 0; k < n; ++k) {
        const double x = (k + 0.5) / n;
        if (whole) {
            total += at(i, begin + 2 * PI * x) * 2 * PI / n;
        } else {
            const double s = 6.4 * (x - 0.5), e = PI / 2 * sinh(s), half = (end - begin) / 2;
            const double weight = PI / 2 * cosh(s) / (cosh(e) * cosh(e)) * 6.4 / n;
            total += at(i, begin + half * (1 + tanh(e))) * half * weight;
        }
    }
    return total;
}

static double integrate(const integrand *i, double begin, double end)
{
    double last, now = sum(i, begin, end, 16);
    int n = 16;
    do {
        last = now;
        n *= 2;
        now = sum(i, begin, end, n);
    } while (fabs(now - last) > 1e-10 * fabs(now) && n < 1 << 17);
    return now;
}

/* ---- Surfaces: half the integral of n . (r x dr) / r^2 [Lambert 1760] ---- */

static double angle_moment(const double normal[3], const double a[3], const double b[3])
{
    double c[3];
    cross3(a, b, c);
    const double length = sqrt(dot3(c, c));
    return length > 0 ? atan2(length, dot3(a, b)) * dot3(normal, c) / length / 2 : 0;
}

static double arc_moment(const integrand *i, const double r[3], const double dr[3])
{
    double c[3];
    cross3(r, dr, c);
    return dot3(i->normal, c) / dot3(r, r) / 2;
}

/* The outline cut at the horizon, along which the cut then runs: in its own plane, it has the
   moment of the angle from a to b about the normal. */
static double ellipse_irradiance(const contour *c, const double normal[3])
{
    const integrand moment = {.f = arc_moment, .c = c, .normal = normal};
    const double middle = dot3(normal, c->center);
    const double x = dot3(normal, c->u), y = dot3(normal, c->v), swing = hypot(x, y);
    double ends[2][3];

    if (middle <= -swing)
        return 0;
    if (middle >= swing)
        return fabs(integrate(&moment, 0, 2 * PI));
    const double top = atan2(y, x), reach = acos(-middle / swing);
    for (int e = 0; e < 2; ++e) {
        const double t = top + (e ? reach : -reach);
        for (int k = 0; k < 3; ++k)
            ends[e][k] = c->center[k] + cos(t) * c->u[k] + sin(t) * c->v[k];
    }
    return fabs(integrate(&moment, top - reach, top + reach)
                + angle_moment(normal, ends[1], ends[0]));
}

static double polygon_irradiance(const contour *c, const double normal[3])
{
    double clipped[CONTOUR_VERTICES + 1][3], total = 0;
    size_t count = 0;

    for (size_t i = 0; i < c->count; ++i) {
        const double *a = c->vertex[i], *b = c->vertex[(i + 1) % c->count];
        const double high = dot3(normal, a), next = dot3(normal, b);
        if (high >= 0)
            memcpy(clipped[count++], a, sizeof clipped[0]);
        if ((high >= 0) != (next >= 0)) {
            double edge[3];
            add3(b, -1, a, edge);
            add3(a, high / (high - next), edge, clipped[count++]);
        }
    }
    for (size_t i = 0; i < count; ++i)
        total += angle_moment(normal, clipped[i], clipped[(i + 1) % count]);
    return fabs(total);
}

double contour_irradiance(const contour *c, const double normal[3])
{
    return (c->count ? polygon_irradiance : ellipse_irradiance)(c, normal);
}

/* ---- Volumes ---- */

/* The exponential integral E_2 [NIST Handbook, 8.19]: E_1 by its series, or E_2 by its continued
   fraction. */
static double exponential_2(double x)
{
    if (x == 0)
        return 1;
    if (x < 1) {
        double term = 1, e1 = -0.57721566490153286 - log(x);
        for (int k = 1; k < 22; ++k) {
            term *= -x / k;
            e1 -= term / k;
        }
        return exp(-x) - x * e1;
    }
    double tail = x + 2 + 2 * 80;
    for (int k = 80; k > 0; --k)
        tail = x + 2 * k - (double)k * (k + 1) / tail;
    return exp(-x) / tail;
}

/* About the receiver's foot on the light's plane, at a height h above it and in polar coordinates
   rho, phi, the integrand is h exp(-x r) / r^3 rho drho dphi, and the integral over rho is
   E_2(x h) - h E_2(x r) / r. */
static double arc_fluence(const integrand *i, const double r[3], const double dr[3])
{
    double c[3];
    cross3(r, dr, c);
    const double distance = sqrt(dot3(r, r));
    const double square = dot3(r, r) - i->height * i->height; /* of rho */
    return (i->top - i->height / distance * exponential_2(i->extinction * distance)) / square
           * dot3(i->normal, c);
}

double contour_fluence(const contour *c, double extinction)
{
    double normal[3];
    cross3(c->u, c->v, normal);
    const double length = sqrt(dot3(normal, normal));
    for (int k = 0; k < 3; ++k)
        normal[k] /= length;
    const double height = fabs(dot3(normal, c->center));
    const integrand fluence = {.f = arc_fluence, .c = c, .normal = normal,
                               .extinction = extinction, .height = height,
                               .top = exponential_2(extinction * height)};
    return height > 0 ? fabs(integrate(&fluence, 0, 2 * PI)) : 0;
}
