/* nff_put.c - see nff_writer.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/nff_writer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"

static void put_number(FILE *file, double value) {
    char text[40];
    double back = NAN;
    snprintf(text, sizeof text, "%.15g", value);
    if (sph_parse_number(text, &back) == -1 || back != value)
        snprintf(text, sizeof text, "%.17g", value);
    putc(' ', file);
    fputs(text, file);
}

void sph_nff_put(struct sph_nff_writer *w, const char *word, const double *values, int n) {
    fputs(word, w->file);
    for (int i = 0; i < n; i++)
        put_number(w->file, values[i]);
    putc('\n', w->file);
}

void sph_nff_put_point(struct sph_nff_writer *w, const char *word, struct sph_vec v) {
    sph_nff_put(w, word, (double[]){v.x, v.y, v.z}, 3);
}

/* A material that blends even where no `shading` is in force. */
static int plain(const struct sph_material *m) {
    return !m->sum.on && !(m->ks > 0 && m->shine > 0) && !(m->trans > 0) && m->kd + m->ks <= 1;
}

void sph_nff_put_material(struct sph_nff_writer *w, uint32_t material) {
    const struct sph_material *m = &w->scene->materials[material];
    while (m->sum.of) /* what the file has */
        material = m->sum.of - 1, m = &w->scene->materials[material];
    if (w->material == material) return;
    w->material = material;
    if (w->shading != m->sum.on && !(w->shading < 0 && plain(m))) {
        fputs(m->sum.on ? "shading sum\n" : "shading blend\n", w->file);
        w->shading = m->sum.on;
    }
    if (m->trans > 0 && w->clear != m->passes) {
        fputs(m->passes ? "shadows clear\n" : "shadows full\n", w->file);
        w->clear = m->passes;
    }
    sph_nff_put(w, "f",
                (double[]){m->rgb[0], m->rgb[1], m->rgb[2], m->kd, m->ks, m->shine, m->trans,
                           m->ior, m->sum.ka, m->sum.kr},
                m->sum.on ? 10 : 8);
}

void sph_nff_put_motion(struct sph_nff_writer *w, uint32_t motion) {
    const struct sph_motion *m = motion ? &w->scene->motions[motion - 1] : NULL;
    if (w->motion == motion) return;
    w->motion = motion;
    if (m)
        sph_nff_put(w, "move",
                    (double[]){m->step.x, m->step.y, m->step.z, m->grow, m->about.x, m->about.y,
                               m->about.z},
                    7);
    else
        fputs("still\n", w->file);
}

const char *sph_nff_image_name(const struct sph_scene *scene, const char *path) {
    const char *slash = strrchr(scene->path, '/');
    size_t folder = slash ? (size_t)(slash - scene->path) + 1 : 0;
    return strncmp(path, scene->path, folder) ? path : path + folder;
}

void sph_nff_put_image(struct sph_nff_writer *w, const char *word, const char *path) {
    path = sph_nff_image_name(w->scene, path);
    int bare = strpbrk(path, " \t#") == NULL && strcmp(path, "none") != 0;
    fprintf(w->file, bare ? "%s %s" : "%s \"%s\"", word, path);
}

void sph_nff_put_colours(struct sph_nff_writer *w, uint32_t texture) {
    static const char *const words[] = {"", " srgb", " linear"};
    fputs(words[w->scene->textures[texture - 1].colours], w->file);
}

void sph_nff_put_texture(struct sph_nff_writer *w, uint32_t texture) {
    if (w->texture == texture) return;
    w->texture = texture;
    if (!texture) {
        fputs("texture none\n", w->file);
        return;
    }
    const struct sph_texture *t = &w->scene->textures[texture - 1];
    sph_nff_put_image(w, "texture", t->path);
    sph_nff_put(w, "", (double[]){t->repeat[0], t->repeat[1], t->offset[0], t->offset[1]}, 4);
    if (t->wrap[0]) fputs(t->colours ? "clamp" : "clamp\n", w->file);
    sph_nff_put_colours(w, texture);
    if (t->colours) putc('\n', w->file);
}
