/* facet.c - runs the named cases of facets, see facet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "facet.h"
#include "machine/machine.h"
#include "naive/naive.h"
#include "trace/setup.h"
#include "trace/traverse.h"

/* ---- facet_exact ---- */
/* With A_j = v_j - org the line lies on one side of each edge as the volume of dir, A_k, A_l has
 * its sign; the plane is met at the volume of A_0, A_1, A_2 over the sum of the three. A ray to a
 * light comes from before the plane if that volume has its sign from all corners of a cube. */

/* a . (b x c), by the six products of Leibniz. */
static sph_i128 volume(const int64_t a[3], const int64_t b[3], const int64_t c[3]) {
    static const int turn[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {2, 1, 0}, {1, 0, 2}, {0, 2, 1}};
    sph_i128 sum = 0;
    for (int i = 0; i < 6; i++) {
        sph_i128 product = (sph_i128)a[turn[i][0]] * b[turn[i][1]] * c[turn[i][2]];
        sum += i < 3 ? product : -product;
    }
    return sum;
}

/* Where the ray leaves the world by one unit, along its longest axis, the first of them: before
 * the plane? Then this is t, and the part of the way that is left is worth as many keys as that
 * component has units. Returns these. */
static uint64_t end_of_world(const struct sph_profile *p, const struct sph_ray *ray,
                             struct facet_exact *e) {
    int64_t most = 0, way = 0, half = 1ll << (p->w - 1);
    for (int i = 0; i < 3; i++) {
        int64_t d = ray->dir[i] < 0 ? -ray->dir[i] : ray->dir[i];
        if (d <= most) continue;
        most = d;
        way = ray->dir[i] > 0 ? half - ray->org[i] : ray->org[i] - (-half - 1);
    }
    struct facet_exact face = {.own_num = way, .own_det = most};
    if (exact_facet_order(e, &face) <= 0) return 0;
    e->num = way;
    e->det = most;
    e->ended = 1;
    return (uint64_t)((e->own_num * most - e->own_det * way) / e->own_num);
}

/* Whether the whole cube around the point that the origin was rounded from lies before the facet's
 * plane; a: corners from the origin. goes: sign of N.dir. */
static int cube_before(const struct sph_profile *p, const struct sph_ray *ray,
                       const struct sph_facet_leaf *f, const int64_t a[3][3], int goes) {
    for (int corner = 0; corner < 8; corner++) {
        int64_t b[3][3];
        sph_i128 way = 0;
        for (int i = 0; i < 9; i++) {
            int off = corner >> i % 3 & 1 ? 1 : -1;
            b[i / 3][i % 3] = a[i / 3][i % 3] * (1 << p->ng) + ray->lift[i % 3] + off;
        }
        for (int j = 0; j < 3; j++)
            way += (sph_i128)f->v[1][j] * b[0][j];
        if (f->kind == SPH_TRIANGLE) way = volume(b[0], b[1], b[2]);
        if (goes < 0 ? way >= 0 : way <= 0) return 0;
    }
    return 1;
}

struct facet_exact exact_facet(const struct sph_profile *p, const struct sph_ray *ray,
                               const struct sph_facet_leaf *f) {
    struct facet_exact e = {0};
    int64_t a[3][3], skip = ray->skip.id, plane = f->kind != SPH_TRIANGLE;
    int above = 1, below = 1;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            a[i][j] = f->v[i][j] - ray->org[j];
    if (plane) {
        for (int j = 0; j < 3; j++) {
            e.det += (sph_i128)f->v[1][j] * ray->dir[j];
            e.num += (sph_i128)f->v[1][j] * a[0][j];
        }
    } else {
        for (int i = 0; i < 3; i++) {
            sph_i128 side = volume(ray->dir, a[i], a[(i + 1) % 3]);
            above &= side >= 0;
            below &= side <= 0;
            e.det += side;
        }
        e.num = volume(a[0], a[1], a[2]);
    }
    e.far = e.det > 0;
    int before =
        ray->kind != SPH_SHADOW || cube_before(p, ray, f, (const int64_t(*)[3])a, e.far ? 1 : -1);
    if (e.det < 0) e.det = -e.det, e.num = -e.num;
    e.met = e.det && e.num > 0 && before && (ray->kind != SPH_SHADOW || e.num < e.det) &&
            (skip < (int64_t)f->id - f->before || skip > (int64_t)f->id + f->after);
    e.hit = e.met && (above || below);
    e.own_num = e.num;
    e.own_det = e.det;
    if (!e.hit || ray->kind == SPH_SHADOW) return e;
    uint64_t more = plane ? end_of_world(p, ray, &e) : 0;
    sph_i128 scaled = e.num * (sph_i128)ray->a;
    e.key = (uint64_t)(scaled / e.det + (scaled % e.det != 0)) + more;
    return e;
}

/* By their continued fractions: nothing grows. */
int exact_facet_order(const struct facet_exact *e1, const struct facet_exact *e2) {
    sph_i128 a = e1->own_num, b = e1->own_det, c = e2->own_num, d = e2->own_det;
    for (int sign = 1;; sign = -sign) {
        if (a / b != c / d) return a / b < c / d ? -sign : sign;
        sph_i128 left = a % b, right = c % d;
        if (!left || !right) return !left && !right ? 0 : !left ? -sign : sign;
        a = b, b = left, c = d, d = right; /* of the reciprocals the order is the other one */
    }
}

struct hard_facet triangle(const int64_t org[3], const int64_t dir[3], const int64_t v0[3],
                           const int64_t v1[3], const int64_t v2[3]) {
    struct hard_facet c = {.ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1},
                           .facet = {.kind = SPH_TRIANGLE, .id = HARD_ID}};
    memcpy(c.ray.org, org, sizeof c.ray.org);
    memcpy(c.ray.dir, dir, sizeof c.ray.dir);
    memcpy(c.facet.v[0], v0, sizeof c.facet.v[0]);
    memcpy(c.facet.v[1], v1, sizeof c.facet.v[1]);
    memcpy(c.facet.v[2], v2, sizeof c.facet.v[2]);
    return c;
}

struct hard_facet plane(const int64_t org[3], const int64_t dir[3], const int64_t point[3],
                        const int64_t normal[3]) {
    struct hard_facet c = triangle(org, dir, point, normal, V3(0, 0, 0));
    c.facet.kind = SPH_PLANE;
    return c;
}

uint64_t key_at(const int64_t dir[3], int64_t x, int64_t d) {
    sph_i128 a = (sph_i128)dir[0] * dir[0] + (sph_i128)dir[1] * dir[1] + (sph_i128)dir[2] * dir[2];
    return (uint64_t)((a * x + d - 1) / d);
}

struct hard_facet wall(const int64_t org[3], const int64_t dir[3], int64_t x, int64_t height,
                       int64_t width) {
    return triangle(org, dir, V3(x, 0, -width), V3(x, 0, width), V3(x, height, 0));
}

static void turn(int64_t v[3]) {
    int64_t x = v[0];
    v[0] = v[1], v[1] = v[2], v[2] = x;
}

static void swap(int64_t a[3], int64_t b[3]) {
    for (int i = 0; i < 3; i++) {
        int64_t x = a[i];
        a[i] = b[i], b[i] = x;
    }
}

static void in_range(struct named *n, const struct hard_facet *c) {
    int legal = gen_on_grid(n->p, c->ray.org) && gen_on_grid(n->p, c->facet.v[0]);
    for (int i = 0; i < 3; i++)
        legal &= c->ray.dir[i] >= -n->most - 1 && c->ray.dir[i] <= n->most;
    if (c->facet.kind == SPH_TRIANGLE)
        legal &= gen_on_grid(n->p, c->facet.v[1]) && gen_on_grid(n->p, c->facet.v[2]);
    require(n, legal, "a vector is out of range");
}

static void add(struct hard_facets *list, const struct hard_facet *c, int named) {
    if (list->n == list->room) {
        size_t room = list->room ? 2 * list->room : 1024;
        struct hard_facet *items = realloc(list->items, room * sizeof *items);
        if (!items) {
            perror("hard_facets_named");
            exit(2);
        }
        list->items = items;
        list->room = room;
    }
    list->items[list->n] = *c;
    list->items[list->n++].named = named;
}

/* One vector; the axes are turned by `turned`. */
static void judge(struct named *n, const struct hard_facet *c, int outcome, uint64_t key) {
    static const char *const names[] = {"anything", "miss", "near", "far"};
    if (n->list) {
        if (n->facets) add(n->facets, c, n->list->named);
        return;
    }
    in_range(n, c);
    n->vectors++;
    struct sph_ray ray = c->ray;
    uint64_t divisions = 0, got = 0;
    sph_ray_setup(n->p, &ray);
    struct sph_facet_result r = sph_facet_test(n->p, &ray, &c->facet);
    if (r.hit && ray.kind != SPH_SHADOW) got = sph_facet_key(&ray, &r, &divisions);
    struct sph_naive_leaf naive = sph_naive_facet(n->p, &c->ray, &c->facet);
    int is = !r.hit ? MISS : r.far ? FAR : NEAR;
    int right = (outcome == ORACLE || is == outcome) && (!key || got == key);
    if (right && r.hit == naive.hit && (!r.hit || r.far == naive.far) && got == naive.key) return;
    const int64_t *o = ray.org, *d = ray.dir;
    require(n, 0,
            "org %ld %ld %ld dir %ld %ld %ld: %s, key %lu, naive %s, key %lu, expected %s, key %lu",
            o[0], o[1], o[2], d[0], d[1], d[2], names[is], got,
            names[!naive.hit  ? MISS
                  : naive.far ? FAR
                              : NEAR],
            naive.key, names[outcome], key);
    const int64_t(*v)[3] = c->facet.v;
    require(n, 0, "  kind %d: %ld %ld %ld, %ld %ld %ld, %ld %ld %ld", c->facet.kind, v[0][0],
            v[0][1], v[0][2], v[1][0], v[1][1], v[1][2], v[2][0], v[2][1], v[2][2]);
}

void expect_facet(struct named *n, struct hard_facet c, int outcome, uint64_t key) {
    int odd = outcome == NEAR ? FAR : outcome == FAR ? NEAR : outcome;
    for (int axes = 0; axes < 3; axes++) {
        for (int order = 0; order < 6; order++) {
            judge(n, &c, order & 1 ? odd : outcome, key);
            if (c.facet.kind == SPH_PLANE) break;
            swap(c.facet.v[order & 1], c.facet.v[2]); /* six times: back where it began */
        }
        turn(c.ray.org);
        turn(c.ray.dir);
        turn(c.ray.lift);
        for (int i = 0; i < 3; i++)
            turn(c.facet.v[i]);
    }
}

/* ---- two leaves of one node ---- */

static void put_vector(uint32_t *line, int at, const int64_t v[3]) {
    for (int i = 0; i < 3; i++)
        sph_field_set(line, at + 24 * i, 24, (uint32_t)v[i]);
}

static void put_facet(uint32_t *line, const struct sph_facet_leaf *f, uint32_t id) {
    for (int i = 0; i < (f->kind == SPH_PLANE ? 2 : 3); i++)
        put_vector(line, 72 * i, f->v[i]);
    sph_field_set(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, id);
    sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, (uint32_t)f->kind);
}

static void put_sphere(uint32_t *line, const struct sph_leaf *s) {
    put_vector(line, SPH_LEAF_CTR_X_LSB, s->ctr);
    sph_field_set(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)s->rad);
}

/* Leaves in lines 1 and 2, primitive records in 3 and 4, leaf lines of facets from line 5 on. */
void two_records(const struct named *n, const struct sph_facet_leaf *const f[2],
                 const struct sph_leaf *sphere, int order, const uint32_t ids[2],
                 uint32_t mem[TWO_RECORDS * SPH_LINE_WORDS], struct sph_machine *m) {
    memset(mem, 0, TWO_RECORDS * SPH_LINE_WORDS * sizeof *mem);
    *m = (struct sph_machine){.mem = mem, .lines = TWO_RECORDS};
    sph_machine_set_profile(m, &sph_profiles[n->profile]);
    m->regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_FACETS | 1 << SPH_EFFECT_INSIDE;
    m->regs[SPH_REG_PRIM_BASE] = 3;
    m->regs[SPH_REG_FACET_BASE] = 5;
    m->regs[SPH_REG_N_SPHERES] = sphere != NULL;
    m->regs[SPH_REG_MEM_LINES] = TWO_RECORDS;
    m->regs[SPH_REG_N_PRIMS] = 2;
    m->regs[SPH_REG_VISIT_LIMIT] = 2;
    sph_field_set(mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, 1);
    sph_field_set(mem, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 2);
    for (int i = 0; i < 2; i++) {
        uint32_t *leaf = mem + SPH_LINE_WORDS * (1 + (i ^ order));
        sph_field_set(mem, i * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                      7u * (1u << (n->p->fw - 3)) + 8); /* 7/8 of a side: more than the box */
        if (f[i]) {
            put_facet(leaf, f[i], ids[i]);
            put_facet(mem + SPH_LINE_WORDS * (5 + ids[i] - (sphere != NULL)), f[i], ids[i]);
        } else if (sphere) {
            put_sphere(leaf, sphere);
            put_sphere(mem + SPH_LINE_WORDS * 3, sphere);
        }
    }
}

static void trace_two(struct named *n, struct sph_ray ray, const struct sph_facet_leaf *const f[2],
                      const struct sph_leaf *sphere, int winner) {
    for (int order = 0; order < (sphere ? 2 : 4); order++) { /* of storage and of ids */
        uint32_t mem[TWO_RECORDS * SPH_LINE_WORDS], visits = 0, errors = 0;
        struct sph_machine m;
        struct sph_counters counters = {0};
        uint32_t ids[2] = {order >> 1 & 1, !(order >> 1 & 1)};
        two_records(n, f, sphere, order & 1, ids, mem, &m);
        uint32_t id = ids[winner < 0 ? ids[1] == 0 : winner];
        sph_ray_setup(n->p, &ray);
        struct sph_hit tree =
            sph_traverse(&m, &ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
        uint64_t tests = counters.count[SPH_COUNT_FACET_TESTS];
        struct sph_hit all =
            sph_traverse(&m, &ray, SPH_TRAVERSE_BRUTE, &counters, &visits, &errors);
        require(n,
                !errors && tree.id == id && all.id == id && tree.key == all.key &&
                    tree.far == all.far && tests == (sphere ? 1u : 2u),
                "order %d: id %u in the tree, %u of all, expected %u, after %lu tests", order,
                tree.id, all.id, id, tests);
    }
}

static uint64_t key_of(const struct named *n, struct sph_ray ray, const struct sph_facet_leaf *f) {
    return sph_naive_facet(n->p, &ray, f).key;
}

static void require_keys(struct named *n, uint64_t a, uint64_t b, int winner) {
    int right = winner < 0 ? a == b && a : winner ? b && (!a || b < a) : a && (!b || a < b);
    require(n, right, "keys %lu and %lu, expected %d first", a, b, winner);
}

void expect_first_facet(struct named *n, struct hard_facet c, const struct sph_facet_leaf *other,
                        int winner) {
    struct hard_facet second = {0, c.ray, *other};
    const struct sph_facet_leaf *both[2] = {&c.facet, other};
    expect_facet(n, c, ORACLE, 0);
    expect_facet(n, second, ORACLE, 0);
    if (n->list) return;
    require_keys(n, key_of(n, c.ray, &c.facet), key_of(n, c.ray, other), winner);
    trace_two(n, c.ray, both, NULL, winner);
}

void expect_first_sphere(struct named *n, struct hard_facet c, const struct sph_leaf *sphere,
                         int winner) {
    const struct sph_facet_leaf *both[2] = {NULL, &c.facet};
    expect_facet(n, c, ORACLE, 0);
    if (n->list) return;
    require_keys(n, sph_naive_leaf(&c.ray, sphere).key, key_of(n, c.ray, &c.facet), winner);
    trace_two(n, c.ray, both, sphere, winner);
}

struct hard_facets hard_facets_named(int profile) {
    struct hard_facets facets = {0};
    struct hard_list list = {0};
    for (int i = 0; i < hard_n_named; i++) {
        struct named n = hard_named_start(profile);
        n.list = &list;
        n.facets = &facets;
        list.named = i + 1;
        hard_named[i].run(&n);
    }
    free(list.items);
    return facets;
}
