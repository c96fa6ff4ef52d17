/* aff_mesh.c - triangles of AFF: `m`, `tpa`; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/aff_reader.h"

#include <stdlib.h>
#include <string.h>

enum { VERTICES, NORMALS, COORDS, LISTS };

/* The lists of a mesh: three numbers each, of texture coordinates two. */
struct mesh {
    double *list[LISTS];
    uint32_t n[LISTS];
    int given[LISTS];
    struct sph_facet facet; /* what all triangles have */
};

static const char *const words[LISTS] = {"vertices", "normals", "texturecoords"};
static const char *const called[LISTS] = {"vertex", "normal", "texture coordinate"};
static const char *const numbers[] = {"x", "y", "z"}, *const coords[] = {"u", "v"};

static int take_list(struct sph_aff *a, struct mesh *m, int which, struct sph_error *err) {
    const char *word = words[which], *const *names = which == COORDS ? coords : numbers;
    int size = which == COORDS ? 2 : 3;
    struct sph_texture texture = {.repeat = {1, 1}, .line = a->top_line};
    uint32_t n = 0;
    if (m->given[which]) return sph_nff_fail(&a->r, err, word, "given twice");
    if (sph_aff_count(a, word, "how many", 0, SPH_AFF_COUNT, &n, err)) return -1;
    if (which == COORDS) {
        int got = sph_nff_image(&a->r, word, texture.path, err);
        if (got < 0 || (got && sph_nff_find_texture(&a->r, &texture, &m->facet.texture, err)))
            return -1;
    }
    m->given[which] = 1;
    for (; m->n[which] < n; m->n[which]++) {
        uint32_t at = m->n[which];
        if (sph_aff_room(a, &m->list[which], at, (size_t)size * sizeof(double), err) ||
            sph_nff_numbers(&a->r, word, names, size, m->list[which] + (size_t)size * at, err))
            return -1;
    }
    return 0;
}

/* Three elements of a list, by their numbers. */
static int take_three(struct sph_aff *a, const struct mesh *m, int which, const double *at[3],
                      struct sph_error *err) {
    for (int k = 0; k < 3; k++) {
        double value;
        if (sph_lex_number(&a->r.lex, "triangles", called[which], &value, err)) return -1;
        if (!(value >= 0 && value < m->n[which] && value == floor(value))) {
            sph_fail(err, "%s:%u: `triangles`: %s %g is none of 0 to %lld of this mesh",
                     a->r.lex.path, a->r.lex.token_line, called[which], value,
                     (long long)m->n[which] - 1);
            return -1;
        }
        at[k] = m->list[which] + (size_t)value * (which == COORDS ? 2 : 3);
    }
    return 0;
}

static int take_triangle(struct sph_aff *a, const struct mesh *m, struct sph_error *err) {
    struct sph_facet f = m->facet;
    for (int which = 0; which < LISTS; which++) {
        const double *at[3] = {NULL, NULL, NULL};
        if (!m->given[which]) continue;
        if (take_three(a, m, which, at, err)) return -1;
        for (int k = 0; k < 3; k++) {
            if (which == VERTICES) f.v[k] = sph_vec_of(at[k][0], at[k][1], at[k][2]);
            if (which == NORMALS) f.n[k] = sph_vec_of(at[k][0], at[k][1], at[k][2]);
            if (which == COORDS) memcpy(f.st[k], at[k], sizeof f.st[k]);
        }
    }
    f.group = a->r.n_groups++;
    f.smooth = m->given[NORMALS] && sph_smooth_given(f.n);
    return sph_scene_add_facet(a->r.scene, &f, err);
}

static int take_lists(struct sph_aff *a, struct mesh *m, struct sph_error *err) {
    for (int got; (got = sph_lex_peek(&a->r.lex, err)) != 0;) {
        int which = 0;
        if (got < 0) return -1;
        sph_lex_take(&a->r.lex);
        if (!strcmp(a->r.lex.token, "triangles")) return 0;
        while (which < LISTS && strcmp(a->r.lex.token, words[which]) != 0)
            which++;
        if (which == LISTS)
            return sph_fail(err,
                            "%s:%u: `m`: `%s` is none of vertices, normals, texturecoords and "
                            "triangles",
                            a->r.lex.path, a->r.lex.token_line, sph_lex_printable(&a->r.lex));
        if (take_list(a, m, which, err)) return -1;
    }
    return sph_fail(err, "%s:%u: the file ends within `m`, before triangles", a->r.lex.path,
                    a->r.lex.token_line);
}

/* m vertices N .. [normals N ..] [texturecoords N FILE ..] triangles N ..: a triangle has three
 * numbers of each list, which count from 0. */
int sph_aff_take_m(struct sph_aff *a, struct sph_error *err) {
    struct mesh m = {.facet = {.kind = SPH_TRIANGLE, .line = a->top_line}};
    uint32_t n = 0;
    int bad = sph_nff_material(&a->r, "m", "mesh", &m.facet.material, err) ||
              take_lists(a, &m, err) ||
              sph_aff_count(a, "triangles", "how many", 0, SPH_MAX_FACETS, &n, err);
    if (!bad && !m.given[VERTICES])
        bad = sph_nff_fail(&a->r, err, "m", "triangles without vertices");
    while (!bad && n--)
        bad = take_triangle(a, &m, err);
    for (int which = 0; which < LISTS; which++)
        free(m.list[which]);
    return bad ? -1 : 0;
}

/* tpa N and N times: a time, and three points with normals */
int sph_aff_take_tpa(struct sph_aff *a, struct sph_error *err) {
    struct sph_facet f = {.kind = SPH_TRIANGLE, .line = a->top_line, .group = a->r.n_groups++};
    uint32_t n;
    if (sph_nff_material(&a->r, "tpa", "triangle", &f.material, err) ||
        sph_aff_count(a, "tpa", "number of times", 1, SPH_AFF_COUNT, &n, err) ||
        sph_aff_room(a, &a->patches, a->n_patches, sizeof *a->patches, err))
        return -1;
    struct sph_aff_patch *p = &a->patches[a->n_patches++];
    *p = (struct sph_aff_patch){.facet = a->r.scene->n_facets};
    for (; p->n < n; p->n++) {
        if (sph_aff_room(a, &p->at, p->n, sizeof *p->at, err)) return -1;
        struct sph_aff_corners *now = &p->at[p->n];
        if (sph_lex_number(&a->r.lex, "tpa", "time", &now->time, err)) return -1;
        if (p->n && !(now->time > now[-1].time))
            return sph_fail(err, "%s:%u: `tpa`: time %g does not come after the one before, %g",
                            a->r.lex.path, a->r.lex.token_line, now->time, now[-1].time);
        for (int k = 0; k < 3; k++)
            if (sph_nff_vec(&a->r, "tpa", &now->v[k], err) ||
                sph_nff_vec(&a->r, "tpa", &now->n[k], err))
                return -1;
    }
    return sph_scene_add_facet(a->r.scene, &f, err);
}
