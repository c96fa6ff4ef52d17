/* harness_image.c - images as textures or as pictures to compare, through OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 *
 * The input decides which. What a header asks for is mostly refused by MORE bytes of memory, as to
 * clear a gigabyte takes a thousand times as long as to read an image; one input of 64 has all.
 */
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "common/number.h"
#include "fuzz.h"
#include "image/image.h"
#include "image/texture.h"

enum { MORE = 16 << 20, KEEP = 1 << 25 };

void __asan_init(void) __attribute__((weak)); /* it has a memory of its own */

/* OpenImageIO 2.4 leaves its reader of PNG by longjmp() where a file ends, and its text behind. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:PNGInput::PngReadCallback\n";
}

void fuzz_begin(const char *root) {
    (void)root;
}

static void texture(void) {
    struct sph_mip mip;
    struct sph_error err = {""};
    if (sph_mip_load("image", SPH_COLOURS_OF_FILE, &mip, &err)) {
        fuzz_message(&err, "image", 0);
        if (mip.texels) fuzz_fail("refused, and something to free");
        return;
    }
    if (mip.width < 1 || mip.width > SPH_TEXTURE_SIDE || mip.height < 1 ||
        mip.height > SPH_TEXTURE_SIDE || mip.levels != sph_mip_levels(mip.width, mip.height))
        fuzz_fail("a chain of %d x %d, %d levels", mip.width, mip.height, mip.levels);
    sph_mip_free(&mip);
}

static void picture(void) {
    struct sph_image image;
    struct sph_image_difference d;
    struct sph_error err = {""};
    if (sph_image_read("image", &image, &err)) {
        fuzz_message(&err, "image", 0);
        return;
    }
    if (sph_image_compare(&image, &image, &d)) fuzz_fail("differs from itself");
    sph_image_free(&image);
}

/* What this process has of data, once OpenImageIO has begun its threads. */
static rlim_t data_now(void) {
    static const char grey[] = "P2\n1 1\n255\n7\n";
    uint64_t kib = 0;
    char line[128];
    fuzz_write("image", (const uint8_t *)grey, sizeof grey - 1);
    texture();
    FILE *status = fopen("/proc/self/status", "r");
    while (status && !kib && fgets(line, sizeof line, status)) {
        const char *at = line + strcspn(line, "0123456789");
        if (!strncmp(line, "VmData:", 7)) sph_take_count(&at, 1, UINT64_MAX >> 10, &kib);
    }
    if (!status || !kib) exit(2);
    fclose(status);
    return (rlim_t)kib << 10;
}

/* all: as much as this process may have at most. */
static void allow(int all) {
    static rlim_t few;
    static int has_all = 1;
    struct rlimit data;
    if (__asan_init) return;
    if (!few) {
        mallopt(M_MMAP_THRESHOLD, KEEP); /* what is freed stays, so that it is not cleared again */
        mallopt(M_TRIM_THRESHOLD, KEEP);
        few = data_now() + MORE;
    }
    if (has_all == all) return;
    has_all = all;
    if (getrlimit(RLIMIT_DATA, &data)) exit(2);
    data.rlim_cur = all ? data.rlim_max : few;
    if (setrlimit(RLIMIT_DATA, &data)) exit(2);
}

void fuzz_one(const uint8_t *data, size_t size) {
    uint64_t choice = fuzz_hash(data, size);
    allow((choice >> 8 & 63) == 0);
    fuzz_write("image", data, size);
    if (choice & 1)
        texture();
    else
        picture();
}
