/* nff_write.c - writes a scene as NFF; see scene.h and docs/scene_format.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * Numbers are written with 15 digits where these give the same double back, with 17 otherwise,
 * whatever the locale. `f` is written whenever the material changes, so that spheres keep
 * their order.
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

static void put_scene(const struct sph_scene *scene, FILE *file) {
    const struct sph_camera *camera = &scene->camera;
    fputs("# Sphaera scene ", file);
    for (const char *c = scene->name; *c; c++)
        putc((unsigned char)*c < 32 || *c == 127 ? '?' : *c, file);
    fprintf(file, "; spheres: %u, lights: %d\n", scene->n_spheres, scene->n_lights);
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
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_sphere *s = &scene->spheres[i];
        const struct sph_material *m = &scene->materials[s->material];
        if (i == 0 || s->material != s[-1].material)
            put_record(file, "f",
                       (double[]){m->rgb[0], m->rgb[1], m->rgb[2], m->kd, m->ks, m->shine, m->trans,
                                  m->ior},
                       8);
        put_record(file, "s", (double[]){s->ctr.x, s->ctr.y, s->ctr.z, s->rad}, 4);
    }
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
