/* aff_progress.c - how much of an AFF file and of what it includes is read; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "scene/aff_reader.h"
#include "scene/inside.h"

int sph_aff_path(const char *from, const char *name, char *path, size_t size) {
    const char *slash = strrchr(from, '/');
    int folder = slash && *name != '/' ? (int)(slash - from) + 1 : 0;
    return snprintf(path, size, "%.*s%s", folder, from, name) < (int)size ? 0 : -1;
}

/* FILE of a line `i level FILE`, or NULL. The line is cut into words. */
static const char *included(char *line) {
    static const char blanks[] = " \t\r\n";
    char *rest, *word = strtok_r(line, blanks, &rest);
    if (!word || strcmp(word, "i") != 0 || !strtok_r(NULL, blanks, &rest)) return NULL;
    return strtok_r(NULL, blanks, &rest);
}

/* Bytes of a file and of those that its lines `i level FILE` name; *files: of how many more. */
static double bytes_of(const struct sph_scene *scene, const char *path, int depth,
                       uint32_t *files) {
    char *line = NULL, *inner = malloc(PATH_MAX);
    size_t room = 0;
    double bytes = 0;
    FILE *file =
        inner && depth < SPH_AFF_DEPTH && *files ? sph_input_open(path, SPH_INPUT_ANY, NULL) : NULL;
    for (ssize_t n; file && (n = getline(&line, &room, file)) > 0;) {
        bytes += (double)n;
        const char *name = included(line);
        if (name && !sph_aff_path(path, name, inner, PATH_MAX) && sph_scene_may_read(scene, inner))
            bytes += bytes_of(scene, inner, depth + 1, files);
    }
    if (file) --*files, fclose(file);
    free(line);
    free(inner);
    return bytes;
}

void sph_aff_tell(struct sph_aff *a, const struct sph_progress *to, const char *path) {
    uint32_t files = SPH_AFF_INCLUDES;
    if (to && to->show) a->to = to, a->all = bytes_of(a->r.scene, path, 0, &files);
}

void sph_aff_tell_file(struct sph_aff *a) {
    const struct sph_lex *lex = &a->r.lex;
    double end = fmin(a->all, a->done + lex->size);
    if (!(a->all > 0) || lex->taken > lex->size) return;
    a->part[a->depth] = sph_progress_part(a->to, fmin(1, a->done / a->all), end / a->all);
    a->r.lex.progress = &a->part[a->depth];
    sph_progress_at(lex->progress, lex->size > 0 ? lex->taken / lex->size : 1);
}
