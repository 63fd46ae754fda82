/* SPDX-License-Identifier: Apache-2.0 */
/* A fibre of a sheaf, see fibre_density.h, and the way along it to a direction. Template: see
   precision.h. */

/* Where a fibre is: sine and cosine of s, and where the horizon clips sin psi - sin psi_end. */
struct FN(psc_fibre_site) {
    real sine, cosine, rise;
};

struct FN(psc_fibre) {
    real sine, cosine;  /* of s */
    real k;             /* cosine of psi */
    real height;        /* of the middle over the horizon */
    real middle, half;  /* shear cos s, width sin s: (tan chi_2 +- tan chi_1) / 2 */
    real first, second; /* 1 / cos chi at both ends */
    real angle;         /* chi_2 - chi_1 */
    real weight;        /* W */
};

/* x - sin x, x in [0, pi], given the sine. */
PSC_LANE real FN(angle_excess)(real x, real sine)
{
    const real z = x * x;

    return x <= K(1.57079632679489661923) ? x * z * FN(sine_polynomial)(z) : x - sine;
}

/* The angle in [0, pi] of a vector (c, s), s >= 0, of the given length. */
PSC_LANE real FN(angle_within)(real c, real s, real length)
{
    const real t = s / (length + ABS(c)), z = t * t;
#if PSC_BITS == 64
    const real defect = atan_polynomial(z);
#else
    static const float a[] = {PSC_ATAN_F32};
    const real z2 = z * z, z4 = z2 * z2;
    const real defect = (ESTRIN4(a, 0, z, z2) + z4 * ESTRIN4(a, 4, z, z2)) + z4 * z4 * a[8];
#endif
    const real small = K(2.0) * t * (K(1.0) - z * defect);

    return c >= K(0.0) ? small : K(3.14159265358979323846) - small;
}

/* All of a fibre but its height. */
PSC_LANE void FN(fibre_shape)(const struct FN(psc_sheaf) *f, real sine, real cosine,
                              struct FN(psc_fibre) *o)
{
    real d, t1, t2, product, sum, spread;

    o->sine = sine;
    o->cosine = cosine;
    o->k = SQRT(f->cos_m * f->cos_m + (f->sin_m * sine) * (f->sin_m * sine));
    o->middle = f->shear * cosine;
    o->half = f->width * sine;
    t1 = o->middle - o->half;
    t2 = o->middle + o->half;
    product = t1 * t2;
    o->first = SQRT(K(1.0) + t1 * t1);
    o->second = SQRT(K(1.0) + t2 * t2);
    d = o->first * o->second;
    spread = K(2.0) * o->half / d;
    /* (1 + t1 t2, t2 - t1) has the length d */
    o->angle = FN(angle_within)(K(1.0) + product, K(2.0) * o->half, d);
    /* W = angle - sin angle + sin angle (1 + cos(chi_1 + chi_2)) */
    product = K(1.0) - product;
    sum = product >= K(0.0) ? K(1.0) + product / d
                            : K(4.0) * (o->middle * o->middle) / (d * (d - product));
    o->weight = FN(angle_excess)(o->angle, spread) + spread * sum;
}

/* The height of the middle, `rise` being sin psi - sin psi_end. */
PSC_LANE real FN(clipped_height)(const struct FN(psc_sheaf) *f, real k, real rise)
{
    const real sum = k + f->nf;

    return K(2.0) * rise * sum / (sum * sum + rise * rise);
}

PSC_LANE real FN(whole_height)(const struct FN(psc_sheaf) *f, real k, real cosine)
{
    return MAX(f->nz * k + f->nf * (f->sin_m * cosine), K(0.0));
}

/* The fibre there. */
PSC_LANE void FN(fibre_of)(const struct FN(psc_sheaf) *f, int clipped,
                           const struct FN(psc_fibre_site) *site, struct FN(psc_fibre) *o)
{
    FN(fibre_shape)(f, site->sine, site->cosine, o);
    o->height = clipped ? FN(clipped_height)(f, o->k, site->rise)
                        : FN(whole_height)(f, o->k, site->cosine);
}

/*
 * The share of a disk beyond a chord, as segment_share() of segment.h, which has the variable w:
 * that of the half-angle w_end, given its cotangent and cosecant, which need not wait for a sine.
 */
PSC_LANE real FN(end_share)(real cotangent, real cosecant, real sine)
{
    const real sum = cosecant + cotangent;
    const real w = K(1.0) / (sum * sum + K(0.41421356237309504880)), w2 = w * w, w4 = w2 * w2;
#if PSC_BITS == 64
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    const real w8 = w4 * w4;
    const real n = ((ESTRIN4(c, 0, w, w2) + w4 * ESTRIN4(c, 4, w, w2)) +
                    w8 * (ESTRIN4(c, 8, w, w2) + w4 * ESTRIN4(c, 12, w, w2))) +
                   w8 * w8 * c[16];
#else
    static const float c[] = {1.0f, PSC_SEGMENT_F32};
    const real n = (ESTRIN4(c, 0, w, w2) + w4 * ESTRIN4(c, 4, w, w2)) + w4 * w4 * c[8];
#endif

    return K(0.424413181578387562) * (sine * sine * sine) * n;
}

/* Where on a fibre: chi, and the distances from both ends in the coordinates U, V. */
struct FN(psc_fibre_place) {
    real sine, cosine; /* of chi */
    real low, high;
};

/*
 * y in [0, angle] with (y - sin y) + 2 sin y sin^2(w + y / 2) = goal, the integral of
 * 2 sin^2 over the angles from w to w + y, for a short way: y is at most half of w, or comes down
 * to that. Sine and cosine are those of w; `stop` is the squared sine at the other end. From the
 * root of the integral of a density that grows linearly, two steps of Halley's. Returns sine and
 * versine of y.
 */
PSC_LANE void FN(short_arc)(real sine, real cosine, real angle, real share, real goal, real stop,
                            real sign, real *sine_y, real *versine_y)
{
    const real start = sine * sine, mean = K(0.5) * (start + stop) * share;
    real y = angle * mean / (start + SQRT(start * start + K(2.0) * (stop - start) * mean));
    real defect, versine, half_s, half_c; /* of y, half the way */
    int i;

    FN(sine_cosine_defects)(y, &defect, &versine);
    half_s = y - defect;
    half_c = K(1.0) - versine;
    for (i = 0; i < 2; i++) {
        /* at the middle of the way, and at its end */
        const real s = sine * half_c + sign * (cosine * half_s);
        const real c = cosine * half_c - sign * (sine * half_s);
        const real at = s * half_c + sign * (c * half_s);
        const real turn = sign * (c * half_c - sign * (s * half_s)); /* at slope' / 2 slope */
        /* y - sin y = 2 (y / 2 - sin y / 2) + 2 sin y / 2 (1 - cos y / 2) */
        const real error = K(2.0) * ((y - half_s) + half_s * (K(1.0) - half_c)) +
                           K(4.0) * half_s * half_c * (s * s) - goal;
        const real below = at * (K(2.0) * (at * at)) - error * turn;
        const real h = K(0.5) * MIN(MAX(-error * at / below, K(-2.0) * y), angle - K(2.0) * y);
        const real h2 = h * h;
        const real odd = h * (K(1.0) - h2 * K(0.166666666666666667)), even = K(0.5) * h2;
        const real next = half_s + (half_c * odd - half_s * even);

        half_c = half_c - (half_c * even + half_s * odd);
        half_s = next;
        y += h;
    }
    *sine_y = K(2.0) * half_s * half_c;
    *versine_y = K(2.0) * half_s * half_s;
}

/* Where the fibre has the share v before it, rest = 1 - v. */
PSC_LANE void FN(along_fibre)(int brief, const struct FN(psc_fibre) *o, real width, real v,
                              real rest, struct FN(psc_fibre_place) *p)
{
    /* By w = pi/2 -+ chi, the angle from E or against it, of whichever the fibre is nearer: near
       and far are the sines of w at the ends, near_cot and far_cot the cotangents. */
    const int turned = o->middle < K(0.0);
    const real share = turned ? v : rest, other = turned ? rest : v;
    const real near_cosec = turned ? o->first : o->second;
    const real far_cosec = turned ? o->second : o->first;
    const real near = K(1.0) / near_cosec, far = K(1.0) / far_cosec;
    const real near_cot = ABS(o->middle) + o->half, far_cot = ABS(o->middle) - o->half;
    const real per = K(1.0) / (o->k * width), chord = o->half * per;
    real sine, cosine, distance, to_near, to_far;
    int from_near;

    if (brief) {
        const real goal = MIN(share, other) * o->weight;
        real sine_y, versine, s, c;

        from_near = share <= other;
        s = from_near ? near : far;
        c = from_near ? near * near_cot : far * far_cot;
        FN(short_arc)(s, c, o->angle, MIN(share, other), goal, from_near ? far * far : near * near,
                      from_near ? K(1.0) : K(-1.0), &sine_y, &versine);
        sine = s * (K(1.0) - versine) + (from_near ? c : -c) * sine_y;
        cosine = c * (K(1.0) - versine) - (from_near ? s : -s) * sine_y;
        distance = sine_y / (sine * s) * per;
    } else {
        const real whole = K(0.636619772367581343) * o->weight; /* over pi/2, the half disk's */
        const real before = FN(end_share)(near_cot, near_cosec, near) + share * whole;
        /* used beyond the middle, where far_cot is negative */
        const real behind = FN(end_share)(ABS(far_cot), far_cosec, far) + other * whole;
        const int beyond = before > K(1.0);
        const real from_end = MIN(behind, K(1.0));
        real cot, dn, df;

        FN(solve_chord)(beyond ? from_end : before, &sine, &cosine);
        cosine = beyond ? -cosine : cosine;
        cot = cosine / sine;
        dn = MAX(near_cot - cot, K(0.0));
        df = MAX(cot - far_cot, K(0.0));
        from_near = dn <= df;
        distance = (from_near ? dn : df) * per;
    }
    p->sine = turned ? -cosine : cosine;
    p->cosine = sine;
    distance = MIN(distance, K(2.0) * chord);
    to_near = from_near ? distance : K(2.0) * chord - distance;
    to_far = from_near ? K(2.0) * chord - distance : distance;
    p->low = turned ? to_near : to_far;
    p->high = turned ? to_far : to_near;
}

/* A direction of the cone: x, y and depth = 1 + z; U depth, V depth, depth^2 (1 - U^2 - V^2), and
   its height over the horizon. */
struct FN(psc_fibre_direction) {
    real x, y, z, depth, uz, vz, margin, height;
};

PSC_LANE void FN(fibre_direction)(const struct FN(psc_sheaf) *f, const struct FN(psc_fibre) *o,
                                  const struct FN(psc_fibre_place) *p, const real per[2], real bt,
                                  struct FN(psc_fibre_direction) *d)
{
    const real xi = p->low < p->high ? p->low - o->sine / o->k : o->sine / o->k - p->high;
    const real eta = o->cosine * (f->cos_m / o->k), z = p->cosine * o->k;
    const real forward = p->cosine * (f->sin_m * o->cosine);

    d->x = forward * f->f[0] - p->sine * f->f[1];
    d->y = forward * f->f[1] + p->sine * f->f[0];
    d->uz = d->x * per[0];
    /* across a needle, from the place on it */
    d->vz = bt <= K(1.0) ? (eta * f->turn[1] + xi * f->turn[0]) * z : d->y * per[1];
    d->y = bt <= K(1.0) ? d->vz * bt : d->y;
    d->z = -(d->x * d->x + d->y * d->y) / (K(1.0) + z);
    d->depth = z;
    d->margin = z * z * (p->low * p->high);
    d->height = p->cosine * o->height;
}

/* The map of a side, from its fibre: v along it. */
PSC_LANE void FN(place_on_fibre)(const struct FN(psc_sheaf) *f, int clipped, int brief,
                                 const real per[2], real bt, const struct FN(psc_fibre_site) *site,
                                 real v, struct FN(psc_fibre_direction) *d)
{
    struct FN(psc_fibre_place) p;
    struct FN(psc_fibre) o;

    FN(fibre_of)(f, clipped, site, &o);
    FN(along_fibre)(brief, &o, f->width, v, K(1.0) - v, &p);
    FN(fibre_direction)(f, &o, &p, per, bt, d);
}

