/* tree.c - see tree.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/tree.h"

#include <math.h>
#include <stdlib.h>

enum { LEAF = 4 };

struct item {
    double ctr[3], rad;
    uint32_t id;
};

struct box {
    double low[3], high[3];
    uint32_t first, count; /* items; a box of more than LEAF has two children */
    uint32_t right;        /* left child: the next box */
};

struct sph_ref_tree {
    struct item *items;
    struct box *boxes;
    uint32_t n_boxes;
};

/* Puts the count/2 items that are least along axis first (Hoare's selection). */
static void halve(struct item *v, uint32_t count, int axis) {
    int64_t low = 0, high = (int64_t)count - 1, k = count / 2;
    while (low < high) {
        double pivot = v[(low + high) / 2].ctr[axis];
        int64_t i = low, j = high;
        while (i <= j) {
            while (v[i].ctr[axis] < pivot)
                i++;
            while (v[j].ctr[axis] > pivot)
                j--;
            if (i <= j) {
                struct item swap = v[i];
                v[i++] = v[j];
                v[j--] = swap;
            }
        }
        if (k <= j)
            high = j;
        else if (k >= i)
            low = i;
        else
            break;
    }
}

static uint32_t build(struct sph_ref_tree *t, uint32_t first, uint32_t count) {
    uint32_t self = t->n_boxes++;
    struct box b = {
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, first, count, 0};
    for (uint32_t i = first; i < first + count; i++)
        for (int j = 0; j < 3; j++) {
            const struct item *s = &t->items[i];
            double slack = 1e-9 * (fabs(s->ctr[j]) + s->rad); /* boxes never lose a hit */
            b.low[j] = fmin(b.low[j], s->ctr[j] - s->rad - slack);
            b.high[j] = fmax(b.high[j], s->ctr[j] + s->rad + slack);
        }
    if (count > LEAF) {
        int axis = 0;
        for (int j = 1; j < 3; j++)
            if (b.high[j] - b.low[j] > b.high[axis] - b.low[axis]) axis = j;
        halve(t->items + first, count, axis);
        build(t, first, count / 2);
        b.right = build(t, first + count / 2, count - count / 2);
    }
    t->boxes[self] = b;
    return self;
}

struct sph_ref_tree *sph_ref_tree_new(const struct sph_scene *scene) {
    struct sph_ref_tree *t = calloc(1, sizeof *t);
    size_t n = scene->n_spheres;
    if (!t) return NULL;
    t->items = malloc((n + 1) * sizeof *t->items);
    t->boxes = malloc((2 * n + 1) * sizeof *t->boxes);
    if (!t->items || !t->boxes) {
        sph_ref_tree_free(t);
        return NULL;
    }
    for (uint32_t i = 0; i < n; i++) {
        const struct sph_sphere *s = &scene->spheres[i];
        t->items[i] = (struct item){{s->ctr.x, s->ctr.y, s->ctr.z}, s->rad, i};
    }
    build(t, 0, (uint32_t)n);
    return t;
}

void sph_ref_tree_free(struct sph_ref_tree *tree) {
    if (!tree) return;
    free(tree->items);
    free(tree->boxes);
    free(tree);
}

/* Stable quadratic: the discriminant from the distance of centre and ray, the small root from the
 * product of the roots. */
static void sphere(const struct item *s, const struct sph_ref_ray *ray, double t_max,
                   struct sph_ref_hit *best) {
    int own = s->id == ray->skip;
    if (own && !ray->inside) return;
    const double *d = ray->dir;
    double oc[3], a = 0, b = 0, oc2 = 0, off2 = 0;
    for (int i = 0; i < 3; i++) {
        oc[i] = s->ctr[i] - ray->org[i];
        a += d[i] * d[i];
        b += oc[i] * d[i];
        oc2 += oc[i] * oc[i];
    }
    for (int i = 0; i < 3; i++) {
        double v = oc[i] - b / a * d[i];
        off2 += v * v;
    }
    double disc = a * (s->rad * s->rad - off2), c = oc2 - s->rad * s->rad, t;
    if (!(disc > 0) || !(b > 0 || c < 0 || own)) return;
    double q = b + copysign(sqrt(disc), b);
    int far = c <= 0 || own;
    if (b >= 0)
        t = far ? q / a : c / q;
    else
        t = c / q; /* far: -|c| / -|q| */
    if (!(t > 0) || t >= t_max || t > best->t || (t == best->t && s->id > best->id)) return;
    *best = (struct sph_ref_hit){t, s->id, far};
}

/* Whether the ray meets the box before t_max. */
static int meets(const struct box *b, const struct sph_ref_ray *ray, double t_max) {
    double near = 0, far = t_max;
    for (int i = 0; i < 3; i++) {
        if (ray->dir[i] == 0) {
            if (ray->org[i] < b->low[i] || ray->org[i] > b->high[i]) return 0;
            continue;
        }
        double t0 = (b->low[i] - ray->org[i]) / ray->dir[i];
        double t1 = (b->high[i] - ray->org[i]) / ray->dir[i];
        near = fmax(near, fmin(t0, t1));
        far = fmin(far, fmax(t0, t1));
    }
    return near <= far * (1 + 1e-12);
}

struct sph_ref_hit sph_ref_trace(const struct sph_ref_tree *tree, const struct sph_ref_ray *ray,
                                 double t_max, int any_hit) {
    struct sph_ref_hit best = {INFINITY, SPH_ID_NONE, 0};
    uint32_t stack[64];
    int sp = 0;
    stack[sp++] = 0;
    while (sp) {
        uint32_t at = stack[--sp];
        const struct box *b = &tree->boxes[at];
        if (!meets(b, ray, fmin(t_max, best.t))) continue;
        if (b->count <= LEAF) {
            for (uint32_t i = 0; i < b->count; i++)
                sphere(&tree->items[b->first + i], ray, t_max, &best);
            if (any_hit && best.t < t_max) break;
        } else {
            stack[sp++] = b->right;
            stack[sp++] = at + 1;
        }
    }
    return best;
}
