/* nff_write.c - writes a scene as NFF; see scene.h and docs/use/scene_format.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * Numbers are written with 15 digits where these give the same double back, with 17 otherwise,
 * whatever the locale. `f` is written whenever the material changes, so that spheres keep
 * their order; facets follow them in theirs.
 */
#include "scene/scene.h"

#include <errno.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

static void put_number(FILE *file, double value) {
    char text[40];
    snprintf(text, sizeof text, "%.15g", value);
    if (strtod(text, NULL) != value) snprintf(text, sizeof text, "%.17g", value);
    putc(' ', file);
    fputs(text, file);
}

static void put_record(FILE *file, const char *word, const double *values, int n) {
    fputs(word, file);
    for (int i = 0; i < n; i++)
        put_number(file, values[i]);
    putc('\n', file);
}

static void put_point(FILE *file, const char *word, struct sph_vec v) {
    put_record(file, word, (double[]){v.x, v.y, v.z}, 3);
}

/* What the primitives that are written next look like. */
struct look {
    const struct sph_scene *scene;
    uint32_t material, texture, motion;
    int sum; /* `shading sum` is in force */
};

static void put_material(struct look *look, FILE *file, uint32_t material) {
    const struct sph_material *m = &look->scene->materials[material];
    if (look->material == material) return;
    look->material = material;
    if (look->sum != m->sum.on) fputs(m->sum.on ? "shading sum\n" : "shading blend\n", file);
    look->sum = m->sum.on;
    put_record(file, "f",
               (double[]){m->rgb[0], m->rgb[1], m->rgb[2], m->kd, m->ks, m->shine, m->trans, m->ior,
                          m->sum.ka, m->sum.kr},
               m->sum.on ? 10 : 8);
}

static void put_motion(struct look *look, FILE *file, uint32_t motion) {
    const struct sph_motion *m = motion ? &look->scene->motions[motion - 1] : NULL;
    if (look->motion == motion) return;
    look->motion = motion;
    if (m)
        put_record(file, "move",
                   (double[]){m->step.x, m->step.y, m->step.z, m->grow, m->about.x, m->about.y,
                              m->about.z},
                   7);
    else
        fputs("still\n", file);
}

/* The name of an image: its path without the folder of the scene; quoted where it must be. */
static void put_image(const struct look *look, FILE *file, const char *word, const char *path) {
    const char *slash = strrchr(look->scene->path, '/');
    size_t folder = slash ? (size_t)(slash - look->scene->path) + 1 : 0;
    if (!strncmp(path, look->scene->path, folder)) path += folder;
    int bare = strpbrk(path, " \t#") == NULL && strcmp(path, "none") != 0;
    fprintf(file, bare ? "%s %s" : "%s \"%s\"", word, path);
}

/* `texture`, for spheres and planes. */
static void put_texture(struct look *look, FILE *file, uint32_t texture) {
    if (look->texture == texture) return;
    look->texture = texture;
    if (!texture) {
        fputs("texture none\n", file);
        return;
    }
    const struct sph_texture *t = &look->scene->textures[texture - 1];
    put_image(look, file, "texture", t->path);
    put_record(file, "", (double[]){t->repeat[0], t->repeat[1], t->offset[0], t->offset[1]}, 4);
    if (t->wrap[0]) fputs("clamp\n", file);
}

static void put_triangle(const struct look *look, FILE *file, const struct sph_facet *f) {
    put_image(look, file, "tt", look->scene->textures[f->texture - 1].path);
    putc('\n', file);
    for (int i = 0; i < 3; i++)
        put_record(file, "", (double[]){f->v[i].x, f->v[i].y, f->v[i].z, f->st[i][0], f->st[i][1]},
                   5);
}

static int same_point(struct sph_vec a, struct sph_vec b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Writes n triangles of one polygon, a fan. Pieces without area that the reader left out stand
 * between two triangles that do not follow each other. */
static void put_polygon(FILE *file, const struct sph_facet *f, uint32_t n) {
    uint32_t corners = n + 2;
    for (uint32_t i = 1; i < n; i++)
        corners += !same_point(f[i].v[1], f[i - 1].v[2]);
    fprintf(file, "p %u\n", corners);
    put_point(file, "", f->v[0]);
    put_point(file, "", f->v[1]);
    for (uint32_t i = 0; i < n; i++) {
        if (i > 0 && !same_point(f[i].v[1], f[i - 1].v[2])) put_point(file, "", f[i].v[1]);
        put_point(file, "", f[i].v[2]);
    }
}

/* Writes facet i and those that belong to its polygon; how many. */
static uint32_t put_facet(struct look *look, FILE *file, uint32_t i) {
    const struct sph_facet *f = &look->scene->facets[i];
    uint32_t n = 1;
    put_motion(look, file, f->motion);
    put_material(look, file, f->material);
    if (f->kind == SPH_PLANE) {
        put_texture(look, file, f->texture);
        put_record(file, "plane",
                   (double[]){f->v[0].x, f->v[0].y, f->v[0].z, f->v[1].x, f->v[1].y, f->v[1].z,
                              f->v[2].x, f->v[2].y, f->v[2].z},
                   9);
        return 1;
    }
    if (f->texture) {
        put_triangle(look, file, f);
        return 1;
    }
    while (i + n < look->scene->n_facets && f[n].group == f->group)
        n++;
    put_polygon(file, f, n);
    return n;
}

static void put_scene(const struct sph_scene *scene, FILE *file) {
    const struct sph_camera *camera = &scene->camera;
    fputs("# Sphaera scene ", file);
    for (const char *c = scene->name; *c; c++)
        putc((unsigned char)*c < 32 || *c == 127 ? '?' : *c, file);
    fprintf(file, "; spheres: %u, lights: %d", scene->n_spheres, scene->n_lights);
    if (scene->n_facets) fprintf(file, ", facets: %u", scene->n_facets);
    putc('\n', file);
    fputs("v\n", file);
    put_point(file, "from", camera->from);
    put_point(file, "at", camera->at);
    put_point(file, "up", camera->up);
    put_record(file, "angle", &camera->angle, 1);
    put_record(file, "hither", &camera->hither, 1);
    fprintf(file, "resolution %d %d\n", camera->width, camera->height);
    put_record(file, "b", scene->background, 3);
    put_record(file, "ambient", scene->ambient, 3);
    for (int i = 0; i < scene->n_lights; i++) {
        const struct sph_light *l = &scene->lights[i];
        put_record(file, "l",
                   (double[]){l->pos.x, l->pos.y, l->pos.z, l->rgb[0], l->rgb[1], l->rgb[2]}, 6);
    }
    struct look look = {scene, UINT32_MAX, 0, 0, 0};
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_sphere *s = &scene->spheres[i];
        put_motion(&look, file, s->motion);
        put_material(&look, file, s->material);
        put_texture(&look, file, s->texture);
        put_record(file, "s", (double[]){s->ctr.x, s->ctr.y, s->ctr.z, s->rad}, 4);
    }
    for (uint32_t i = 0; i < scene->n_facets;)
        i += put_facet(&look, file, i);
}

int sph_scene_write(const struct sph_scene *scene, FILE *file, struct sph_error *err) {
    locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c_locale) return sph_fail(err, "%s: no memory to write", scene->path);
    locale_t before = uselocale(c_locale);
    put_scene(scene, file);
    uselocale(before);
    freelocale(c_locale);
    if (fflush(file) || ferror(file))
        return sph_fail(err, "%s: cannot write: %s", scene->path, strerror(errno));
    return 0;
}
