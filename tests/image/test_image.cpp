/* test_image.cpp - images of every kind as textures, MIP chains, files that are refused; pictures
 * that are written
 * SPDX-License-Identifier: Apache-2.0
 *
 * Files are written into $TMP; prints TAP. What the model writes or encodes without OpenImageIO is
 * held against OpenImageIO.
 */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/color.h>
#include <OpenImageIO/imageio.h>

#include "image/image.h"
#include "image/texture.h"

namespace {

int checks = 0, failures = 0;
std::string folder;

void check(bool good, const std::string &what) {
    std::printf("%s %d - %s\n", good ? "ok" : "not ok", ++checks, what.c_str());
    failures += !good;
}

std::string at(const std::string &name) {
    return folder + "/" + name;
}

using Pixel = std::function<float(int x, int y, int c)>;

/* Writes a file in the format of its name. */
bool write(const std::string &name, int w, int h, int channels, OIIO::TypeDesc type, Pixel pixel,
           bool associated = true) {
    std::vector<float> v;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            for (int c = 0; c < channels; c++)
                v.push_back(pixel(x, y, c));
    OIIO::ImageSpec spec(w, h, channels, type);
    if (!associated) spec.attribute("oiio:UnassociatedAlpha", 1);
    auto out = OIIO::ImageOutput::create(at(name));
    return out && out->open(at(name), spec) && out->write_image(OIIO::TypeFloat, v.data()) &&
           out->close();
}

std::uint32_t rgba(unsigned r, unsigned g, unsigned b, unsigned a) {
    return r | g << 8 | b << 16 | a << 24;
}

/* The first texel of a file, 0 and a message if it is refused. */
std::uint32_t first(const std::string &name, int colours = SPH_COLOURS_LINEAR) {
    struct sph_mip mip;
    struct sph_error err = {{0}};
    if (sph_mip_load(at(name).c_str(), colours, &mip, &err)) {
        std::printf("# %s\n", err.text);
        return 0;
    }
    std::uint32_t texel = mip.texels[0];
    sph_mip_free(&mip);
    return texel;
}

void kinds() {
    const OIIO::TypeDesc u8 = OIIO::TypeUInt8, u16 = OIIO::TypeUInt16, real = OIIO::TypeFloat;
    const float v[4] = {200 / 255.0f, 100 / 255.0f, 50 / 255.0f, 25 / 255.0f};
    auto flat = [&](int, int, int c) { return v[c]; };
    const struct {
        const char *name;
        int channels;
        OIIO::TypeDesc type;
        std::uint32_t texel;
    } cases[] = {
        {"rgb8.png", 3, u8, rgba(200, 100, 50, 255)},
        {"rgba8.png", 4, u8, rgba(200, 100, 50, 25)},
        {"grey8.png", 1, u8, rgba(200, 200, 200, 255)},
        {"greya8.png", 2, u8, rgba(200, 200, 200, 100)},
        {"rgb16.png", 3, u16, rgba(200, 100, 50, 255)},
        {"rgba16.png", 4, u16, rgba(200, 100, 50, 25)},
        {"rgb8.ppm", 3, u8, rgba(200, 100, 50, 255)},
        {"rgb16.ppm", 3, u16, rgba(200, 100, 50, 255)},
        {"grey16.pgm", 1, u16, rgba(200, 200, 200, 255)},
        {"real.exr", 3, real, rgba(200, 100, 50, 255)},
        {"reala.exr", 4, real, rgba(255, 255, 255, 25)}, /* multiplied by alpha, by definition */
        {"grey.exr", 1, real, rgba(200, 200, 200, 255)},
    };
    for (const auto &c : cases) {
        bool written = write(c.name, 5, 3, c.channels, c.type, flat, false);
        std::uint32_t texel = first(c.name);
        std::printf("# %s %08x\n", c.name, texel);
        check(written && texel == c.texel, c.name);
    }
    bool jpeg = write("rgb.jpg", 16, 16, 3, u8, flat);
    std::uint32_t texel = first("rgb.jpg");
    bool close = true;
    for (int c = 0; c < 3; c++)
        close &= std::abs(static_cast<int>(texel >> 8 * c & 255) -
                          static_cast<int>(std::lround(255 * v[c]))) <= 2;
    check(jpeg && close && texel >> 24 == 255, "rgb.jpg within 2");

    const float dim[4] = {0.1f, 0.05f, 0.025f, 0.5f};
    write("dim.exr", 1, 1, 4, real, [&](int, int, int c) { return dim[c]; });
    check(first("dim.exr") == rgba(51, 26, 13, 128), "what an EXR multiplies by alpha is divided");
    const float odd[4] = {-3, 7, NAN, 0.5f}; /* real numbers that are no colours */
    write("odd.exr", 1, 1, 4, real, [&](int, int, int c) { return odd[c]; });
    check(first("odd.exr") == rgba(0, 255, 0, 128), "real numbers are limited to 0 .. 1");
    /* half of 65535 is 127.5 of 255: to nearest, halves up */
    write("half.pgm", 1, 1, 1, u16, [](int, int, int) { return 32768 / 65535.0f; });
    check((first("half.pgm") & 255) == 128, "16 bits are rounded to nearest");
    write("many.exr", 1, 1, 6, real, [](int, int, int c) { return static_cast<float>(c) / 10; });
    check(first("many.exr") == rgba(0, 85, 170, 77), "of six channels four count");
}

/* Bytes of a file as light: by its own rule, and as asked for. */
void colours() {
    const OIIO::TypeDesc u8 = OIIO::TypeUInt8, u16 = OIIO::TypeUInt16, real = OIIO::TypeFloat;
    auto grey = [](int, int, int) { return 128 / 255.0f; };
    const struct {
        const char *name;
        OIIO::TypeDesc type;
        unsigned by_file; /* 55 is the light of 128 in sRGB */
    } cases[] = {{"c8.png", u8, 55}, {"c16.png", u16, 55},  {"c8.ppm", u8, 55},
                 {"c8.tif", u8, 55}, {"c16.tif", u16, 128}, {"c.exr", real, 128},
                 {"c8.bmp", u8, 55}, {"c8.tga", u8, 55},    {"c.tif", real, 128}};
    for (const auto &c : cases) {
        bool good = write(c.name, 2, 2, 3, c.type, grey) &&
                    (first(c.name, SPH_COLOURS_OF_FILE) & 255) == c.by_file &&
                    (first(c.name, SPH_COLOURS_SRGB) & 255) == 55 &&
                    (first(c.name, SPH_COLOURS_LINEAR) & 255) == 128;
        check(good, std::string("light of ") + c.name);
    }
    OIIO::ImageSpec spec(1, 1, 3, u8);
    const struct {
        float gamma;
        unsigned light;
    } gammas[] = {{1, 128}, {2, 64}};
    for (const auto &g : gammas) {
        spec.attribute("oiio:Gamma", g.gamma);
        spec.attribute("oiio:ColorSpace", g.gamma > 1 ? "Gamma2.0" : "Linear");
        const float v[3] = {128 / 255.0f, 128 / 255.0f, 128 / 255.0f};
        auto out = OIIO::ImageOutput::create(at("gamma.png"));
        bool good = out && out->open(at("gamma.png"), spec) &&
                    out->write_image(OIIO::TypeFloat, v) && out->close();
        std::uint32_t texel = first("gamma.png", SPH_COLOURS_OF_FILE);
        std::printf("# gamma %g: %08x\n", static_cast<double>(g.gamma), texel);
        check(good && (texel & 255) == g.light, "a PNG's own gamma");
    }
    /* OpenImageIO's writer divides by alpha in linear light, so that 200, 100, 50 are in the file
     */
    const float half[4] = {147 / 255.0f, 71 / 255.0f, 34 / 255.0f, 128 / 255.0f};
    bool good = write("half.webp", 16, 16, 4, u8, [&](int, int, int c) { return half[c]; });
    std::uint32_t texel = first("half.webp");
    std::printf("# half.webp %08x\n", texel);
    const unsigned want[4] = {200, 100, 50, 128};
    for (unsigned c = 0; c < 4; c++)
        good &= std::abs(static_cast<int>(texel >> 8 * c & 255) - static_cast<int>(want[c])) <= 6;
    check(good, "WebP with alpha keeps its colour, within 6 of its losses");
}

/* Colour is not multiplied by alpha, whether the file has it so or not, and whatever its reader
 * makes of that: what OpenImageIO writes of it comes back. */
void alphas() {
    const OIIO::TypeDesc u8 = OIIO::TypeUInt8, u16 = OIIO::TypeUInt16, real = OIIO::TypeFloat;
    const float half = 128 / 255.0f, plain[4] = {200 / 255.0f, 100 / 255.0f, 50 / 255.0f, half};
    const struct {
        const char *name;
        OIIO::TypeDesc type;
        int plain, multiplied; /* the format has, or may have, such colours */
    } cases[] = {
        {"a8.png", u8, 1, 1},   {"a16.png", u16, 1, 1}, {"a8.tif", u8, 1, 1},
        {"a16.tif", u16, 1, 1}, {"a.tif", real, 1, 1},  {"a8.tga", u8, 1, 1},
        {"a.exr", real, 0, 1},  {"a8.sgi", u8, 1, 1},   {"a8.rla", u8, 1, 1},
        {"a8.dpx", u8, 1, 1},   {"a8.iff", u8, 1, 1},   {"a8.bmp", u8, 1, 0},
        {"a8.ico", u8, 1, 0},
    };
    for (const auto &c : cases)
        for (int multiplied = 0; multiplied < 2; multiplied++) {
            auto pixel = [&](int, int, int k) {
                return multiplied && k < 3 ? half * plain[k] : plain[k];
            };
            if (!(multiplied ? c.multiplied : c.plain)) continue;
            bool good = write(c.name, 16, 16, 4, c.type, pixel, multiplied);
            std::uint32_t texel = first(c.name);
            for (int k = 0; k < 4; k++)
                good &= std::abs(static_cast<int>(texel >> 8 * k & 255) -
                                 static_cast<int>(std::lround(255 * plain[k]))) <= 2;
            std::printf("# %s %08x\n", c.name, texel);
            check(good, std::string(multiplied ? "multiplied " : "plain ") + c.name);
        }
}

/* The mean of the texels of level 0 that a texel of an image with sides 2^n covers. */
double mean(const struct sph_mip &mip, int level, int x, int y, int c) {
    double sum = 0;
    int n = 1 << level;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++)
            sum += mip.texels[(y * n + j) * mip.width + x * n + i] >> (8 * c) & 255;
    return sum / n / n;
}

void chains() {
    auto noise = [](int x, int y, int c) {
        unsigned n = static_cast<unsigned>(x * 7919 + y * 104729 + c * 1299709);
        n = (n ^ n >> 13) * 0x5bd1e995;
        return static_cast<float>(n >> 24) / 255;
    };
    struct sph_mip mip;
    struct sph_error err = {{0}};
    write("noise.png", 64, 32, 3, OIIO::TypeUInt8, noise);
    bool good = !sph_mip_load(at("noise.png").c_str(), SPH_COLOURS_LINEAR, &mip, &err);
    check(good && mip.width == 64 && mip.height == 32 && mip.levels == 7, "64 x 32 has 7 levels");
    double worst = 0;
    int texels = 0;
    for (int l = 1; good && l <= 5; l++) /* down to 2 x 1: 4^l texels each */
        for (int y = 0; y < 32 >> l; y++)
            for (int x = 0; x < 64 >> l; x++)
                for (int c = 0; c < 3; c++, texels++) {
                    const std::uint32_t *level = mip.texels + sph_mip_at(&mip, l);
                    double v = level[y * (64 >> l) + x] >> (8 * c) & 255;
                    worst = std::fmax(worst, std::fabs(v - mean(mip, l, x, y, c)));
                }
    std::printf("# %d channels of texels, at most %.6f from the mean of 4^level\n", texels, worst);
    check(worst < 0.5001, "every level is the mean of level 0, rounded once");
    if (good) sph_mip_free(&mip);

    /* one colour stays itself in images of any size, to the last level */
    const int sizes[][2] = {{1, 1}, {2, 1}, {1, 7}, {3, 5}, {100, 37}, {255, 257}, {2048, 2}};
    for (const auto &s : sizes) {
        std::string name = "flat" + std::to_string(s[0]) + "x" + std::to_string(s[1]) + ".png";
        const float v[3] = {1 / 255.0f, 128 / 255.0f, 254 / 255.0f};
        write(name, s[0], s[1], 3, OIIO::TypeUInt8, [&](int, int, int c) { return v[c]; });
        good = !sph_mip_load(at(name).c_str(), SPH_COLOURS_LINEAR, &mip, &err);
        std::size_t all = good ? sph_mip_at(&mip, mip.levels) : 0, same = 0;
        for (std::size_t i = 0; i < all; i++)
            same += mip.texels[i] == rgba(1, 128, 254, 255);
        check(good && all > 0 && same == all, name + ": one colour on every level");
        if (good) sph_mip_free(&mip);
    }

    /* an odd side: the mean stays */
    write("odd.png", 81, 63, 3, OIIO::TypeUInt8, noise);
    good = !sph_mip_load(at("odd.png").c_str(), SPH_COLOURS_LINEAR, &mip, &err);
    double sum = 0;
    for (int i = 0; good && i < 81 * 63; i++)
        sum += mip.texels[i] & 255;
    double last = good ? mip.texels[sph_mip_at(&mip, mip.levels - 1)] & 255 : 0;
    std::printf("# mean of level 0 %.2f, last level %.0f\n", sum / 81 / 63, last);
    check(good && mip.levels == 7 && std::fabs(sum / 81 / 63 - last) < 6, "81 x 63: mean stays");
    if (good) sph_mip_free(&mip);
}

/* Cuts a file to a part of its bytes. */
void cut(const std::string &from, const std::string &to, int percent) {
    std::vector<char> bytes(1 << 20);
    std::FILE *f = std::fopen(at(from).c_str(), "rb");
    std::size_t n = f ? std::fread(bytes.data(), 1, bytes.size(), f) : 0;
    if (f) std::fclose(f);
    f = std::fopen(at(to).c_str(), "wb");
    if (!f) return;
    std::fwrite(bytes.data(), 1, n * static_cast<std::size_t>(percent) / 100, f);
    std::fclose(f);
}

void refused(const std::string &name, const char *reason) {
    struct sph_mip mip;
    struct sph_error err = {{0}};
    int rc = sph_mip_load(at(name).c_str(), SPH_COLOURS_LINEAR, &mip, &err);
    std::printf("# %s\n", err.text);
    check(rc == -1 && !mip.texels && std::strstr(err.text, at(name).c_str()) &&
              std::strlen(err.text) > at(name).size() + 2 && std::strstr(err.text, reason),
          "refused: " + name);
    if (!rc) sph_mip_free(&mip);
}

void bad() {
    auto noise = [](int x, int y, int c) { return static_cast<float>((x * y + c) % 17) / 17; };
    refused("missing.png", "No such file");
    write("wide.pgm", 2049, 1, 1, OIIO::TypeUInt8, noise);
    refused("wide.pgm", "at most 2048");
    write("high.png", 1, 2049, 3, OIIO::TypeUInt8, noise);
    refused("high.png", "2049");
    for (const char *name : {"good.png", "good.jpg", "good.exr", "good.ppm"}) {
        write(name, 64, 64, 3, std::strstr(name, "exr") ? OIIO::TypeFloat : OIIO::TypeUInt8, noise);
        std::string part = std::string("half_") + name, none = std::string("empty_") + name;
        cut(name, part, 50);
        cut(name, none, 0);
        refused(part, "");
        refused(none, "empty file");
    }
    cut("good.jpg", "almost.jpg", 99); /* only the last rows are missing */
    refused("almost.jpg", "ends early");
    std::FILE *f = std::fopen(at("words.png").c_str(), "w");
    if (f) std::fputs("not an image\n", f), std::fclose(f);
    refused("words.png", "");
    refused("", ""); /* a folder */
}

/* The bytes of a file of RGB. */
std::vector<std::uint8_t> bytes_of(const std::string &name, int w, int h) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(3 * w * h));
    auto in = OIIO::ImageInput::open(at(name));
    bool good = in && in->spec().width == w && in->spec().height == h &&
                in->spec().nchannels == 3 && in->spec().format == OIIO::TypeUInt8 &&
                in->read_image(0, 0, 0, 3, OIIO::TypeUInt8, bytes.data());
    return good ? bytes : std::vector<std::uint8_t>();
}

/* A transfer curve is OpenImageIO's, of each light of a pixel and of means of samples; files that
 * no OpenImageIO has written have the pixels of one that it has. */
void written() {
    int off = 0, lights = 0;
    for (int samples : {1, 2, 3, 5})
        for (int i = 0; i <= 255 * 256 * samples; i++, lights++) {
            float light = static_cast<float>(i) / 256 / static_cast<float>(samples);
            float curve = 255 * OIIO::linear_to_sRGB(light / 255) + 0.5f;
            off += sph_linear_byte(light, SPH_TRANSFER_SRGB) != static_cast<int>(curve);
            off += sph_linear_byte(light, SPH_TRANSFER_LINEAR) != static_cast<int>(light + 0.5f);
        }
    std::printf("# %d lights, %d bytes off\n", lights, off);
    check(!off, "a byte is OpenImageIO's");
    const int sizes[][2] = {{1, 1}, {7, 3}, {300, 200}, {16383, 1}};
    for (const auto &s : sizes) {
        std::vector<float> rgb;
        for (int i = 0; i < 3 * s[0] * s[1]; i++)
            rgb.push_back(static_cast<float>(i * 7919 % 65281) / 256);
        struct sph_linear light = {s[0], s[1], rgb.data()};
        for (int transfer : {SPH_TRANSFER_LINEAR, SPH_TRANSFER_SRGB}) {
            std::string stem = std::to_string(s[0]) + (transfer ? "srgb" : "linear");
            struct sph_error err = {{0}};
            int rc = 0;
            for (const char *ending : {".png", ".ppm", ".tif"})
                rc |= sph_linear_write(at(stem + ending).c_str(), &light, transfer, &err);
            auto expected = bytes_of(stem + ".tif", s[0], s[1]);
            check(!rc && !expected.empty() && bytes_of(stem + ".png", s[0], s[1]) == expected &&
                      bytes_of(stem + ".ppm", s[0], s[1]) == expected,
                  stem + ": PNG and PPM have the pixels of OpenImageIO's TIFF");
        }
    }
}

} // namespace

int main() {
    const char *tmp = std::getenv("TMP");
    folder = tmp ? tmp : ".";
    kinds();
    colours();
    alphas();
    chains();
    bad();
    written();
    std::printf("1..%d\n", checks);
    return failures != 0;
}
