/* SPDX-License-Identifier: Apache-2.0 */
/* The table of the tabulated map. */
#ifndef PSC_SRC_TABLE_H
#define PSC_SRC_TABLE_H

#include <psc/psc.h>

#define PSC_TABLE_MAGIC 0x74637370u
#define PSC_LEAST_RESOLUTION 2
#define PSC_MOST_RESOLUTION 1024

/*
 * Row i of n is for beta / alpha = (i + 1) / n. Its n + 1 numbers are the shares of the sectors up to
 * the azimuths j (pi / 2) / n in that of a quadrant: from 0 to 1, and rising, which in float they are up to
 * PSC_MOST_RESOLUTION.
 */
struct psc_table {
    uint32_t magic, resolution;
    float share[];
};

#endif
