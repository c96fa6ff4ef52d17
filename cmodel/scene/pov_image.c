/* pov_image.c - see pov_image.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Coordinates are those of docs/design/textures.md, but t goes up, as in the file: the nearest
 * texel of the whole image is seen. A pigment is made of three functions, one a channel.
 */
#include "scene/pov_image.h"

#include <math.h>

#include "machine/layout.h" /* SPH_TRIANGLE, SPH_PLANE */
#include "scene/pov_surface.h"

void sph_pov_images(const struct sph_scene *s, FILE *f) {
    if (!s->n_textures) return;
    for (uint32_t i = 0; i < s->n_textures; i++) {
        fprintf(f, "#declare Image%u = function { pigment { image_map { \"", i);
        for (const char *c = s->textures[i].path; *c; c++) {
            if (*c == '"' || *c == '\\') putc('\\', f);
            putc(*c, f);
        }
        fprintf(f, "\" gamma %s } } }\n",
                s->textures[i].colours == SPH_COLOURS_SRGB ? "srgb" : "1");
    }
    fputs("#declare Repeated = function(v) { v }\n"
          "#declare Clamped = function(v) { min(max(v, 0), 0.999999) }\n"
          "#declare Across = function(x, y, z, m, o) { m * (0.5 + atan2(x, z) / (2 * pi)) + o }\n"
          "#declare Up = function(x, y, z, m, o) {\n"
          "  m * (0.5 + atan2(y, sqrt(x * x + z * z)) / pi) + o }\n"
          "#declare Along = function(x, y, z, a, b, c, o) { a * x + b * y + c * z + o }\n",
          f);
}

static void put_list(FILE *f, const double *v, int n) {
    for (int i = 0; i < n; i++) {
        putc(',', f);
        sph_pov_number(f, v[i]);
    }
}

/* The average of three functions of the image; s, t: how a point has coordinates, `way` with n
 * numbers of each. */
static void put_pigment(FILE *f, const struct sph_scene *scene, uint32_t texture, uint32_t material,
                        const char *const way[2], double values[2][4], int n) {
    static const char *const channel[] = {"red", "green", "blue"};
    const struct sph_texture *t = &scene->textures[texture - 1];
    const struct sph_material *m = &scene->materials[material];
    fputs("pigment { average pigment_map {", f);
    for (int c = 0; c < 3; c++) {
        fprintf(f, "\n  [1 function { Image%u(", texture - 1);
        for (int k = 0; k < 2; k++) {
            fprintf(f, "%s(%s(x,y,z", t->wrap[k] ? "Clamped" : "Repeated", way[k]);
            put_list(f, values[k], n);
            fputs(")),", f);
        }
        double rgb[3] = {0, 0, 0};
        rgb[c] = 3 * m->rgb[c];
        fprintf(f, "0).%s } color_map { [0 rgb 0] [1 rgb ", channel[c]);
        sph_pov_vector(f, rgb);
        fputs("] }]", f);
    }
    fputs(" }", f);
}

void sph_pov_round(const struct sph_scene *scene, const struct sph_sphere *s, double scale,
                   FILE *f) {
    static const char *const way[2] = {"Across", "Up"};
    const struct sph_texture *t = &scene->textures[s->texture - 1];
    double values[2][4] = {{t->repeat[0], t->offset[0]}, {t->repeat[1], t->offset[1]}};
    put_pigment(f, scene, s->texture, s->material, way, values, 2);
    fputs(" translate ", f);
    sph_pov_vector(f, (double[]){s->ctr.x * scale, s->ctr.y * scale, s->ctr.z * scale});
    fputs(" }", f);
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How s and t rise along a plane: one repeat by its units of length. */
static void slopes_of_plane(const struct sph_facet *f, double slope[2][3]) {
    const double n[3] = {f->v[1].x, f->v[1].y, f->v[1].z};
    double along[2][3] = {{f->v[2].x, f->v[2].y, f->v[2].z}, {0}};
    cross(n, along[0], along[1]);
    cross(along[1], n, along[0]);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            slope[k][i] = along[k][i] / sqrt(dot(along[k], along[k])) / f->st[0][k];
}

/* And along a triangle: from corner to corner. */
static void slopes_of_triangle(const struct sph_facet *f, double slope[2][3]) {
    double e[2][3], n[3], along[2][3];
    for (int k = 0; k < 2; k++) {
        e[k][0] = f->v[k + 1].x - f->v[0].x;
        e[k][1] = f->v[k + 1].y - f->v[0].y;
        e[k][2] = f->v[k + 1].z - f->v[0].z;
    }
    cross(e[0], e[1], n);
    cross(e[1], n, along[0]);
    cross(n, e[0], along[1]);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            slope[k][i] = ((f->st[1][k] - f->st[0][k]) * along[0][i] +
                           (f->st[2][k] - f->st[0][k]) * along[1][i]) /
                          dot(n, n);
}

/* Of each kind: how s and t rise, and which of st says what they are at v[0]. */
static const struct {
    void (*slopes)(const struct sph_facet *, double slope[2][3]);
    int start;
} kinds[SPH_KINDS] = {[SPH_TRIANGLE] = {slopes_of_triangle, 0}, [SPH_PLANE] = {slopes_of_plane, 1}};

void sph_pov_flat(const struct sph_scene *scene, const struct sph_facet *f, double scale,
                  FILE *file) {
    static const char *const way[2] = {"Along", "Along"};
    const double at[3] = {f->v[0].x, f->v[0].y, f->v[0].z};
    double values[2][4], slope[2][3];
    kinds[f->kind].slopes(f, slope);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++)
            values[k][i] = slope[k][i];
        values[k][3] = f->st[kinds[f->kind].start][k] - dot(slope[k], at);
    }
    put_pigment(file, scene, f->texture, f->material, way, values, 4);
    fputs(" scale ", file);
    sph_pov_number(file, scale);
    fputs(" }", file);
}
