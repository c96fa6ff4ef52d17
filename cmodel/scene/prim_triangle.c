/* prim_triangle.c - triangles in a scene file: `p`, `pp`, `tt`, `ttp`, `c`; see scene.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "scene/prim.h"
#include "scene/frustum.h"
#include "scene/polygon.h"
#include "scene/vector.h"

/* The number of corners of `p` or `pp`. */
static int take_count(struct sph_reader *r, const char *record, int *n, struct sph_error *err) {
    double count;
    if (sph_lex_number(&r->lex, record, "number of corners", &count, err)) return -1;
    if (!(count >= 3 && count <= SPH_MAX_CORNERS && count == floor(count)))
        return sph_fail(err, "%s:%u: `%s`: %g corners; a polygon has 3 to %d", r->lex.path,
                        r->lex.token_line, record, count, SPH_MAX_CORNERS);
    *n = (int)count;
    return 0;
}

/* p n (x y z)..., pp n (x y z nx ny nz)...: normals count if none is zero. The triangles of a
 * polygon that is not flat are polygons of their own: one may see another. */
static int take_polygon(struct sph_reader *r, int with_normals, struct sph_error *err) {
    const char *record = with_normals ? "pp" : "p";
    struct sph_vec corner[SPH_MAX_CORNERS], normal[SPH_MAX_CORNERS];
    int index[SPH_MAX_CORNERS - 2][3], n = 0;
    struct sph_facet facet = {.kind = SPH_TRIANGLE};
    struct sph_error why = {{0}};
    double bent = 0;
    facet.smooth = with_normals;
    facet.line = r->lex.token_line;
    if (sph_nff_material(r, record, "polygon", &facet.material, err) ||
        take_count(r, record, &n, err))
        return -1;
    for (int i = 0; i < n; i++)
        if (sph_nff_vec(r, record, &corner[i], err) ||
            (with_normals && sph_nff_vec(r, record, &normal[i], err)))
            return -1;
    for (int i = 0; i < n && with_normals; i++)
        facet.smooth &= sph_vec_length(normal[i]) > 0;
    int count = sph_polygon_cut(corner, n, index, &bent, &why);
    if (!count) return sph_nff_note(r, SPH_READ_NO_AREA, facet.line, err);
    if (count < 0)
        return sph_fail(err, "%s:%u: `%s`: %.300s", r->lex.path, facet.line, record, why.text);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            facet.v[k] = corner[index[i][k]];
        for (int k = 0; k < 3 && facet.smooth; k++)
            facet.n[k] = normal[index[i][k]];
        facet.group = r->n_groups;
        if (sph_scene_add_facet(r->scene, &facet, err)) return -1;
        if (bent > 0 || i == count - 1) r->n_groups++;
    }
    return bent > 0 ? sph_nff_note(r, SPH_READ_BENT, facet.line, err) : 0;
}

/* tt FILE [srgb|linear] and three times x y z u v; ttp: x y z nx ny nz u v */
static int take_image(struct sph_reader *r, const char *word, int with_normals,
                      struct sph_error *err) {
    static const char *const names[] = {"u", "v"};
    struct sph_texture texture = {.repeat = {1, 1}, .line = r->lex.token_line};
    struct sph_facet facet = {.kind = SPH_TRIANGLE, .group = r->n_groups, .line = texture.line};
    if (sph_nff_material(r, word, "triangle", &facet.material, err)) return -1;
    int got = sph_nff_image(r, word, texture.path, err);
    if (got < 0 || (got && sph_nff_colours(r, &texture.colours, err)) ||
        (got && sph_nff_find_texture(r, &texture, &facet.texture, err)))
        return -1;
    for (int i = 0; i < 3; i++)
        if (sph_nff_vec(r, word, &facet.v[i], err) ||
            (with_normals && sph_nff_vec(r, word, &facet.n[i], err)) ||
            sph_nff_numbers(r, word, names, 2, facet.st[i], err))
            return -1;
    facet.smooth = with_normals && sph_smooth_given(facet.n);
    if (sph_triangle_empty(facet.v[0], facet.v[1], facet.v[2]))
        return sph_nff_note(r, SPH_READ_NO_AREA, facet.line, err);
    r->n_groups++;
    return sph_scene_add_facet(r->scene, &facet, err);
}

static int take_tt(struct sph_reader *r, struct sph_error *err) {
    return take_image(r, "tt", 0, err);
}

static int take_ttp(struct sph_reader *r, struct sph_error *err) {
    return take_image(r, "ttp", 1, err);
}

static int take_p(struct sph_reader *r, struct sph_error *err) {
    return take_polygon(r, 0, err);
}

static int take_pp(struct sph_reader *r, struct sph_error *err) {
    return take_polygon(r, 1, err);
}

static void put_tt(struct sph_nff_writer *w, const struct sph_facet *f) {
    sph_nff_put_image(w, f->smooth ? "ttp" : "tt", w->scene->textures[f->texture - 1].path);
    sph_nff_put_colours(w, f->texture);
    putc('\n', w->file);
    for (int i = 0; i < 3; i++) {
        double p[] = {f->v[i].x, f->v[i].y, f->v[i].z, f->st[i][0], f->st[i][1]};
        if (f->smooth) {
            sph_nff_put(w, "", p, 3);
            sph_nff_put_point(w, "", f->n[i]);
            sph_nff_put(w, "", p + 3, 2);
        } else {
            sph_nff_put(w, "", p, 5);
        }
    }
}

/* A triangle with normals stands by itself, whatever polygon it was of. */
static void put_smooth(struct sph_nff_writer *w, const struct sph_facet *f) {
    fputs("pp 3\n", w->file);
    for (int i = 0; i < 3; i++)
        sph_nff_put(
            w, "", (double[]){f->v[i].x, f->v[i].y, f->v[i].z, f->n[i].x, f->n[i].y, f->n[i].z}, 6);
}

/* c base(3) radius apex(3) radius: a cone or cylinder, as triangles. */
static int take_c(struct sph_reader *r, struct sph_error *err) {
    struct sph_frustum cone = {.line = r->lex.token_line};
    struct sph_facet look = {.line = cone.line};
    if (sph_nff_material(r, "c", "cone", &look.material, err) ||
        sph_nff_vec(r, "c", &cone.base, err) ||
        sph_lex_number(&r->lex, "c", "base radius", &cone.base_rad, err) ||
        sph_nff_vec(r, "c", &cone.apex, err) ||
        sph_lex_number(&r->lex, "c", "apex radius", &cone.apex_rad, err))
        return -1;
    return sph_scene_add_frustum(r->scene, &cone, r->round, &look, &r->n_groups, err);
}

static void put_cone(struct sph_nff_writer *w, const struct sph_frustum *c) {
    sph_nff_put(w, "c",
                (double[]){c->base.x, c->base.y, c->base.z, c->base_rad, c->apex.x, c->apex.y,
                           c->apex.z, c->apex_rad},
                8);
}

static int same_point(struct sph_vec a, struct sph_vec b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Whether a corner stands there twice: then it cannot be told where an ear goes. */
static int has_twin(const struct sph_vec *corner, uint32_t n) {
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = 0; k < i; k++)
            if (same_point(corner[i], corner[k])) return 1;
    return 0;
}

/* The outline of n triangles that were cut off as ears, corner 0 first: each ear goes back between
 * its neighbours, the last first. How many corners; 0 if a piece without area is missing, or the
 * outline touches itself in a corner. */
static uint32_t outline_of(const struct sph_facet *f, uint32_t n, struct sph_vec *corner) {
    uint32_t count = 3;
    memcpy(corner, f[n - 1].v, sizeof f->v);
    for (uint32_t i = n - 1; i-- > 0; count++) {
        uint32_t k = 0;
        while (k < count && !(same_point(corner[k], f[i].v[0]) &&
                              same_point(corner[(k + 1) % count], f[i].v[2])))
            k++;
        if (k == count) return 0;
        memmove(&corner[k + 2], &corner[k + 1], (count - k - 1) * sizeof *corner);
        corner[k + 1] = f[i].v[1];
    }
    return has_twin(corner, count) ? 0 : count;
}

static void put_corners(struct sph_nff_writer *w, const struct sph_vec *corner, uint32_t n) {
    fprintf(w->file, "p %u\n", n);
    for (uint32_t i = 0; i < n; i++)
        sph_nff_put_point(w, "", corner[i]);
}

/* Writes n triangles of a polygon that was cut by ears; those of a gap one by one. */
static void put_ears(struct sph_nff_writer *w, const struct sph_facet *f, uint32_t n) {
    struct sph_vec corner[SPH_MAX_CORNERS + 1];
    uint32_t corners = outline_of(f, n, corner);
    if (corners) put_corners(w, corner, corners);
    for (uint32_t i = 0; i < n && !corners; i++)
        put_corners(w, f[i].v, 3);
}

static int is_fan(const struct sph_facet *f, uint32_t n) {
    for (uint32_t i = 1; i < n; i++)
        if (!same_point(f[i].v[0], f[0].v[0])) return 0;
    return 1;
}

/* Writes n triangles of one polygon, a fan. Pieces without area that the reader left out stand
 * between two triangles that do not follow each other. */
static void put_fan(struct sph_nff_writer *w, const struct sph_facet *f, uint32_t n) {
    uint32_t corners = n + 2;
    for (uint32_t i = 1; i < n; i++)
        corners += !same_point(f[i].v[1], f[i - 1].v[2]);
    fprintf(w->file, "p %u\n", corners);
    sph_nff_put_point(w, "", f->v[0]);
    sph_nff_put_point(w, "", f->v[1]);
    for (uint32_t i = 0; i < n; i++) {
        if (i > 0 && !same_point(f[i].v[1], f[i - 1].v[2])) sph_nff_put_point(w, "", f[i].v[1]);
        sph_nff_put_point(w, "", f[i].v[2]);
    }
}

static uint32_t write(struct sph_nff_writer *w, uint32_t i) {
    const struct sph_facet *f = &w->scene->facets[i];
    uint32_t n = 1;
    sph_nff_put_motion(w, f->motion);
    sph_nff_put_material(w, f->material);
    if (f->texture) {
        put_tt(w, f);
        return 1;
    }
    if (f->smooth) {
        put_smooth(w, f);
        return 1;
    }
    while (i + n < w->scene->n_facets &&
           (f->frustum ? f[n].frustum == f->frustum : f[n].group == f->group))
        n++;
    if (f->frustum)
        put_cone(w, &w->scene->frusta[f->frustum - 1]);
    else if (is_fan(f, n))
        put_fan(w, f, n);
    else
        put_ears(w, f, n);
    return n;
}

static const struct sph_nff_word words[] = {
    {"p", take_p, SPH_READ_POLYGON},    {"pp", take_pp, SPH_READ_POLYGON},
    {"tt", take_tt, SPH_READ_TRIANGLE}, {"ttp", take_ttp, SPH_READ_TRIANGLE},
    {"c", take_c, SPH_READ_CONE},       {0}};
const struct sph_prim_scene sph_prim_scene_triangle = {
    .words = words, .write = write, .points = 3, .wants = "finite corners"};
