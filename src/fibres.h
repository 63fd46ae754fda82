/* SPDX-License-Identifier: Apache-2.0 */
#ifndef PSC_SRC_FIBRES_H
#define PSC_SRC_FIBRES_H

#include "fibre_starts.h"

/* Tangents of semi-arcs that are not told from a right angle. */
#define PSC_WIDEST_TANGENT 1e60

/* On each half of the range of s; what the sharpest cones need is less. */
#define PSC_FIBRE_PANELS 64

/* How the receiver's horizon lies to an elliptic cone: the unit normal (Nx, Ny, Nz) in the frame
   of the cone, scaled to gnomonic coordinates. Above it is x U + y V + z > 0. */
struct psc_horizon {
    double x, y, z; /* Nx tan alpha, Ny tan beta, Nz */
    double margin;  /* x^2 + y^2 - z^2: above 0 where the horizon cuts the cone */
};

/* The integral over s as polynomials in cos 2s, see fibre_series_tmpl.h, in shares of the whole:
   all but the mean are coefficients. start is the place over a root of the share from the nearer
   end, in powers of the root's square, or of the root itself from a horizon; from the top and from
   the end. */
#define PSC_SERIES_TERMS 24
#define PSC_FIBRE_SERIES(real)                                             \
    real mean, start[2][PSC_START_TERMS];                                  \
    real even[PSC_SERIES_TERMS], odd[PSC_SERIES_TERMS];                    \
    real even_integral[PSC_SERIES_TERMS], odd_integral[PSC_SERIES_TERMS];  \
    real even_slope[PSC_SERIES_TERMS], odd_slope[PSC_SERIES_TERMS];

/* The part of an elliptic cone above a horizon as a sheaf of fibres, see fibre_density.h: F in the
   frame of the cone, E = (-f[1], f[0]), and in the coordinates U, V of ellipse_view.h; sine and
   cosine of the largest psi; tan chi = shear cos s -+ width sin s at the ends of a fibre; the
   receiver's normal along z and F; the end of the range of s, and pi less that. A sheaf is brief
   if every fibre is short beside its distance to both ends of E, shorter where it takes double. */
#define PSC_SHEAF(real)                    \
    real f[2], turn[2];                    \
    real sin_m, cos_m, shear, width;       \
    real nz, nf, end, rest, cos_end;       \
    int clipped, brief, brief_f32;

struct psc_fibre_series_f64 {
    PSC_FIBRE_SERIES(double)
};
struct psc_fibre_series_f32 {
    PSC_FIBRE_SERIES(float)
};
struct psc_sheaf_f64 {
    PSC_SHEAF(double)
};
struct psc_sheaf_f32 {
    PSC_SHEAF(float)
};

/* With the integral of its density. */
struct psc_fibres {
    struct psc_sheaf_f64 sheaf;
    double total; /* projected solid angle */
    int rule;     /* of the series; -1: none, panels */
    int steps;    /* from the start to the place */
    struct psc_fibre_series_f64 series;
    /* Without a series panels, those of the lower half counted from the end: where each ends, and
       the integral up to there. */
    int panels[2];
    double edge[2][PSC_FIBRE_PANELS], below[2][PSC_FIBRE_PANELS];
};

#endif
