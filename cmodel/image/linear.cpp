/* linear.cpp - pictures of light: sums of samples, transfer curves, OpenEXR; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <OpenImageIO/color.h>

#include "core/trail.h"
#include "image/file.h"

namespace {

using namespace sph_picture;

const float white = 255;

/* Channels of 32 bits, as their names are listed; words: of one pixel. */
struct exr_channels {
    std::vector<std::string> names;
    std::vector<OIIO::TypeDesc> formats;
    std::vector<std::uint32_t> words;
    void real(const char *name, float value) { add(name, OIIO::TypeFloat, &value); }
    void whole(const char *name, std::uint32_t value) { add(name, OIIO::TypeUInt32, &value); }

  private:
    void add(const char *name, OIIO::TypeDesc format, const void *value) {
        names.emplace_back(name);
        formats.push_back(format);
        words.resize(words.size() + 1);
        std::memcpy(&words.back(), value, sizeof words.back());
    }
};

/* Z is OpenEXR's name of depth; layers are named LAYER.CHANNEL, as compositing programs split them.
 */
void channels_of(exr_channels &to, const float *rgb, const struct sph_pixel &p,
                 const struct sph_layer *layer) {
    to.real("R", rgb[0] / white);
    to.real("G", rgb[1] / white);
    to.real("B", rgb[2] / white);
    to.whole("id", p.id);
    to.whole("key.hi", static_cast<std::uint32_t>(p.key >> 32));
    to.whole("key.lo", static_cast<std::uint32_t>(p.key));
    to.whole("visits", p.visits);
    to.whole("texture", p.texture);
    if (!layer) return;
    to.real("Z", layer->depth);
    to.real("N.X", layer->normal[0]);
    to.real("N.Y", layer->normal[1]);
    to.real("N.Z", layer->normal[2]);
    to.real("albedo.R", layer->albedo[0]);
    to.real("albedo.G", layer->albedo[1]);
    to.real("albedo.B", layer->albedo[2]);
    to.real("level", layer->level);
}

/* The light of a pixel's channel, u8.8: what its byte is rounded from, if that is known. */
std::uint32_t light(const struct sph_frame *frame, const struct sph_trail *trails, std::size_t at,
                    int layer, int c) {
    return trails ? trails[at].sum[layer][c] : 256u * channel(frame->pixels[at].colour[layer], c);
}

/* Channels of all pixels. */
std::size_t light_count(const struct sph_linear *picture) {
    return 3 * static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
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

int sph_linear_bytes(const struct sph_linear *picture, int transfer, std::uint8_t *bytes,
                     struct sph_error *err) {
    return guarded("a picture", err, [&] {
        std::size_t n = light_count(picture);
        for (std::size_t i = 0; i < n; i++)
            bytes[i] = encode(picture->rgb[i], transfer);
        return 0;
    });
}

int sph_linear_write(const char *path, const struct sph_linear *picture, int transfer,
                     struct sph_error *err) {
    return guarded(path, err, [&] {
        std::vector<std::uint8_t> bytes(light_count(picture));
        if (sph_linear_bytes(picture, transfer, bytes.data(), err)) return -1;
        const char *space = transfer == SPH_TRANSFER_SRGB ? "sRGB" : "Linear";
        return write_bytes(path, picture->width, picture->height, bytes, space, err);
    });
}

int sph_linear_write_exr(const char *path, const struct sph_linear *picture,
                         const struct sph_frame *frame, const struct sph_layer *layers,
                         struct sph_error *err) {
    bool whole = frame->width == picture->width && frame->height == picture->height;
    return guarded(path, err, [&] {
        OIIO::ImageSpec spec(picture->width, picture->height, 3, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B"};
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", no_time);
        if (!whole) {
            std::vector<float> rgb(picture->rgb, picture->rgb + light_count(picture));
            for (float &light : rgb)
                light /= white;
            return write_file(path, "openexr", spec, rgb.data(), err);
        }
        std::vector<std::uint32_t> words;
        for (std::size_t i = 0; i < pixel_count(frame); i++) {
            exr_channels pixel;
            channels_of(pixel, &picture->rgb[3 * i], frame->pixels[i],
                        layers ? &layers[i] : nullptr);
            words.insert(words.end(), pixel.words.begin(), pixel.words.end());
            if (i) continue;
            spec.nchannels = static_cast<int>(pixel.names.size());
            spec.channelnames = pixel.names;
            spec.channelformats = pixel.formats;
        }
        return write_file(path, "openexr", spec, words.data(), err);
    });
}
