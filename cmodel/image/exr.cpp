/* exr.cpp - pictures of light as OpenEXR; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <cstring>
#include <string>

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

/* Channels of all pixels. */
std::size_t light_count(const struct sph_linear *picture) {
    return 3 * static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
}

} // namespace

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
        for (std::size_t i = 0; i < sph_pixel_count(frame); i++) {
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
