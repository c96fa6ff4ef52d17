/* trail.h - what the golden model tells of a pixel besides the pixel
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TRAIL_H
#define SPH_TRAIL_H

#include <stdint.h>

#include "machine/layout.h"

/* What the rays of a pixel met; no part of the frame, and the hardware does not tell it. */
struct sph_trail {
    uint32_t faced, blocked; /* bit l: light l of the machine shines on the side of the primary
                                hit that is seen; of these, no light comes through */
    uint32_t reflected_id;   /* found by the mirror ray of the primary hit, SPH_ID_NONE: nothing */
    uint32_t refracted_id;   /* by its refracted ray */
    int depth;               /* surfaces one after another that made the colour, at most; 0: none */
    uint32_t sum[SPH_FRAMES][3]; /* u8.8, what the pixel's colours are rounded from */
};

#endif
