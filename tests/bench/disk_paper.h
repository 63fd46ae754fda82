/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Disks by the radial map of C. Guillén, C. Ureña, A. King, M. Fajardo, I. Georgiev, J. López-
 * Moreno, A. Jarabo: Area-preserving parameterizations for spherical ellipses. EGSR 2017, as that
 * paper gives it, in double precision: the elliptic integral by B. C. Carlson: Numerical
 * computation of real or complex elliptic integrals. Numerical Algorithms 10, 1995; Newton's
 * method to an error of 1e-6 of the quadrant. Numbers in parentheses are the first paper's
 * equations, (3) with its axes the right way round. And the table of its section 4.1.
 */
#ifndef PSC_BENCH_DISK_PAPER_H
#define PSC_BENCH_DISK_PAPER_H

#include <math.h>
#include <string.h>

/* ---- Carlson's integrals, by duplication and the series of fifth order ---- */

static inline double carlson_f(double x, double y, double z)
{
    double mean, ex, ey, e2, e3;

    for (;;) {
        const double lambda = sqrt(x * y) + sqrt(x * z) + sqrt(y * z);

        mean = (x + y + z) / 3.0;
        ex = (mean - x) / mean;
        ey = (mean - y) / mean;
        if (fabs(ex) < 2e-3 && fabs(ey) < 2e-3 && fabs(ex + ey) < 2e-3)
            break;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
    e2 = ex * ey - (ex + ey) * (ex + ey);
    e3 = -ex * ey * (ex + ey);
    return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / sqrt(mean);
}

static inline double carlson_c(double x, double y)
{
    double mean, s;

    for (;;) {
        const double lambda = 2.0 * sqrt(x * y) + y;

        mean = (x + y + y) / 3.0;
        s = (y - mean) / mean;
        if (fabs(s) < 2e-3)
            break;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
    }
    return (1.0 + s * s * (0.3 + s * (1.0 / 7.0 + s * (0.375 + s * 9.0 / 22.0)))) / sqrt(mean);
}

static inline double carlson_j(double x, double y, double z, double p)
{
    const double delta = (p - x) * (p - y) * (p - z);
    double mean, ex, ey, ez, ep, e2, e3, e4, e5, xyz, sum = 0.0, power = 1.0;

    for (;;) {
        const double rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), rp = sqrt(p);
        const double lambda = rx * ry + rx * rz + ry * rz;
        const double d = (rp + rx) * (rp + ry) * (rp + rz);

        mean = (x + y + z + p + p) / 5.0;
        ex = (mean - x) / mean;
        ey = (mean - y) / mean;
        ez = (mean - z) / mean;
        if (fabs(ex) < 2e-3 && fabs(ey) < 2e-3 && fabs(ez) < 2e-3)
            break;
        sum += power / d * carlson_c(1.0, 1.0 + power * power * power * delta / (d * d));
        power *= 0.25;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
        p = 0.25 * (p + lambda);
    }
    ep = -0.5 * (ex + ey + ez);
    xyz = ex * ey * ez;
    e2 = ex * ey + ex * ez + ey * ez - 3.0 * ep * ep;
    e3 = xyz + 2.0 * e2 * ep + 4.0 * ep * ep * ep;
    e4 = (2.0 * xyz + e2 * ep + 3.0 * ep * ep * ep) * ep;
    e5 = xyz * ep * ep;
    return power / (mean * sqrt(mean)) *
               (1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 -
                9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0) +
           6.0 * sum;
}

/* Legendre's integral of the third kind. */
static inline double legendre_pi(double n, double phi, double m)
{
    const double s = sin(phi), c = cos(phi), q = 1.0 - m * s * s;

    return s * carlson_f(c * c, q, 1.0) +
           n / 3.0 * s * s * s * carlson_j(c * c, q, 1.0, 1.0 - n * s * s);
}

/* ---- The spherical ellipse ---- */

struct spherical_ellipse_f64 {
    double x[3], y[3], z[3];
    double a, b, quadrant, pdf; /* of (4); the solid angle of a quadrant */
};

/* (16) by (19) and (20) */
static inline double radial_area(const struct spherical_ellipse_f64 *e, double phi)
{
    const double a2 = e->a * e->a, b2 = e->b * e->b;
    const double n = (a2 - b2) / (a2 * (1.0 - b2)), m = (a2 - b2) / (1.0 - b2);
    const double stretch = e->a / e->b * sqrt((1.0 - b2) / (1.0 - a2));
    const double parameter = atan2(stretch * sin(phi), cos(phi));

    return phi - e->b * (1.0 - a2) / (e->a * sqrt(1.0 - b2)) * legendre_pi(n, parameter, m);
}

/* (17) and (18) */
static inline double radial_height(const struct spherical_ellipse_f64 *e, double phi)
{
    const double s = e->a * sin(phi), c = e->b * cos(phi);

    return sqrt(1.0 - e->a * e->a * e->b * e->b / (s * s + c * c));
}

/* light: center, normal, radius */
static inline int disk_build_f64(struct spherical_ellipse_f64 *e, const double position[3],
                             const double normal[3], const double *light)
{
    const double *n = light + 3, radius = light[6];
    double c[3], zd[3], yd[3], z, y, low, high, length, yh, zh, y0, z0, y1, z1, chord;
    int i;

    (void)normal; /* solid angle does not look at the horizon */
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (i = 0; i < 3; i++) {
        c[i] = light[i] - position[i];
        zd[i] = n[i] / length;
    }
    z = c[0] * zd[0] + c[1] * zd[1] + c[2] * zd[2];
    for (i = 0; i < 3 && z < 0.0; i++)
        zd[i] = -zd[i];
    z = fabs(z);
    e->x[0] = c[1] * zd[2] - c[2] * zd[1]; /* (3) */
    e->x[1] = c[2] * zd[0] - c[0] * zd[2];
    e->x[2] = c[0] * zd[1] - c[1] * zd[0];
    length = sqrt(e->x[0] * e->x[0] + e->x[1] * e->x[1] + e->x[2] * e->x[2]);
    for (i = 0; i < 3; i++)
        e->x[i] /= length;
    yd[0] = zd[1] * e->x[2] - zd[2] * e->x[1];
    yd[1] = zd[2] * e->x[0] - zd[0] * e->x[2];
    yd[2] = zd[0] * e->x[1] - zd[1] * e->x[0];
    y = c[0] * yd[0] + c[1] * yd[1] + c[2] * yd[2];
    low = sqrt((y - radius) * (y - radius) + z * z);
    high = sqrt((y + radius) * (y + radius) + z * z);
    y0 = (y - radius) / low;
    z0 = z / low;
    y1 = (y + radius) / high;
    z1 = z / high;
    length = sqrt((y0 + y1) * (y0 + y1) + (z0 + z1) * (z0 + z1));
    yh = (y0 + y1) / length;
    zh = (z0 + z1) / length;
    for (i = 0; i < 3; i++) {
        e->z[i] = yh * yd[i] + zh * zd[i];
        e->y[i] = zh * yd[i] - yh * zd[i];
    }
    yh *= z / zh;
    chord = sqrt(radius * radius - (yh - y) * (yh - y));
    e->a = chord / sqrt(chord * chord + yh * yh + z * z);                  /* (4) */
    e->b = 0.5 * sqrt((y1 - y0) * (y1 - y0) + (z1 - z0) * (z1 - z0));
    e->quadrant = radial_area(e, asin(1.0));
    e->pdf = 0.25 / e->quadrant;
    return e->quadrant > 0.0;
}

/* The share of a quadrant that u stands for, and the quadrant. */
static inline double fold_quadrant(double u, int *quadrant)
{
    const double t = 4.0 * u;

    *quadrant = t < 3.0 ? (int)t : 3;
    return *quadrant % 2 ? *quadrant + 1 - t : t - *quadrant;
}

/* (22) and (15) */
static inline void place_on_ellipse(const struct spherical_ellipse_f64 *e, int quadrant, double phi,
                                    double height, double v, double direction[3])
{
    const double h = (1.0 - v) * height + v, r = sqrt(1.0 - h * h);
    const double x = (quadrant == 1 || quadrant == 2 ? -r : r) * cos(phi);
    const double y = (quadrant > 1 ? -r : r) * sin(phi);
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = x * e->x[i] + y * e->y[i] + h * e->z[i];
}

/* (21) by Newton's method from the planar ellipse's angle. */
static inline void disk_sample_f64(const struct spherical_ellipse_f64 *e, double u, double v,
                               double direction[3], double *pdf)
{
    const double right = asin(1.0);
    double phi, low = 0.0, high = right, height, off, t;
    int quadrant, i;

    t = fold_quadrant(u, &quadrant);
    phi = atan2(e->b * sin(t * right), e->a * cos(t * right));
    for (i = 0; i < 20; i++) {
        height = radial_height(e, phi);
        off = radial_area(e, phi) - t * e->quadrant;
        if (fabs(off) <= 1e-6 * e->quadrant)
            break;
        *(off > 0.0 ? &high : &low) = phi;
        phi -= off / (1.0 - height);
        if (!(phi > low && phi < high))
            phi = 0.5 * (low + high);
    }
    place_on_ellipse(e, quadrant, phi, radial_height(e, phi), v, direction);
    *pdf = e->pdf;
}

/* ---- The table ---- */

/* By the ratio of the semi-arcs and the angle: the share of the quadrant up to there. */
#define DISK_TABLES(X) X(64) X(256) X(1024)
#define DISK_TABLE(n) static float disk_table_of_##n[(n) * (n)];
DISK_TABLES(DISK_TABLE)
#undef DISK_TABLE

static inline void make_disk_table(int resolution, float *table)
{
    const double right = asin(1.0), alpha = 0.3;
    int row, i;

    for (row = 0; row < resolution; row++, table += resolution) {
        struct spherical_ellipse_f64 e;
        double sum = 0.0;

        memset(&e, 0, sizeof e);
        e.a = sin(alpha);
        e.b = sin(alpha * (row + 0.5) / resolution);
        for (i = 0; i < resolution; i++) {
            table[i] = (float)sum;
            sum += 1.0 - radial_height(&e, (i + 0.5) / resolution * right);
        }
        for (i = 0; i < resolution; i++)
            table[i] = (float)(table[i] / sum);
    }
}

static inline void make_disk_tables(void)
{
#define MAKE_DISK_TABLE(n) make_disk_table(n, disk_table_of_##n);
    DISK_TABLES(MAKE_DISK_TABLE)
#undef MAKE_DISK_TABLE
}

static inline void disk_table_sample(int resolution, const float *table,
                                     const struct spherical_ellipse_f64 *e, double u, double v,
                                     double direction[3], double *pdf)
{
    const double right = asin(1.0);
    const int ratio = (int)(asin(e->b) / asin(e->a) * resolution);
    const float *row = table + (ratio < resolution ? ratio : resolution - 1) * resolution;
    int quadrant, low = 0, high = resolution;
    const double t = fold_quadrant(u, &quadrant);
    double next, phi;

    while (high - low > 1) {
        const int middle = (low + high) / 2;

        *(row[middle] <= t ? &low : &high) = middle;
    }
    next = high < resolution ? row[high] : 1.0;
    phi = (low + (t - row[low]) / (next - row[low])) / resolution * right;
    place_on_ellipse(e, quadrant, phi, radial_height(e, phi), v, direction);
    *pdf = e->pdf;
}

#define DISK_TABLE_SAMPLE(n)                                                                    \
    static inline void disk_table_##n##_f64(const struct spherical_ellipse_f64 *e, double u,    \
                                            double v, double direction[3], double *pdf)         \
    {                                                                                           \
        disk_table_sample(n, disk_table_of_##n, e, u, v, direction, pdf);                       \
    }
DISK_TABLES(DISK_TABLE_SAMPLE)
#undef DISK_TABLE_SAMPLE

#endif
