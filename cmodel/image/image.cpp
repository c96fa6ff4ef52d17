/* image.cpp - see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/image.h"

#include <cstdlib>
#include <cstring>
#include <memory>

#include "common/input.h"
#include "image/file.h"
#include "machine/layout.h"

namespace {

using namespace sph_picture;

const int amplify = 16;

/* Of a picture: three of the largest side by side, four bytes a pixel, not compressed; a head. */
const long long most_bytes = 12ll * SPH_MAX_SIDE * SPH_MAX_SIDE + (1 << 20);

} // namespace

int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err) {
    return guarded(path, err, [&] {
        std::size_t n = pixel_count(frame);
        std::vector<std::uint8_t> bytes(3 * n);
        for (std::size_t i = 0; i < n; i++)
            for (int c = 0; c < 3; c++)
                bytes[3 * i + static_cast<std::size_t>(c)] =
                    channel(frame->pixels[i].colour[layer], c);
        return write_bytes(path, frame->width, frame->height, bytes, nullptr, err);
    });
}

int sph_image_write_difference(const char *path, const struct sph_frame *a,
                               const struct sph_frame *b, int layer, struct sph_error *err) {
    if (a->width != b->width || a->height != b->height)
        return sph_fail(err, "%s: frames of %dx%d and %dx%d do not stand side by side", path,
                        a->width, a->height, b->width, b->height);
    return guarded(path, err, [&] {
        std::size_t w = static_cast<std::size_t>(a->width);
        std::vector<std::uint8_t> bytes(9 * pixel_count(a));
        for (std::size_t i = 0; i < pixel_count(a); i++) {
            const struct sph_pixel &p = a->pixels[i], &q = b->pixels[i];
            std::uint8_t *left = &bytes[(i / w * 3 * w + i % w) * 3];
            std::uint8_t *middle = left + 3 * w, *right = left + 6 * w;
            bool dark = true;
            for (int c = 0; c < 3; c++) {
                std::uint8_t l = channel(p.colour[layer], c), m = channel(q.colour[layer], c);
                left[c] = encode(l, SPH_TRANSFER_SRGB);
                middle[c] = encode(m, SPH_TRANSFER_SRGB);
                int by = amplify * std::abs(l - m);
                right[c] = static_cast<std::uint8_t>(by > 255 ? 255 : by);
                if (by) dark = false;
            }
            if (dark &&
                (p.id != q.id || p.key != q.key || p.visits != q.visits || p.texture != q.texture))
                right[2] = 255;
        }
        return write_bytes(path, 3 * a->width, a->height, bytes, nullptr, err);
    });
}

int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err) {
    *image = {};
    std::FILE *probe = sph_input_open(path, most_bytes, err); /* OpenImageIO takes any file */
    if (!probe) return -1;
    std::fclose(probe);
    return guarded(path, err, [&] {
        std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
        if (!in)
            return sph_fail(err, "%s: %s", path, reason(OIIO::geterror(), "not an image").c_str());
        const OIIO::ImageSpec &spec = in->spec();
        if (spec.format != OIIO::TypeUInt8)
            return sph_fail(err, "%s: channels are %s, not 8-bit", path, spec.format.c_str());
        if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
            return sph_fail(err, "%s: empty picture", path);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(spec.image_bytes()));
        if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, bytes.data()))
            return sph_fail(err, "%s: %s", path, reason(in->geterror(), "ends early").c_str());
        image->bytes = static_cast<std::uint8_t *>(std::malloc(bytes.size()));
        if (!image->bytes) return sph_fail(err, "%s: no memory for the picture", path);
        std::memcpy(image->bytes, bytes.data(), bytes.size());
        image->width = spec.width;
        image->height = spec.height;
        image->channels = spec.nchannels;
        return 0;
    });
}
