/* tb_pipes.cpp - rt_pipes against sph_traverse(): rays of all pipes at once
 * SPDX-License-Identifier: Apache-2.0
 *
 * As tb_trace. What is more here: each ray stays in the pipe of its slot, results come from each
 * leaf unit and shadow rays from each shading unit in one clock, and rays that are done take turns.
 */
#include "Vrt_pipes.h"

using Top = Vrt_pipes;
#include "trace/traced_rays.h"

int main(int argc, char **argv) {
    Trace b("tb_pipes", argc, argv, 6000);
    return run(b);
}
