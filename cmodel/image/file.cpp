/* file.cpp - see file.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/file.h"

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include <OpenImageIO/filesystem.h>

#include "common/file.h"

const char *const sph_picture::no_time = "1970:01:01 00:00:00";

std::string sph_picture::reason(const std::string &text, const char *otherwise) {
    enum { MOST = 200 };
    const std::size_t first = text.find_first_not_of('\n');
    if (first == std::string::npos) return otherwise;
    const std::string line = text.substr(first, text.find('\n', first) - first);
    return line.size() <= MOST ? line : line.substr(0, MOST) + "...";
}

namespace {

enum { BITS_AT = 28, COMPRESSION_AT = 30, HEAD = 34, RLE8 = 1, RLE4 = 2 };

int refuse_bmp(const char *path, const unsigned char *head, struct sph_error *err) {
    const int bits = head[BITS_AT] | head[BITS_AT + 1] << 8, how = head[COMPRESSION_AT];
    if ((how != RLE8 && how != RLE4) || bits == (how == RLE8 ? 8 : 4)) return 0;
    return sph_fail(err, "%s: a BMP of %d bits a pixel, compressed as one of %d", path, bits,
                    how == RLE8 ? 8 : 4);
}

/* A code of 12 bits stands for fewer than 2^12 pixels, and a shorter one for fewer yet: 4096 pixels
 * a byte are more than any file has. */
int refuse_gif(const char *path, const unsigned char *head, long bytes, struct sph_error *err) {
    const int width = head[6] | head[7] << 8, height = head[8] | head[9] << 8;
    if (static_cast<long>(width) * height <= 4096 * bytes) return 0;
    return sph_fail(err, "%s: a GIF of %d x %d pixels, which has only %ld bytes", path, width,
                    height, bytes);
}

} // namespace

int sph_picture::refuse_unsound(const char *path, struct sph_error *err) {
    unsigned char head[HEAD] = {};
    std::FILE *file = std::fopen(path, "rb");
    if (!file) return 0;
    const std::size_t n = std::fread(head, 1, HEAD, file);
    const long bytes = std::fseek(file, 0, SEEK_END) ? -1 : std::ftell(file);
    std::fclose(file);
    if (n == HEAD && !std::memcmp(head, "BM", 2)) return refuse_bmp(path, head, err);
    if (bytes > 0 && !std::memcmp(head, "GIF", 3)) return refuse_gif(path, head, bytes, err);
    return 0;
}

int sph_picture::write_file(const char *path, const char *format, const OIIO::ImageSpec &spec,
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

int sph_bytes_write_other(const char *path, const char *format, int width, int height,
                          const uint8_t *rgb, struct sph_error *err) {
    return sph_picture::guarded(path, err, [&] {
        OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
        if (!std::strcmp(format, "jpeg")) spec.attribute("Compression", "jpeg:95");
        if (!std::strcmp(format, "tiff")) spec.attribute("DateTime", sph_picture::no_time);
        return sph_picture::write_file(path, format, spec, rgb, err);
    });
}
