/* image.cpp - reading of pictures; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/image.h"

#include <cstdlib>
#include <memory>

#include "common/file.h"
#include "image/file.h"
#include "machine/layout.h"

namespace {

/* Of a picture: three of the largest side by side, four bytes a pixel, not compressed; a head. */
const int most_side = 3 * SPH_MAX_SIDE;
const long long most_bytes = 4ll * most_side * SPH_MAX_SIDE + (1 << 20);

} // namespace

int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err) {
    *image = {};
    std::FILE *probe = sph_input_open(path, most_bytes, err); /* OpenImageIO takes any file */
    if (!probe) return -1;
    std::fclose(probe);
    if (sph_picture::refuse_unsound(path, err)) return -1;
    return sph_picture::guarded(path, err, [&] {
        std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
        if (!in)
            return sph_fail(err, "%s: %s", path,
                            sph_picture::reason(OIIO::geterror(), "not an image").c_str());
        const OIIO::ImageSpec &spec = in->spec();
        if (spec.format != OIIO::TypeUInt8)
            return sph_fail(err, "%s: channels are %s, not 8-bit", path, spec.format.c_str());
        if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
            return sph_fail(err, "%s: empty picture", path);
        if (spec.width > most_side || spec.height > most_side ||
            spec.image_bytes() > static_cast<OIIO::imagesize_t>(most_bytes))
            return sph_fail(
                err, "%s: %d x %d pixels of %d bytes are more than three pictures of %d x %d", path,
                spec.width, spec.height, spec.nchannels, SPH_MAX_SIDE, SPH_MAX_SIDE);
        /* by calloc(), which clears no page of a large one before somebody writes there */
        std::unique_ptr<std::uint8_t, decltype(&std::free)> bytes(
            static_cast<std::uint8_t *>(
                std::calloc(static_cast<std::size_t>(spec.image_bytes()), 1)),
            std::free);
        if (!bytes) return sph_fail(err, "%s: no memory for the picture", path);
        if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, bytes.get()))
            return sph_fail(err, "%s: %s", path,
                            sph_picture::reason(in->geterror(), "ends early").c_str());
        image->width = spec.width;
        image->height = spec.height;
        image->channels = spec.nchannels;
        image->bytes = bytes.release();
        return 0;
    });
}
