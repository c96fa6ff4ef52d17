/* lazy.c - image.h and texture.h for what seldom needs a picture
 * SPDX-License-Identifier: Apache-2.0
 *
 * OpenImageIO brings some 250 libraries with it, which a program that links it loads at every start
 * in a quarter of a second. So tool and shared library link this file, and what does the work
 * stands in an object of its own, which is loaded when a picture is first asked for.
 */
#include <dlfcn.h>
#include <pthread.h>
#include <string.h>

#include "common/module.h"
#include "common/output.h"
#include "image/image.h"
#include "image/texture.h"

enum { LONGEST = 4096 };

/* The function of that name, or NULL with a message. */
static void *find(const char *name, struct sph_error *err) {
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
    if (!function) sph_fail(err, "pictures cannot be read or written: %s", why);
    return function;
}

/* Calls the function of that name, which came with `found`, a pointer to its type. */
#define FOUND(found, name, err)                                                                    \
    void *at = find(name, err);                                                                    \
    memcpy(&(found), &at, sizeof(found))

int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err) {
    int (*f)(const char *, const struct sph_frame *, int, struct sph_error *);
    FOUND(f, "sph_image_write", err);
    return f ? f(path, frame, layer, err) : -1;
}

int sph_image_write_difference(const char *path, const struct sph_frame *a,
                               const struct sph_frame *b, int layer, struct sph_error *err) {
    int (*f)(const char *, const struct sph_frame *, const struct sph_frame *, int,
             struct sph_error *);
    FOUND(f, "sph_image_write_difference", err);
    return f ? f(path, a, b, layer, err) : -1;
}

int sph_linear_of(const struct sph_frame *frame, const struct sph_trail *trails, int layer,
                  int samples, struct sph_linear *out, struct sph_error *err) {
    int (*f)(const struct sph_frame *, const struct sph_trail *, int, int, struct sph_linear *,
             struct sph_error *);
    FOUND(f, "sph_linear_of", err);
    return f ? f(frame, trails, layer, samples, out, err) : -1;
}

int sph_linear_bytes(const struct sph_linear *picture, int transfer, uint8_t *bytes,
                     struct sph_error *err) {
    int (*f)(const struct sph_linear *, int, uint8_t *, struct sph_error *);
    FOUND(f, "sph_linear_bytes", err);
    return f ? f(picture, transfer, bytes, err) : -1;
}

int sph_linear_write(const char *path, const struct sph_linear *picture, int transfer,
                     struct sph_error *err) {
    int (*f)(const char *, const struct sph_linear *, int, struct sph_error *);
    FOUND(f, "sph_linear_write", err);
    return f ? f(path, picture, transfer, err) : -1;
}

int sph_linear_write_exr(const char *path, const struct sph_linear *picture,
                         const struct sph_frame *frame, const struct sph_layer *layers,
                         struct sph_error *err) {
    int (*f)(const char *, const struct sph_linear *, const struct sph_frame *,
             const struct sph_layer *, struct sph_error *);
    FOUND(f, "sph_linear_write_exr", err);
    return f ? f(path, picture, frame, layers, err) : -1;
}

int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err) {
    int (*f)(const char *, struct sph_image *, struct sph_error *);
    FOUND(f, "sph_image_read", err);
    return f ? f(path, image, err) : -1;
}

int sph_image_write_gif(const char *path, const char *const *pictures, int n, double rate,
                        struct sph_error *err) {
    int (*f)(const char *, const char *const *, int, double, struct sph_error *);
    FOUND(f, "sph_image_write_gif", err);
    return f ? f(path, pictures, n, rate, err) : -1;
}

int sph_mip_load(const char *path, struct sph_mip *mip, struct sph_error *err) {
    int (*f)(const char *, struct sph_mip *, struct sph_error *);
    FOUND(f, "sph_mip_load", err);
    return f ? f(path, mip, err) : -1;
}
