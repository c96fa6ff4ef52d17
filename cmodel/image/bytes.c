/* bytes.c - 8-bit pictures in the format of their names; see bytes.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/bytes.h"

#include <string.h>

#include "common/file.h"

int sph_bytes_write(const char *path, int width, int height, const uint8_t *rgb, int transfer,
                    struct sph_error *err) {
    const char *format = sph_image_format(path, err);
    if (!format) return -1;
    int png = !strcmp(format, "png"), rc = 0;
    if (!png && strcmp(format, "pnm") != 0)
        return sph_bytes_write_other(path, format, width, height, rgb, err);
    struct sph_output out;
    if (sph_output_open(&out, path, err)) return -1;
    if (png) {
        rc = sph_png_write(out.file, path, width, height, rgb, transfer, err);
    } else {
        fprintf(out.file, "P6\n%d %d\n255\n", width, height);
        fwrite(rgb, 3 * (size_t)width, (size_t)height, out.file);
    }
    return sph_output_close(&out, rc, err);
}
