/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Where in the unit square a sampled point lies, and how large the light is, from 113-bit
 * quadrature of positive densities: an independent answer to compare the library with.
 *
 * Nothing here is a step of the library. The library evaluates and inverts closed forms of the
 * areas; this adds up chords (equations 12 to 14 of [UG18]) and sectors (20 to 22). Equations 13
 * and 21 subtract nearly equal numbers when a lune is thin, so what is summed up is their
 * difference, rewritten with the height z_e of the cap's edge above the horizon:
 *
 *     x_max^2 - x_min^2 = z_e^2                                  along a chord of a lune,
 *     r_max^2 - r_min^2 = z_e^2 (r_max + r_min) / (r_max + r_min + 2 x_e cos phi)   on its rays.
 *
 * test_reference.c compares both with the equations as printed.
 */
#ifndef PSC_TESTS_REFERENCE_H
#define PSC_TESTS_REFERENCE_H

#include "quad.h"

enum { REFERENCE_PANELS = 40 };

/* The running integral of a positive density over [0, end]. */
struct reference_integral {
    quad end;
    int panels;
    quad below[REFERENCE_PANELS + 1];
};

enum reference_case { REFERENCE_EMPTY, REFERENCE_ELLIPSE, REFERENCE_BOTH, REFERENCE_LUNE };

/* A cap above the horizon: sines and cosines of its half-angle a and of the elevation b of its
   axis, in the local frame of [UG18] where the axis is (cos b, 0, sin b). */
struct reference {
    enum reference_case visible;
    quad sa, ca, sb, cb;
    quad height;    /* 1 - ca */
    quad rise;      /* sin(a - |b|): how far the edge of a lune rises above the horizon */
    quad theta_tip; /* angle on the ellipse where it touches the horizon */
    quad half;      /* half the projected solid angle */
    struct reference_integral chords, sectors;
};

/* From angles, exact for the doubles given. */
void reference_from_angles(struct reference *r, double alpha, double beta);

/* From a sphere of radius rho whose centre is w beside and h above the receiver. */
void reference_from_sphere(struct reference *r, quad w, quad h, quad rho);

/* Projected solid angle. */
quad reference_total(const struct reference *r);

/* The point (s, t) of the unit square, in the paper's orientation, that the exact map takes to
   the direction axis + (dx, y, .). */
void reference_radial(const struct reference *r, quad dx, quad y, quad st[2]);
void reference_parallel(const struct reference *r, quad dx, quad y, quad st[2]);

/* The other way round: the direction less the axis that the exact map takes (s, t) to. */
void reference_radial_sample(const struct reference *r, quad s, quad t, quad offset[3]);
void reference_parallel_sample(const struct reference *r, quad s, quad t, quad offset[3]);

/* The point of the parallel map's square over which [SC97] lays the point (u, v): first onto the
   unit disk, there read as chord and position on the chord. */
void reference_concentric(double u, double v, quad st[2]);

/* The unit disk that [SC97] makes of the square. */
void reference_disk(double u, double v, quad pq[2]);

/* The same from the cone of directions, with horizon ignored: t from the azimuth, which is 0
   towards the normal. */
void reference_cone(const struct reference *r, quad dx, quad y, quad dz, quad st[2]);

#endif
