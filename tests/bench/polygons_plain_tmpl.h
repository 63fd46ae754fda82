/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, fans of them and rectangles as the papers print them and renderers write them, with
 * the angles of libm. Template: see real.h; after vectors_tmpl.h.
 *
 * Area: G. Turk: Generating random points in triangles. Graphics Gems, 1990.
 * Triangles: J. Arvo: Stratified sampling of spherical triangles. SIGGRAPH 1995.
 * Rectangles: C. Ureña, M. Fajardo, A. King: An area-preserving parametrization for spherical
 * rectangles. EGSR 2013.
 */

static inline real FN(clamp)(real x, real low, real high)
{
    return MAX(low, MIN(x, high));
}

static inline void FN(normalize)(real v[3])
{
    const real inverse = R(1) / sqrt(FN(dot)(v, v));
    int i;

    for (i = 0; i < 3; i++)
        v[i] *= inverse;
}

/* The unit vector towards v, of what is perpendicular to the unit vector n. */
static inline void FN(perpendicular)(const real v[3], const real n[3], real out[3])
{
    const real along = FN(dot)(v, n);
    int i;

    for (i = 0; i < 3; i++)
        out[i] = v[i] - along * n[i];
    FN(normalize)(out);
}

/* The unit normal of the plane through two vectors and the origin. */
static inline void FN(plane)(const real a[3], const real b[3], real n[3])
{
    FN(cross)(a, b, n);
    FN(normalize)(n);
}

/* ---- Triangles ---- */

struct FN(triangle) {
    real a[3], b[3], c[3];
    real alpha, sin_alpha, cos_alpha, cos_c, area;
};

/* light: the vertices */
static inline int FN(triangle_build)(struct FN(triangle) *t, const real position[3],
                                     const real normal[3], const real *light)
{
    real ab[3], bc[3], ca[3];
    int i;

    (void)normal;
    for (i = 0; i < 3; i++) {
        t->a[i] = light[i] - position[i];
        t->b[i] = light[3 + i] - position[i];
        t->c[i] = light[6 + i] - position[i];
    }
    FN(normalize)(t->a);
    FN(normalize)(t->b);
    FN(normalize)(t->c);
    FN(plane)(t->a, t->b, ab);
    FN(plane)(t->b, t->c, bc);
    FN(plane)(t->c, t->a, ca);
    t->cos_alpha = FN(clamp)(-FN(dot)(ab, ca), R(-1), R(1));
    t->alpha = acos(t->cos_alpha);
    t->sin_alpha = sin(t->alpha);
    t->cos_c = FN(dot)(t->a, t->b);
    t->area = t->alpha + acos(FN(clamp)(-FN(dot)(ab, bc), R(-1), R(1))) +
              acos(FN(clamp)(-FN(dot)(bc, ca), R(-1), R(1))) - R(PI);
    return 1;
}

static inline void FN(triangle_sample)(const struct FN(triangle) *t, real u, real v,
                                       real direction[3], real *pdf)
{
    const real part = u * t->area - t->alpha, s = sin(part), c = cos(part);
    const real x = c - t->cos_alpha, y = s + t->sin_alpha * t->cos_c;
    const real q = FN(clamp)(((y * c - x * s) * t->cos_alpha - y) /
                                 ((y * s + x * c) * t->sin_alpha), R(-1), R(1));
    real corner[3], side[3], z;
    int i;

    FN(perpendicular)(t->c, t->a, side);
    for (i = 0; i < 3; i++)
        corner[i] = q * t->a[i] + sqrt(R(1) - q * q) * side[i];
    z = R(1) - v * (R(1) - FN(dot)(corner, t->b));
    FN(perpendicular)(corner, t->b, side);
    for (i = 0; i < 3; i++)
        direction[i] = z * t->b[i] + sqrt(MAX(R(0), R(1) - z * z)) * side[i];
    *pdf = R(1) / t->area;
}

/* ---- Pentagons: fans of triangles ---- */

struct FN(pentagon) {
    struct FN(triangle) triangle[3];
    real below[3], area;
};

/* light: the vertices */
static inline int FN(pentagon_build)(struct FN(pentagon) *p, const real position[3],
                                     const real normal[3], const real *light)
{
    real corners[9];
    int i, c;

    p->area = R(0);
    for (i = 0; i < 3; i++) {
        for (c = 0; c < 3; c++) {
            corners[c] = light[3 * (i + 1) + c];
            corners[3 + c] = light[c];
            corners[6 + c] = light[3 * (i + 2) + c];
        }
        FN(triangle_build)(&p->triangle[i], position, normal, corners);
        p->below[i] = p->area;
        p->area += p->triangle[i].area;
    }
    return 1;
}

static inline void FN(pentagon_sample)(const struct FN(pentagon) *p, real u, real v,
                                       real direction[3], real *pdf)
{
    const real at = u * p->area;
    const int i = (at >= p->below[1]) + (at >= p->below[2]);
    const struct FN(triangle) *t = &p->triangle[i];

    FN(triangle_sample)(t, MIN((at - p->below[i]) / t->area, R(1)), v, direction, pdf);
    *pdf = R(1) / p->area;
}

/* ---- Rectangles ---- */

struct FN(rectangle) {
    real x[3], y[3], z[3];
    real x0, x1, y0, y1, z0, b0, b1, k, area;
};

/* light: a corner and two edges */
static inline int FN(rectangle_build)(struct FN(rectangle) *r, const real position[3],
                                      const real normal[3], const real *light)
{
    const real *ex = light + 3, *ey = light + 6;
    const real width = sqrt(FN(dot)(ex, ex)), height = sqrt(FN(dot)(ey, ey));
    real d[3], v[4][3], n[4][3], g[4];
    int i;

    (void)normal;
    for (i = 0; i < 3; i++) {
        d[i] = light[i] - position[i];
        r->x[i] = ex[i] / width;
        r->y[i] = ey[i] / height;
    }
    FN(cross)(r->x, r->y, r->z);
    r->z0 = FN(dot)(d, r->z);
    if (r->z0 > R(0)) {
        r->z0 = -r->z0;
        for (i = 0; i < 3; i++)
            r->z[i] = -r->z[i];
    }
    r->x0 = FN(dot)(d, r->x);
    r->y0 = FN(dot)(d, r->y);
    r->x1 = r->x0 + width;
    r->y1 = r->y0 + height;
    for (i = 0; i < 4; i++) {
        v[i][0] = i == 1 || i == 2 ? r->x1 : r->x0;
        v[i][1] = i > 1 ? r->y1 : r->y0;
        v[i][2] = r->z0;
    }
    for (i = 0; i < 4; i++)
        FN(plane)(v[i], v[(i + 1) % 4], n[i]);
    for (i = 0; i < 4; i++)
        g[i] = acos(FN(clamp)(-FN(dot)(n[i], n[(i + 1) % 4]), R(-1), R(1)));
    r->b0 = n[0][2];
    r->b1 = n[2][2];
    r->k = R(2 * PI) - g[2] - g[3];
    r->area = g[0] + g[1] - r->k;
    return 1;
}

static inline void FN(rectangle_sample)(const struct FN(rectangle) *r, real u, real v,
                                        real direction[3], real *pdf)
{
    const real angle = u * r->area + r->k;
    const real f = (cos(angle) * r->b0 - r->b1) / sin(angle);
    const real c = FN(clamp)((f > R(0) ? R(1) : R(-1)) / sqrt(f * f + r->b0 * r->b0), R(-1), R(1));
    const real x = FN(clamp)(-(c * r->z0) / sqrt(R(1) - c * c), r->x0, r->x1);
    const real d2 = x * x + r->z0 * r->z0;
    const real h0 = r->y0 / sqrt(d2 + r->y0 * r->y0), h1 = r->y1 / sqrt(d2 + r->y1 * r->y1);
    const real h = h0 + v * (h1 - h0), h2 = h * h;
    const real y = h2 < R(1) - R(1e-6) ? h * sqrt(d2) / sqrt(R(1) - h2) : r->y1;

    FN(to_world)(r->x, r->y, r->z, x, y, r->z0, direction);
    FN(normalize)(direction);
    *pdf = R(1) / r->area;
}

/* ---- Area ---- */

/* A corner as the receiver sees it, and the edges from there: two, or as many as a fan has. */
struct FN(face) {
    real corner[3], edge[4][3], normal[3], below[3], area;
};

/* The direction to a point of the light, and area as it is seen from there. */
static inline void FN(face_sample)(const struct FN(face) *f, const real first[3],
                                   const real second[3], real s, real t, real direction[3],
                                   real *pdf)
{
    real square, length, cosine;
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = f->corner[i] + (s * first[i] + t * second[i]);
    square = FN(dot)(direction, direction);
    length = sqrt(square);
    for (i = 0; i < 3; i++)
        direction[i] /= length;
    cosine = fabs(FN(dot)(direction, f->normal));
    *pdf = square / (cosine * f->area);
}

static inline void FN(face_triangle)(const struct FN(face) *f, int k, real u, real v,
                                     real direction[3], real *pdf)
{
    const real root = sqrt(v);

    FN(face_sample)(f, f->edge[k], f->edge[k + 1], root * (R(1) - u), root * u, direction, pdf);
}

/* A fan about the first of some vertices. */
static inline int FN(face_fan)(struct FN(face) *f, int vertices, const real position[3],
                               const real *light)
{
    real across[3];
    int i, c;

    for (c = 0; c < 3; c++) {
        f->corner[c] = light[c] - position[c];
        f->normal[c] = R(0);
        for (i = 1; i < vertices; i++)
            f->edge[i - 1][c] = light[3 * i + c] - light[c];
    }
    f->area = R(0);
    for (i = 0; i + 2 < vertices; i++) {
        FN(cross)(f->edge[i], f->edge[i + 1], across);
        f->below[i] = f->area;
        f->area += R(0.5) * sqrt(FN(dot)(across, across));
        for (c = 0; c < 3; c++)
            f->normal[c] += across[c];
    }
    FN(normalize)(f->normal);
    return 1;
}

static inline int FN(triangle_area_build)(struct FN(face) *f, const real position[3],
                                          const real normal[3], const real *light)
{
    (void)normal;
    return FN(face_fan)(f, 3, position, light);
}

static inline void FN(triangle_area_sample)(const struct FN(face) *f, real u, real v,
                                            real direction[3], real *pdf)
{
    FN(face_triangle)(f, 0, u, v, direction, pdf);
}

static inline int FN(pentagon_area_build)(struct FN(face) *f, const real position[3],
                                          const real normal[3], const real *light)
{
    (void)normal;
    return FN(face_fan)(f, 5, position, light);
}

static inline void FN(pentagon_area_sample)(const struct FN(face) *f, real u, real v,
                                            real direction[3], real *pdf)
{
    const real at = u * f->area;
    const int k = (at >= f->below[1]) + (at >= f->below[2]);
    const real above = k < 2 ? f->below[k + 1] : f->area;

    FN(face_triangle)(f, k, (at - f->below[k]) / (above - f->below[k]), v, direction, pdf);
}

static inline int FN(rectangle_area_build)(struct FN(face) *f, const real position[3],
                                           const real normal[3], const real *light)
{
    int c;

    (void)normal;
    for (c = 0; c < 3; c++) {
        f->corner[c] = light[c] - position[c];
        f->edge[0][c] = light[3 + c];
        f->edge[1][c] = light[6 + c];
    }
    FN(cross)(f->edge[0], f->edge[1], f->normal);
    f->area = sqrt(FN(dot)(f->normal, f->normal));
    FN(normalize)(f->normal);
    return 1;
}

static inline void FN(rectangle_area_sample)(const struct FN(face) *f, real u, real v,
                                             real direction[3], real *pdf)
{
    FN(face_sample)(f, f->edge[0], f->edge[1], u, v, direction, pdf);
}
