/* tb_shade.cpp - rt_shade, with all that is inside, against sph_render_pixel()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_shade.h"

using Top = Vrt_shade;
#include "shade/shaded_pixels.h"

int main(int argc, char **argv) {
    Shade b("tb_shade", argc, argv, 4000);
    return run(b);
}
