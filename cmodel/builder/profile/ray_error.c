/* ray_error.c - see ray_error.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/profile/ray_error.h"

#include <math.h>

#include "builder/grid/light.h"
#include "reference/facet.h"
#include "reference/world.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length(const double v[3]) {
    return sqrt(dot(v, v));
}

double sph_ray_error_distance(const struct sph_ref_step *s) {
    return s->hit.t * length(s->ray.dir);
}

/* Least cosine that counts: what is seen at a flatter angle is as wide as a point of it wavers. */
static double cosine(const struct sph_ref_step *s) {
    double least = 1.0 / 64, sizes = length(s->ray.dir) * length(s->normal);
    return fmax(fabs(dot(s->ray.dir, s->normal)) / sizes, least);
}

static const struct sph_facet *facet_of(const struct sph_ray_error *w, uint32_t id) {
    return id < w->scene->n_spheres ? NULL : &w->scene->facets[id - w->scene->n_spheres];
}

double sph_ray_error_surface(const struct sph_ray_error *w, uint32_t id) {
    if (id == SPH_ID_NONE) return 0;
    const struct sph_facet *f = facet_of(w, id);
    double off = 0, rad = 0;
    if (!f) {
        const struct sph_sphere *s = &w->scene->spheres[id];
        off = sph_grid_off(&w->grid, s->ctr);
        rad = round(s->rad / w->grid.step) * w->grid.step - s->rad;
    } else {
        for (int k = 0; k < (sph_ref_facet_unbounded(f) ? 1 : 3); k++)
            off = fmax(off, sph_grid_off(&w->grid, f->v[k]));
    }
    return off + fabs(rad);
}

double sph_ray_error_worst(const struct sph_ray_error *w, uint32_t id) {
    if (id == SPH_ID_NONE) return 0;
    return (sqrt(3) + !facet_of(w, id)) * w->grid.step / 2;
}

/* The least height of a triangle. */
static double height(const struct sph_facet *f) {
    double side[3][3], normal[3], longest = 0;
    for (int k = 0; k < 3; k++) {
        const struct sph_vec *a = &f->v[k], *b = &f->v[(k + 1) % 3];
        side[k][0] = b->x - a->x, side[k][1] = b->y - a->y, side[k][2] = b->z - a->z;
        longest = fmax(longest, length(side[k]));
    }
    for (int i = 0; i < 3; i++)
        normal[i] = side[0][(i + 1) % 3] * side[1][(i + 2) % 3] -
                    side[0][(i + 2) % 3] * side[1][(i + 1) % 3];
    return length(normal) / longest;
}

/* How far the roundings of its corners turn a triangle; of a plane's normal to 24 bits. */
static double tilt(const struct sph_facet *f, double off) {
    return sph_ref_facet_unbounded(f) ? ldexp(1, -22) : 2 * off / height(f);
}

double sph_ray_error_dir(const struct sph_ray_error *w) {
    if (w->grid.axes == SPH_AXES_CAMERA) return 0;
    return sqrt(3) * ldexp(1, -w->profile->wd);
}

struct sph_ends sph_ray_error_ends(const struct sph_ray_error *w) {
    return (struct sph_ends){w->grid.rotation, w->grid.origin, w->grid.step,
                             ldexp(1, w->profile->w - 1)};
}

int sph_ray_error_ended(const struct sph_ray_error *w, const struct sph_ref_log *log) {
    struct sph_ends ends = sph_ray_error_ends(w);
    for (int k = 0; k < log->n; k++) {
        const struct sph_ref_step *s = &log->step[k];
        const struct sph_facet *f = s->hit.id == SPH_ID_NONE ? NULL : facet_of(w, s->hit.id);
        if (f && sph_ref_facet_unbounded(f) &&
            s->hit.t > sph_ends_at(&ends, s->ray.org, s->ray.dir))
            return 1;
    }
    return 0;
}

void sph_ray_error_log(const struct sph_ray_error *w, const struct sph_ref_log *log,
                       struct sph_ray_errors out[SPH_REF_STEPS]) {
    const struct sph_profile *p = w->profile;
    double step = w->grid.step, guard = sqrt(3) * step * ldexp(1, -p->ng - 1);
    double dir = sqrt(3) * ldexp(1, 1 - p->wd);
    struct sph_ends ends = sph_ray_error_ends(w);
    int parent[SPH_MAX_DEPTH + 1] = {0};
    for (int k = 0; k < log->n; k++) {
        const struct sph_ref_step *s = &log->step[k];
        struct sph_ray_errors *o = &out[k], from = {0, 0, 0, 0};
        if (s->depth)
            from = out[parent[s->depth - 1]];
        else
            from.turn = sph_ray_error_dir(w);
        *o = (struct sph_ray_errors){0, 0, 0, 0};
        parent[s->depth] = k;
        if (s->hit.id == SPH_ID_NONE) continue;
        double far = sph_ray_error_distance(s) - (s->depth ? 0 : w->grid.seen_from.ahead);
        double quotient = far * ldexp(1, 1 - p->pq);
        double off = sph_ray_error_surface(w, s->hit.id), came = from.at + from.turn * far;
        const struct sph_facet *f = facet_of(w, s->hit.id);
        o->across = came + off;
        o->at = o->across / cosine(s) + sqrt(3) / 2 * step + quotient;
        double rad = f ? INFINITY : w->scene->spheres[s->hit.id].rad;
        o->normal = (guard + quotient) / rad + (f ? tilt(f, off) : 0);
        o->turn = from.turn + 2 * (o->normal + o->across / rad) + dir;
        if (f && sph_ref_facet_unbounded(f)) /* to its colour it is one which of both turns */
            o->normal += sph_ends_turn(&ends, w->scene, s->ray.org, s->ray.dir, s->hit.t);
    }
}

double sph_ray_error_width(const struct sph_ref_ray *a, const struct sph_ref_ray *b, double far) {
    double gap[3], la = length(a->dir), lb = length(b->dir);
    for (int i = 0; i < 3; i++)
        gap[i] = a->org[i] + far * a->dir[i] / la - b->org[i] - far * b->dir[i] / lb;
    return length(gap);
}

/* Rays of neighbours in a curved mirror may pass several edges: no more than a thing's size lies
 * between two. */
static double size(const struct sph_ray_error *w, uint32_t id) {
    if (id == SPH_ID_NONE) return INFINITY;
    const struct sph_facet *f = facet_of(w, id);
    if (!f) return w->scene->spheres[id].rad;
    return sph_ref_facet_unbounded(f) ? INFINITY : height(f);
}

/* Distance at which a step's ray meets what another one's did. */
static double meets(const struct sph_ray_error *w, const struct sph_ref_step *a, uint32_t id) {
    if (id == SPH_ID_NONE) return INFINITY;
    return sph_ref_meet(w->tree, id, &a->ray) * length(a->ray.dir);
}

double sph_ray_error_edge(const struct sph_ray_error *w, const struct sph_ref_step *a,
                          const struct sph_ref_step *b, const struct sph_ray_errors *of_a,
                          const struct sph_ray_errors *of_b) {
    double far_a = a->hit.id == SPH_ID_NONE ? INFINITY : sph_ray_error_distance(a);
    double far_b = b->hit.id == SPH_ID_NONE ? INFINITY : sph_ray_error_distance(b);
    double other_a = meets(w, a, b->hit.id), other_b = meets(w, b, a->hit.id);
    if (isfinite(other_a) && isfinite(other_b) && isfinite(far_a) && isfinite(far_b)) {
        double gap = other_a - far_a + other_b - far_b; /* they cut each other */
        return (of_a->across / cosine(a) + of_b->across / cosine(b)) / gap;
    }
    int first = !isfinite(other_b) && (isfinite(other_a) || far_a <= far_b);
    double far = first ? far_a : far_b, off = first ? of_a->across : of_b->across;
    double wide = sph_ray_error_width(&a->ray, &b->ray, far);
    return off / fmin(wide, fmin(size(w, a->hit.id), size(w, b->hit.id)));
}

double sph_ray_error_shadow(const struct sph_ray_error *w, const struct sph_ref_step *a,
                            const struct sph_ref_step *b, const struct sph_ray_errors *of, int l) {
    const struct sph_vec *lamp = &w->scene->lights[l].pos;
    const struct sph_ref_hit *by = a->blocked >> l & 1 ? &a->by[l] : &b->by[l];
    double to[3] = {lamp->x - a->at[0], lamp->y - a->at[1], lamp->z - a->at[2]}, move[3];
    double rest = 1 - by->t, far = length(to), along = 0;
    for (int i = 0; i < 3; i++) {
        move[i] = b->at[i] - a->at[i];
        along += move[i] * to[i] / far;
    }
    double wide = rest * sqrt(fmax(dot(move, move) - along * along, 0));
    double off =
        sph_ray_error_surface(w, by->id) + rest * of->at + by->t * sph_light_off(&w->grid, *lamp);
    return off / fmin(wide, size(w, by->id));
}
