/* mesh_text.c - texts of meshes, line by line, and where their records stand; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/file.h"
#include "common/number.h"
#include "scene/inside.h"
#include "scene/mesh.h"

int sph_text_open(struct sph_text *t, const char *path, struct sph_error *err) {
    enum { MOST = 2000000000 };
    *t = (struct sph_text){.path = path};
    FILE *file = sph_input_open(path, MOST, err);
    if (!file) return -1;
    long size = fseek(file, 0, SEEK_END) ? -1 : ftell(file);
    rewind(file);
    t->bytes = size < 0 ? NULL : malloc((size_t)size + 1);
    size_t got = t->bytes ? fread(t->bytes, 1, (size_t)size, file) : 0;
    int bad = !t->bytes      ? sph_fail(err, "%s: no memory for %ld bytes", path, size)
              : ferror(file) ? sph_fail(err, "%s: cannot read: %s", path, strerror(errno))
              : !got         ? sph_fail(err, "%s: the file is empty", path)
                             : 0;
    fclose(file);
    if (bad || !t->bytes) {
        sph_text_close(t);
        return -1;
    }
    t->at = t->rest = t->bytes;
    t->end = t->bytes + got;
    *t->end = 0;
    return 0;
}

void sph_text_close(struct sph_text *t) {
    free(t->bytes);
    *t = (struct sph_text){0};
}

int sph_text_line(struct sph_text *t) {
    if (t->at == t->end) return 0;
    t->line++;
    t->rest = t->at;
    while (t->at < t->end && *t->at != '\n' && *t->at != '\r')
        t->at++;
    if (t->at == t->end) return 1;
    char *stop = t->at++;
    if (*stop == '\r' && *t->at == '\n') t->at++;
    *stop = 0;
    return 1;
}

char *sph_text_word(struct sph_text *t) {
    char *word = t->rest + strspn(t->rest, " \t"), *end = word + strcspn(word, " \t");
    if (word == end) return NULL;
    t->rest = *end ? end + 1 : end;
    *end = 0;
    return word;
}

int sph_text_number(struct sph_text *t, const char *record, const char *what, double *value,
                    struct sph_error *err) {
    const char *word = sph_text_word(t);
    if (!word) return sph_fail(err, "%s:%u: `%s`: %s is missing", t->path, t->line, record, what);
    int bad = sph_parse_number(word, value);
    if (!bad) return 0;
    return sph_fail(err, "%s:%u: `%s`: %s: `%.40s` is %s", t->path, t->line, record, what, word,
                    bad == -2 ? "too large" : "not a number");
}

int sph_mesh_lines_add(struct sph_mesh_lines *l, uint32_t line, struct sph_error *err) {
    if (!(l->n & (l->n - 1))) {
        uint32_t *room = realloc(l->face, (l->n ? 2 * (size_t)l->n : 1) * sizeof *room);
        if (!room) return sph_fail(err, "no memory for the lines of %u faces", l->n);
        l->face = room;
    }
    l->face[l->n++] = line;
    return 0;
}

void sph_mesh_lines_free(struct sph_mesh_lines *l) {
    free(l->face);
    free(l->text);
    *l = (struct sph_mesh_lines){0};
}

const char *sph_mesh_beside(const struct sph_scene *scene, const char *of, const char *name,
                            char *path, size_t size) {
    static const char unread[] = "cannot be read";
    const char *slash = strrchr(of, '/');
    int folder = slash && name[0] != '/' ? (int)(slash - of) + 1 : 0;
    int n = snprintf(path, size, "%.*s%s", folder, of, name);
    if (n < 0 || (size_t)n >= size) return unread;
    int there = !access(path, R_OK);
    for (char *c = path + folder; !there && (c = strchr(c, '\\')) != NULL;)
        *c = '/';
    if (!sph_scene_may_read(scene, path)) return SPH_OUTSIDE;
    return access(path, R_OK) ? unread : NULL;
}
