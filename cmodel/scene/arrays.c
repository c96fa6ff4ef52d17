/* arrays.c - see arrays.h; nff_read.c does the same with records of a file
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/arrays.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common/number.h"
#include "scene/edit.h"
#include "scene/nesting.h"
#include "scene/nff_reader.h"
#include "scene/polygon.h"
#include "scene/vector.h"

static int is_number(double value) {
    return fabs(value) <= SPH_NUMBER_MAX;
}

/* Are the n numbers of a row, named by `names` one after another, such as a scene may have? */
static int check_row(const char *array, uint32_t row, const char *const *names, const double *value,
                     int n, struct sph_error *err) {
    for (int i = 0; i < n; i++)
        if (!is_number(value[i]))
            return sph_fail(err, "%s[%u]: %s is %g, no number up to %g", array, row, names[i],
                            value[i], SPH_NUMBER_MAX);
    return 0;
}

/* Are the colours or shares of a row within 0..1? */
static int check_unit(const char *array, uint32_t row, const char *const *names,
                      const double *value, int n, struct sph_error *err) {
    for (int i = 0; i < n; i++)
        if (!(value[i] >= 0 && value[i] <= 1))
            return sph_fail(err, "%s[%u]: %s is %g, not within 0 to 1", array, row, names[i],
                            value[i]);
    return 0;
}

static int check_colour(const char *name, const double rgb[3], struct sph_error *err) {
    for (int i = 0; i < 3; i++)
        if (!(rgb[i] >= 0 && rgb[i] <= 1))
            return sph_fail(err, "%s: %s is %g, not within 0 to 1", name, sph_nff_colour[i],
                            rgb[i]);
    return 0;
}

static int camera(const struct sph_arrays *a, struct sph_scene *scene, struct sph_error *err) {
    const struct {
        const char *name;
        struct sph_vec v;
    } vectors[] = {{"from", a->camera.from}, {"at", a->camera.at}, {"up", a->camera.up}};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
        const double v[3] = {vectors[i].v.x, vectors[i].v.y, vectors[i].v.z};
        for (int k = 0; k < 3; k++)
            if (!is_number(v[k]))
                return sph_fail(err, "camera: %s.%s is %g, no number up to %g", vectors[i].name,
                                sph_nff_point[k], v[k], SPH_NUMBER_MAX);
    }
    scene->camera = a->camera;
    memcpy(scene->background, a->background, sizeof scene->background);
    memcpy(scene->ambient, a->ambient, sizeof scene->ambient);
    return check_colour("background", a->background, err) ||
                   check_colour("ambient", a->ambient, err)
               ? -1
               : sph_camera_check(&scene->camera, "camera", err);
}

static int materials(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    static const char *const names[] = {"red", "green", "blue", "Kd",
                                        "Ks",  "Shine", "T",    "index of refraction"};
    enum { N = 8, UNITS = 5, SHINE = 5, T = 6, INDEX = 7 };
    for (uint32_t i = 0; i < a->n_materials; i++) {
        const double *f = a->materials + (size_t)N * i;
        if (check_row("materials", i, names, f, N, err) ||
            check_unit("materials", i, names, f, UNITS, err) ||
            check_unit("materials", i, names + T, f + T, 1, err))
            return -1;
        if (f[SHINE] < 0 || f[INDEX] < 0)
            return sph_fail(err, "materials[%u]: %s is negative", i,
                            names[f[SHINE] < 0 ? SHINE : INDEX]);
        struct sph_material m = {{f[0], f[1], f[2]}, f[3], f[4], f[5], f[6], f[7],
                                 (int)i + 1,         {0},  0};
        const double share[2] = {m.kd, m.ks};
        if (sph_nff_shade(r, share, &m, err) || sph_scene_add_material(r->scene, &m, err) ||
            sph_nff_note(r, SPH_READ_MATERIAL, i + 1, err))
            return -1;
    }
    return 0;
}

/* The material of a row. */
static int material_of(const struct sph_arrays *a, const char *array, const uint32_t *of,
                       uint32_t row, uint32_t *material, struct sph_error *err) {
    *material = of ? of[row] : 0;
    if (*material < a->n_materials) return 0;
    return sph_fail(err, "%s[%u]: %u is none of %u materials", array, row, *material,
                    a->n_materials);
}

/* The images that rows name; files are opened when a machine is built. */
static int textures(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    for (uint32_t i = 0; i < a->n_textures; i++) {
        struct sph_texture t = {.colours = SPH_COLOURS_OF_FILE, .repeat = {1, 1}, .line = i + 1};
        if (!a->textures[i] || !a->textures[i][0])
            return sph_fail(err, "textures[%u]: the name of the image file is empty", i);
        if (snprintf(t.path, sizeof t.path, "%s", a->textures[i]) >= (int)sizeof t.path)
            return sph_fail(err, "textures[%u]: the name of the image file is too long", i);
        if (sph_scene_add_texture(r->scene, &t, err)) return -1;
    }
    return 0;
}

/* The texture of a row, as primitives have it: 0 if it has none. */
static int texture_of(const struct sph_arrays *a, const char *array, const uint32_t *of,
                      uint32_t row, uint32_t *texture, struct sph_error *err) {
    *texture = of && of[row] != SPH_ID_NONE ? of[row] + 1 : 0;
    if (*texture <= a->n_textures) return 0;
    return sph_fail(err, "%s[%u]: %u is none of %u textures", array, row, of[row], a->n_textures);
}

static int spheres(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    static const char *const names[] = {"x", "y", "z", "radius"};
    for (uint32_t i = 0; i < a->n_spheres; i++) {
        const double *s = a->spheres + (size_t)4 * i;
        uint32_t material, texture;
        if (material_of(a, "sphere_materials", a->sphere_materials, i, &material, err) ||
            texture_of(a, "sphere_textures", a->sphere_textures, i, &texture, err) ||
            check_row("spheres", i, names, s, 4, err))
            return -1;
        if (s[3] == 0) return sph_fail(err, "spheres[%u]: radius is 0", i);
        if (s[3] < 0 && sph_material_clear(&r->scene->materials[material]) &&
            sph_scene_hollow(r->scene, &material, err))
            return -1;
        if (sph_scene_add_sphere(r->scene, sph_vec_of(s[0], s[1], s[2]), fabs(s[3]), material,
                                 i + 1, err) ||
            sph_nff_note(r, SPH_READ_SPHERE, i + 1, err))
            return -1;
        r->scene->spheres[r->scene->n_spheres - 1].texture = texture;
    }
    return 0;
}

static struct sph_vec vec(const double v[3]) {
    return sph_vec_of(v[0], v[1], v[2]);
}

static int triangles(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    static const char *const names[] = {"corner 0 x", "corner 0 y", "corner 0 z",
                                        "corner 1 x", "corner 1 y", "corner 1 z",
                                        "corner 2 x", "corner 2 y", "corner 2 z"};
    static const char *const places[] = {"corner 0 s", "corner 0 t", "corner 1 s",
                                         "corner 1 t", "corner 2 s", "corner 2 t"};
    for (uint32_t i = 0; i < a->n_triangles; i++) {
        const double *v = a->triangles + (size_t)9 * i,
                     *n = a->normals ? a->normals + (size_t)9 * i : NULL,
                     *st = a->st ? a->st + (size_t)6 * i : NULL;
        struct sph_facet f = {.kind = SPH_TRIANGLE, .group = r->n_groups, .line = i + 1};
        if (material_of(a, "triangle_materials", a->triangle_materials, i, &f.material, err) ||
            texture_of(a, "triangle_textures", a->triangle_textures, i, &f.texture, err) ||
            check_row("triangles", i, names, v, 9, err) ||
            (st && check_row("st", i, places, st, 6, err)) ||
            (n && check_row("normals", i, names, n, 9, err)))
            return -1;
        for (int k = 0; k < 3; k++) {
            f.v[k] = vec(v + 3 * (size_t)k);
            if (n) f.n[k] = vec(n + 3 * (size_t)k);
            if (st) memcpy(f.st[k], st + 2 * (size_t)k, sizeof f.st[k]);
        }
        f.smooth = n && sph_smooth_given(f.n);
        int empty = sph_triangle_empty(f.v[0], f.v[1], f.v[2]);
        if (sph_nff_note(r, empty ? SPH_READ_NO_AREA : SPH_READ_TRIANGLE, i + 1, err)) return -1;
        if (empty) continue;
        r->n_groups++;
        if (sph_scene_add_facet(r->scene, &f, err)) return -1;
    }
    return 0;
}

static int planes(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    static const char *const names[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (uint32_t i = 0; i < a->n_planes; i++) {
        const double *p = a->planes + (size_t)6 * i;
        struct sph_facet f = {.kind = SPH_PLANE, .group = r->n_groups, .line = i + 1};
        if (material_of(a, "plane_materials", a->plane_materials, i, &f.material, err) ||
            check_row("planes", i, names, p, 6, err))
            return -1;
        f.v[0] = vec(p), f.v[1] = vec(p + 3);
        f.v[2] = sph_plane_axis(f.v[1]);
        if (p[3] == 0 && p[4] == 0 && p[5] == 0)
            return sph_fail(err, "planes[%u]: the normal is zero", i);
        r->n_groups++;
        if (sph_scene_add_facet(r->scene, &f, err) || sph_nff_note(r, SPH_READ_PLANE, i + 1, err))
            return -1;
    }
    return 0;
}

static int lights(struct sph_reader *r, const struct sph_arrays *a, struct sph_error *err) {
    static const char *const places[] = {"x", "y", "z"};
    if (a->n_lights > SPH_MAX_LIGHTS)
        return sph_fail(err, "lights: %u of them, more than %d", a->n_lights, SPH_MAX_LIGHTS);
    for (uint32_t i = 0; i < a->n_lights; i++) {
        const double *at = a->lights + (size_t)3 * i, white[3] = {1, 1, 1},
                     *rgb = a->colours ? a->colours + (size_t)3 * i : white;
        if (check_row("lights", i, places, at, 3, err) ||
            check_row("light_colours", i, sph_nff_colour, rgb, 3, err))
            return -1;
        for (int k = 0; k < 3; k++)
            if (rgb[k] < 0)
                return sph_fail(err, "light_colours[%u]: %s is negative", i, sph_nff_colour[k]);
        r->plain[i] = !a->colours;
        if (sph_scene_add_light(r->scene, vec(at), rgb[0], rgb[1], rgb[2], err) ||
            sph_nff_note(r, SPH_READ_LIGHT, i + 1, err))
            return -1;
        r->scene->lights[i].line = i + 1;
    }
    return 0;
}

int sph_scene_of_arrays(const struct sph_arrays *a, struct sph_scene *scene,
                        struct sph_error *err) {
    struct sph_reader r = {.view_line = 1};
    memset(scene, 0, sizeof *scene);
    sph_nff_start(&r, scene, NULL);
    sph_scene_set_path(scene, a->name);
    r.lex.path = scene->path;
    int bad = camera(a, scene, err) || materials(&r, a, err) || textures(&r, a, err) ||
              spheres(&r, a, err) || triangles(&r, a, err) || planes(&r, a, err) ||
              lights(&r, a, err) || sph_nff_finish(&r, err) || sph_scene_nest(scene, err);
    if (!bad) return 0;
    sph_scene_free(scene);
    return -1;
}
