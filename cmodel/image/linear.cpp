/* linear.cpp - pictures of light: sums of samples, transfer curves, OpenEXR; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <cmath>
#include <cstdlib>

#include <OpenImageIO/color.h>

#include "core/trail.h"
#include "image/file.h"

namespace {

using namespace sph_picture;

const float white = 255;

struct exr_pixel {
    float rgb[3];
    std::uint32_t id, key_hi, key_lo, visits, texture;
};
static_assert(sizeof(exr_pixel) == 32, "channels lie side by side");

/* The light of a pixel's channel, u8.8: what its byte is rounded from, if that is known. */
std::uint32_t light(const struct sph_frame *frame, const struct sph_trail *trails, std::size_t at,
                    int layer, int c) {
    return trails ? trails[at].sum[layer][c] : 256u * channel(frame->pixels[at].colour[layer], c);
}

} // namespace

std::uint8_t sph_picture::encode(float light, int transfer) {
    if (transfer == SPH_TRANSFER_SRGB) light = white * OIIO::linear_to_sRGB(light / white);
    return static_cast<std::uint8_t>(std::floor((light < white ? light : white) + 0.5f));
}

int sph_linear_of(const struct sph_frame *frame, const struct sph_trail *trails, int layer,
                  int samples, struct sph_linear *out, struct sph_error *err) {
    if (samples < 1 || frame->width % samples || frame->height % samples)
        return sph_fail(err, "a frame of %dx%d has no whole pixels of %d x %d samples",
                        frame->width, frame->height, samples, samples);
    *out = {frame->width / samples, frame->height / samples, nullptr};
    std::size_t w = static_cast<std::size_t>(frame->width), n = static_cast<std::size_t>(samples);
    std::size_t columns = w / n, pixels = pixel_count(frame) / (n * n);
    out->rgb = static_cast<float *>(std::malloc(3 * pixels * sizeof *out->rgb));
    if (!out->rgb)
        return sph_fail(err, "no memory for a picture of %dx%d", out->width, out->height);
    for (std::size_t i = 0; i < 3 * pixels; i++) {
        std::size_t corner = i / 3 / columns * n * w + i / 3 % columns * n;
        std::uint64_t sum = 0;
        for (std::size_t k = 0; k < n * n; k++)
            sum += light(frame, trails, corner + k / n * w + k % n, layer, static_cast<int>(i % 3));
        double mean = static_cast<double>(sum) / static_cast<double>(n * n) / 256;
        out->rgb[i] = mean < white ? static_cast<float>(mean) : white;
    }
    return 0;
}

void sph_linear_free(struct sph_linear *picture) {
    std::free(picture->rgb);
    *picture = {};
}

int sph_linear_write(const char *path, const struct sph_linear *picture, int transfer,
                     struct sph_error *err) {
    return guarded(path, err, [&] {
        std::size_t n = 3 * static_cast<std::size_t>(picture->width) *
                        static_cast<std::size_t>(picture->height);
        std::vector<std::uint8_t> bytes(n);
        for (std::size_t i = 0; i < n; i++)
            bytes[i] = encode(picture->rgb[i], transfer);
        const char *space = transfer == SPH_TRANSFER_SRGB ? "sRGB" : "Linear";
        return write_bytes(path, picture->width, picture->height, bytes, space, err);
    });
}

int sph_linear_write_exr(const char *path, const struct sph_linear *picture,
                         const struct sph_frame *frame, struct sph_error *err) {
    bool whole = frame->width == picture->width && frame->height == picture->height;
    return guarded(path, err, [&] {
        OIIO::ImageSpec spec(picture->width, picture->height, whole ? 8 : 3, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B"};
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", no_time);
        if (!whole) {
            std::size_t n = 3 * static_cast<std::size_t>(picture->width) *
                            static_cast<std::size_t>(picture->height);
            std::vector<float> rgb(picture->rgb, picture->rgb + n);
            for (float &light : rgb)
                light /= white;
            return write_file(path, "openexr", spec, rgb.data(), err);
        }
        std::vector<exr_pixel> pixels(pixel_count(frame));
        for (std::size_t i = 0; i < pixels.size(); i++) {
            const struct sph_pixel &p = frame->pixels[i];
            for (std::size_t c = 0; c < 3; c++)
                pixels[i].rgb[c] = picture->rgb[3 * i + c] / white;
            pixels[i].id = p.id;
            pixels[i].key_hi = static_cast<std::uint32_t>(p.key >> 32);
            pixels[i].key_lo = static_cast<std::uint32_t>(p.key);
            pixels[i].visits = p.visits;
            pixels[i].texture = p.texture;
        }
        spec.channelnames = {"R", "G", "B", "id", "key.hi", "key.lo", "visits", "texture"};
        spec.channelformats.assign(3, OIIO::TypeFloat);
        spec.channelformats.resize(8, OIIO::TypeUInt32);
        return write_file(path, "openexr", spec, pixels.data(), err);
    });
}
