/* file.h - writing of picture files by OpenImageIO, for the sources of this folder
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_IMAGE_FILE_H
#define SPH_IMAGE_FILE_H

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "image/bytes.h"

namespace sph_picture {

extern const char *const no_time; /* the same frame, the same bytes */

/* A library's message as the end of a line of ours: the first of several, which the others follow
 * from, and of that no more than has room; `otherwise` if there is none. */
std::string reason(const std::string &text, const char *otherwise);

/* -1 with a message if OpenImageIO 2.4 would look outside its memory, or clear much of it for a
 * small file: a BMP whose pixels are compressed as if they had 8 or 4 bits each, and have not; a
 * GIF of more pixels than its bytes can stand for. */
int refuse_unsound(const char *path, struct sph_error *err);

/* Writes pixels, native in the spec's formats, to path as a file of kind format. The file is made
 * in memory first: OpenImageIO's writers do not report a full disk. */
int write_file(const char *path, const char *format, const OIIO::ImageSpec &spec,
               const void *pixels, struct sph_error *err);

/* No exception leaves the C interface. */
template <class Work> int guarded(const char *path, struct sph_error *err, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        return sph_fail(err, "%s: no memory for its pixels", path);
    } catch (const std::exception &e) {
        return sph_fail(err, "%s: %s", path, e.what());
    }
}

} // namespace sph_picture

#endif
