/* help.c - see help.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/help.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "common/number.h"
#include "machine/records.h"
#include "scene/vector.h"

enum { TEXT = 1024 };

struct help {
    char text[TEXT];
    struct sph_known_picture is;
    double score;
};

struct helper {
    const struct sph_scene *scene;
    const struct sph_build_options *o;
    const struct sph_error_bound *bound;
    double least; /* score that is worth a line */
    struct help best[SPH_HELPS + 1];
    int n;
    struct sph_vec middle; /* of what is bounded, but the largest sphere */
    double reach;          /* from there to its farthest point, and to the eye */
    uint32_t largest;      /* sphere */
};

/* How much better than the bound, dB: the lesser of colours and of points. */
static double score(const struct sph_known_picture *p, const struct sph_error_bound *bound) {
    return fmin(p->measured.psnr_least - bound->psnr,
                20 * log10(bound->pixels / fmax(p->expected.pixels, 1e-9)));
}

/* Draws it in the widths, and keeps it if it is among the best. */
static int try_it(struct helper *h, const struct sph_scene *scene,
                  const struct sph_build_options *options, const struct sph_profile *widths,
                  struct sph_error *err, const char *format, ...) {
    struct help *next = &h->best[h->n];
    struct sph_build_options o = *options;
    memset(next, 0, sizeof *next);
    o.widths = widths;
    if (sph_estimate(scene, &o, widths, 1, &next->is.expected, err)) return -1;
    if (!next->is.expected.fits) return 0;
    if (sph_judge_once(scene, &o, widths, &next->is.measured, err)) return -1;
    next->score = score(&next->is, h->bound);
    if (!next->is.measured.pixels || next->score < h->least) return 0;
    va_list list;
    va_start(list, format);
    vsnprintf(next->text, sizeof next->text, format, list);
    va_end(list);
    int at = h->n;
    struct help mine = *next;
    for (; at && h->best[at - 1].score < mine.score; at--)
        h->best[at] = h->best[at - 1];
    h->best[at] = mine;
    if (h->n < SPH_HELPS) h->n++;
    return 0;
}

/* ---- the same scene ---- */

/* W has no more bits than the finest profile: the other widths have. */
static int try_widths(struct helper *h, struct sph_error *err) {
    struct sph_profile wide[] = {sph_profiles[SPH_PROFILES - 1], sph_profiles[SPH_PROFILES - 1]};
    struct sph_error why = {""};
    wide[0].wd += 2, wide[0].pq += 4;
    wide[1] = wide[0];
    wide[1].ng += 2;
    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++) {
        if (sph_profile_check(&wide[i], &why)) continue;
        struct sph_profile p = sph_profile_unpack(sph_profile_pack(&wide[i])); /* its name */
        if (try_it(h, h->scene, h->o, &p, err, "--profile %s", p.name)) return -1;
    }
    return 0;
}

static int try_depth(struct helper *h, struct sph_error *err) {
    struct sph_build_options o = *h->o;
    if (!o.max_depth || o.reflect == SPH_ON || o.refract == SPH_ON) return 0;
    o.max_depth--;
    return try_it(h, h->scene, &o, sph_build_profile(h->o), err, "--depth %d", o.max_depth);
}

/* ---- other scenes ---- */

static struct sph_vec between(struct sph_vec a, struct sph_vec b, double t) {
    struct sph_vec d = sph_vec_sub(b, a);
    return (struct sph_vec){a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
}

/* As it is told, so that what is told was tried. */
static double told(double x) {
    char text[32];
    double read = x;
    snprintf(text, sizeof text, "%.6g", x);
    sph_parse_number(text, &read);
    return read;
}

static struct sph_vec told_point(struct sph_vec p) {
    return (struct sph_vec){told(p.x), told(p.y), told(p.z)};
}

/* Middle and reach of what is bounded. */
static void survey(struct helper *h) {
    const struct sph_scene *s = h->scene;
    struct sph_vec sum = {0, 0, 0};
    double n = 0;
    for (uint32_t i = 0; i < s->n_spheres; i++)
        if (s->spheres[i].rad > s->spheres[h->largest].rad) h->largest = i;
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t i = 0; i < s->n_spheres; i++) {
            const struct sph_sphere *b = &s->spheres[i];
            if (i == h->largest && s->n_spheres > 1) continue;
            if (pass)
                h->reach = fmax(h->reach, sph_vec_length(sph_vec_sub(b->ctr, h->middle)) + b->rad);
            else
                sum.x += b->ctr.x, sum.y += b->ctr.y, sum.z += b->ctr.z, n++;
        }
        for (uint32_t i = 0; i < s->n_facets; i++)
            for (int k = 0; k < 3 && !sph_kind_unbounded((uint32_t)s->facets[i].kind); k++) {
                struct sph_vec v = s->facets[i].v[k];
                if (pass)
                    h->reach = fmax(h->reach, sph_vec_length(sph_vec_sub(v, h->middle)));
                else
                    sum.x += v.x, sum.y += v.y, sum.z += v.z, n++;
            }
        if (!pass)
            h->middle = n > 0 ? (struct sph_vec){sum.x / n, sum.y / n, sum.z / n} : s->camera.at;
    }
    h->reach = fmax(h->reach, sph_vec_length(sph_vec_sub(s->camera.from, h->middle)));
}

enum { FAR = 2 }; /* times the reach: nothing need be farther */

/* All lights that are far go where they were seen, but nearer. */
static int try_lights(struct helper *h, struct sph_error *err) {
    struct sph_scene s = *h->scene;
    int n = 0, one = 0;
    for (int l = 0; l < s.n_lights; l++) {
        double far = sph_vec_length(sph_vec_sub(s.lights[l].pos, h->middle));
        if (!(far > FAR * h->reach)) continue;
        s.lights[l].pos = told_point(between(h->middle, s.lights[l].pos, FAR * h->reach / far));
        one = l, n++;
    }
    if (!n) return 0;
    struct sph_vec p = s.lights[one].pos;
    struct sph_place at = sph_place_of(&s, s.lights[one].line, "number", (uint32_t)one);
    if (n > 1)
        return try_it(h, &s, h->o, sph_build_profile(h->o), err,
                      "lights no farther than %.6g from (%.6g, %.6g, %.6g)", FAR * h->reach,
                      h->middle.x, h->middle.y, h->middle.z);
    return try_it(h, &s, h->o, sph_build_profile(h->o), err,
                  "the light %s nearer, l %.6g %.6g %.6g", at.text, p.x, p.y, p.z);
}

/* A sphere far larger than all else, as a smaller one that touches the same point. */
static int try_sphere(struct helper *h, struct sph_error *err) {
    struct sph_scene s = *h->scene;
    if (s.n_spheres < 2 || !(h->scene->spheres[h->largest].rad > 2 * FAR * h->reach)) return 0;
    s.spheres = malloc(s.n_spheres * sizeof *s.spheres);
    if (!s.spheres) return sph_fail(err, "%s: no memory", s.path);
    memcpy(s.spheres, h->scene->spheres, s.n_spheres * sizeof *s.spheres);
    struct sph_sphere *b = &s.spheres[h->largest];
    double rad = told(FAR * h->reach), far = sph_vec_length(sph_vec_sub(h->middle, b->ctr));
    b->ctr = told_point(between(b->ctr, h->middle, (b->rad - rad) / far));
    b->rad = rad;
    struct sph_place at = sph_place_of(&s, b->line, "number", h->largest);
    int rc = far > 0 ? try_it(h, &s, h->o, sph_build_profile(h->o), err,
                              "the sphere %s smaller, s %.6g %.6g %.6g %.6g", at.text, b->ctr.x,
                              b->ctr.y, b->ctr.z, rad)
                     : 0;
    free(s.spheres);
    return rc;
}

/* The plane that is seen beyond the grid, as a square around the foot of the middle. */
static int try_plane(struct helper *h, uint32_t plane, struct sph_error *err) {
    struct sph_scene s = *h->scene;
    const struct sph_facet *was = &h->scene->facets[plane];
    if (was->texture) return 0;
    s.facets = malloc((s.n_facets + 1) * sizeof *s.facets);
    if (!s.facets) return sph_fail(err, "%s: no memory", s.path);
    memcpy(s.facets, h->scene->facets, s.n_facets * sizeof *s.facets);
    double side = FAR * h->reach, length = sph_vec_length(was->v[1]);
    struct sph_vec n = between((struct sph_vec){0, 0, 0}, was->v[1], 1 / length);
    double up = sph_vec_dot(sph_vec_sub(h->middle, was->v[0]), n);
    struct sph_vec foot = {h->middle.x - up * n.x, h->middle.y - up * n.y, h->middle.z - up * n.z};
    struct sph_vec axis =
        fabs(n.x) < fabs(n.y) ? (struct sph_vec){1, 0, 0} : (struct sph_vec){0, 1, 0};
    struct sph_vec a = sph_vec_cross(n, axis), b;
    a = between((struct sph_vec){0, 0, 0}, a, side / sph_vec_length(a));
    b = sph_vec_cross(n, a);
    struct sph_vec corner[4];
    for (int i = 0; i < 4; i++) {
        double u = i == 1 || i == 2 ? 1 : -1, v = i > 1 ? 1 : -1;
        corner[i] = told_point((struct sph_vec){
            foot.x + u * a.x + v * b.x, foot.y + u * a.y + v * b.y, foot.z + u * a.z + v * b.z});
    }
#define CORNER(i) corner[i].x, corner[i].y, corner[i].z
    uint32_t group = s.facets[s.n_facets - 1].group + 1;
    struct sph_facet square = {.kind = SPH_TRIANGLE,
                               .v = {corner[0], corner[1], corner[2]},
                               .material = was->material,
                               .group = group,
                               .line = was->line};
    memmove(&s.facets[plane], &s.facets[plane + 1], (s.n_facets - plane - 1) * sizeof *s.facets);
    s.facets[s.n_facets - 1] = square;
    square.v[1] = corner[2], square.v[2] = corner[3];
    s.facets[s.n_facets++] = square;
    struct sph_place at = sph_place_of(&s, was->line, "number", plane);
    int rc = try_it(h, &s, h->o, sph_build_profile(h->o), err,
                    "the plane %s as a square, p 4, %.6g %.6g %.6g, %.6g %.6g %.6g, "
                    "%.6g %.6g %.6g, %.6g %.6g %.6g",
                    at.text, CORNER(0), CORNER(1), CORNER(2), CORNER(3));
    free(s.facets);
    return rc;
}

int sph_help(const struct sph_scene *scene, const struct sph_build_options *o,
             const struct sph_error_bound *bound, const struct sph_known_picture *now,
             struct sph_build_report *report, struct sph_error *err) {
    struct helper h = {.scene = scene, .o = o, .bound = bound, .least = score(now, bound) + 1};
    char is[TEXT];
    survey(&h);
    int cut = report->cut.beyond || report->cut.later;
    if (try_widths(&h, err) || try_depth(&h, err) || try_lights(&h, err) || try_sphere(&h, err) ||
        (cut && try_plane(&h, report->cut.plane, err)))
        return -1;
    for (int i = 0; i < h.n; i++)
        sph_note(report->warning, sizeof report->warning, "%s: %s: with %s: %s\n", scene->path,
                 sph_picture_keeps(&h.best[i].is, bound) ? "would do" : "helps", h.best[i].text,
                 sph_picture_says(&h.best[i].is, is, sizeof is));
    return 0;
}
