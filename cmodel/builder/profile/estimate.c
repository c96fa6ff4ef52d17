/* estimate.c - see estimate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/profile/estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/profile/ray_error.h"
#include "common/parallel.h"

enum { SAMPLE = 2304, ROWS = 4 }; /* pixels, at most; rows of them that are worth a thread */

/* Mean square error, levels^2, of colours that are right but rounded: anywhere within a level;
 * where a material's shares, of 8 bits, add up they may all be off by one. */
static double rounded(const struct sph_scene *scene) {
    for (uint32_t i = 0; i < scene->n_materials; i++)
        if (scene->materials[i].sum.on) return 1;
    return 1.0 / 3;
}

struct sums {
    double square, wrong, pixels;
};

/* A pixel's rays and its colour, 255 is white. */
struct look {
    struct sph_ref_log log;
    double rgb[3], ended[3]; /* ended: how far it is off where the grid ends a plane */
};

static void look(const struct sph_ref_job *j, int x, int y, struct look *out) {
    struct sph_ref_seen seen = {.log = &out->log};
    sph_ref_sample_of(j, x, y, &seen);
    for (int i = 0; i < 3; i++)
        out->rgb[i] = 255 * fmin(fmax(seen.sum[SPH_FRAMES - 1][i], 0), 1);
}

/* The part of pixels between two for which an edge between them is on the wrong side; -1: there is
 * none. *smooth: how far what they see is moved, in pixels. *first: the eye's own rays meet
 * different things. */
static double edge(const struct sph_ray_error *w, const struct look *a, const struct look *b,
                   double *smooth, int *first) {
    struct sph_ray_errors of_a[SPH_REF_STEPS], of_b[SPH_REF_STEPS];
    sph_ray_error_log(w, &a->log, of_a);
    sph_ray_error_log(w, &b->log, of_b);
    int n = a->log.n < b->log.n ? a->log.n : b->log.n;
    double part = -1;
    for (int k = 0; k < n; k++) {
        const struct sph_ref_step *s = &a->log.step[k], *t = &b->log.step[k];
        if (s->hit.id != t->hit.id || s->hit.far != t->hit.far || s->depth != t->depth) {
            *first = k == 0;
            return fmax(part, *smooth + sph_ray_error_edge(w, s, t, &of_a[k], &of_b[k]));
        }
        if (s->hit.id == SPH_ID_NONE) continue;
        *smooth = fmax(*smooth, of_a[k].across / sph_ray_error_width(&s->ray, &t->ray,
                                                                     sph_ray_error_distance(s)));
        uint32_t differ = (s->blocked ^ t->blocked) & s->faced & t->faced;
        for (int l = 0; l < w->scene->n_lights; l++)
            if (differ >> l & 1) part = fmax(part, sph_ray_error_shadow(w, s, t, &of_a[k], l));
    }
    return a->log.n == b->log.n ? part : fmax(part, *smooth);
}

/* What a pixel and a neighbour tell. shift: in pixels, of the whole picture here. */
static void add_pair(const struct sph_ray_error *w, const struct look *a, const struct look *b,
                     double shift, struct sums *sums) {
    double smooth = shift, square = 0;
    int first = 0;
    for (int i = 0; i < 3; i++)
        square += (a->rgb[i] - b->rgb[i]) * (a->rgb[i] - b->rgb[i]);
    double part = edge(w, a, b, &smooth, &first);
    if (part >= 0) {
        part = fmin(M_PI / 4 * part, 1); /* edges lie in any direction: Cauchy and Crofton */
        if (first) sums->wrong += part;
        sums->square += part * square;
    } else {
        smooth = fmin(smooth, 1);
        sums->square += smooth * smooth * square;
    }
}

/* The pixel as it is if planes end where the grid does: what rays see that go on from there is
 * nothing that the pixel's neighbours could tell. */
static void look_ended(const struct sph_ref_job *j, const struct sph_ray_error *w, int x, int y,
                       struct look *at) {
    if (!sph_ray_error_ended(w, &at->log)) return;
    struct sph_ends ends = sph_ray_error_ends(w);
    struct sph_ref_job ended = *j;
    struct look as;
    ended.ends = &ends;
    look(&ended, x, y, &as);
    for (int i = 0; i < 3; i++)
        at->ended[i] = fabs(as.rgb[i] - at->rgb[i]);
}

/* Normals that are off by themselves, and what the eye's own ray meets. */
static void add_pixel(const struct sph_ray_error *w, const struct look *a, const struct look *b,
                      double shift, struct sums *sums) {
    struct sph_ray_errors of[SPH_REF_STEPS];
    const struct sph_ref_step *s = &a->log.step[0];
    sph_ray_error_log(w, &a->log, of);
    for (int i = 0; i < 3; i++) {
        double off = 0;
        for (int k = 0; k < a->log.n; k++)
            off += 255 * a->log.step[k].swing[i] * of[k].normal;
        off = fmax(off, a->ended[i]); /* of its own light a plane's end is a turn, too */
        sums->square += off * off;
    }
    if (s->hit.id == SPH_ID_NONE) return;
    double far = sph_ray_error_distance(s);
    double by = (sph_ray_error_worst(w, s->hit.id) + sph_ray_error_dir(w) * far) /
                sph_ray_error_width(&s->ray, &b->log.step[0].ray, far);
    sums->pixels = fmax(sums->pixels, by + shift);
}

/* A row of samples: the sums of n profiles. */
static void add_row(const struct sph_ref_job *j, const struct sph_ray_error *w, int n, int y,
                    int by, struct sums *sums) {
    const struct sph_ref_view *v = &j->view;
    for (int x = by / 2; x < v->width; x += by) {
        struct look at, right, below;
        double dx = v->window.left + x, dy = v->window.top - y; /* from where the view goes */
        look(j, x, y, &at);
        look(j, x + 1, y, &right);
        look(j, x, y + 1, &below);
        for (int p = 0; p < n; p++) {
            double shift = w[p].fov_error * sqrt(dx * dx + dy * dy);
            add_pair(&w[p], &at, &right, shift, &sums[p]);
            add_pair(&w[p], &at, &below, shift, &sums[p]);
            memset(at.ended, 0, sizeof at.ended);
            look_ended(j, &w[p], x, y, &at);
            add_pixel(&w[p], &at, &right, shift, &sums[p]);
        }
    }
}

struct samples {
    const struct sph_ref_job *j;
    const struct sph_ray_error *w;
    int n, by;
    struct sums *of; /* [rows][n] */
};

static void add_rows(void *user, uint32_t first, uint32_t end) {
    const struct samples *s = user;
    for (int i = (int)first; i < (int)end; i++)
        add_row(s->j, s->w, s->n, s->by / 2 + i * s->by, s->by, s->of + i * s->n);
}

/* Rows of samples, by pixels apart, and as many columns; sums in the order of rows, whatever
 * threads there are. -1 if memory is out. */
static int add(const struct sph_ref_job *j, const struct sph_ray_error *w, int n, int by,
               struct sums *sums) {
    int rows = (j->view.height - 1 - by / 2) / by + 1;
    struct sums *of = calloc((size_t)rows * (size_t)n, sizeof *of);
    if (!of) return -1;
    sph_parallel_for((uint32_t)rows, ROWS, add_rows, &(struct samples){j, w, n, by, of});
    for (int i = 0; i < rows * n; i++) {
        sums[i % n].square += of[i].square;
        sums[i % n].wrong += of[i].wrong;
        sums[i % n].pixels = fmax(sums[i % n].pixels, of[i].pixels);
    }
    free(of);
    return 0;
}

/* Grid and rays of a profile; 0 if the camera does not fit. */
static int prepare(const struct sph_scene *scene, const struct sph_ref_view *view,
                   const struct sph_profile *profile, int axes, struct sph_ray_error *w) {
    struct sph_rays rays;
    w->scene = scene;
    w->profile = profile;
    if (sph_grid_fit(scene, profile->w, axes, &w->grid, NULL)) return 0;
    const struct sph_raster raster =
        sph_raster_of(&scene->camera, view->width, view->height, w->grid.seen_from.angle);
    if (sph_rays_of(&raster, profile, &rays, NULL)) return 0;
    w->fov_error = rays.fov_error + w->grid.seen_from.off;
    struct sph_steps steps;
    if (axes == SPH_AXES_CAMERA) return 1;
    if (sph_rays_turn(&rays, &raster, &w->grid, profile, &steps, NULL)) return 0;
    w->fov_error += steps.off;
    return 1;
}

int sph_estimate(const struct sph_scene *scene, const struct sph_build_options *o,
                 const struct sph_profile *profiles, int n, struct sph_estimate *estimates,
                 struct sph_error *err) {
    struct sph_reference_options how = {.width = o->width ? o->width : scene->camera.width,
                                        .height = o->height ? o->height : scene->camera.height,
                                        .max_depth = o->max_depth,
                                        .shadow = o->shadow != SPH_OFF,
                                        .reflect = o->reflect != SPH_OFF,
                                        .refract = o->refract != SPH_OFF,
                                        .specular = o->specular != SPH_OFF,
                                        .filter = o->tex_filter,
                                        .spread = o->spread != SPH_OFF,
                                        .mips = o->texture != SPH_OFF ? o->mips : NULL};
    struct sph_ref_job j = {.scene = scene, .o = &how};
    struct sph_ray_error w[SPH_ESTIMATES];
    struct sums sums[SPH_ESTIMATES] = {{0, 0, 0}};
    int which[SPH_ESTIMATES], some = 0, samples = 0, axes = sph_axes_of(scene, o);
    double pixels = (double)how.width * how.height;
    if (how.width < 1 || how.height < 1 ||
        !sph_ref_view_of(&scene->camera, how.width, how.height, &j.view))
        some = -1; /* sph_build() says why */
    for (int p = 0; p < n; p++) {
        estimates[p] = (struct sph_estimate){0, 0, 0, 0};
        if (some >= 0 && prepare(scene, &j.view, &profiles[p], axes, &w[some])) which[some++] = p;
    }
    if (some < 1) return 0;
    int threads = sph_parallel_if(scene->n_spheres + scene->n_facets >= SPH_BUILD_SHARED);
    struct sph_ref_tree *tree = sph_ref_tree_new(scene);
    for (int p = 0; p < some; p++)
        w[p].tree = tree;
    j.tree = tree;
    j.textures = (struct sph_ref_textures){
        scene, how.mips, how.filter, how.lod, j.view.window.screen, pixels, how.spread};
    int by = (int)ceil(sqrt(pixels / SAMPLE));
    samples = ((how.width - 1 - by / 2) / by + 1) * ((how.height - 1 - by / 2) / by + 1);
    int rc = tree ? add(&j, w, some, by, sums) : -1;
    sph_ref_tree_free(tree);
    sph_parallel_most(threads);
    if (rc) return sph_fail(err, "%s: no memory for an estimate", scene->path);
    for (int p = 0; p < some; p++) {
        double square = sums[p].square / samples / 3 + rounded(scene);
        estimates[which[p]] = (struct sph_estimate){1, sums[p].pixels, sums[p].wrong / samples,
                                                    10 * log10(255 * 255 / square)};
    }
    return 0;
}
