/* kd.c - see kd.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/kd.h"

#include <math.h>
#include <stdlib.h>

enum { LEAF = 3, LEVELS = 64 };        /* in place of an axis; of the stack */
enum { STEP_COST = 1, TEST_COST = 4 }; /* of a node, of a primitive */

struct cell {
    double low[3], high[3];
};

struct node {
    union {
        double at;      /* where the cell is cut */
        uint32_t count; /* LEAF: of numbers */
    };
    uint32_t axis, next; /* the upper cell, the lower one follows the node; LEAF: first number */
};

struct sph_kd {
    struct node *nodes;
    uint32_t *numbers; /* ids */
    uint32_t n_nodes, n_numbers;
    struct cell root;
};

/* What is there while a tree is built. */
struct maker {
    struct sph_kd *kd;
    const struct sph_ref_item *items;
    struct cell *boxes;   /* of items, a little wider: no hit is lost to rounding */
    double *lows, *highs; /* of the boxes in a cell, along an axis */
};

struct cut {
    int axis;
    double at, cost;
};

static int rising(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Half of the surface. */
static double area(const struct cell *c) {
    double d[3];
    for (int i = 0; i < 3; i++)
        d[i] = c->high[i] - c->low[i];
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

static struct cell below(struct cell c, const struct cut *cut) {
    c.high[cut->axis] = cut->at;
    return c;
}

static struct cell above(struct cell c, const struct cut *cut) {
    c.low[cut->axis] = cut->at;
    return c;
}

/* Keeps the cheapest cut of a cell across one axis in *best. */
static void try_axis(const struct maker *m, const uint32_t *list, uint32_t n,
                     const struct cell *cell, int axis, struct cut *best) {
    for (uint32_t i = 0; i < n; i++) {
        m->lows[i] = m->boxes[list[i]].low[axis];
        m->highs[i] = m->boxes[list[i]].high[axis];
    }
    qsort(m->lows, n, sizeof *m->lows, rising);
    qsort(m->highs, n, sizeof *m->highs, rising);
    for (uint32_t begun = 0, ended = 0; ended < n;) {
        double at = begun < n ? fmin(m->lows[begun], m->highs[ended]) : m->highs[ended];
        uint32_t lower = begun;
        while (ended < n && m->highs[ended] <= at)
            ended++;
        while (begun < n && m->lows[begun] <= at)
            begun++;
        if (at <= cell->low[axis] || at >= cell->high[axis]) continue;
        struct cut cut = {axis, at, 0};
        struct cell halves[2] = {below(*cell, &cut), above(*cell, &cut)};
        double tests = area(&halves[0]) * lower + area(&halves[1]) * (n - ended);
        cut.cost = STEP_COST + TEST_COST * tests / area(cell);
        if (cut.cost < best->cost) *best = cut;
    }
}

/* Room for n + more in an array that has n, whose space is a power of 2; NULL if there is none. */
static void *room(void *array, size_t n, size_t more, size_t size) {
    size_t space = 1;
    while (space < n + more)
        space *= 2;
    return n && space < 2 * n ? array : realloc(array, space * size);
}

static int leaf(struct sph_kd *kd, const struct maker *m, const uint32_t *list, uint32_t n) {
    uint32_t *numbers = room(kd->numbers, kd->n_numbers, n, sizeof *numbers);
    if (!numbers) return -1;
    kd->numbers = numbers;
    struct node *node = &kd->nodes[kd->n_nodes - 1];
    *node = (struct node){.count = n, .axis = LEAF, .next = kd->n_numbers};
    for (uint32_t i = 0; i < n; i++)
        kd->numbers[kd->n_numbers++] = m->items[list[i]].id;
    return 0;
}

static int build(struct maker *m, const uint32_t *list, uint32_t n, const struct cell *cell,
                 int levels) {
    struct sph_kd *kd = m->kd;
    struct cut best = {LEAF, 0, (double)TEST_COST * n};
    uint32_t self = kd->n_nodes;
    struct node *nodes = room(kd->nodes, self, 1, sizeof *nodes);
    if (!nodes) return -1;
    kd->nodes = nodes;
    kd->n_nodes++;
    for (int axis = 0; axis < 3 && levels > 0; axis++)
        try_axis(m, list, n, cell, axis, &best);
    if (best.axis == LEAF) return leaf(kd, m, list, n);

    uint32_t *lower = malloc(2 * (size_t)n * sizeof *lower), n_lower = 0, n_upper = 0;
    if (!lower) return -1;
    uint32_t *upper = lower + n;
    for (uint32_t i = 0; i < n; i++) {
        if (m->boxes[list[i]].low[best.axis] < best.at) lower[n_lower++] = list[i];
        if (m->boxes[list[i]].high[best.axis] > best.at) upper[n_upper++] = list[i];
    }
    struct cell halves[2] = {below(*cell, &best), above(*cell, &best)};
    int rc = build(m, lower, n_lower, &halves[0], levels - 1);
    kd->nodes[self] =
        (struct node){.at = best.at, .axis = (uint32_t)best.axis, .next = kd->n_nodes};
    if (!rc) rc = build(m, upper, n_upper, &halves[1], levels - 1);
    free(lower);
    return rc;
}

/* The boxes, wider by what the largest coordinate may be off, and the one around them. */
static struct cell widen(const struct maker *m, uint32_t n) {
    struct cell root = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    double slack = 0;
    for (uint32_t i = 0; i < n; i++)
        for (int j = 0; j < 3; j++)
            slack = fmax(slack, fmax(fabs(m->items[i].low[j]), fabs(m->items[i].high[j])));
    slack *= 1e-9;
    for (uint32_t i = 0; i < n; i++)
        for (int j = 0; j < 3; j++) {
            m->boxes[i].low[j] = m->items[i].low[j] - slack;
            m->boxes[i].high[j] = m->items[i].high[j] + slack;
            root.low[j] = fmin(root.low[j], m->boxes[i].low[j]);
            root.high[j] = fmax(root.high[j], m->boxes[i].high[j]);
        }
    return root;
}

struct sph_kd *sph_kd_new(const struct sph_ref_item *items, uint32_t n) {
    struct sph_kd *kd = calloc(1, sizeof *kd);
    struct maker m = {kd, items, malloc((n + 1ull) * sizeof *m.boxes),
                      malloc((n + 1ull) * sizeof *m.lows), malloc((n + 1ull) * sizeof *m.highs)};
    uint32_t *all = malloc((n + 1ull) * sizeof *all);
    int made = kd && m.boxes && m.lows && m.highs && all;
    if (made) {
        kd->root = widen(&m, n);
        for (uint32_t i = 0; i < n; i++)
            all[i] = i;
        made = !build(&m, all, n, &kd->root, 8 + (int)(1.3 * log2(n + 1.0)));
    }
    free(m.boxes);
    free(m.lows);
    free(m.highs);
    free(all);
    if (made) return kd;
    sph_kd_free(kd);
    return NULL;
}

void sph_kd_free(struct sph_kd *kd) {
    if (!kd) return;
    free(kd->nodes);
    free(kd->numbers);
    free(kd);
}

uint64_t sph_kd_nodes(const struct sph_kd *kd) {
    return kd->n_nodes;
}

uint64_t sph_kd_node_bytes(void) {
    return sizeof(struct node);
}

uint64_t sph_kd_bytes(const struct sph_kd *kd) {
    return kd->n_nodes * sizeof *kd->nodes + kd->n_numbers * sizeof *kd->numbers;
}

/* A part of the ray, and the node whose cell it is in. */
struct span {
    uint32_t node;
    double near, far;
};

/* The part that is in the root's cell: none if near > far. */
static struct span enter(const struct cell *root, const double org[3], const double dir[3],
                         double limit) {
    struct span s = {0, 0, limit};
    for (int i = 0; i < 3; i++) {
        if (dir[i] == 0) {
            if (org[i] < root->low[i] || org[i] > root->high[i]) s.far = -1;
            continue;
        }
        double t0 = (root->low[i] - org[i]) / dir[i], t1 = (root->high[i] - org[i]) / dir[i];
        s.near = fmax(s.near, fmin(t0, t1));
        s.far = fmin(s.far, fmax(t0, t1));
    }
    return s;
}

uint64_t sph_kd_walk(const struct sph_kd *kd, const double org[3], const double dir[3],
                     double limit, sph_kd_test *test, void *user) {
    struct span now = enter(&kd->root, org, dir, limit), stack[LEVELS];
    uint64_t visited = 1;
    if (now.near > now.far) return visited;
    for (int sp = 0;; visited++) {
        const struct node *node = &kd->nodes[now.node];
        if (node->axis != LEAF) {
            double from = org[node->axis], to = dir[node->axis], t = (node->at - from) / to;
            int up = from > node->at || (from == node->at && to > 0);
            uint32_t first = up ? node->next : now.node + 1;
            uint32_t second = up ? now.node + 1 : node->next;
            if (to != 0 && t > 0 && t <= now.far) {
                if (t >= now.near) {
                    stack[sp++] = (struct span){second, t, now.far};
                    now.far = t;
                } else {
                    first = second;
                }
            }
            now.node = first;
            continue;
        }
        for (uint32_t i = 0; i < node->count; i++)
            limit = test(user, kd->numbers[node->next + i]);
        if (!sp || stack[sp - 1].near > limit) return visited;
        now = stack[--sp];
    }
}
