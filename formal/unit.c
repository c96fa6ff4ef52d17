/* unit.c - proof for every argument: inverse square roots lie where docs/design/traversal.md needs
 * them
 * SPDX-License-Identifier: Apache-2.0
 *
 * y^2 (x + 1) <= 2^50 for every x of the table: so y times the square root of any number below
 * x + 1 is at most 2^25, and no unit vector is longer than 1 before its rounding. And
 * (y + RSQRT_ERROR)^2 x >= 2^50 with y >= 2^16: what the depth of a key needs.
 *
 * Exit: 0 all hold, 1 one does not.
 */
#include <stdio.h>

#include "machine/layout.h"
#include "math/arith.h"

int main(void) {
    for (uint32_t x = 1 << 16; x < 1 << 18; x++) {
        uint64_t y = sph_rsqrt(x), high = y + SPH_RSQRT_ERROR;
        if (y >= 1 << 16 && y < 1 << 17 && y * y * (x + 1) <= 1ull << 50 &&
            high * high * x >= 1ull << 50)
            continue;
        printf("fails: y of %u is %llu\n", x, (unsigned long long)y);
        return 1;
    }
    return 0;
}
