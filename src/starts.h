/* SPDX-License-Identifier: Apache-2.0 */
/* Written by starts.py: do not edit. */
#ifndef PSC_SRC_STARTS_H
#define PSC_SRC_STARTS_H

/* Lunes: the two coefficients of the start, of share^2 and 1 - a1 (lune_map.h). The start is
   within 1.5e-03 of the distance from the tip. */
#define PSC_LUNE_0(s, e) \
    ((-0.01615 + (e) * (0.20029 + (e) * (0.20872 + (e) * (-0.62880 + (e) * -6.76004)))) + (s) * \
    ((0.20021 + (e) * (-1.60896 + (e) * (0.14898 + (e) * 0.43938))) + (s) * \
    ((1.40472 + (e) * (0.34666 + (e) * 2.97225)) + (s) * \
    ((-3.15301 + (e) * -0.23495) + (s) * \
    1.67756))))
#define PSC_LUNE_1(s, e) \
    ((0.01698 + (e) * (0.28859 + (e) * (-0.01800 + (e) * (-3.43529 + (e) * 11.03463)))) + (s) * \
    ((-0.39192 + (e) * (1.84470 + (e) * (3.78889 + (e) * -8.80089))) + (s) * \
    ((-0.93098 + (e) * (-3.62053 + (e) * 1.12300)) + (s) * \
    ((3.29105 + (e) * 0.74072) + (s) * \
    -2.10285))))

/* Ellipse and lune: the coefficients of y^2, y^4 and y^6 in the start for Kepler's equation, of m
   and psi_l^2 (radial_map_tmpl.h). The start is within 8.8e-04. */
#define PSC_KEPLER_0(m, z) \
    ((0.16636 + (m) * -4.23373) + (z) * -0.11993)
#define PSC_KEPLER_1(m, z) \
    ((-0.86438 + (m) * 6.83223) + (z) * 0.24374)
#define PSC_KEPLER_2(m, z) \
    ((0.61750 + (m) * -4.01423) + (z) * -0.18013)

#endif
