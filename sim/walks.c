/* walks.c - the fast walks of this processor against the literal one: make neon
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: walks MACHINE.sph...      each frame literally, by the best lanes, by plain ones, and both
 * in packets: pixels and counters, errors. Needs of the model no library, so that it is compiled
 * for processors that are not here.
 */
#include <stdio.h>
#include <string.h>

#include "render/render.h"
#include "fast/fast.h"
#include "machine/machine.h"
#include "drawn.h"

/* Pixels that differ; -1 if counters or errors do. */
static int differ(const struct sph_machine *m, int lanes, int traverse, char *name, size_t room) {
    struct sph_fast *fast = sph_fast_new(m, lanes);
    struct sph_render_options how = {.traverse = traverse, .threads = 1, .fast = fast};
    struct sph_render_options literal = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    struct sph_frame frame, expected;
    struct sph_counters c = {{0}}, c_expected = {{0}};
    struct sph_error err = {{0}};
    int errors = sph_render(m, &literal, &expected, &c_expected, &err), wrong = 0;
    if (!fast || sph_render(m, &how, &frame, &c, &err) != errors) return -1;
    snprintf(name, room, "%s%s", sph_fast_lanes(fast),
             traverse == SPH_TRAVERSE_PACKETS ? " in packets" : "");
    if (traverse == SPH_TRAVERSE_PACKETS) untell(&expected, &c_expected);
    for (int i = 0; i < frame.width * frame.height; i++)
        wrong += memcmp(&frame.pixels[i], &expected.pixels[i], sizeof *frame.pixels) != 0;
    if (memcmp(&c, &c_expected, sizeof c) != 0) wrong = -1;
    sph_frame_free(&frame);
    sph_frame_free(&expected);
    sph_fast_free(fast);
    return wrong;
}

int main(int argc, char **argv) {
    int failed = 0;
    for (int i = 1; i < argc; i++) {
        struct sph_error err = {{0}};
        struct sph_machine m;
        const char *name = strrchr(argv[i], '/');
        printf("%-24s", name ? name + 1 : argv[i]);
        if (sph_machine_read(argv[i], &m, &err)) {
            printf(" %s\n", err.text);
            return 1;
        }
        for (int lanes = SPH_FAST_BEST; lanes <= SPH_FAST_PLAIN; lanes++)
            for (int packets = 0; packets < 2; packets++) {
                char way[64] = "no walk";
                int wrong = differ(&m, lanes, packets ? SPH_TRAVERSE_PACKETS : SPH_TRAVERSE_FAST,
                                   way, sizeof way);
                printf(", %s: %s" + (!lanes && !packets), way,
                       !wrong      ? "same"
                       : wrong < 0 ? "COUNTERS"
                                   : "DIFFERENT");
                failed += wrong != 0;
            }
        printf("\n");
        sph_machine_free(&m);
    }
    printf("%d machines, %d differences\n", argc - 1, failed);
    return argc < 2 || failed;
}
