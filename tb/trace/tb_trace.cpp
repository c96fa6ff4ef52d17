/* tb_trace.cpp - rt_trace against sph_traverse(), or with ACCEL against sph_bih_walk()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_trace.h"

using Top = Vrt_trace;
#include "trace/traced_rays.h"

int main(int argc, char **argv) {
    Trace b("tb_trace", argc, argv, 20000);
    return run(b);
}
