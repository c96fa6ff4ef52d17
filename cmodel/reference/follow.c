/* follow.c - see follow.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/follow.h"

#include <math.h>
#include <string.h>

#include "reference/facet.h"
#include "scene/nesting.h"

/* ---- drift ---- */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void sph_ref_drift_start(struct sph_ref_ray *ray) {
    ray->lift = ray->off = 0;
    ray->turn = 2 * SPH_REF_ULP; /* axes of the camera, distance of the screen, place on it */
}

double sph_ref_drift_hit(const struct sph_scene *scene, const struct sph_ref_ray *ray,
                         const struct sph_ref_hit *hit, const double at[3], const double side[3],
                         struct sph_ref_ray *next) {
    double length = sqrt(dot(ray->dir, ray->dir)), place = SPH_REF_ULP * 2 * sph_ref_size(at);
    double cosine = fmax(fabs(dot(ray->dir, side)) / length, 1e-8), along = hit->slack * length;
    next->lift = along * cosine + place;
    next->off = (ray->off + hit->t * length * ray->turn) / cosine + along + place;
    if (hit->id >= scene->n_spheres)
        return sph_ref_facet_turn(&scene->facets[hit->id - scene->n_spheres], next->off);
    return next->off / scene->spheres[hit->id].rad + 4 * SPH_REF_ULP;
}

double sph_ref_drift_light(const double at[3], const double lamp[3], const double dir[3]) {
    return 2 * SPH_REF_ULP * (sph_ref_size(at) + sph_ref_size(lamp)) / sph_ref_size(dir);
}

double sph_ref_drift_mirror(double turn, double normal) {
    return turn + 2 * normal + 2 * SPH_REF_ULP;
}

double sph_ref_drift_refract(double turn, double normal, double cosine, double ratio) {
    double rest = 1 - ratio * ratio * (1 - cosine * cosine), both = turn + normal;
    double unsure = 2 * ratio * ratio * fabs(cosine) * both + 8 * SPH_REF_ULP;
    if (fabs(rest) <= unsure) return INFINITY;
    if (rest < 0) return 0;
    double bend = ratio + ratio * ratio * fabs(cosine) / sqrt(rest); /* of the normal's share */
    return ratio * turn + bend * both + (ratio + 1) * normal + 2 * SPH_REF_ULP;
}

/* ---- whitted ---- */

static double share(double k) {
    return fmin(fmax(k, 0), 1);
}

static double left(const struct sph_material *m, double kr, double kt) {
    return m->sum.on ? 1 : 1 - kr - kt;
}

struct sph_ref_shares sph_ref_shares_of(const struct sph_material *m, int follow, int reflect,
                                        int refract) {
    double mirror = share(m->sum.on ? m->sum.kr : m->ks);
    struct sph_ref_shares s = {.kr = follow && reflect ? mirror : 0};
    if (m->sum.on) {
        s.ka = m->sum.ka, s.kd = m->kd, s.ks = m->ks;
        s.kt = follow && refract ? share(m->trans) : 0;
    } else { /* (1 - ks) * colour = kd * rgb */
        s.ka = s.kd = mirror < 1 ? fmin(1, m->kd / (1 - mirror)) : m->kd;
    }
    s.own = left(m, s.kr, s.kt);
    return s;
}

void sph_ref_reflect_all(struct sph_ref_shares *s, const struct sph_material *m, int whole) {
    s->kr = whole ? 1 : fmin(1, s->kr + s->kt);
    s->kt = 0;
    s->own = left(m, s->kr, s->kt);
}

int sph_ref_refract(const double dir[3], const double normal[3], double ratio, double out[3]) {
    double cosine = -dot(dir, normal), rest = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(rest >= 0)) return 0;
    for (int i = 0; i < 3; i++)
        out[i] = ratio * dir[i] + (ratio * cosine - sqrt(rest)) * normal[i];
    return 1;
}

double sph_ref_specular(const double normal[3], const double to_light[3], const double dir[3],
                        double shine) {
    double cosine = dot(normal, to_light), back[3];
    for (int i = 0; i < 3; i++)
        back[i] = to_light[i] - 2 * cosine * normal[i]; /* mirrored light, turned round */
    double c = dot(back, dir);
    return c > 0 ? pow(c, shine) : 0;
}

/* Scales v to length 1; 0 if it has none. */
static int unit(double v[3]) {
    double n = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= n;
    return isfinite(n) && n > 0;
}

/* What reaches a point: matt light and highlights, a channel. */
struct lit {
    double matt[3], gloss[3], full[3]; /* full: as if all came along the normal */
    uint32_t faced, blocked;           /* bit l: light l is on the normal's side; and in shadow */
    int doubt;                         /* whether one is in shadow is not certain */
    struct sph_ref_hit by[SPH_MAX_LIGHTS]; /* what blocks it */
};

/* from: lift and off of a ray from the point. dir: of the ray that sees it, of length 1. shine 0:
 * no highlights. */
static struct lit light(const struct sph_ref_job *j, const double at[3], const double normal[3],
                        const struct sph_ref_ray *from, const double dir[3],
                        const struct sph_ref_hit *hit, double shine) {
    struct lit lit = {.faced = 0};
    for (int l = 0; l < j->scene->n_lights; l++) {
        const struct sph_light *lamp = &j->scene->lights[l];
        struct sph_ref_ray ray = {
            .org = {at[0], at[1], at[2]},
            .dir = {lamp->pos.x - at[0], lamp->pos.y - at[1], lamp->pos.z - at[2]},
            .skip = hit->id,
            .inside = hit->far,
            .light = 1,
            .lift = from->lift,
            .off = from->off};
        double to[3] = {ray.dir[0], ray.dir[1], ray.dir[2]};
        double cosine = unit(to) ? dot(to, normal) : 0;
        if (!(cosine > 0)) continue;
        lit.faced |= 1u << l;
        lit.by[l].t = INFINITY;
        const double place[3] = {lamp->pos.x, lamp->pos.y, lamp->pos.z};
        ray.turn = sph_ref_drift_light(at, place, ray.dir);
        if (j->o->shadow) lit.by[l] = sph_ref_trace(j->tree, &ray, 1, 1);
        lit.doubt |= lit.by[l].doubt;
        if (lit.by[l].t < 1) {
            lit.blocked |= 1u << l;
            continue;
        }
        double gloss = shine > 0 ? sph_ref_specular(normal, to, dir, shine) : 0;
        for (int i = 0; i < 3; i++) {
            lit.matt[i] += cosine * lamp->rgb[i];
            lit.full[i] += lamp->rgb[i];
            lit.gloss[i] += gloss * lamp->rgb[i];
        }
    }
    return lit;
}

/* The hit point, the normal on the ray's side, and that of the primitive, which is another one
 * where normals are interpolated; returns the material. */
static const struct sph_material *surface(const struct sph_scene *scene,
                                          const struct sph_ref_ray *ray,
                                          const struct sph_ref_hit *hit, double at[3],
                                          double normal[3], double side[3]) {
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
    memcpy(side, normal, 3 * sizeof *side);
    if (hit->id >= scene->n_spheres)
        sph_ref_facet_smooth(&scene->facets[hit->id - scene->n_spheres], at, normal);
    for (int i = 0; i < 3 && hit->far; i++)
        normal[i] = -normal[i], side[i] = -side[i];
    return &scene->materials[material];
}

/* What a ray meets, or what lights it there, is not certain. It does not count where it has less
 * than half a level of the colours, and nobody asks for its id. */
static void doubt(struct sph_ref_seen *seen, const struct sph_ref_branch *b) {
    if (b->depth < 2 || b->weight > 0.5 / 255) seen->pixel.doubt = 1;
}

/* How the unit normal turns with the hit point. */
static double curvature(const struct sph_scene *scene, const struct sph_ref_hit *hit) {
    if (hit->id >= scene->n_spheres) return 0;
    return (hit->far ? -1 : 1) / scene->spheres[hit->id].rad;
}

/* A surface at depth: whole is the weight of its ray, own what is left of it. */
static void add(struct sph_ref_seen *seen, int depth, double whole, double own,
                const double colour[3]) {
    for (int f = 0; f < SPH_FRAMES; f++) {
        int final = f == SPH_FRAMES - 1;
        double share = !final && f == depth ? whole : f > depth || final ? own : 0;
        for (int i = 0; i < 3; i++)
            seen->sum[f][i] += share * colour[i];
    }
}

/* The light of a surface in the log; share: its part of the pixel. */
static void note_light(struct sph_ref_step *step, const struct lit *lit, const double albedo[3],
                       double share) {
    if (!step) return;
    step->faced = lit->faced, step->blocked = lit->blocked;
    memcpy(step->by, lit->by, sizeof step->by);
    for (int i = 0; i < 3; i++)
        step->swing[i] = share * albedo[i] * lit->full[i];
}

/* The colour of a surface. dir: of length 1. */
static void shade(const struct sph_ref_job *j, struct sph_ref_branch *b,
                  const struct sph_ref_hit *hit, const struct sph_material *f,
                  const struct sph_ref_shares *k, const double at[3], const double normal[3],
                  const struct sph_ref_ray *from, const double dir[3], struct sph_ref_step *step,
                  struct sph_ref_seen *seen, double colour[3]) {
    double image[3], lod[SPH_LODS], shine = k->ks > 0 && j->o->specular ? f->shine : 0;
    struct lit lit = light(j, at, normal, from, dir, hit, shine);
    if (lit.doubt) doubt(seen, b);
    sph_ref_path_hit(&b->path, b->ray.dir, hit->t, normal);
    if (sph_ref_texture(&j->textures, hit->id, at, &b->path, image, lod, seen->work) &&
        !seen->pixel.textured) {
        seen->pixel.textured = 1, seen->pixel.via = b->via;
        memcpy(seen->pixel.lod, lod, sizeof lod);
        seen->pixel.facing = fabs(dot(dir, normal)) / sqrt(dot(normal, normal));
    }
    if (hit->id < j->scene->n_spheres || j->scene->facets[hit->id - j->scene->n_spheres].smooth)
        b->via = SPH_VIA_CURVED;
    else if (b->via == SPH_VIA_NOTHING)
        b->via = SPH_VIA_FLAT;
    double most = j->o->unlimited ? INFINITY : 1;
    for (int i = 0; i < 3; i++) {
        double sum = k->ka * j->scene->ambient[i] + k->kd * lit.matt[i];
        colour[i] =
            fmin(most, fmin(most, f->rgb[i] * image[i] * sum) + fmin(most, k->ks * lit.gloss[i]));
        image[i] *= f->rgb[i];
    }
    note_light(step, &lit, image, b->weight * k->own * k->kd);
    if (b->depth) return;
    seen->pixel.faced = lit.faced, seen->pixel.shadow = lit.blocked;
    seen->pixel.distance = hit->t * sqrt(dot(b->ray.dir, b->ray.dir));
}

/* The rays that leave a surface. from: their origin; tilt: by how much the normal may be off;
 * turn: the refracted ray. */
static void follow_rays(const struct sph_ref_job *j, const struct sph_ref_branch *b,
                        const struct sph_ref_hit *hit, const struct sph_ref_ray *from,
                        const double normal[3], const double side[3],
                        const struct sph_ref_shares *k, double ratio, const double bent[3],
                        double tilt, double turn, struct sph_ref_seen *seen) {
    double curved = curvature(j->scene, hit);
    struct sph_ref_branch next = *b;
    memcpy(next.ray.org, from->org, sizeof from->org);
    next.ray.lift = from->lift, next.ray.off = from->off;
    next.ray.skip = hit->id;
    next.depth++;
    if (k->kr > 0) {
        double dn = dot(b->ray.dir, normal) / dot(normal, normal);
        struct sph_ref_branch mirror = next;
        sph_ref_path_mirror(&mirror.path, b->ray.dir, normal, curved);
        mirror.ray.inside = hit->far;
        mirror.ray.turn = sph_ref_drift_mirror(b->ray.turn, tilt);
        mirror.mirrored = 1;
        mirror.weight *= k->kr;
        for (int i = 0; i < 3; i++)
            mirror.ray.dir[i] -= 2 * dn * normal[i];
        double behind = dot(mirror.ray.dir, side);
        for (int i = 0; i < 3 && behind < 0; i++)
            mirror.ray.dir[i] -= 2 * behind * side[i];
        sph_ref_follow(j, mirror, seen);
    }
    if (k->kt > 0) {
        sph_ref_path_refract(&next.path, b->ray.dir, normal, curved, ratio);
        next.ray.inside = !hit->far;
        next.ray.turn = turn;
        next.mirrored = 0;
        next.weight *= k->kt;
        for (int i = 0; i < 3; i++)
            next.ray.dir[i] = bent[i];
        sph_ref_follow(j, next, seen);
    }
}

static int is_plane(const struct sph_scene *scene, uint32_t id) {
    return id >= scene->n_spheres && sph_ref_facet_unbounded(&scene->facets[id - scene->n_spheres]);
}

/* The next step of the log, NULL if there is none. */
static struct sph_ref_step *note(struct sph_ref_seen *seen, const struct sph_ref_branch *b,
                                 const struct sph_ref_hit *hit) {
    struct sph_ref_log *log = seen->log;
    if (!log || log->n == SPH_REF_STEPS) return NULL;
    struct sph_ref_step *step = &log->step[log->n++];
    *step = (struct sph_ref_step){.ray = b->ray, .hit = *hit, .depth = b->depth};
    return step;
}

void sph_ref_follow(const struct sph_ref_job *j, struct sph_ref_branch b,
                    struct sph_ref_seen *seen) {
    struct sph_ref_hit hit = sph_ref_trace(j->tree, &b.ray, INFINITY, 0);
    if (j->ends && hit.id != SPH_ID_NONE && is_plane(j->scene, hit.id))
        hit.t = fmin(hit.t, sph_ends_at(j->ends, b.ray.org, b.ray.dir));
    struct sph_ref_step *step = note(seen, &b, &hit);
    if (b.depth == 0) seen->pixel.id = hit.id;
    if (b.depth == 1)
        *(b.mirrored ? &seen->pixel.reflected_id : &seen->pixel.refracted_id) = hit.id;
    if (hit.doubt) doubt(seen, &b);
    if (hit.id == SPH_ID_NONE) {
        add(seen, b.depth, b.weight, b.weight, j->scene->background);
        return;
    }
    double at[3], normal[3], side[3], colour[3], bent[3] = {0}, dir[3];
    const struct sph_material *f = surface(j->scene, &b.ray, &hit, at, normal, side);
    struct sph_ref_ray from = {.org = {at[0], at[1], at[2]}};
    double tilt = sph_ref_drift_hit(j->scene, &b.ray, &hit, at, side, &from);
    if (step) memcpy(step->at, at, sizeof at), memcpy(step->normal, normal, sizeof normal);
    if (j->o->world && is_plane(j->scene, hit.id)) {
        struct sph_ends ends = sph_ends_of(j->o->world);
        const struct sph_facet *plane = &j->scene->facets[hit.id - j->scene->n_spheres];
        if (sph_ends_show(&ends, j->scene, plane, b.ray.org, b.ray.dir, hit.t))
            seen->pixel.beyond |= b.depth ? SPH_BEYOND_LATER : SPH_BEYOND_EYE;
    }
    struct sph_ref_shares k =
        sph_ref_shares_of(f, b.depth < j->o->max_depth, j->o->reflect, j->o->refract);
    double inside = sph_index_ratio(f), ratio = hit.far ? inside : 1 / inside;
    memcpy(dir, b.ray.dir, sizeof dir);
    unit(dir);
    shade(j, &b, &hit, f, &k, at, normal, &from, dir, step, seen, colour);
    double turn = k.kt > 0 ? sph_ref_drift_refract(b.ray.turn, tilt, dot(dir, normal), ratio) : 0;
    if (isinf(turn)) doubt(seen, &b);
    if (k.kt > 0 && !sph_ref_refract(dir, normal, ratio, bent)) {
        sph_ref_reflect_all(&k, f, j->o->total);
    }
    add(seen, b.depth, b.weight, b.weight * k.own, colour);
    follow_rays(j, &b, &hit, &from, normal, side, &k, ratio, bent, tilt, turn, seen);
}
