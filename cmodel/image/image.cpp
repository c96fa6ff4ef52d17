/* image.cpp - see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/image.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <strings.h>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "common/input.h"
#include "common/output.h"
#include "machine/layout.h"

namespace {

const int amplify = 16;
const char *const no_time = "1970:01:01 00:00:00"; /* the same frame, the same bytes */

/* Endings of names and what OpenImageIO calls their formats. */
const struct {
    const char *ending, *format;
} formats[] = {{"png", "png"}, {"tif", "tiff"},  {"tiff", "tiff"},  {"ppm", "pnm"},
               {"bmp", "bmp"}, {"tga", "targa"}, {"exr", "openexr"}};

/* Of a picture: three of the largest side by side, four bytes a pixel, not compressed; a head. */
const long long most_bytes = 12ll * SPH_MAX_SIDE * SPH_MAX_SIDE + (1 << 20);

/* Writes pixels, native in the spec's formats, to path as a file of kind format. The file is made
 * in memory first: OpenImageIO's writers do not report a full disk. */
int write_file(const char *path, const char *format, const OIIO::ImageSpec &spec,
               const void *pixels, struct sph_error *err) {
    std::unique_ptr<OIIO::ImageOutput> image = OIIO::ImageOutput::create(format);
    if (!image)
        return sph_fail(err, "%s: OpenImageIO writes no %s: %s", path, format,
                        OIIO::geterror().c_str());
    OIIO::Filesystem::IOVecOutput memory;
    bool good = image->set_ioproxy(&memory) && image->open(path, spec) &&
                image->write_image(OIIO::TypeUnknown, pixels) && image->close();
    if (!good) return sph_fail(err, "%s: %s", path, image->geterror().c_str());
    struct sph_output out;
    if (sph_output_open(&out, path, err)) return -1;
    const std::vector<unsigned char> &bytes = memory.buffer();
    std::fwrite(bytes.data(), 1, bytes.size(), out.file);
    return sph_output_close(&out, 0, err);
}

/* Bytes, 8-bit RGB, into a file of the format of its name. */
int write_bytes(const char *path, int width, int height, const std::vector<std::uint8_t> &bytes,
                struct sph_error *err) {
    const char *format = sph_image_format(path, err);
    if (!format) return -1;
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    if (!std::strcmp(format, "tiff")) spec.attribute("DateTime", no_time);
    return write_file(path, format, spec, bytes.data(), err);
}

/* No exception leaves the C interface. */
template <class Work> int guarded(const char *path, struct sph_error *err, Work work) {
    try {
        return work();
    } catch (const std::exception &e) {
        return sph_fail(err, "%s: %s", path, e.what());
    }
}

std::uint8_t channel(std::uint32_t colour, int c) {
    return static_cast<std::uint8_t>(colour >> 8 * c & 255);
}

std::size_t pixel_count(const struct sph_frame *frame) {
    return static_cast<std::size_t>(frame->width) * static_cast<std::size_t>(frame->height);
}

struct exr_pixel {
    float rgb[3];
    std::uint32_t id, key_hi, key_lo, visits, texture;
};
static_assert(sizeof(exr_pixel) == 32, "channels lie side by side");

} // namespace

const char *sph_image_format(const char *path, struct sph_error *err) {
    const char *slash = std::strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = *name ? std::strrchr(name + 1, '.') : nullptr; /* .. is a folder */
    if (!dot) return formats[0].format;
    std::string endings;
    for (const auto &f : formats) {
        if (!strcasecmp(dot + 1, f.ending)) return f.format;
        endings += std::string(endings.empty() ? "" : ", ") + f.ending;
    }
    sph_fail(err, "%s: no picture is written as %s; endings are %s", path, dot, endings.c_str());
    return nullptr;
}

int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err) {
    return guarded(path, err, [&] {
        std::size_t n = pixel_count(frame);
        std::vector<std::uint8_t> bytes(3 * n);
        for (std::size_t i = 0; i < n; i++)
            for (int c = 0; c < 3; c++)
                bytes[3 * i + static_cast<std::size_t>(c)] =
                    channel(frame->pixels[i].colour[layer], c);
        return write_bytes(path, frame->width, frame->height, bytes, err);
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
                left[c] = channel(p.colour[layer], c);
                middle[c] = channel(q.colour[layer], c);
                int by = amplify * std::abs(left[c] - middle[c]);
                right[c] = static_cast<std::uint8_t>(by > 255 ? 255 : by);
                if (by) dark = false;
            }
            if (dark &&
                (p.id != q.id || p.key != q.key || p.visits != q.visits || p.texture != q.texture))
                right[2] = 255;
        }
        return write_bytes(path, 3 * a->width, a->height, bytes, err);
    });
}

int sph_image_write_exr(const char *path, const struct sph_frame *frame, int layer,
                        struct sph_error *err) {
    return guarded(path, err, [&] {
        std::vector<exr_pixel> pixels(pixel_count(frame));
        for (std::size_t i = 0; i < pixels.size(); i++) {
            const struct sph_pixel &p = frame->pixels[i];
            for (int c = 0; c < 3; c++)
                pixels[i].rgb[c] = static_cast<float>(channel(p.colour[layer], c)) / 255.0f;
            pixels[i].id = p.id;
            pixels[i].key_hi = static_cast<std::uint32_t>(p.key >> 32);
            pixels[i].key_lo = static_cast<std::uint32_t>(p.key);
            pixels[i].visits = p.visits;
            pixels[i].texture = p.texture;
        }
        OIIO::ImageSpec spec(frame->width, frame->height, 8, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B", "id", "key.hi", "key.lo", "visits", "texture"};
        spec.channelformats.assign(3, OIIO::TypeFloat);
        spec.channelformats.resize(8, OIIO::TypeUInt32);
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", no_time);
        return write_file(path, "openexr", spec, pixels.data(), err);
    });
}

int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err) {
    *image = {};
    std::FILE *probe = sph_input_open(path, most_bytes, err); /* OpenImageIO takes any file */
    if (!probe) return -1;
    std::fclose(probe);
    return guarded(path, err, [&] {
        std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
        if (!in) return sph_fail(err, "%s: %s", path, OIIO::geterror().c_str());
        const OIIO::ImageSpec &spec = in->spec();
        if (spec.format != OIIO::TypeUInt8)
            return sph_fail(err, "%s: channels are %s, not 8-bit", path, spec.format.c_str());
        if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
            return sph_fail(err, "%s: empty picture", path);
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(spec.image_bytes()));
        if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, bytes.data()))
            return sph_fail(err, "%s: %s", path, in->geterror().c_str());
        image->bytes = static_cast<std::uint8_t *>(std::malloc(bytes.size()));
        if (!image->bytes) return sph_fail(err, "%s: no memory for the picture", path);
        std::memcpy(image->bytes, bytes.data(), bytes.size());
        image->width = spec.width;
        image->height = spec.height;
        image->channels = spec.nchannels;
        return 0;
    });
}

void sph_image_free(struct sph_image *image) {
    std::free(image->bytes);
    *image = {};
}

int sph_image_compare(const struct sph_image *a, const struct sph_image *b,
                      struct sph_image_difference *d) {
    *d = {0, 0, -1, -1, 0};
    if (a->width != b->width || a->height != b->height || a->channels != b->channels)
        return d->size_differs = 1;
    std::size_t at = 0;
    for (int y = 0; y < a->height; y++)
        for (int x = 0; x < a->width; x++) {
            bool differs = false;
            for (int c = 0; c < a->channels; c++, at++) {
                int by = std::abs(a->bytes[at] - b->bytes[at]);
                if (by) differs = true;
                if (static_cast<std::uint32_t>(by) > d->max_byte)
                    d->max_byte = static_cast<std::uint32_t>(by);
            }
            if (differs && !d->pixels++) {
                d->x = x;
                d->y = y;
            }
        }
    return d->pixels != 0;
}
