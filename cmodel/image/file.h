/* file.h - writing of picture files, for the sources of this folder
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_IMAGE_FILE_H
#define SPH_IMAGE_FILE_H

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "image/image.h"

namespace sph_picture {

extern const char *const no_time; /* the same frame, the same bytes */

/* A library's message as the end of a line of ours; `otherwise` if it says nothing. */
std::string reason(std::string text, const char *otherwise);

/* Writes pixels, native in the spec's formats, to path as a file of kind format. The file is made
 * in memory first: OpenImageIO's writers do not report a full disk. */
int write_file(const char *path, const char *format, const OIIO::ImageSpec &spec,
               const void *pixels, struct sph_error *err);

/* Bytes, 8-bit RGB, into a file of the format of its name; space: what OpenImageIO calls the
 * transfer that they have, for PNG (it writes TIFF with it in halves), or NULL: they are no light.
 */
int write_bytes(const char *path, int width, int height, const std::vector<std::uint8_t> &bytes,
                const char *space, struct sph_error *err);

/* No exception leaves the C interface. */
template <class Work> int guarded(const char *path, struct sph_error *err, Work work) {
    try {
        return work();
    } catch (const std::exception &e) {
        return sph_fail(err, "%s: %s", path, e.what());
    }
}

inline std::uint8_t channel(std::uint32_t colour, int c) {
    return static_cast<std::uint8_t>(colour >> 8 * c & 255);
}

inline std::size_t pixel_count(const struct sph_frame *frame) {
    return static_cast<std::size_t>(frame->width) * static_cast<std::size_t>(frame->height);
}

/* Linear light, 255 is white, as a byte in a transfer (SPH_TRANSFER_*); halves are rounded up. */
std::uint8_t encode(float light, int transfer);

} // namespace sph_picture

#endif
