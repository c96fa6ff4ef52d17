/* mesh_stl.c - the records of an STL file, text or binary; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "scene/mesh.h"

/* ---- binary: a head, the number of triangles, 50 bytes each: normal, corners, two more ---- */

enum { HEAD = 80, EACH = 50, NUMBERS = 12 };

static uint32_t word_at(const char *at) {
    const uint8_t *b = (const uint8_t *)at;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* Of bytes behind the triangles assimp is not told. */
static int check_binary(struct sph_text *t, struct sph_scene *scene, struct sph_mesh_lines *lines,
                        struct sph_error *err) {
    uint64_t size = (uint64_t)(t->end - t->bytes), n = word_at(t->bytes + HEAD);
    uint64_t whole = HEAD + 4 + EACH * n;
    if (size < whole)
        return sph_fail(err, "%s: the file ends after %" PRIu64 " of %" PRIu64 " triangles",
                        t->path, (size - HEAD - 4) / EACH, n);
    if (size > whole) {
        if (sph_ledger_note(&scene->ledger, SPH_READ_UNSUPPORTED, t->path, 0, err)) return -1;
        lines->size = (size_t)whole;
        lines->text = malloc(lines->size);
        if (!lines->text) return sph_fail(err, "%s: no memory", t->path);
        memcpy(lines->text, t->bytes, lines->size);
    }
    for (uint64_t i = 0; i < n; i++)
        for (int k = 0; k < NUMBERS; k++) {
            uint32_t bits = word_at(t->bytes + HEAD + 4 + EACH * i + 4 * (size_t)k);
            float f;
            memcpy(&f, &bits, sizeof f);
            if (fabs((double)f) <= SPH_NUMBER_MAX) continue; /* not if it is no number */
            /* a normal is not used, and may be no number where there is no area */
            if (k >= 3)
                return sph_fail(err, "%s: triangle %" PRIu64 ": not a number, or too large",
                                t->path, i);
        }
    return 0;
}

/* ---- text ---- */

/* The words of a facet, and how many numbers they have. */
static const struct {
    const char *word, *second;
    int numbers;
} facet[] = {{"facet", "normal", 3}, {"outer", "loop", 0}, {"vertex", NULL, 3},
             {"vertex", NULL, 3},    {"vertex", NULL, 3},  {"endloop", NULL, 0},
             {"endfacet", NULL, 0}};
enum { STEPS = sizeof facet / sizeof *facet };

static int take_step(struct sph_text *t, int step, const char *word, FILE *out,
                     struct sph_error *err) {
    static const char *const axes[] = {"x", "y", "z"};
    const char *second = facet[step].second, *got = NULL;
    if (strcasecmp(word, facet[step].word) != 0 ||
        (second && (!(got = sph_text_word(t)) || strcasecmp(got, second) != 0)))
        return sph_fail(err, "%s:%u: `%.40s` where `%s%s%s` should stand", t->path, t->line, word,
                        facet[step].word, second ? " " : "", second ? second : "");
    fputs(step ? facet[step].word : "facet normal 0 0 0", out);
    if (step && second) fprintf(out, " %s", second);
    for (int i = 0; i < facet[step].numbers && i < 3; i++) {
        double value = 0;
        if (!step) { /* the normal is not used */
            if (!sph_text_word(t))
                return sph_fail(err, "%s:%u: `facet normal`: %s is missing", t->path, t->line,
                                axes[i]);
        } else if (sph_text_number(t, word, axes[i], &value, err)) {
            return -1;
        } else {
            fprintf(out, " %.17g", value);
        }
    }
    putc('\n', out);
    return 0;
}

static int check_text(struct sph_text *t, struct sph_scene *scene, struct sph_mesh_lines *lines,
                      FILE *out, struct sph_error *err) {
    int step = -1; /* within a facet: the next of its words; -1: outside of a solid */
    while (sph_text_line(t)) {
        const char *word = sph_text_word(t);
        if (!word) continue;
        if (step <= 0 && !strcasecmp(word, step ? "solid" : "endsolid")) {
            step = step ? 0 : -1;
            fputs(step ? "endsolid\n" : "solid x\n", out);
            if (!step && sph_ledger_note(&scene->ledger, SPH_READ_WORD, t->path, t->line, err))
                return -1;
            continue;
        }
        if (step < 0)
            return sph_fail(err, "%s:%u: `%.40s` where `solid` should stand", t->path, t->line,
                            word);
        if (take_step(t, step, word, out, err)) return -1;
        if (!step && sph_mesh_lines_add(lines, t->line, err)) return -1;
        step = (step + 1) % STEPS;
    }
    return step > 0 ? sph_fail(err, "%s:%u: the file ends within a facet", t->path, t->line) : 0;
}

int sph_stl_check(const char *path, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err) {
    struct sph_text t;
    if (sph_text_open(&t, path, err)) return -1;
    size_t size = (size_t)(t.end - t.bytes);
    int text = !strncasecmp(t.bytes, "solid", 5) && !memchr(t.bytes, 0, size);
    FILE *out = text ? open_memstream(&lines->text, &lines->size) : NULL;
    int bad = text && !out       ? sph_fail(err, "%s: no memory", path)
              : text             ? check_text(&t, scene, lines, out, err)
              : size < HEAD + 4u ? sph_fail(err, "%s: the file ends within its head", path)
                                 : check_binary(&t, scene, lines, err);
    sph_text_close(&t);
    if (out && fclose(out)) bad = sph_fail(err, "%s: no memory", path);
    return bad ? -1 : 0;
}
