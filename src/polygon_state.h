/* SPDX-License-Identifier: Apache-2.0 */
/* What a sampler keeps of a flat light with straight edges. */
#ifndef PSC_SRC_POLYGON_STATE_H
#define PSC_SRC_POLYGON_STATE_H

#include "fan_lanes.h"
#include "rectangle_map.h"
#include "rectangle_plain_map.h"
#include "sector_light.h"

/* How a light was built: with exact products, or without them as one of these. */
enum psc_plain { PSC_NOT_PLAIN, PSC_PLAIN_TRIANGLE, PSC_PLAIN_RECTANGLE, PSC_PLAIN_FAN };

struct psc_polygon_light {
    struct psc_polygon_view view;
    double normal[3];                /* the light's own, of length 1 */
    double up[3], receiver[3];       /* the receiver's, of length 1, or 0 when it has none; and as
                                        it is, but for a power of two */
    double height[PSC_MAX_VERTICES]; /* of the vertices above the receiver's plane, in the view */
    double area, solid_angle;        /* of the whole light */
    double unit;                     /* the length of 1 in its fan */
    double volume;                   /* area times twice the height of the receiver above the
                                        light's plane, in units of the view */

    /* How it was built: without view and heights where it is plain. */
    enum psc_plain plain;
    struct psc_ray_fan_f64 rays; /* of a triangle, with b / |b| */
    double b[3];
    /* What was given, for questions whose answers sampling does not need: vertices, or a corner and
       two edges. */
    int numbers;
    double position[3], corner[PSC_MAX_VERTICES][3];

    int turns_left;                  /* vertices run counterclockwise seen from the receiver */

    union {
        struct psc_sector_light projected;
        struct {
            /* The triangles that u selects from, without those of no size; below and per_share
               give the share of u of all before, and 1 / the share of this one. */
            int triangles;
            double below[PSC_FAN_LANES], per_share[PSC_FAN_LANES];
            union {
                struct {
                    struct psc_fan_f64 fan[PSC_MAX_FAN];
                    struct psc_face_f64 face[PSC_MAX_FAN];
                    struct psc_flat flat[PSC_MAX_FAN];
                    /* For maps along the edges: the first by area and of those that are not
                       plain. */
                    struct psc_rectangle rectangle;
                    struct psc_plain_rectangle plain_rectangle;
                    double edge_v[3]; /* at the right angle */
                };
                struct psc_ray_fans fans;
            };
        };
    };
};

#endif
