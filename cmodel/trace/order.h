/* order.h - which of the four children of a node a ray visits first
 * SPDX-License-Identifier: Apache-2.0
 *
 * The one place of the order in the model, literal and fast; in the RTL it is the depth that
 * rt_traverse.v gives to rt_sort. docs/design/extending.md tells how to try another one.
 */
#ifndef SPH_ORDER_H
#define SPH_ORDER_H

#include <stdint.h>

/* The vector walks of cmodel/fast have the order below in instructions of their own. 0: another
 * one, so that sph_fast_new() takes the walks that ask sph_child_depth(). */
enum { SPH_ORDER_IN_LANES = 1 };

/* The depth, s16, by which child 0..3 of a node waits: the least is visited first, equal ones as
 * the node has them, and what is deeper than the ray's best hit is left out. near: least depth that
 * the child reaches; any: any hit ends the ray (shadow rays, effect FIRST), which then takes
 * children as the node has them and leaves none out. */
static inline int32_t sph_child_depth(int any, int32_t near, int child) {
    (void)child;
    return any ? INT16_MIN : near;
}

#endif
