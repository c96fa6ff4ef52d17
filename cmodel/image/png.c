/* png.c - 8-bit pictures as PNG, by libpng; see bytes.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <png.h>

#include "image/bytes.h"

/* Of deflate: 3 % more bytes than its usual 6, in half the time; so is one filter for all rows. */
enum { LEVEL = 4, FILTER = PNG_FILTER_UP };

static void failed(png_structp png, png_const_charp why) {
    sph_fail(png_get_error_ptr(png), "%s", why);
    png_longjmp(png, 1);
}

static void warned(png_structp png, png_const_charp why) {
    (void)png;
    (void)why;
}

/* What fails here, the file remembers. */
static void write_bytes(png_structp png, png_bytep bytes, size_t n) {
    fwrite(bytes, 1, n, png_get_io_ptr(png));
}

static void flush(png_structp png) {
    (void)png;
}

/* Everything between opening and closing; -1: libpng has jumped to the end. */
static int write_all(png_structp png, png_infop info, int width, int height, const uint8_t *rgb,
                     int transfer) {
    if (setjmp(png_jmpbuf(png))) return -1;
    png_set_compression_level(png, LEVEL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, FILTER);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (transfer == SPH_TRANSFER_SRGB)
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
    if (transfer == SPH_TRANSFER_LINEAR) png_set_gAMA(png, info, 1);
    png_write_info(png, info);
    for (int y = 0; y < height; y++)
        png_write_row(png, rgb + 3 * (size_t)width * (size_t)y);
    png_write_end(png, info);
    return 0;
}

int sph_png_write(FILE *file, const char *path, int width, int height, const uint8_t *rgb,
                  int transfer, struct sph_error *err) {
    struct sph_error why = {{0}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &why, failed, warned);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    int rc = -1;
    if (info) {
        png_set_write_fn(png, file, write_bytes, flush);
        rc = write_all(png, info, width, height, rgb, transfer);
    }
    png_destroy_write_struct(&png, &info);
    return rc ? sph_fail(err, "%s: %s", path, *why.text ? why.text : "no memory for PNG") : 0;
}
