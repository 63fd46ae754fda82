/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Elliptic cones given by their semi-arcs, and samples given as offsets from the axis. Not part of
 * the interface: vectors in double hold neither an arc of nearly a right angle nor a direction in
 * a small cone, and tests that compare with reference values of such cones need both.
 */
#ifndef PSC_SRC_ARCS_H
#define PSC_SRC_ARCS_H

#include <psc/psc.h>

/* Builds the sampler of an elliptical disk across the z axis, seen by a receiver without a normal
   at the origin, with the semi-arcs alpha >= beta along x and y, in (0, pi/2). Solid angle only.
   Results as psc_build_ellipse(). */
psc_result psc_build_ellipse_arcs(psc_sampler *sampler, const psc_technique *technique,
                                  double alpha, double beta);

/* The same by projected solid angle, for a receiver whose normal lies over the axis and `upwards`
   (any length) in the xy plane: planes through the line across both cut the cone in fibres, of
   which the highest, or the lowest, is the angle gap above the horizon. */
psc_result psc_build_ellipse_above(psc_sampler *sampler, double alpha, double beta,
                                   const double upwards[2], int lower, double gap);

/* The sample of psc_sample_f64(), as direction minus axis in the frame of the cone: accurate
   relative to the sines of the semi-arcs. */
void psc_sample_cone_offset_f64(const psc_sampler *sampler, double u, double v, double offset[3]);
void psc_sample_cone_offset_f32(const psc_sampler *sampler, float u, float v, float offset[3]);

#endif
