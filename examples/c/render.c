/* render.c - a scene file, or one in memory, to a picture and counters
 * SPDX-License-Identifier: Apache-2.0
 *
 * cc render.c -o render $(pkg-config --cflags --libs sphaera)
 * ./render PICTURE.png [SCENE.nff]
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sphaera/sphaera.h>

static const char two_balls[] = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 64 48\n"
                                "b 0.1 0.2 0.3\n"
                                "l 4 6 8\n"
                                "f 0.9 0.3 0.2  0.7 0.3 10 0 1\n"
                                "s -1 0 0  1.2\n"
                                "f 0.3 0.8 0.4  0.7 0.3 10 0 1\n"
                                "s 1.4 0.4 -1  1\n";

int main(int argc, char **argv) {
    sphaera_error error = {""};
    sphaera_scene *scene = NULL;
    sphaera_machine *machine = NULL;
    sphaera_frame *frame = NULL;
    sphaera_build_options options;
    if (argc < 2) {
        fprintf(stderr, "usage: render PICTURE.png [SCENE.nff]\n");
        return 2;
    }
    sphaera_build_init(&options);
    options.profile = "standard";
    options.depth = 1;

    int bad = argc > 2 ? sphaera_scene_read(argv[2], 0, &scene, &error)
                       : sphaera_scene_parse(two_balls, strlen(two_balls), "two balls", 0, &scene,
                                             &error);
    if (!bad) bad = sphaera_build(scene, &options, &machine, &error);
    if (!bad) bad = sphaera_render(machine, 0, &frame, &error);
    if (!bad) bad = sphaera_frame_write(frame, argv[1], &error);
    if (bad) fprintf(stderr, "render: %s\n", error.text);
    if (!bad) {
        printf("%" PRIu32 " spheres, %dx%d\n", sphaera_scene_spheres(scene),
               sphaera_frame_width(frame), sphaera_frame_height(frame));
        printf("frame   %016" PRIx64 "\n", sphaera_frame_hash(frame));
        for (int i = 0; sphaera_counter_name(i); i++)
            if (sphaera_frame_counter(frame, i))
                printf("%-16s %" PRIu64 "\n", sphaera_counter_name(i),
                       sphaera_frame_counter(frame, i));
    }
    sphaera_frame_free(frame);
    sphaera_machine_free(machine);
    sphaera_scene_free(scene);
    return bad ? 1 : 0;
}
