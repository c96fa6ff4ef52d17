/* light_picture.c - see light_picture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/light_picture.h"

#include <stdlib.h>
#include <string.h>

#include "image/image.h"
#include "tool/depth_picture.h"

const char *const tool_transfer_names[] = {"linear", "srgb", NULL};

error_t light_option(struct light_pictures *how, struct tool_outputs *outputs, int key, char *arg,
                     struct argp_state *state) {
    const char *format;
    switch (key) {
    case 'o':
        format =
            sph_image_format(tool_picture(state, outputs, key, "--output", arg, TOOL_LIGHT), NULL);
        if (format && !strcmp(format, "openexr"))
            how->exr = arg;
        else
            how->picture = arg;
        return 0;
    case TOOL_KEY_EXR:
        how->exr = tool_picture(state, outputs, key, "--exr", arg, TOOL_EXR);
        return 0;
    case TOOL_KEY_LAYER:
        how->layer = (int)tool_number(state, "--layer", arg, 0, SPH_FRAMES - 1);
        return 0;
    case TOOL_KEY_TRANSFER:
        how->transfer = tool_choice(state, "--transfer", arg, tool_transfer_names);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* m NULL: no machine drew it, and there are no layers. */
static int write_exr(const char *path, const struct sph_machine *m, const struct sph_linear *light,
                     const struct sph_frame *frame, struct sph_error *err) {
    struct sph_layer *layers = m ? sph_layers_of(m, frame) : NULL;
    if (m && !layers) return sph_fail(err, "%s: no memory for its layers", path);
    int rc = sph_linear_write_exr(path, light, frame, layers, err);
    free(layers);
    return rc;
}

static int write(const struct light_pictures *how, int samples, const struct sph_machine *m,
                 const struct sph_frame *frame, const struct sph_trail *trails,
                 struct sph_error *err) {
    struct sph_linear light = {0};
    int rc = sph_linear_of(frame, trails, how->layer, samples, &light, err);
    if (!rc && how->picture) rc = sph_linear_write(how->picture, &light, how->transfer, err);
    if (!rc && how->exr) rc = write_exr(how->exr, m, &light, frame, err);
    sph_linear_free(&light);
    return rc;
}

int light_picture(const struct light_pictures *how, int samples, const struct sph_machine *m,
                  const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_error *err) {
    struct sph_frame painted;
    if (!how->depths) return write(how, samples, m, frame, trails, err);
    if (depth_picture(frame, trails, &painted)) return sph_fail(err, "no memory for depths");
    int rc = write(how, samples, m, &painted, NULL, err);
    sph_frame_free(&painted);
    return rc;
}
