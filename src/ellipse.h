/* SPDX-License-Identifier: Apache-2.0 */
#ifndef PSC_SRC_ELLIPSE_H
#define PSC_SRC_ELLIPSE_H

/* An elliptic cone of directions as the receiver sees it. */
struct psc_ellipse {
    double a, ca, b, cb; /* sines and cosines of the semi-arcs alpha >= beta, along x and y */
    double at, bt;       /* their tangents */
    double x[3], y[3], z[3]; /* right-handed orthonormal frame; z points to the centre of the cone */
};

#endif
