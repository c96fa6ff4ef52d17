/* texture.cpp - see texture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/texture.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "common/file.h"
#include "common/number.h"
#include "image/file.h"

namespace {

enum { CHANNELS = 4 };

/* Of an image: four floats a texel, not compressed, and a head. */
const long long MOST_BYTES = 16ll * SPH_TEXTURE_SIDE * SPH_TEXTURE_SIDE + (1 << 20);

/* 0 .. 1 to 0 .. 255, to nearest; what is no number is 0. */
std::uint32_t byte(float v) {
    return v > 0 ? static_cast<std::uint32_t>(std::lround(255.0 * std::fmin(v, 1))) : 0;
}

/* Rounds a level of four channels to texels. */
int put_level(const OIIO::ImageBuf &level, std::uint32_t *texels) {
    const OIIO::ImageSpec &spec = level.spec();
    std::vector<float> v(static_cast<std::size_t>(spec.image_pixels()) * CHANNELS);
    if (!level.get_pixels(OIIO::ROI::All(), OIIO::TypeFloat, v.data())) return -1;
    for (std::size_t i = 0; i < v.size(); i += CHANNELS) {
        texels[i / CHANNELS] = 0;
        for (std::size_t c = 0; c < CHANNELS; c++)
            texels[i / CHANNELS] |= byte(v[i + c]) << (8 * c);
    }
    return 0;
}

/* Where an image is: a file, or "file#first+bytes" for a part of one, as GLB files hold them. */
struct place {
    std::string file;
    unsigned long long first = 0, bytes = 0; /* bytes 0: the whole file */
};

place place_of(const char *path) {
    place p{path};
    const char *mark = std::strrchr(path, '#'), *at = mark ? mark + 1 : path;
    std::uint64_t first = 0, bytes = 0;
    if (!mark || sph_take_count(&at, 0, SPH_INPUT_ANY, &first) || sph_take_char(&at, '+') ||
        sph_parse_count(at, 1, MOST_BYTES, &bytes) || OIIO::Filesystem::exists(path))
        return p;
    return {std::string(path, mark), first, bytes};
}

/* Whether a JPEG file has its end-of-image marker: OpenImageIO fills what is missing with grey. */
bool jpeg_ends(const place &p) {
    std::vector<unsigned char> bytes(p.bytes ? p.bytes : OIIO::Filesystem::file_size(p.file));
    OIIO::Filesystem::read_bytes(p.file, bytes.data(), bytes.size(), p.first);
    for (std::size_t i = 2; i + 1 < bytes.size();) {
        unsigned marker = bytes[i] == 0xff ? bytes[i + 1] : 0;
        if (marker == 0xd9) return true;
        bool alone = marker <= 1 || marker == 0xff || (marker >= 0xd0 && marker <= 0xd7);
        if (alone || i + 3 >= bytes.size())
            i++; /* pixels, fill bytes, restarts */
        else
            i += 2 + (static_cast<std::size_t>(bytes[i + 2]) << 8 | bytes[i + 3]);
    }
    return false;
}

/* Why an image cannot be a texture; NULL if it can. */
const char *unfit(const OIIO::ImageSpec &spec) {
    if (spec.deep) return "pixels of many depths are no texture";
    if (spec.depth > 1) return "a volume is no texture";
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return "no pixels";
    return nullptr;
}

/* Whether colours are multiplied by alpha, as the reader gives them. That is OpenImageIO's rule for
 * what its reader does not call unassociated, but readers of formats that have no such colours do
 * not say so. Of whole numbers one colour above its alpha shows that they are not. pixel: of n
 * channels, colour first. */
bool is_multiplied(const OIIO::ImageInput &in, const OIIO::ImageSpec &spec,
                   const std::vector<float> &pixel, std::size_t alpha) {
    static const char *const plain[] = {"bmp", "ico", "dds"};
    const float least = 1 / 255.0f; /* what rounding leaves */
    const std::size_t n = static_cast<std::size_t>(spec.nchannels);
    if (spec.get_int_attribute("oiio:UnassociatedAlpha")) return false;
    for (const char *format : plain)
        if (!std::strcmp(in.format_name(), format)) return false;
    for (std::size_t i = 0; i < pixel.size() && !spec.format.is_floating_point(); i += n)
        for (std::size_t c = 0; c < alpha; c++)
            if (pixel[i + c] > pixel[i + alpha] + least) return false;
    return true;
}

const float LINEAR = 0, SRGB = -1; /* else the exponent that makes it linear */

/* How colours stand for light. */
float transfer_of(const OIIO::ImageSpec &spec, int colours) {
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const float gamma = spec.get_float_attribute("oiio:Gamma");
    if (colours == SPH_COLOURS_LINEAR) return LINEAR;
    if (colours == SPH_COLOURS_SRGB) return SRGB;
    if (OIIO::Strutil::istarts_with(space, "lin") ||
        OIIO::Strutil::iequals(space, "scene_linear") || spec.format.is_floating_point())
        return LINEAR;
    if (OIIO::Strutil::istarts_with(space, "gamma") && gamma > 0)
        return std::fabs(gamma - 1) < 1e-4f ? LINEAR : gamma;
    return space.empty() && spec.format.basesize() > 1 ? LINEAR : SRGB;
}

/* Light of a colour 0 .. 1; sRGB: IEC 61966-2-1. */
float light_of(float v, float transfer) {
    if (transfer == SRGB) return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
    return transfer == LINEAR ? v : std::pow(v, transfer);
}

/* Reads level 0 into a buffer of red, green, blue, alpha, all limited to 0 .. 1. */
int read_level(const char *path, int colours, OIIO::ImageBuf *to, int *decoded,
               struct sph_error *err) {
    const place p = place_of(path);
    std::vector<unsigned char> bytes(p.bytes);
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    if (p.bytes &&
        OIIO::Filesystem::read_bytes(p.file, bytes.data(), bytes.size(), p.first) != bytes.size())
        return sph_fail(err, "%s: the file ends within it", path);
    if (!p.bytes && sph_picture::refuse_unsound(path, err)) return -1;
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    /* what glTF has: PNG and JPEG */
    const char *name = !p.bytes ? path : bytes[0] == 0xff ? "part.jpg" : "part.png";
    OIIO::Filesystem::IOProxy *proxy = &memory;
    if (p.bytes) config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(name, &config);
    if (!in)
        return sph_fail(err, "%s: %s", path,
                        sph_picture::reason(OIIO::geterror(), "not an image").c_str());
    const OIIO::ImageSpec spec = in->spec();
    if (const char *why = unfit(spec)) return sph_fail(err, "%s: %s", path, why);
    if (spec.width > SPH_TEXTURE_SIDE || spec.height > SPH_TEXTURE_SIDE)
        return sph_fail(err, "%s: %d x %d texels, at most %d on a side", path, spec.width,
                        spec.height, SPH_TEXTURE_SIDE);
    std::size_t n = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> from(static_cast<std::size_t>(spec.image_pixels()) * n);
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, from.data()))
        return sph_fail(err, "%s: %s", path,
                        sph_picture::reason(in->geterror(), "ends early").c_str());
    if (!std::strcmp(in->format_name(), "jpeg") && !jpeg_ends(p))
        return sph_fail(err, "%s: ends early", path);

    const int grey = n < 3;
    const std::size_t colour[3] = {0, grey ? 0u : 1u, grey ? 0u : 2u};
    const std::size_t alpha = grey ? 1 : 3;
    const bool has_alpha = n > alpha && (grey || spec.alpha_channel == 3);
    const bool multiplied = has_alpha && is_multiplied(*in, spec, from, alpha);
    const float transfer = transfer_of(spec, colours);
    *decoded = transfer != LINEAR;
    std::vector<float> all(from.size() / n * CHANNELS);
    for (std::size_t i = 0; i < from.size() / n; i++) {
        for (std::size_t c = 0; c < 3; c++)
            all[CHANNELS * i + c] = from[n * i + colour[c]];
        all[CHANNELS * i + 3] = has_alpha ? from[n * i + alpha] : 1;
        const float a = all[CHANNELS * i + 3];
        for (std::size_t c = 0; c < CHANNELS; c++) {
            float &v = all[CHANNELS * i + c];
            if (multiplied && c < 3 && a > 0) v /= a;
            v = v > 0 ? std::fmin(v, 1.0f) : 0;
            if (c < 3) v = light_of(v, transfer);
        }
    }
    to->reset(OIIO::ImageSpec(spec.width, spec.height, CHANNELS, OIIO::TypeFloat));
    if (!to->set_pixels(OIIO::ROI::All(), OIIO::TypeFloat, all.data()))
        return sph_fail(err, "%s: %s", path, to->geterror().c_str());
    return 0;
}

int load(const char *path, int colours, struct sph_mip *mip, struct sph_error *err) {
    OIIO::ImageBuf level;
    if (read_level(path, colours, &level, &mip->decoded, err)) return -1;
    mip->width = level.spec().width;
    mip->height = level.spec().height;
    mip->levels = sph_mip_levels(mip->width, mip->height);
    mip->texels = static_cast<std::uint32_t *>(std::malloc(4 * sph_mip_at(mip, mip->levels)));
    if (!mip->texels) return sph_fail(err, "%s: no memory for the texture", path);
    for (int l = 0; l < mip->levels; l++) {
        if (l) {
            int w = static_cast<int>(sph_level_size(static_cast<std::uint32_t>(mip->width), l));
            int h = static_cast<int>(sph_level_size(static_cast<std::uint32_t>(mip->height), l));
            OIIO::ROI half(0, w, 0, h, 0, 1, 0, CHANNELS);
            level = OIIO::ImageBufAlgo::resize(level, "box", 0, half, 1);
        }
        if (level.has_error() || put_level(level, mip->texels + sph_mip_at(mip, l)))
            return sph_fail(err, "%s: level %d: %s", path, l, level.geterror().c_str());
    }
    return 0;
}

} // namespace

int sph_mip_load(const char *path, int colours, struct sph_mip *mip, struct sph_error *err) {
    *mip = {};
    const place p = place_of(path); /* OpenImageIO takes any file */
    std::FILE *probe = sph_input_open(p.file.c_str(), p.bytes ? SPH_INPUT_ANY : MOST_BYTES, err);
    if (!probe) return -1;
    int empty = std::fgetc(probe) == EOF;
    int why = errno;
    if (empty && std::ferror(probe)) {
        std::fclose(probe);
        return sph_fail(err, "%s: %s", path, std::strerror(why));
    }
    std::fclose(probe);
    if (empty) return sph_fail(err, "%s: empty file", path);
    int rc;
    try {
        rc = load(path, colours, mip, err);
    } catch (const std::exception &e) {
        rc = sph_fail(err, "%s: %s", path, e.what());
    }
    if (rc) sph_mip_free(mip);
    return rc;
}
