/* lazy.c - of image.h and texture.h what needs OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 *
 * OpenImageIO brings some 250 libraries with it, which a program that links it loads at every start
 * in a quarter of a second. So tool and shared library link this file, and what does the work
 * stands in an object of its own, which is loaded when it is first asked for: to read a picture, or
 * to write one that is neither PNG nor PPM.
 */
#include <dlfcn.h>
#include <pthread.h>
#include <string.h>

#include "common/module.h"
#include "common/file.h"
#include "image/bytes.h"
#include "image/texture.h"

enum { LONGEST = 4096 };

/* The function of that name, or NULL with a message about the picture at path. */
static void *find(const char *name, const char *path, struct sph_error *err) {
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static void *object;
    char why[LONGEST] = "";
    pthread_mutex_lock(&lock);
    if (!object) {
        object = sph_module_load("image", why, sizeof why);
        void (*clean)(void);
        void *at = object ? dlsym(object, "sph_output_clean") : NULL;
        memcpy(&clean, &at, sizeof clean);
        if (at) sph_output_also(clean);
    }
    pthread_mutex_unlock(&lock);
    void *function = object ? dlsym(object, name) : NULL;
    if (!function) sph_fail(err, "%s: needs OpenImageIO (make images-setup): %s", path, why);
    return function;
}

/* Calls the function of that name, which came with `found`, a pointer to its type. */
#define FOUND(found, name, path, err)                                                              \
    void *at = find(name, path, err);                                                              \
    memcpy(&(found), &at, sizeof(found))

int sph_bytes_write_other(const char *path, const char *format, int width, int height,
                          const uint8_t *rgb, struct sph_error *err) {
    int (*f)(const char *, const char *, int, int, const uint8_t *, struct sph_error *);
    FOUND(f, "sph_bytes_write_other", path, err);
    return f ? f(path, format, width, height, rgb, err) : -1;
}

int sph_linear_write_exr(const char *path, const struct sph_linear *picture,
                         const struct sph_frame *frame, const struct sph_layer *layers,
                         struct sph_error *err) {
    int (*f)(const char *, const struct sph_linear *, const struct sph_frame *,
             const struct sph_layer *, struct sph_error *);
    FOUND(f, "sph_linear_write_exr", path, err);
    return f ? f(path, picture, frame, layers, err) : -1;
}

int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err) {
    int (*f)(const char *, struct sph_image *, struct sph_error *);
    FOUND(f, "sph_image_read", path, err);
    return f ? f(path, image, err) : -1;
}

int sph_image_write_gif(const char *path, const char *const *pictures, int n, double rate,
                        struct sph_error *err) {
    int (*f)(const char *, const char *const *, int, double, struct sph_error *);
    FOUND(f, "sph_image_write_gif", path, err);
    return f ? f(path, pictures, n, rate, err) : -1;
}

int sph_mip_load(const char *path, int colours, struct sph_mip *mip, struct sph_error *err) {
    int (*f)(const char *, int, struct sph_mip *, struct sph_error *);
    FOUND(f, "sph_mip_load", path, err);
    return f ? f(path, colours, mip, err) : -1;
}
