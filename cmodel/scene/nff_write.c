/* nff_write.c - writes a scene as NFF; see scene.h and docs/reference/scene_format.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * The same text whatever the locale. `f` is written whenever the material changes, so that spheres
 * keep their order; facets follow them in theirs.
 */
#include "scene/prim.h"

#include <errno.h>
#include <locale.h>
#include <string.h>

static void put_scene(const struct sph_scene *scene, FILE *file) {
    const struct sph_camera *camera = &scene->camera;
    fputs("# Sphaera scene ", file);
    for (const char *c = scene->name; *c; c++)
        putc((unsigned char)*c < 32 || *c == 127 ? '?' : *c, file);
    fprintf(file, "; spheres: %u, lights: %d", scene->n_spheres, scene->n_lights);
    uint32_t facets, cones;
    sph_scene_count(scene, &facets, &cones);
    if (facets) fprintf(file, ", facets: %u", facets);
    if (cones) fprintf(file, ", cones: %u", cones);
    putc('\n', file);
    fputs("v\n", file);
    struct sph_nff_writer w = {.scene = scene, .file = file, .material = UINT32_MAX, .shading = -1};
    sph_nff_put_point(&w, "from", camera->from);
    sph_nff_put_point(&w, "at", camera->at);
    sph_nff_put_point(&w, "up", camera->up);
    sph_nff_put(&w, "angle", &camera->angle, 1);
    sph_nff_put(&w, "hither", &camera->hither, 1);
    if (camera->shift[0] != 0 || camera->shift[1] != 0) sph_nff_put(&w, "shift", camera->shift, 2);
    fprintf(file, "resolution %d %d\n", camera->width, camera->height);
    for (uint32_t i = 0; i < scene->n_flights; i++) {
        const struct sph_flight *f = &scene->flights[i];
        sph_nff_put(
            &w, "fly",
            (double[]){f->frame, f->from.x, f->from.y, f->from.z, f->at.x, f->at.y, f->at.z}, 7);
    }
    sph_nff_put(&w, "b", scene->background, 3);
    sph_nff_put(&w, "ambient", scene->ambient, 3);
    for (int i = 0; i < scene->n_lights; i++) {
        const struct sph_light *l = &scene->lights[i];
        sph_nff_put(&w, "l",
                    (double[]){l->pos.x, l->pos.y, l->pos.z, l->rgb[0], l->rgb[1], l->rgb[2]}, 6);
    }
    for (uint32_t i = 0; i < scene->n_spheres;)
        i += sph_prim_scene_of(SPH_SPHERE)->write(&w, i);
    for (uint32_t i = 0; i < scene->n_facets;)
        i += sph_prim_scene_of((uint32_t)scene->facets[i].kind)->write(&w, i);
}

/* Between quotes all stands but a quote, an end of line and other characters that do not print. */
static int check_names(const struct sph_scene *scene, struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_textures; i++) {
        char shown[sizeof scene->textures[i].path];
        int bad = 0;
        snprintf(shown, sizeof shown, "%s", sph_nff_image_name(scene, scene->textures[i].path));
        for (char *c = shown; *c; c++) {
            int control = (unsigned char)*c < 32 || *c == 127;
            bad |= control || *c == '"';
            if (control) *c = '?';
        }
        if (bad)
            return sph_fail(err,
                            "%s: image %.200s: a name with a quote or a control character cannot "
                            "stand in a scene file",
                            scene->path, shown);
    }
    return 0;
}

int sph_scene_write(const struct sph_scene *scene, FILE *file, struct sph_error *err) {
    if (check_names(scene, err)) return -1;
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
