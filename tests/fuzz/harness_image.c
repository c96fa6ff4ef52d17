/* harness_image.c - images as textures and as pictures to compare, through OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fuzz.h"
#include "image/image.h"
#include "image/texture.h"

void fuzz_begin(const char *root) {
    (void)root;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_mip mip;
    struct sph_image image;
    struct sph_error err = {""}, why = {""};
    fuzz_write("image", data, size);
    if (sph_mip_load("image", &mip, &err)) {
        fuzz_message(&err, "image", 0);
        if (mip.texels) fuzz_fail("refused, and something to free");
    } else {
        if (mip.width < 1 || mip.width > SPH_TEXTURE_SIDE || mip.height < 1 ||
            mip.height > SPH_TEXTURE_SIDE || mip.levels != sph_mip_levels(mip.width, mip.height))
            fuzz_fail("a chain of %d x %d, %d levels", mip.width, mip.height, mip.levels);
        sph_mip_free(&mip);
    }
    if (sph_image_read("image", &image, &why)) {
        fuzz_message(&why, "image", 0);
    } else {
        struct sph_image_difference d;
        if (sph_image_compare(&image, &image, &d)) fuzz_fail("differs from itself");
        sph_image_free(&image);
    }
}
