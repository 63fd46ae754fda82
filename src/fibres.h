/* SPDX-License-Identifier: Apache-2.0 */
#ifndef PSC_SRC_FIBRES_H
#define PSC_SRC_FIBRES_H

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

/* The integral over s as a polynomial, see fibre_series.h; in shares of the whole. */
#define PSC_SERIES_TERMS 24
struct psc_fibre_series {
    int rule; /* -1: none, panels */
    int steps;
    double density[PSC_SERIES_TERMS], integral[PSC_SERIES_TERMS], mean;
    /* Starts: the place over a root of the share, in powers of that root's square from an end of
       a whole cone, of the root itself from a horizon; from the top and from the end. */
    double middle, start[2][4];
};

/* The part of an elliptic cone above a horizon as a sheaf of fibres, see fibre_density.h. */
struct psc_sheaf {
    double f[2];         /* F in the frame of the cone; E = (-f[1], f[0]) */
    double turn[2];      /* F in the coordinates U, V of ellipse_view.h */
    double sin_m, cos_m; /* of the largest psi */
    double shear, width; /* tan chi = shear cos s -+ width sin s at the ends of a fibre */
    double nz, nf;       /* the receiver's normal along z and F */
    int clipped;
    int brief;        /* every fibre is short beside its distance to both ends of E */
    double end, rest; /* of the range of s, and pi less that */
};

/* With the integral of its density. */
struct psc_fibres {
    struct psc_sheaf sheaf;
    double total; /* projected solid angle */
    struct psc_fibre_series series;
    /* Without a series panels, those of the lower half counted from the end: where each ends, and
       the integral up to there. */
    int panels[2];
    double edge[2][PSC_FIBRE_PANELS], below[2][PSC_FIBRE_PANELS];
};

#endif
