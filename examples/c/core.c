/* core.c - all that a bench of one's own needs of a machine, out of memory
 * SPDX-License-Identifier: Apache-2.0
 *
 * cc core.c -o core $(pkg-config --cflags --libs sphaera)
 * ./core SCENE.nff     registers, memory, parameters, counters; stages of the middle pixel
 */
#include <inttypes.h>
#include <stdio.h>

#include <sphaera/sphaera.h>

static void put_core(const sphaera_machine *machine, const sphaera_frame *frame) {
    sphaera_parameter parameter;
    uint32_t lines;
    const int32_t *registers = sphaera_machine_registers(machine);
    const uint32_t *memory = sphaera_machine_memory(machine, &lines);
    printf("core %s:", sphaera_machine_core(machine));
    for (int i = 0; !sphaera_machine_parameter(machine, i, &parameter); i++)
        printf(" %s=%d", parameter.name, parameter.value);
    printf("\n");
    for (int i = 0; i < sphaera_registers(); i++)
        if (sphaera_register_name(i) && registers[i])
            printf("register %s %d\n", sphaera_register_name(i), registers[i]);
    printf("memory %" PRIu32 " lines, the first %08" PRIx32 "...%08" PRIx32 "\n", lines, memory[7],
           memory[0]);
    for (int i = 0; sphaera_counter_name(i); i++)
        if (sphaera_counter_exact(i))
            printf("expect %s %" PRIu64 "\n", sphaera_counter_name(i),
                   sphaera_frame_counter(frame, i));
}

static void put_stages(sphaera_pixel *pixel) {
    sphaera_stage stage;
    sphaera_operand operand;
    for (int i = 0; !sphaera_pixel_stage(pixel, i, &stage); i++) {
        printf("ray %d stage %s:", stage.ray, stage.name);
        for (int k = 0; !sphaera_pixel_operand(pixel, i, k, &operand); k++)
            printf(" %s %" PRIx64 " (%d bits, %g)", operand.name, operand.low, operand.bits,
                   operand.value);
        printf("\n");
    }
}

int main(int argc, char **argv) {
    sphaera_error error = {""};
    sphaera_scene *scene = NULL;
    sphaera_machine *machine = NULL;
    sphaera_frame *frame = NULL;
    sphaera_pixel *pixel = NULL;
    if (argc != 2) {
        fprintf(stderr, "usage: core SCENE.nff\n");
        return 2;
    }
    int bad = sphaera_scene_read(argv[1], 0, &scene, &error) ||
              sphaera_build(scene, NULL, &machine, &error) ||
              sphaera_render(machine, 0, &frame, &error) ||
              sphaera_pixel_trace(machine, sphaera_machine_width(machine) / 2,
                                  sphaera_machine_height(machine) / 2, &pixel, &error);
    if (bad) fprintf(stderr, "core: %s\n", error.text);
    if (!bad) put_core(machine, frame);
    if (!bad) put_stages(pixel);
    sphaera_pixel_free(pixel);
    sphaera_frame_free(frame);
    sphaera_machine_free(machine);
    sphaera_scene_free(scene);
    return bad ? 1 : 0;
}
