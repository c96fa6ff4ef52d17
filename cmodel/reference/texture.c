/* texture.c - see texture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/texture.h"

#include <math.h>
#include <string.h>

#include "reference/facet.h"
#include "texture/lookup.h"

/* ---- choose ---- */

double sph_choose_path(double length, double base, struct sph_flops *f) {
    return sph_f_sub(f, sph_f_log2(f, length), base);
}

static void sphere(const struct sph_choice *c, double length[2], struct sph_flops *f) {
    const double *n = c->from, pi = acos(-1.0);
    double flat = sph_f_root(f, sph_f_add(f, sph_f_mul(f, n[0], n[0]), sph_f_mul(f, n[2], n[2])));
    length[0] = sph_f_div(f, sph_f_mul(f, 2 * pi, flat), c->shape.st[0][0]);
    length[1] = sph_f_div(f, sph_f_mul(f, pi, c->shape.rad), c->shape.st[0][1]);
}

/* |dP/ds| and |dP/dt| are length[k] over what is returned. */
static double triangle(const struct sph_choice *c, double length[2], struct sph_flops *f) {
    double d[2][2], edge[2][3], along[2][3];
    sph_texture_edges(&c->shape, edge, d, f);
    for (int i = 0; i < 3; i++) {
        along[0][i] =
            sph_f_sub(f, sph_f_mul(f, d[1][1], edge[0][i]), sph_f_mul(f, d[0][1], edge[1][i]));
        along[1][i] =
            sph_f_sub(f, sph_f_mul(f, d[0][0], edge[1][i]), sph_f_mul(f, d[1][0], edge[0][i]));
    }
    for (int k = 0; k < 2; k++)
        length[k] = sph_f_root(f, sph_f_dot(f, along[k], along[k]));
    return fabs(sph_f_sub(f, sph_f_mul(f, d[0][0], d[1][1]), sph_f_mul(f, d[1][0], d[0][1])));
}

double sph_choose_bmrt(const struct sph_choice *c, const struct sph_texture_view *view,
                       struct sph_flops *f) {
    double length[2] = {c->shape.st[0][0], c->shape.st[0][1]}; /* plane */
    double most = 0;
    double wide = sph_f_mul(f, c->length, 1 / view->distance); /* the screen's is of the frame */
    if (c->shape.kind == SPH_SHAPE_TRIANGLE)
        wide = sph_f_mul(f, wide, triangle(c, length, f));
    else if (c->shape.kind == SPH_SHAPE_SPHERE)
        sphere(c, length, f);
    for (int k = 0; k < 2; k++)
        most = fmax(most, sph_f_div(f, sph_f_mul(f, wide, c->side[k]), length[k]));
    return sph_f_log2(f, most);
}

void sph_choose_all(const struct sph_choice *choice, const struct sph_texture_view *view,
                    struct sph_level_work *work, double *level) {
    struct sph_level_work scratch = {.hits = {0}};
    struct sph_flops before = {0}; /* of the frame, or of the scene */
    struct sph_level_work *w = work ? work : &scratch;
    int kind = choice->shape.kind;
    double texels = choice->side[0] * choice->side[1];
    w->hits[kind]++;
    for (int way = 0; way < SPH_WAYS; way++) {
        struct sph_flops *f = &w->flops[way][kind];
        struct sph_choice c = *choice;
        c.shape.given = way == SPH_WAY_BMRT || way == SPH_WAY_ANEW;
        if (way == SPH_WAY_BMRT || way == SPH_WAY_BMRT_ALONE) {
            level[way] = sph_choose_bmrt(&c, view, f);
            continue;
        }
        struct sph_flops *of_base = way == SPH_WAY_KEPT ? &before : f;
        struct sph_texture_area area = sph_texture_area_of(&c.shape, texels, of_base);
        level[way] = sph_choose_path(c.length, sph_texture_base_log2(&area, view, of_base), f);
    }
}

void sph_level_work_add(struct sph_level_work *to, const struct sph_level_work *more) {
    for (int kind = 0; kind < SPH_SHAPES; kind++) {
        to->hits[kind] += more->hits[kind];
        for (int way = 0; way < SPH_WAYS; way++)
            sph_flops_add(&to->flops[way][kind], &more->flops[way][kind]);
    }
}

/* How an image lies around a point: coordinates (t down), their gradients in space, and what the
 * level is chosen from. */
struct place {
    double st[2], slope[2][3];
    struct sph_choice choice;
};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void on_sphere(const struct sph_sphere *s, const struct sph_texture *t, const double at[3],
                      struct place *p) {
    double pi = acos(-1.0), n[3] = {at[0] - s->ctr.x, at[1] - s->ctr.y, at[2] - s->ctr.z};
    double flat = n[0] * n[0] + n[2] * n[2], square = flat + n[1] * n[1];
    p->st[0] = t->repeat[0] * (0.5 + atan2(n[0], n[2]) / (2 * pi)) + t->offset[0];
    p->st[1] = 1 - t->repeat[1] * (0.5 + atan2(n[1], sqrt(flat)) / pi) - t->offset[1];
    double s_rise = t->repeat[0] / (2 * pi * fmax(flat, 1e-300));
    double t_rise = t->repeat[1] / (pi * square * sqrt(fmax(flat, 1e-300)));
    const double s_slope[3] = {n[2] * s_rise, 0, -n[0] * s_rise};
    const double t_slope[3] = {n[1] * n[0] * t_rise, -flat * t_rise, n[1] * n[2] * t_rise};
    for (int i = 0; i < 3; i++)
        p->slope[0][i] = s_slope[i], p->slope[1][i] = t_slope[i];
    p->choice.shape = (struct sph_texture_shape){
        .kind = SPH_SHAPE_SPHERE, .st = {{t->repeat[0], t->repeat[1]}}, .rad = s->rad};
    memcpy(p->choice.from, n, sizeof n);
}

/* The level of each way, not limited yet. */
static void levels(const struct sph_ref_textures *r, const struct sph_mip *mip, struct place *p,
                   const struct sph_ref_path *path, struct sph_level_work *work,
                   double lod[SPH_LODS]) {
    struct sph_choice *c = &p->choice;
    struct sph_texture_view view = {r->screen, r->pixels, 1, 0};
    struct sph_flops free = {0};
    double way[SPH_WAYS], most = 0;
    c->length = path->length;
    c->side[0] = mip->width, c->side[1] = mip->height;
    sph_choose_all(c, &view, work, way);
    lod[SPH_LOD_MENDED] = way[SPH_WAY_KEPT];
    if (r->spread) lod[SPH_LOD_MENDED] += log2(path->wide / path->length);
    lod[SPH_LOD_BMRT] = way[SPH_WAY_BMRT];
    struct sph_texture_area area = sph_texture_area_of(&c->shape, c->side[0] * c->side[1], &free);
    view.literal = 1;
    lod[SPH_LOD_PRINTED] =
        sph_choose_path(path->length, sph_texture_base_log2(&area, &view, &free), &free);
    for (int axis = 0; axis < 2; axis++) {
        double du = dot(p->slope[0], path->org[axis]) * c->side[0];
        double dv = dot(p->slope[1], path->org[axis]) * c->side[1];
        most = fmax(most, hypot(du, dv));
    }
    lod[SPH_LOD_RAYS] = log2(most);
}

/* Texel of a level, 0..1 a channel; x and y of any size. */
static void texel(const struct sph_mip *mip, int level, const int wrap[2], double x, double y,
                  double weight, double rgb[3]) {
    double at[2] = {x, y}, size[2];
    for (int k = 0; k < 2; k++) {
        size[k] = sph_level_size((uint32_t)(k ? mip->height : mip->width), level);
        if (wrap[k])
            at[k] = fmin(fmax(at[k], 0), size[k] - 1);
        else
            at[k] -= floor(at[k] / size[k]) * size[k];
    }
    size_t index = sph_mip_at(mip, level) + (size_t)at[1] * (size_t)size[0] + (size_t)at[0];
    for (int c = 0; c < 3; c++)
        rgb[c] += weight * (mip->texels[index] >> 8 * c & 255) / 255.0;
}

static void bilinear(const struct sph_mip *mip, int level, const int wrap[2], const double st[2],
                     double weight, double rgb[3]) {
    double x = st[0] * sph_level_size((uint32_t)mip->width, level) - 0.5;
    double y = st[1] * sph_level_size((uint32_t)mip->height, level) - 0.5;
    double wx = x - floor(x), wy = y - floor(y);
    for (int k = 0; k < 4; k++)
        texel(mip, level, wrap, floor(x) + (k & 1), floor(y) + (k >> 1),
              weight * (k & 1 ? wx : 1 - wx) * (k >> 1 ? wy : 1 - wy), rgb);
}

static void filter(const struct sph_ref_textures *r, const struct sph_mip *mip, const int wrap[2],
                   const double st[2], double lod, double rgb[3]) {
    rgb[0] = rgb[1] = rgb[2] = 0;
    if (r->filter == SPH_FILTER_NEAREST) {
        texel(mip, 0, wrap, floor(st[0] * mip->width), floor(st[1] * mip->height), 1, rgb);
    } else if (r->filter == SPH_FILTER_BETWEEN) {
        double next = lod - floor(lod);
        bilinear(mip, (int)lod, wrap, st, 1 - next, rgb);
        if (next > 0) bilinear(mip, (int)lod + 1, wrap, st, next, rgb);
    } else {
        bilinear(mip, r->filter == SPH_FILTER_LEVEL ? (int)(lod + 0.5) : 0, wrap, st, 1, rgb);
    }
}

int sph_ref_texture(const struct sph_ref_textures *r, uint32_t id, const double at[3],
                    const struct sph_ref_path *path, double rgb[3], double lod[SPH_LODS],
                    struct sph_level_work *work) {
    const struct sph_scene *scene = r->scene;
    const struct sph_facet *f =
        id < scene->n_spheres ? NULL : &scene->facets[id - scene->n_spheres];
    uint32_t index = f ? f->texture : scene->spheres[id].texture;
    rgb[0] = rgb[1] = rgb[2] = 1;
    if (!r->mips || !index) return 0;
    const struct sph_texture *texture = &scene->textures[index - 1];
    const struct sph_mip *mip = &r->mips[index - 1];
    struct place p;
    if (f) {
        const double from[3] = {at[0] - f->v[0].x, at[1] - f->v[0].y, at[2] - f->v[0].z};
        sph_ref_facet_image(f, from, p.st, p.slope, &p.choice.shape);
    } else {
        on_sphere(&scene->spheres[id], texture, at, &p);
    }
    levels(r, mip, &p, path, work, lod);
    for (int k = 0; k < SPH_LODS; k++) /* what is no number is level 0 */
        lod[k] = lod[k] > 0 ? fmin(lod[k], mip->levels - 1) : 0;
    filter(r, mip, texture->wrap, p.st, lod[r->lod], rgb);
    return 1;
}
