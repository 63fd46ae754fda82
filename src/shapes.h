/* SPDX-License-Identifier: Apache-2.0 */
/* Every shape that has kernels: X(from, CONSTANT, name), `from` being passed through. A shape is
   a row here, a file with its public calls and its psc_shape_name, and the kernels of its family
   (see kernel_tmpl.h). */
#ifndef PSC_SRC_SHAPES_H
#define PSC_SRC_SHAPES_H

#define PSC_SHAPES(X, from)       \
    X(from, SPHERE, sphere)       \
    X(from, CAP, cap)             \
    X(from, DISK, disk)           \
    X(from, ELLIPSE, ellipse)     \
    X(from, ELLIPSOID, ellipsoid) \
    X(from, TRIANGLE, triangle)   \
    X(from, RECTANGLE, rectangle) \
    X(from, POLYGON, polygon)

#endif
