/* tb_leaf_units.cpp - rt_leaf_units against sph_leaf_visit(): visits of all pipes at once
 * SPDX-License-Identifier: Apache-2.0
 *
 * As tb_leaf_unit. What is more here: pipes take turns at their leaf unit and shading units ask one
 * for records; a result or a record comes from the unit of its slot, for nobody else.
 */
#include "Vrt_leaf_units.h"

using Top = Vrt_leaf_units;
#include "trace/leaf_visits.h"

int main(int argc, char **argv) {
    LeafVisits b("tb_leaf_units", argc, argv, 12000);
    return run(b);
}
