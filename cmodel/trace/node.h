/* node.h - reads the words of a tree node                        layout: machine/machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NODE_H
#define SPH_NODE_H

#include "machine/machine.h"
#include "trace/filter.h"

static inline struct sph_child sph_child_read(const uint32_t *line, int i) {
    int at = i * SPH_CHILD_STRIDE;
    return (struct sph_child){
        {sph_field_signed(line, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS)},
        (int32_t)sph_field(line, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS)};
}

#endif
