/* mesh_obj.c - the records of a Wavefront OBJ file and of its material libraries; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "common/number.h"
#include "scene/mesh.h"

enum { CORNER, COORDINATE, NORMAL, LISTS };
static const char *const lists[LISTS] = {"v", "vt", "vn"};
static const char *const called[LISTS] = {"vertex", "texture coordinate", "normal"};
static const int least[LISTS] = {3, 1, 3}, most[LISTS] = {6, 3, 3};
static const char *const names[] = {"x", "y", "z", "4th number", "5th number", "6th number"};

struct obj {
    struct sph_text text;
    struct sph_scene *scene;
    struct sph_mesh_lines *lines;
    int skip;
    FILE *out;                            /* the same records for assimp */
    uint64_t n[LISTS];                    /* elements so far */
    uint64_t highest[LISTS], line[LISTS]; /* the highest number that is named, and where */
    uint32_t smooth;                      /* line of the first smoothing group, 0: none */
};

static int note(struct obj *o, enum sph_read kind, struct sph_error *err) {
    return sph_ledger_note(&o->scene->ledger, kind, o->text.path, o->text.line, err);
}

/* v, vt, vn: as many numbers as there may be; assimp takes no single texture coordinate. */
static int take_element(struct obj *o, int list, struct sph_error *err) {
    int n = 0;
    fputs(lists[list], o->out);
    for (; n < most[list]; n++) {
        double value = 0;
        o->text.rest += strspn(o->text.rest, " \t");
        if (n >= least[list] && !*o->text.rest) break;
        if (sph_text_number(&o->text, lists[list], names[n], &value, err)) return -1;
        fprintf(o->out, " %.17g", value);
    }
    if (n == 5)
        return sph_fail(err, "%s:%u: `v`: the 6th number is missing", o->text.path, o->text.line);
    fputs(n == 1 ? " 0\n" : "\n", o->out);
    o->n[list]++;
    return note(o, SPH_READ_CORNER, err);
}

/* One number of a corner: from 1, or from the newest backwards, -1. */
static int take_index(struct obj *o, const char *record, int list, const char **at,
                      struct sph_error *err) {
    int64_t index = 0;
    const int64_t beyond = (int64_t)1 << 40;
    if (sph_take_whole(at, -beyond, beyond, &index) || !index)
        return sph_fail(err, "%s:%u: `%s`: `%.40s` is no number of a %s", o->text.path,
                        o->text.line, record, *at, called[list]);
    if (index < 0 && (uint64_t)-index > o->n[list])
        return sph_fail(err, "%s:%u: `%s`: %s %" PRId64 ", but there are %" PRIu64 " before it",
                        o->text.path, o->text.line, record, called[list], index, o->n[list]);
    if (index > 0 && (uint64_t)index > o->highest[list])
        o->highest[list] = (uint64_t)index, o->line[list] = o->text.line;
    return 0;
}

/* a, a/b, a//c, a/b/c */
static int take_corner(struct obj *o, const char *record, const char *word, struct sph_error *err) {
    const char *at = word;
    for (int list = 0; list < LISTS; list++) {
        if (list && sph_take_char(&at, '/')) break;
        if ((!list || (*at && *at != '/')) && take_index(o, record, list, &at, err)) return -1;
    }
    return *at ? sph_fail(err, "%s:%u: `%s`: `%.40s` is no corner", o->text.path, o->text.line,
                          record, word)
               : 0;
}

/* f, and l and p, which are no surface. */
static int take_face(struct obj *o, const char *record, struct sph_error *err) {
    uint32_t n = 0;
    fputs(record, o->out);
    for (const char *word; (word = sph_text_word(&o->text)) != NULL; n++) {
        fprintf(o->out, " %s", word);
        if (take_corner(o, record, word, err)) return -1;
    }
    putc('\n', o->out);
    if (!n) return sph_fail(err, "%s:%u: `%s`: no corners", o->text.path, o->text.line, record);
    if (*record == 'f' && n > 2) return sph_mesh_lines_add(o->lines, o->text.line, err);
    if (!o->lines->part) o->lines->part = o->text.line;
    return 0;
}

/* ---- material libraries ---- */

/* A name: the rest of the line without blanks around it. */
static char *take_name(struct sph_text *t) {
    char *name = t->rest + strspn(t->rest, " \t");
    size_t n = strlen(name);
    while (n && (name[n - 1] == ' ' || name[n - 1] == '\t'))
        name[--n] = 0;
    return name;
}

/* Words of numbers that are used, and how many they have. */
static const struct {
    const char *word;
    int n;
} parts[] = {{"Kd", 3}, {"Ks", 3}, {"Tf", 3}, {"Ns", 1},
             {"d", 1},  {"Tr", 1}, {"Ni", 1}, {"illum", 1}};

static int note_part(struct obj *o, const struct sph_text *t, enum sph_read kind,
                     struct sph_error *err) {
    return sph_ledger_note(&o->scene->ledger, kind, t->path, t->line, err);
}

/* map_Kd [-option ...] FILE: options have no effect. */
static int take_map(struct obj *o, struct sph_text *t, struct sph_error *err) {
    char path[512], *name = take_name(t);
    int options = 0;
    while (*name == '-' && isalpha((unsigned char)name[1])) {
        sph_text_word(t);
        do {
            name = t->rest + strspn(t->rest, " \t");
            size_t n = strspn(name, "+-.0123456789eE");
            int word = !strncmp(name, "on", 2) || !strncmp(name, "off", 3);
            if (!word && (!n || (name[n] != ' ' && name[n] != '\t'))) break;
        } while (sph_text_word(t));
        options = 1;
    }
    if (options && note_part(o, t, SPH_READ_PART_OTHER, err)) return -1;
    if (!*name) return sph_fail(err, "%s:%u: `map_Kd`: no file", t->path, t->line);
    const char *wrong = sph_mesh_beside(o->scene, t->path, name, path, sizeof path);
    if (!wrong) return note_part(o, t, SPH_READ_PART, err);
    if (o->skip) return note_part(o, t, SPH_READ_MISSING, err);
    return sph_fail(err, "%s:%u: `map_Kd`: image %.200s %s", t->path, t->line, name, wrong);
}

static int take_part(struct obj *o, struct sph_text *t, struct sph_error *err) {
    const char *word = sph_text_word(t);
    if (!word || *word == '#') return 0;
    if (!strcmp(word, "newmtl")) return note_part(o, t, SPH_READ_MATERIAL, err);
    if (!strcasecmp(word, "map_Kd")) return take_map(o, t, err);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (strcmp(parts[i].word, word) != 0) continue;
        t->rest += strspn(t->rest, " \t");
        if (isalpha((unsigned char)*t->rest)) break; /* `spectral`, `xyz`, `-halo` */
        for (int k = 0; k < parts[i].n; k++) {
            double value;
            if (k == 1 && !*(t->rest + strspn(t->rest, " \t"))) break; /* one for all three */
            if (sph_text_number(t, word, parts[i].n == 3 ? names[k] : "number", &value, err))
                return -1;
        }
        return note_part(o, t, SPH_READ_PART, err);
    }
    return note_part(o, t, SPH_READ_PART_OTHER, err);
}

static int take_library(struct obj *o, struct sph_error *err) {
    char path[512], *name = take_name(&o->text);
    const char *wrong = sph_mesh_beside(o->scene, o->text.path, name, path, sizeof path);
    if (wrong) {
        if (o->skip) return note(o, SPH_READ_MISSING, err);
        return sph_fail(err, "%s:%u: `mtllib`: %.200s %s", o->text.path, o->text.line, name, wrong);
    }
    struct sph_text t;
    if (sph_text_open(&t, path, err)) return -1;
    int bad = 0;
    while (!bad && sph_text_line(&t))
        bad = take_part(o, &t, err);
    sph_text_close(&t);
    fprintf(o->out, "mtllib %s\n", name);
    return bad ? -1 : note(o, SPH_READ_WORD, err);
}

/* ---- the file ---- */

/* Curves, free-form surfaces and the like, which assimp passes over, and words of no format. */
static int take_record(struct obj *o, struct sph_error *err) {
    const char *word = sph_text_word(&o->text);
    if (!word || *word == '#') return 0;
    int named = !strcmp(word, "mtllib") || !strcmp(word, "usemtl");
    if (!named) o->text.rest[strcspn(o->text.rest, "#")] = 0;
    for (int list = 0; list < LISTS; list++)
        if (!strcmp(word, lists[list])) return take_element(o, list, err);
    if (!strcmp(word, "f") || !strcmp(word, "l") || !strcmp(word, "p"))
        return take_face(o, word, err);
    if (!strcmp(word, "mtllib")) return take_library(o, err);
    if (!strcmp(word, "s")) {
        const char *group = sph_text_word(&o->text);
        if (group && strcmp(group, "off") != 0 && strcmp(group, "0") != 0 && !o->smooth)
            o->smooth = o->text.line;
        return note(o, SPH_READ_WORD, err);
    }
    int used = !strcmp(word, "usemtl") || !strcmp(word, "o") || !strcmp(word, "g");
    if (used) fprintf(o->out, "%s %s\n", word, take_name(&o->text));
    return note(o, used ? SPH_READ_WORD : SPH_READ_UNSUPPORTED, err);
}

/* The next record: a line that ends in \ goes on in the next one. */
static int next_record(struct obj *o) {
    for (char *c = o->text.at; c < o->text.end && *c != '\n'; c++)
        if (*c == '\\' && (c[1] == '\n' || (c[1] == '\r' && c[2] == '\n')))
            memset(c, ' ', c[1] == '\n' ? 2 : 3), o->text.line++;
    return sph_text_line(&o->text);
}

int sph_obj_check(const char *path, int skip, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err) {
    struct obj o = {.scene = scene, .lines = lines, .skip = skip};
    if (sph_text_open(&o.text, path, err)) return -1;
    o.out = open_memstream(&lines->text, &lines->size);
    int bad = o.out ? 0 : sph_fail(err, "%s: no memory", path);
    while (!bad && next_record(&o))
        bad = take_record(&o, err);
    for (int list = 0; list < LISTS && !bad; list++)
        if (o.highest[list] > o.n[list])
            bad = sph_fail(err, "%s:%" PRIu64 ": `f`: %s %" PRIu64 ", but the file has %" PRIu64,
                           path, o.line[list], called[list], o.highest[list], o.n[list]);
    if (!bad && o.smooth && !o.n[NORMAL])
        bad = sph_ledger_note(&scene->ledger, SPH_READ_FLAT, path, o.smooth, err);
    sph_text_close(&o.text);
    if (o.out && fclose(o.out)) bad = sph_fail(err, "%s: no memory", path);
    return bad ? -1 : 0;
}
