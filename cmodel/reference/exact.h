/* exact.h - on which side of an edge a ray passes, exactly
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_EXACT_H
#define SPH_REFERENCE_EXACT_H

/* The sign of dir . ((p - org) x (q - org)), of these very doubles: -1, 0 or 1. Exchanging p and q
 * turns it over. */
int sph_ref_exact_side(const double org[3], const double dir[3], const double p[3],
                       const double q[3]);

#endif
