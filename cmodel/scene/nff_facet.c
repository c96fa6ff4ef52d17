/* nff_facet.c - polygons, triangles and planes: `p`, `pp`, `tt`, `plane`; see nff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "scene/nff_reader.h"
#include "scene/polygon.h"

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

/* Notes a polygon that is not flat, for the message of build. */
static void note_bent(struct sph_scene *scene, uint32_t line, double bent) {
    if (!scene->n_bent++ || bent > scene->bent) scene->bent = bent, scene->bent_line = line;
}

/* p n (x y z)..., pp n (x y z nx ny nz)...: facets are flat, so normals are read and not used. The
 * triangles of a polygon that is not flat are polygons of their own: one may see another. */
int sph_nff_take_polygon(struct sph_reader *r, int with_normals, struct sph_error *err) {
    const char *record = with_normals ? "pp" : "p";
    struct sph_vec corner[SPH_MAX_CORNERS], normal;
    int index[SPH_MAX_CORNERS - 2][3], n = 0;
    struct sph_facet facet = {.kind = SPH_TRIANGLE};
    struct sph_error why = {{0}};
    double bent = 0;
    facet.line = r->lex.token_line;
    if (sph_nff_material(r, record, "polygon", &facet.material, err) ||
        take_count(r, record, &n, err))
        return -1;
    for (int i = 0; i < n; i++)
        if (sph_nff_vec(r, record, &corner[i], err) ||
            (with_normals && sph_nff_vec(r, record, &normal, err)))
            return -1;
    int count = sph_polygon_fan(corner, n, index, &bent, &why);
    if (count < 0)
        return sph_fail(err, "%s:%u: `%s`: %.300s", r->lex.path, facet.line, record, why.text);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            facet.v[k] = corner[index[i][k]];
        facet.group = r->n_groups;
        if (sph_scene_add_facet(r->scene, &facet, err)) return -1;
        if (bent > 0 || i == count - 1) r->n_groups++;
    }
    if (bent > 0) note_bent(r->scene, facet.line, bent);
    return 0;
}

/* tt FILE and three times x y z u v */
int sph_nff_take_tt(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"u", "v"};
    struct sph_texture texture = {.repeat = {1, 1}, .line = r->lex.token_line};
    struct sph_facet facet = {.kind = SPH_TRIANGLE, .group = r->n_groups, .line = texture.line};
    if (sph_nff_material(r, "tt", "triangle", &facet.material, err)) return -1;
    int got = sph_nff_image(r, "tt", texture.path, err);
    if (got < 0 || (got && sph_nff_find_texture(r, &texture, &facet.texture, err))) return -1;
    for (int i = 0; i < 3; i++)
        if (sph_nff_vec(r, "tt", &facet.v[i], err) ||
            sph_nff_numbers(r, "tt", names, 2, facet.st[i], err))
            return -1;
    if (sph_triangle_empty(facet.v[0], facet.v[1], facet.v[2]))
        return sph_fail(err, "%s:%u: `tt`: the triangle has no area", r->lex.path, facet.line);
    r->n_groups++;
    return sph_scene_add_facet(r->scene, &facet, err);
}

/* The axis that s of a plane follows if the file names none: x, or z if that is nearer to lying in
 * the plane. */
static struct sph_vec default_axis(struct sph_vec n) {
    return fabs(n.x) <= fabs(n.z) ? sph_vec_of(1, 0, 0) : sph_vec_of(0, 0, 1);
}

/* plane x y z nx ny nz [sx sy sz] */
int sph_nff_take_plane(struct sph_reader *r, struct sph_error *err) {
    static const char *const normal[] = {"nx", "ny", "nz"}, *const along[] = {"sx", "sy", "sz"};
    struct sph_facet facet = {.kind = SPH_PLANE, .group = r->n_groups};
    double n[3], s[3];
    facet.line = r->lex.token_line;
    if (sph_nff_material(r, "plane", "plane", &facet.material, err) ||
        sph_nff_vec(r, "plane", &facet.v[0], err) || sph_nff_numbers(r, "plane", normal, 3, n, err))
        return -1;
    facet.v[1] = sph_vec_of(n[0], n[1], n[2]);
    facet.v[2] = default_axis(facet.v[1]);
    if (!(fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2]))) > 0))
        return sph_fail(err, "%s:%u: `plane`: the normal is zero", r->lex.path, facet.line);
    int got = sph_nff_more(r, "plane", along, 3, s, err);
    if (got < 0) return -1;
    if (got) facet.v[2] = sph_vec_of(s[0], s[1], s[2]);
    if (sph_parallel(facet.v[1], facet.v[2]))
        return sph_fail(err, "%s:%u: `plane`: the direction of s is along the normal, or zero",
                        r->lex.path, facet.line);
    facet.texture = r->texture;
    for (int i = 0; i < 2 && r->texture; i++) {
        facet.st[0][i] = r->scene->textures[r->texture - 1].repeat[i];
        facet.st[1][i] = r->scene->textures[r->texture - 1].offset[i];
    }
    r->n_groups++;
    return sph_scene_add_facet(r->scene, &facet, err);
}
