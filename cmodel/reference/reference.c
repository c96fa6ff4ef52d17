/* reference.c - see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/reference.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "reference/facet.h"
#include "reference/tree.h"

struct job {
    const struct sph_scene *scene;
    const struct sph_reference_options *o;
    const struct sph_ref_tree *tree;
    double axes[3][3]; /* camera right, up, back in the scene's frame */
    double screen;     /* distance of the screen in pixels */
    int width, height;
    struct sph_ref_textures textures;
};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Scales v to length 1; 0 if it has none. */
static int unit(double v[3]) {
    double n = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= n;
    return isfinite(n) && n > 0;
}

static int camera(struct job *j) {
    const struct sph_camera *c = &j->scene->camera;
    double back[3] = {c->from.x - c->at.x, c->from.y - c->at.y, c->from.z - c->at.z};
    double up[3] = {c->up.x, c->up.y, c->up.z};
    if (!unit(back)) return 0;
    for (int i = 0; i < 3; i++)
        j->axes[2][i] = back[i];
    cross(up, back, j->axes[0]);
    if (!unit(j->axes[0])) return 0;
    cross(back, j->axes[0], j->axes[1]);
    j->screen = j->height / 2.0 / tan(c->angle * acos(-1.0) / 360);
    return isfinite(j->screen) && j->screen > 0;
}

/* Light that reaches a point, per channel; sets a bit of *faced for each light on the normal's
 * side, and of *blocked if it is in shadow. */
static void light(const struct job *j, const double at[3], const double normal[3],
                  const struct sph_ref_hit *hit, double sum[3], uint32_t *faced,
                  uint32_t *blocked) {
    for (int i = 0; i < 3; i++)
        sum[i] = j->scene->ambient[i];
    for (int l = 0; l < j->scene->n_lights; l++) {
        const struct sph_light *lamp = &j->scene->lights[l];
        struct sph_ref_ray ray = {
            .org = {at[0], at[1], at[2]},
            .dir = {lamp->pos.x - at[0], lamp->pos.y - at[1], lamp->pos.z - at[2]},
            .skip = hit->id,
            .inside = hit->far};
        double cosine = dot(ray.dir, normal) / sqrt(dot(ray.dir, ray.dir));
        if (!(cosine > 0)) continue;
        *faced |= 1u << l;
        if (j->o->shadow && sph_ref_trace(j->tree, &ray, 1, 1).t < 1) {
            *blocked |= 1u << l;
            continue;
        }
        for (int i = 0; i < 3; i++)
            sum[i] += cosine * lamp->rgb[i];
    }
}

/* The hit point, and the normal on the ray's side; returns the material. */
static const struct sph_material *surface(const struct sph_scene *scene,
                                          const struct sph_ref_ray *ray,
                                          const struct sph_ref_hit *hit, double at[3],
                                          double normal[3]) {
    uint32_t material;
    for (int i = 0; i < 3; i++)
        at[i] = ray->org[i] + hit->t * ray->dir[i];
    if (hit->id < scene->n_spheres) {
        const struct sph_sphere *s = &scene->spheres[hit->id];
        const double ctr[3] = {s->ctr.x, s->ctr.y, s->ctr.z};
        for (int i = 0; i < 3; i++)
            normal[i] = (at[i] - ctr[i]) / s->rad;
        material = s->material;
    } else {
        const struct sph_facet *f = &scene->facets[hit->id - scene->n_spheres];
        sph_ref_facet_normal(f, normal);
        material = f->material;
    }
    for (int i = 0; i < 3 && hit->far; i++)
        normal[i] = -normal[i];
    return &scene->materials[material];
}

/* How the unit normal turns with the hit point. */
static double curvature(const struct sph_scene *scene, const struct sph_ref_hit *hit) {
    if (hit->id >= scene->n_spheres) return 0;
    return (hit->far ? -1 : 1) / scene->spheres[hit->id].rad;
}

static uint32_t byte(double c) {
    return (uint32_t)(fmin(fmax(c, 0), 1) * 255 + 0.5);
}

static struct sph_reference_pixel render_pixel(const struct job *j, int x, int y,
                                               struct sph_level_work *work) {
    struct sph_reference_pixel pixel = {
        .id = SPH_ID_NONE, .reflected_id = SPH_ID_NONE, .distance = INFINITY};
    const struct sph_camera *c = &j->scene->camera;
    struct sph_ref_ray ray = {.org = {c->from.x, c->from.y, c->from.z}, .skip = SPH_ID_NONE};
    double weight = 1, sum[3] = {0};
    for (int i = 0; i < 3; i++)
        ray.dir[i] = (x - (j->width - 1) / 2.0) * j->axes[0][i] +
                     ((j->height - 1) / 2.0 - y) * j->axes[1][i] - j->screen * j->axes[2][i];
    struct sph_ref_path path;
    sph_ref_path_start(&path, ray.dir, j->axes[0], j->axes[1]);
    int last = 0, via = SPH_VIA_NOTHING;
    for (int depth = 0; !last; depth++) {
        struct sph_ref_hit hit = sph_ref_trace(j->tree, &ray, INFINITY, 0);
        double colour[3], ks = 0;
        if (hit.id == SPH_ID_NONE) {
            for (int i = 0; i < 3; i++)
                colour[i] = j->scene->background[i];
        } else {
            double at[3], normal[3], lit[3], image[3], lod[SPH_LODS];
            const struct sph_material *f = surface(j->scene, &ray, &hit, at, normal);
            uint32_t faced = 0, blocked = 0;
            light(j, at, normal, &hit, lit, &faced, &blocked);
            sph_ref_path_hit(&path, ray.dir, hit.t, normal);
            if (sph_ref_texture(&j->textures, hit.id, at, &path, image, lod, work) &&
                !pixel.textured) {
                pixel.textured = 1, pixel.via = via;
                memcpy(pixel.lod, lod, sizeof lod);
                pixel.facing =
                    fabs(dot(ray.dir, normal)) / sqrt(dot(ray.dir, ray.dir) * dot(normal, normal));
            }
            if (hit.id < j->scene->n_spheres)
                via = SPH_VIA_CURVED;
            else if (via == SPH_VIA_NOTHING)
                via = SPH_VIA_FLAT;
            ks = fmin(fmax(f->ks, 0), 1);
            double share = ks < 1 ? fmin(1, f->kd / (1 - ks)) : f->kd;
            for (int i = 0; i < 3; i++)
                colour[i] = fmin(1, f->rgb[i] * share * image[i] * lit[i]);
            if (depth == 0) {
                pixel.faced = faced, pixel.shadow = blocked;
                pixel.distance = hit.t * sqrt(dot(ray.dir, ray.dir));
            }

            double dn = dot(ray.dir, normal) / dot(normal, normal);
            sph_ref_path_mirror(&path, ray.dir, normal, curvature(j->scene, &hit));
            ray.skip = hit.id, ray.inside = hit.far;
            for (int i = 0; i < 3; i++) {
                ray.org[i] = at[i];
                ray.dir[i] -= 2 * dn * normal[i];
            }
        }
        if (depth == 0) pixel.id = hit.id;
        if (depth == 1) pixel.reflected_id = hit.id;
        last = !(ks > 0) || !j->o->reflect || depth >= j->o->max_depth;

        uint32_t seen = 0;
        for (int i = 0; i < 3; i++) {
            seen |= byte(sum[i] + weight * colour[i]) << (8 * i);
            sum[i] += weight * (1 - ks) * colour[i];
        }
        weight *= ks;
        for (int i = 0; i < SPH_FRAMES; i++)
            if (depth <= i || i == SPH_FRAMES - 1) pixel.colour[i] = seen;
    }
    return pixel;
}

int sph_reference_render(const struct sph_scene *scene, const struct sph_reference_options *options,
                         struct sph_reference *out, struct sph_error *err) {
    struct job j = {.scene = scene, .o = options};
    j.width = options->width ? options->width : scene->camera.width;
    j.height = options->height ? options->height : scene->camera.height;
    if (j.width <= 0 || j.height <= 0)
        return sph_fail(err, "%s: a frame of %dx%d has no pixels", scene->path, j.width, j.height);
    if (!camera(&j)) return sph_fail(err, "%s: the camera has no direction", scene->path);
    j.textures = (struct sph_ref_textures){scene,        options->mips, options->filter,
                                           options->lod, j.screen,      (double)j.width * j.height};
    struct sph_ref_tree *tree = sph_ref_tree_new(scene, options->world);
    memset(&out->work, 0, sizeof out->work);
    out->width = j.width, out->height = j.height;
    out->pixels = calloc((size_t)j.width * (size_t)j.height, sizeof *out->pixels);
    if (!tree || !out->pixels) {
        sph_ref_tree_free(tree);
        sph_reference_free(out);
        return sph_fail(err, "%s: no memory for the reference", scene->path);
    }
    j.tree = tree;
#pragma omp parallel for schedule(dynamic, 4)                                                      \
    num_threads(options->threads > 0 ? options->threads : omp_get_num_procs())
    for (int y = 0; y < j.height; y++) {
        struct sph_level_work work = {.hits = {0}};
        for (int x = 0; x < j.width; x++)
            out->pixels[(size_t)y * (size_t)j.width + (size_t)x] = render_pixel(&j, x, y, &work);
#pragma omp critical
        sph_level_work_add(&out->work, &work);
    }
    sph_ref_tree_free(tree);
    return 0;
}

void sph_reference_free(struct sph_reference *r) {
    free(r->pixels);
    r->pixels = NULL;
}
