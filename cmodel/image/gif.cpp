/* gif.cpp - an animated picture of several; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "common/file.h"
#include "image/file.h"
#include "image/image.h"

namespace {

/* A picture that is given back at the end. */
struct Picture {
    struct sph_image image = {};
    ~Picture() { sph_image_free(&image); }
};

/* Adds the picture of a file to the animation; the first gives the size. */
int add(OIIO::ImageOutput &out, const std::string &name, const char *from, bool first, double rate,
        struct sph_image *size, struct sph_error *err) {
    Picture p;
    if (sph_image_read(from, &p.image, err)) return -1;
    if (first) *size = {p.image.width, p.image.height, p.image.channels, nullptr};
    if (p.image.channels != 3 || p.image.width != size->width || p.image.height != size->height)
        return sph_fail(err, "%s: %dx%d with %d channels, not %dx%d with 3", from, p.image.width,
                        p.image.height, p.image.channels, size->width, size->height);
    OIIO::ImageSpec spec(p.image.width, p.image.height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:Movie", 1);
    spec.attribute("FramesPerSecond", static_cast<float>(rate));
    auto mode = first ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
    if (!out.open(name, spec, mode) || !out.write_image(OIIO::TypeUInt8, p.image.bytes))
        return sph_fail(err, "%s: %s", name.c_str(), out.geterror().c_str());
    return 0;
}

/* Whether the file has its last byte: OpenImageIO does not report a full disk. */
bool ends(const char *name) {
    std::FILE *file = std::fopen(name, "rb");
    bool good = file && !std::fseek(file, -1, SEEK_END) && std::fgetc(file) == ';';
    if (file) std::fclose(file);
    return good;
}

} // namespace

int sph_image_write_gif(const char *path, const char *const *pictures, int n, double rate,
                        struct sph_error *err) {
    return sph_picture::guarded(path, err, [&] {
        struct sph_output file;
        if (sph_output_open_named(&file, path, "tmp.gif", err)) return -1;
        const char *name = file.temporary;
        std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("gif");
        struct sph_image size = {};
        int rc = out ? 0 : sph_fail(err, "%s: %s", path, OIIO::geterror().c_str());
        for (int i = 0; i < n && !rc; i++)
            rc = add(*out, name, pictures[i], i == 0, rate, &size, err);
        if (out && !out->close() && !rc)
            rc = sph_fail(err, "%s: %s", path, out->geterror().c_str());
        if (!rc && !ends(name)) rc = sph_fail(err, "%s: %s", path, std::strerror(ENOSPC));
        return sph_output_close(&file, rc, err);
    });
}
