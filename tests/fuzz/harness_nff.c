/* harness_nff.c - scenes in NFF
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fuzz.h"

void fuzz_begin(const char *root) {
    (void)root;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_scene scene;
    struct sph_error err = {""};
    uint64_t choice = fuzz_hash(data, size);
    struct sph_read_options o = {.skip_unsupported = choice >> 60 & 1,
                                 .at = choice >> 61 & 1 ? 3 : 0};
    if (sph_scene_parse((const char *)data, size, "scene.nff", &o, &scene, &err)) {
        fuzz_message(&err, "scene.nff", 1);
        return;
    }
    fuzz_scene(&scene, choice);
    sph_scene_free(&scene);
}
