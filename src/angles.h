/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Caps given by angles, and samples given as offsets from the axis.
 *
 * Not part of the interface: an axis vector in double moves the elevation of a cap by up to one
 * rounding, which changes the area of a thin lune by far more than that, and a unit vector holds
 * a direction inside a cap of half-angle a only to 1e-16 / a. Tests that compare with reference
 * values of such caps need both ends without that rounding.
 */
#ifndef PSC_SRC_ANGLES_H
#define PSC_SRC_ANGLES_H

#include <psc/psc.h>

/* Builds the sampler of a distant cap for a one-sided receiver at the origin with normal (0,0,1)
   and the axis (cos elevation, 0, sin elevation). half_angle in (0, pi/2], elevation in
   [-pi/2, pi/2]. Results as psc_build_cap(). */
psc_result psc_build_cap_angles(psc_sampler *sampler, const psc_technique *technique,
                                double half_angle, double elevation);

/* The sample of psc_sample_f64(), as direction minus axis in the frame of the above: accurate
   relative to the sine of the half-angle. */
void psc_sample_offset_f64(const psc_sampler *sampler, double u, double v, double offset[3]);
void psc_sample_offset_f32(const psc_sampler *sampler, float u, float v, float offset[3]);

#endif
