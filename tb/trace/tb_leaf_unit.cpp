/* tb_leaf_unit.cpp - rt_leaf_unit, leaf cache, tests and roots, against sph_leaf_visit()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_leaf_unit.h"

using Top = Vrt_leaf_unit;
#include "trace/leaf_visits.h"

int main(int argc, char **argv) {
    LeafVisits b("tb_leaf_unit", argc, argv, 50000);
    return run(b);
}
