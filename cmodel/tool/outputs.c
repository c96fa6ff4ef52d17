/* outputs.c - see outputs.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/outputs.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "image/image.h"

static int to_stdout; /* files that go to standard output */

FILE *tool_text(void) {
    return to_stdout ? stderr : stdout;
}

const char *tool_output(struct tool_outputs *outputs, int key, const char *path) {
    int i = 0;
    while (i < outputs->n && outputs->key[i] != key)
        i++;
    assert(i < TOOL_OUTPUTS);
    if (i == outputs->n)
        outputs->n++;
    else
        to_stdout -= !strcmp(outputs->path[i], "-");
    outputs->key[i] = key;
    outputs->path[i] = path;
    to_stdout += !strcmp(path, "-");
    return path;
}

const char *tool_picture(const struct argp_state *state, struct tool_outputs *outputs, int key,
                         const char *option, const char *path, int kinds) {
    struct sph_error err = {""};
    const char *format = sph_image_format(path, &err), *dot = strrchr(path, '.');
    if (!format)
        argp_error(state, "%s: %s", option, err.text);
    else if (kinds == TOOL_EXACT && !strcmp(format, "openexr"))
        argp_error(state, "%s: %s: only `sphaera render` writes OpenEXR", option, path);
    else if (kinds == TOOL_EXACT && !strcmp(format, "jpeg"))
        argp_error(state, "%s: %s: JPEG would change the values, which are no light", option, path);
    else if (kinds == TOOL_EXR && dot && strcmp(format, "openexr") != 0)
        argp_error(state, "%s: %s: OpenEXR is written to names that end in .exr", option, path);
    return tool_output(outputs, key, path);
}

/* Where the last part of a path starts; *st: of the folder that it is in. */
static const char *folder(const char *path, struct stat *st) {
    const char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path;
    char *name = slash ? strndup(path, (size_t)(last - path)) : strdup(".");
    int found = name && !stat(name, st);
    free(name);
    return found ? last : NULL;
}

/* Two names of one file, that is there or will be. */
static int same(const char *a, const char *b) {
    struct stat one, two;
    int there = !stat(a, &one), other = !stat(b, &two);
    if (!strcmp(a, "-") || !strcmp(b, "-") || there != other) return 0;
    if (there) return S_ISREG(one.st_mode) && one.st_dev == two.st_dev && one.st_ino == two.st_ino;
    const char *last = folder(a, &one), *last2 = folder(b, &two);
    return last && last2 && !strcmp(last, last2) && one.st_dev == two.st_dev &&
           one.st_ino == two.st_ino;
}

int tool_spares(const struct tool_outputs *outputs, const char *text, struct sph_error *err) {
    struct stat in, out;
    char input[SPH_SCENE_FILE];
    sph_scene_section(text, input);
    if (to_stdout > 1) return sph_fail(err, "-: only one file can go to standard output");
    for (int i = 0; i < outputs->n; i++)
        for (int k = 0; k < i; k++)
            if (outputs->key[i] != outputs->key[k] && same(outputs->path[i], outputs->path[k]))
                return sph_fail(err, "%.200s: would overwrite %.200s, which is written too",
                                outputs->path[i], outputs->path[k]);
    for (int i = 0; i < outputs->n; i++) {
        const char *path = outputs->path[i];
        if (strcmp(path, "-") && !stat(path, &out) && !stat(input, &in) && S_ISREG(in.st_mode) &&
            out.st_dev == in.st_dev && out.st_ino == in.st_ino)
            return sph_fail(err, "%.200s: would overwrite %.200s, which is read", path, input);
    }
    return 0;
}

int tool_spares_images(const struct tool_outputs *outputs, const struct sph_scene *scene,
                       struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_textures; i++)
        if (tool_spares(outputs, scene->textures[i].path, err)) return -1;
    for (uint32_t i = 0; i < scene->n_files; i++)
        if (tool_spares(outputs, scene->files[i], err)) return -1;
    return 0;
}
