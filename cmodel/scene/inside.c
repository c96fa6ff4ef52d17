/* inside.c - see inside.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/inside.h"

/* Cuts the last part of a path off, or what follows a '#': what is left is "", "/" or a path. */
static void shorten(char *path) {
    char *cut = path + strlen(path);
    while (cut > path && *cut != '/' && *cut != '#')
        cut--;
    if (cut == path && *cut == '/' && cut[1]) cut++;
    *cut = 0;
}

/* The part of a path that is there, without links. -1: the path is too long, or no folder is. */
static int real_part(const char *path, char real[PATH_MAX]) {
    char part[PATH_MAX];
    int n = snprintf(part, sizeof part, "%s", path);
    if (n < 0 || n >= PATH_MAX) return -1;
    while (!realpath(*part ? part : ".", real)) {
        if (!*part) return -1;
        shorten(part);
    }
    return 0;
}

/* Whether a path without links is a folder, or lies in or below it. */
static int below(const char *path, const char *folder, size_t length) {
    return !strncmp(path, folder, length) &&
           (!path[length] || path[length] == '/' || (length && folder[length - 1] == '/'));
}

int sph_scene_may_read(const struct sph_scene *scene, const char *path) {
    static const char beside[] = "TextureFiles";
    char folder[sizeof scene->path], own[PATH_MAX], real[PATH_MAX],
        images[PATH_MAX + sizeof beside];
    if (scene->allow_paths) return 1;
    const char *slash = strrchr(scene->path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - scene->path) + 1 : 1,
             slash ? scene->path : ".");
    if (!realpath(folder, own) || real_part(path, real)) return 0;
    if (below(real, own, strlen(own))) return 1;
    snprintf(images, sizeof images, "%.*s%s", (int)(strrchr(own, '/') - own) + 1, own, beside);
    return scene->aff && below(real, images, strlen(images));
}
