/* repeat.c - what the library says of a scene, every bit of it, as text; see test_repeat.sh
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "sphaera/sphaera.h"

static void must(int rc, const sphaera_error *e) {
    if (!rc) return;
    fprintf(stderr, "%s\n", e->text);
    exit(1);
}

int main(int argc, char **argv) {
    sphaera_error e;
    sphaera_scene *scene;
    sphaera_machine *machine;
    sphaera_frame *frame;
    sphaera_price *price;
    sphaera_build_options options;
    sphaera_price_row row;
    uint32_t lines;
    if (argc != 2) return 2;
    sphaera_build_init(&options);
    options.width = 40, options.height = 30;
    must(sphaera_scene_read(argv[1], 0, &scene, &e), &e);
    must(sphaera_build(scene, &options, &machine, &e), &e);
    printf("%s\n%s\n", sphaera_machine_why(machine), sphaera_machine_core(machine));
    const uint32_t *memory = sphaera_machine_memory(machine, &lines);
    for (uint32_t i = 0; i < 8 * lines; i++)
        printf("%08" PRIx32 "\n", memory[i]);
    for (int i = 0; i < sphaera_registers(); i++)
        printf("%" PRId32 "\n", sphaera_machine_registers(machine)[i]);
    must(sphaera_render(machine, 3, &frame, &e), &e);
    printf("frame %016" PRIx64 "\n", sphaera_frame_hash(frame));
    for (int i = 0; sphaera_counter_name(i); i++)
        printf("%s %" PRIu64 "\n", sphaera_counter_name(i), sphaera_frame_counter(frame, i));
    for (int i = 0; i < 20; i++) {
        double origin[3] = {0.5 * i, 3, 40}, direction[3] = {-0.1 * i, -0.3, -4};
        sphaera_hit hit;
        if (sphaera_trace(machine, origin, direction, &hit, &e))
            printf("%s\n", e.text);
        else
            printf("%" PRIu32 " %" PRIu64 " %a %a %a %a\n", hit.id, hit.key, hit.distance,
                   hit.point[0], hit.point[1], hit.point[2]);
    }
    must(sphaera_price_measure(scene, &options, 0, 0, 0, &price, &e), &e);
    for (int i = 0; !sphaera_price_get(price, i, &row); i++)
        printf("%s %a %a %a %" PRIu64 " %a %d\n", row.name, row.psnr, row.psnr_expected,
               row.wrong_most, row.wrong, row.cycles_per_pixel, row.keeps);
    sphaera_price_free(price);
    sphaera_frame_free(frame);
    sphaera_machine_free(machine);
    sphaera_scene_free(scene);
    return 0;
}
