/* tb_shades.cpp - rt_shades against sph_render_pixel(): pixels of all units at once
 * SPDX-License-Identifier: Apache-2.0
 *
 * As tb_shade. What is more here: each hit, ray and record goes to the unit of its slot and nowhere
 * else, pixels that end take turns, and a colour comes from the unit that was asked.
 */
#include "Vrt_shades.h"

using Top = Vrt_shades;
#include "shade/shaded_pixels.h"

int main(int argc, char **argv) {
    Shade b("tb_shades", argc, argv, 1500);
    return run(b);
}
