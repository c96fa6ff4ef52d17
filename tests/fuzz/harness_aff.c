/* harness_aff.c - scenes in AFF; behind a line of three % stands a second file, more.aff
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"
#include "scene/aff.h"

static const char cut[] = "\n%%%\n";
enum { CUT = sizeof cut - 1 };

static int linked;

void fuzz_begin(const char *root) {
    (void)root;
    unlink("more.aff");
}

/* more.aff is a name of a file that stays open (fuzz_write()), or there is none. */
static void put_more(const uint8_t *data, size_t size) {
    if (data) fuzz_write("part", data, size);
    if (data && !linked && link("part", "more.aff")) exit(2);
    if (!data && linked) unlink("more.aff");
    linked = data != NULL;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_scene scene;
    struct sph_error err = {""};
    uint64_t choice = fuzz_hash(data, size);
    struct sph_read_options o = {.at = choice >> 61 & 1 ? 3 : 0,
                                 .timed = choice >> 62 & 1,
                                 .time = (double)(choice >> 40 & 255) / 100};
    const uint8_t *more = memmem(data, size, cut, CUT);
    size_t first = more ? (size_t)(more - data) : size;
    fuzz_write("scene.aff", data, first);
    put_more(more ? more + CUT : NULL, more ? size - first - CUT : 0);
    if (sph_scene_read("scene.aff", &o, &scene, &err)) {
        fuzz_message(&err, strncmp(err.text, "more.aff", 8) ? "scene.aff" : "more.aff", 1);
        return;
    }
    fuzz_scene(&scene, choice);
    sph_scene_free(&scene);
}
