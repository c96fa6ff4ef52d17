/* pictures.cpp - the pictures of a co-simulation: model, RTL, difference, side by side
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: pictures MODEL.frame RTL.frame FOLDER [SAMPLES]
 *
 * Colours are those of the deepest reflection, in sRGB; SAMPLES x SAMPLES of the frames' pixels
 * make one of model.png and rtl.png. diff.png shows |model - RTL| of each byte, 16 times and at
 * most 255, and white where only id, key, visits or texture differ.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "image/image.h"
extern "C" {
#include "common/number.h"
#include "core/frame.h"
}

namespace {

const int LAYER = SPH_FRAMES - 1;

sph_pixel difference(const sph_pixel &a, const sph_pixel &b) {
    sph_pixel d{};
    for (unsigned shift = 0; shift < 24; shift += 8) {
        int x = static_cast<int>(a.colour[LAYER] >> shift & 255);
        int y = static_cast<int>(b.colour[LAYER] >> shift & 255);
        auto value = static_cast<uint32_t>(std::min(16 * std::abs(x - y), 255));
        d.colour[LAYER] |= value << shift;
    }
    bool hidden = a.id != b.id || a.key != b.key || a.visits != b.visits || a.texture != b.texture;
    if (!d.colour[LAYER] && hidden) d.colour[LAYER] = 0xffffff;
    return d;
}

int write(const std::string &path, const struct sph_frame *frame, int samples,
          struct sph_error *err) {
    struct sph_linear picture {};
    int failed = sph_linear_of(frame, nullptr, LAYER, samples, &picture, err) ||
                 sph_linear_write(path.c_str(), &picture, SPH_TRANSFER_SRGB, err);
    sph_linear_free(&picture);
    return failed;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 4 && argc != 5) {
        std::fprintf(stderr, "usage: pictures MODEL.frame RTL.frame FOLDER [SAMPLES]\n");
        return 2;
    }
    sph_error err = {{0}};
    sph_shot model{}, rtl{};
    int failed = sph_shot_read(argv[1], &model, &err) || sph_shot_read(argv[2], &rtl, &err);
    if (!failed && (model.frame.width != rtl.frame.width || model.frame.height != rtl.frame.height))
        failed = sph_fail(&err, "%s and %s differ in size", argv[1], argv[2]);
    if (!failed) {
        std::string folder = std::string(argv[3]) + "/";
        size_t n = static_cast<size_t>(model.frame.width) * static_cast<size_t>(model.frame.height);
        std::vector<sph_pixel> pixels(n);
        for (size_t i = 0; i < n; i++)
            pixels[i] = difference(model.frame.pixels[i], rtl.frame.pixels[i]);
        sph_frame diff = {model.frame.width, model.frame.height, pixels.data()};
        uint64_t count = 1;
        if (argc == 5 && sph_parse_count(argv[4], 1, 16, &count))
            return fprintf(stderr, "pictures: SAMPLES: '%s' is no number from 1 to 16\n", argv[4]),
                   2;
        int samples = static_cast<int>(count);
        failed = write(folder + "model.png", &model.frame, samples, &err) ||
                 write(folder + "rtl.png", &rtl.frame, samples, &err) ||
                 sph_image_write((folder + "diff.png").c_str(), &diff, LAYER, &err) ||
                 sph_image_write_difference((folder + "side-by-side.png").c_str(), &model.frame,
                                            &rtl.frame, LAYER, &err);
    }
    sph_frame_free(&model.frame);
    sph_frame_free(&rtl.frame);
    if (failed) std::fprintf(stderr, "pictures: %s\n", err.text);
    return failed ? 1 : 0;
}
