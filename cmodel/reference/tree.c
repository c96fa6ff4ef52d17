/* tree.c - see tree.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/tree.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "common/parallel.h"
#include "reference/facet.h"
#include "reference/kd.h"
#include "reference/meet.h"

enum { LEAF = 4, PARALLEL = 8192 }; /* items of a box; those that threads share */

struct box {
    double low[3], high[3];
    uint32_t first, count; /* items; a box of more than LEAF has two children */
    uint32_t right;        /* left child: the next box */
};

struct sph_ref_tree {
    struct sph_ref_item *items;
    struct box *boxes;
    uint32_t n_items, n_boxes;
    uint32_t *unbounded, n_unbounded; /* planes, which no box holds */
    const struct sph_scene *scene;
    struct sph_kd *kd; /* NULL: the boxes are walked */
    struct sph_ref_work *work;
};

static double middle(const struct sph_ref_item *v, int axis) {
    return v->low[axis] + v->high[axis];
}

/* Puts the count/2 items that are least along axis first (Hoare's selection). */
static void halve(struct sph_ref_item *v, uint32_t count, int axis) {
    int64_t low = 0, high = (int64_t)count - 1, k = count / 2;
    while (low < high) {
        double pivot = middle(&v[(low + high) / 2], axis);
        int64_t i = low, j = high;
        while (i <= j) {
            while (middle(&v[i], axis) < pivot)
                i++;
            while (middle(&v[j], axis) > pivot)
                j--;
            if (i <= j) {
                struct sph_ref_item swap = v[i];
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

/* The boxes of so many items, and of one more. */
static void boxes_of(uint32_t count, uint32_t *boxes, uint32_t *more) {
    uint32_t half, half_more;
    *boxes = *more = 1;
    if (count < LEAF) return;
    boxes_of(count / 2, &half, &half_more);
    if (count > LEAF) *boxes += count % 2 ? half + half_more : 2 * half;
    *more += count % 2 ? 2 * half_more : half + half_more;
}

/* A box to be made, of some items. */
struct part {
    struct sph_ref_tree *tree;
    uint32_t self, first, count;
};

static void build_part(void *part);

/* Makes box `self` of some items and those below it, behind it. */
static void build(struct sph_ref_tree *t, uint32_t self, uint32_t first, uint32_t count) {
    struct box b = {
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, first, count, 0};
    for (uint32_t i = first; i < first + count; i++) {
        const struct sph_ref_item *s = &t->items[i];
        double slack = 1e-9 * sph_ref_most(sph_ref_size(s->low), sph_ref_size(s->high));
        for (int j = 0; j < 3; j++) { /* no hit is lost, nor what is as good as one */
            b.low[j] = sph_ref_least(b.low[j], s->low[j] - slack);
            b.high[j] = sph_ref_most(b.high[j], s->high[j] + slack);
        }
    }
    if (count > LEAF) {
        uint32_t left = count / 2, boxes, more;
        int axis = 0;
        for (int j = 1; j < 3; j++)
            if (b.high[j] - b.low[j] > b.high[axis] - b.low[axis]) axis = j;
        halve(t->items + first, count, axis);
        boxes_of(left, &boxes, &more);
        b.right = self + 1 + boxes;
        struct part lower = {t, self + 1, first, left};
        struct part upper = {t, b.right, first + left, count - left};
        sph_parallel_two(count > PARALLEL, build_part, &lower, &upper);
    }
    t->boxes[self] = b;
}

static void build_part(void *user) {
    const struct part *p = user;
    build(p->tree, p->self, p->first, p->count);
}

static void add(struct sph_ref_tree *t, uint32_t id, const struct sph_vec *v, int n, double rad) {
    struct sph_ref_item *at = &t->items[t->n_items++];
    *at = (struct sph_ref_item){
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, id};
    for (int i = 0; i < n; i++)
        for (int j = 0; j < 3; j++) {
            double c = j == 0 ? v[i].x : j == 1 ? v[i].y : v[i].z;
            at->low[j] = fmin(at->low[j], c - rad);
            at->high[j] = fmax(at->high[j], c + rad);
        }
}

/* The tree of all items; 0 if memory is out. */
static int grow(struct sph_ref_tree *t, int kd) {
    uint32_t more;
    if (kd) return (t->kd = sph_kd_new(t->items, t->n_items)) != NULL;
    boxes_of(t->n_items, &t->n_boxes, &more);
    build(t, 0, 0, t->n_items);
    return 1;
}

struct sph_ref_tree *sph_ref_tree_new(const struct sph_scene *scene) {
    return sph_ref_tree_counted(scene, 0, NULL);
}

struct sph_ref_tree *sph_ref_tree_counted(const struct sph_scene *scene, int kd,
                                          struct sph_ref_work *work) {
    clock_t start = clock();
    struct sph_ref_tree *t = calloc(1, sizeof *t);
    size_t n = (size_t)scene->n_spheres + scene->n_facets;
    if (!t) return NULL;
    t->scene = scene;
    t->items = malloc((n + 1) * sizeof *t->items);
    t->boxes = malloc((2 * n + 1) * sizeof *t->boxes);
    t->unbounded = malloc(((size_t)scene->n_facets + 1) * sizeof *t->unbounded);
    if (!t->items || !t->boxes || !t->unbounded) {
        sph_ref_tree_free(t);
        return NULL;
    }
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        add(t, i, &scene->spheres[i].ctr, 1, scene->spheres[i].rad);
    for (uint32_t i = 0; i < scene->n_facets; i++)
        if (sph_ref_facet_unbounded(&scene->facets[i]))
            t->unbounded[t->n_unbounded++] = i;
        else
            add(t, scene->n_spheres + i, scene->facets[i].v, 3, 0);
    if (!grow(t, kd)) {
        sph_ref_tree_free(t);
        return NULL;
    }
    if (!(t->work = work)) return t;
    *work = (struct sph_ref_work){.nodes = kd ? sph_kd_nodes(t->kd) : t->n_boxes,
                                  .node_bytes = kd ? sph_kd_node_bytes() : sizeof *t->boxes,
                                  .bytes = kd ? sph_kd_bytes(t->kd)
                                              : t->n_boxes * sizeof *t->boxes +
                                                    t->n_items * sizeof t->items->id,
                                  .build_seconds = (double)(clock() - start) / CLOCKS_PER_SEC};
    return t;
}

void sph_ref_tree_free(struct sph_ref_tree *tree) {
    if (!tree) return;
    free(tree->items);
    free(tree->boxes);
    free(tree->unbounded);
    sph_kd_free(tree->kd);
    free(tree);
}

double sph_ref_meet(const struct sph_ref_tree *t, uint32_t id, const struct sph_ref_ray *ray) {
    struct sph_ref_cast cast = sph_ref_cast(ray);
    struct sph_ref_meet m;
    return sph_ref_meet_ahead(t->scene, id, &cast, &m) && m.met ? m.t : INFINITY;
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
        near = sph_ref_most(near, sph_ref_least(t0, t1));
        far = sph_ref_least(far, sph_ref_most(t0, t1));
    }
    return near <= far * (1 + 1e-12);
}

/* A ray on its way through the tree. Hits are stretches of it: `limit` is where the first of all
 * ends, and those that begin before lie in one place with it. */
struct walk {
    const struct sph_ref_tree *tree;
    const struct sph_ref_cast *cast;
    double t_max, limit, begin; /* begin: where the first of all begins */
    double may;                 /* where what may be met, but is not, begins */
    int any_hit, tied, settle;  /* settle: which of those in one place it is */
    struct sph_ref_hit best;
    uint64_t steps, tests;
};

/* One more hit that begins before the limit. */
static void add_hit(struct walk *w, const struct sph_ref_hit *hit, double low, double high) {
    struct sph_ref_hit *best = &w->best;
    if (!w->settle) {
        w->tied = high < w->begin ? 0 : 1;
        w->begin = w->tied ? sph_ref_least(w->begin, low) : low;
        w->limit = sph_ref_least(w->limit, high);
        if (best->id == SPH_ID_NONE || !w->tied) *best = *hit;
        return;
    }
    int doubt = best->doubt | hit->doubt;
    if (best->id != SPH_ID_NONE && best->id != hit->id)
        doubt |= !sph_ref_coincide(w->tree->scene, best->id, hit->id);
    if (hit->id < best->id) *best = *hit;
    best->doubt = doubt;
}

/* Tests a primitive; what is farther than the t that it returns does not count. */
static double test(void *user, uint32_t id) {
    struct walk *w = user;
    struct sph_ref_meet m;
    w->tests++;
    if (!sph_ref_meet_ahead(w->tree->scene, id, w->cast, &m)) return w->limit;
    double low = m.t - m.slack, high = sph_ref_least(m.t + m.slack, DBL_MAX);
    if (!(low <= w->limit) || low >= w->t_max) return w->limit;
    if (!m.met) {
        w->may = sph_ref_least(w->may, low);
        return w->limit;
    }
    if (high >= w->t_max) return w->limit;
    struct sph_ref_hit hit = {m.t, id, m.far, m.slack, m.doubt};
    if (!w->any_hit) {
        add_hit(w, &hit, low, high);
        return w->limit;
    }
    w->best = hit;
    return hit.doubt ? w->limit : -1;
}

static void walk_boxes(struct walk *w) {
    const struct sph_ref_tree *tree = w->tree;
    double limit = w->limit;
    uint32_t stack[64];
    int sp = 0;
    stack[sp++] = 0;
    while (sp && limit >= 0) {
        uint32_t at = stack[--sp];
        const struct box *b = &tree->boxes[at];
        w->steps++;
        if (!meets(b, w->cast->ray, limit)) continue;
        if (b->count <= LEAF) {
            for (uint32_t i = 0; i < b->count; i++)
                limit = test(w, tree->items[b->first + i].id);
        } else {
            stack[sp++] = b->right;
            stack[sp++] = at + 1;
        }
    }
}

static void walk(struct walk *w) {
    const struct sph_ref_tree *tree = w->tree;
    const struct sph_ref_ray *ray = w->cast->ray;
    double limit = w->limit;
    for (uint32_t i = 0; i < tree->n_unbounded && limit >= 0; i++)
        limit = test(w, tree->scene->n_spheres + tree->unbounded[i]);
    if (limit < 0) return;
    if (tree->kd)
        w->steps += sph_kd_walk(tree->kd, ray->org, ray->dir, limit, test, w);
    else
        walk_boxes(w);
}

struct sph_ref_hit sph_ref_trace(const struct sph_ref_tree *tree, const struct sph_ref_ray *ray,
                                 double t_max, int any_hit) {
    struct sph_ref_cast cast = sph_ref_cast(ray);
    struct walk w = {.tree = tree,
                     .cast = &cast,
                     .t_max = t_max,
                     .limit = t_max,
                     .begin = INFINITY,
                     .may = INFINITY,
                     .any_hit = any_hit,
                     .best = {.t = INFINITY, .id = SPH_ID_NONE}};
    walk(&w);
    if (w.tied) {
        w.settle = 1;
        w.best = (struct sph_ref_hit){.t = INFINITY, .id = SPH_ID_NONE};
        walk(&w);
    }
    if (isfinite(w.may) && w.may <= w.limit && !(any_hit && w.best.t < t_max && !w.best.doubt))
        w.best.doubt = 1;
    if (tree->work) {
        tree->work->rays++;
        tree->work->steps += w.steps;
        tree->work->tests += w.tests;
    }
    return w.best;
}
