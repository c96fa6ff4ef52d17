/* harness_frame.c - frame files; the checksum at their end is made right first
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "core/frame.h"
#include "fuzz.h"
#include "machine/format.h"

void fuzz_begin(const char *root) {
    (void)root;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_shot shot;
    struct sph_error err = {""};
    uint8_t *bytes = malloc(size + 1);
    if (!bytes) exit(2);
    memcpy(bytes, data, size);
    if (size > SPH_CHECKSUM_BYTES)
        sph_put64(bytes + size - SPH_CHECKSUM_BYTES,
                  sph_fnv_bytes(SPH_FNV_START, bytes, size - SPH_CHECKSUM_BYTES));
    fuzz_write("in.frame", bytes, size);
    if (sph_shot_read("in.frame", &shot, &err)) {
        fuzz_message(&err, "in.frame", 0);
    } else {
        if (sph_shot_write(&shot, "out.frame", &err)) fuzz_fail("not written: %s", err.text);
        fuzz_same("out.frame", bytes, size);
        fuzz_no_rest();
        sph_frame_free(&shot.frame);
    }
    free(bytes);
}
