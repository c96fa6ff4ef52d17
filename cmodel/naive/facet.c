/* facet.c - ray and facet by definition, see naive.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * org + t*dir = v0 + x*e1 + y*e2 is solved for x, y and t in rational numbers, by elimination.
 */
#include <gmp.h>

#include "naive/naive.h"

/* Three equations of three unknowns, the last column is the right side. */
struct equations {
    mpq_t m[3][4], x;
    int sign;     /* of the determinant */
    uint64_t add; /* to the key */
};

static void equations_set(struct equations *e, const int64_t e1[3], const int64_t e2[3],
                          const struct sph_ray *ray, const int64_t v0[3]) {
    e->add = 0;
    mpq_init(e->x);
    for (int i = 0; i < 3; i++) {
        const int64_t row[4] = {e1[i], e2[i], -ray->dir[i], ray->org[i] - v0[i]};
        for (int j = 0; j < 4; j++) {
            mpq_init(e->m[i][j]);
            mpq_set_si(e->m[i][j], row[j], 1);
        }
    }
}

static void equations_clear(struct equations *e) {
    mpq_clear(e->x);
    for (int i = 0; i < 12; i++)
        mpq_clear(e->m[i / 4][i % 4]);
}

/* Gauss and Jordan: the unknowns stand in the last column then. 0 if there is not one solution. */
static int equations_solve(struct equations *e) {
    e->sign = 1;
    for (int c = 0; c < 3; c++) {
        int pivot = c;
        while (pivot < 3 && !mpq_sgn(e->m[pivot][c]))
            pivot++;
        if (pivot == 3) return 0;
        if (pivot != c) e->sign = -e->sign;
        e->sign *= mpq_sgn(e->m[pivot][c]);
        for (int j = 0; j < 4; j++)
            mpq_swap(e->m[pivot][j], e->m[c][j]);
        for (int j = 3; j >= c; j--)
            mpq_div(e->m[c][j], e->m[c][j], e->m[c][c]);
        for (int i = 0; i < 3; i++)
            for (int j = 3; i != c && j >= c; j--) {
                mpq_mul(e->x, e->m[i][c], e->m[c][j]);
                mpq_sub(e->m[i][j], e->m[i][j], e->x);
            }
    }
    return 1;
}

static void triangle_directions(const struct sph_facet_leaf *f, int64_t e1[3], int64_t e2[3]) {
    for (int i = 0; i < 3; i++) {
        e1[i] = f->v[1][i] - f->v[0][i];
        e2[i] = f->v[2][i] - f->v[0][i];
    }
}

/* The sides x and y of the triangle are at least 0, and no more than 1 together. */
static int triangle_holds(struct equations *e, const struct sph_ray *ray, int w) {
    (void)ray, (void)w;
    mpq_add(e->x, e->m[0][3], e->m[1][3]);
    return mpq_sgn(e->m[0][3]) >= 0 && mpq_sgn(e->m[1][3]) >= 0 && mpq_cmp_si(e->x, 1, 1) <= 0;
}

/* Two directions of the plane with normal n, whose cross product is n times something positive. */
static void plane_directions(const struct sph_facet_leaf *f, int64_t e1[3], int64_t e2[3]) {
    const int64_t *n = f->v[1];
    int i = n[0] ? 0 : n[1] ? 1 : 2, j = (i + 1) % 3, k = (i + 2) % 3;
    int64_t turn = n[i] < 0 ? -1 : 1;
    e1[i] = -n[j], e1[j] = n[i], e1[k] = 0; /* e1 x e2 = n[i] * n */
    e2[i] = -n[k] * turn, e2[j] = 0, e2[k] = n[i] * turn;
}

/* Where a coordinate along the first of the longest components of dir becomes one that w bits do
 * not hold, a ray goes no farther. From there to the plane it has a part of the way, of which it is
 * worth as many keys as that component has units. */
static void end(struct equations *e, const struct sph_ray *ray, int w) {
    int64_t first = 1, longest = 0;
    for (int i = 1; i < w; i++)
        first *= 2;
    for (int i = 0; i < 3; i++) {
        int64_t d = ray->dir[i], size = d < 0 ? -d : d;
        if (size <= longest) continue;
        longest = size;
        mpq_set_si(e->x, (d < 0 ? -first - 1 : first) - ray->org[i], 1);
        mpq_set_si(e->m[0][0], d, 1);
        mpq_div(e->x, e->x, e->m[0][0]);
    }
    if (mpq_cmp(e->m[2][3], e->x) <= 0) return;
    mpq_sub(e->m[0][0], e->m[2][3], e->x);
    mpq_div(e->m[0][0], e->m[0][0], e->m[2][3]);
    mpz_mul_si(mpq_numref(e->m[0][0]), mpq_numref(e->m[0][0]), longest);
    mpz_fdiv_q(mpq_numref(e->m[0][0]), mpq_numref(e->m[0][0]), mpq_denref(e->m[0][0]));
    e->add = mpz_get_ui(mpq_numref(e->m[0][0]));
    mpq_set(e->m[2][3], e->x);
}

/* The smallest integer that is at least t * |dir|^2. */
static uint64_t key_of(struct equations *e, const struct sph_ray *ray) {
    mpz_t a;
    mpz_init(a);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(mpq_numref(e->x), ray->dir[i]);
        mpz_addmul(a, mpq_numref(e->x), mpq_numref(e->x));
    }
    mpz_mul(a, a, mpq_numref(e->m[2][3]));
    mpz_cdiv_q(a, a, mpq_denref(e->m[2][3]));
    uint64_t key = mpz_get_ui(a) + e->add;
    mpz_clear(a);
    return key;
}

/* A plane has no end, but rays have. */
static int plane_holds(struct equations *e, const struct sph_ray *ray, int w) {
    if (ray->kind != SPH_SHADOW) end(e, ray, w);
    return 1;
}

/* What this model knows of each kind. */
static const struct {
    void (*directions)(const struct sph_facet_leaf *f, int64_t e1[3], int64_t e2[3]);
    int (*holds)(struct equations *solved, const struct sph_ray *ray, int w); /* moves t */
} kinds[SPH_KINDS] = {[SPH_TRIANGLE] = {triangle_directions, triangle_holds},
                      [SPH_PLANE] = {plane_directions, plane_holds}};

/* e1 x e2 . v */
static void volume(const int64_t e1[3], const int64_t e2[3], const int64_t v[3], mpz_t sum) {
    mpz_t x;
    mpz_init(x);
    mpz_set_ui(sum, 0);
    for (int i = 0; i < 6; i++) {
        int a = i % 3, b = (a + (i < 3 ? 1 : 2)) % 3;
        mpz_set_si(x, e1[a]);
        mpz_mul_si(x, x, e2[b]);
        mpz_mul_si(x, x, i < 3 ? v[3 - a - b] : -v[3 - a - b]);
        mpz_add(sum, sum, x);
    }
    mpz_clear(x);
}

/* A ray to a light comes from somewhere in a cube: its centre is the point before it was rounded to
 * the grid, half its side the last guard bit. Whether all its corners lie on that side of the
 * facet's plane from which the ray goes to the other. */
static int cube_before(const struct sph_profile *p, const struct sph_ray *ray,
                       const struct sph_facet_leaf *f, const int64_t e1[3], const int64_t e2[3]) {
    int same = 1;
    mpz_t goes, way;
    mpz_inits(goes, way, NULL);
    volume(e1, e2, ray->dir, goes);
    for (int corner = 0; corner < 8; corner++) {
        int64_t to[3];
        for (int i = 0; i < 3; i++)
            to[i] = (f->v[0][i] - ray->org[i]) * (1 << p->ng) + ray->lift[i] +
                    (corner >> i & 1 ? 1 : -1);
        volume(e1, e2, to, way);
        same &= mpz_sgn(way) == mpz_sgn(goes);
    }
    mpz_clears(goes, way, NULL);
    return same;
}

struct sph_naive_leaf sph_naive_facet(const struct sph_profile *p, const struct sph_ray *ray,
                                      const struct sph_facet_leaf *f) {
    struct sph_naive_leaf r = {0};
    struct equations e;
    int64_t e1[3], e2[3], skip = ray->skip.id, id = f->id;
    if (id - f->before <= skip && skip <= id + f->after) return r;
    kinds[f->kind].directions(f, e1, e2);
    equations_set(&e, e1, e2, ray, f->v[0]);
    if (equations_solve(&e) && mpq_sgn(e.m[2][3]) > 0) {
        int shadow = ray->kind == SPH_SHADOW;
        r.hit = !shadow || mpq_cmp_si(e.m[2][3], 1, 1) < 0;
        r.hit = r.hit && (!shadow || cube_before(p, ray, f, e1, e2));
        r.hit = r.hit && kinds[f->kind].holds(&e, ray, p->w);
        r.far = r.hit && e.sign < 0; /* the column of dir is negated */
        if (r.hit && !shadow) r.key = key_of(&e, ray);
    }
    equations_clear(&e);
    return r;
}

/* Three numbers of 24 bits, the first one's lowest bit is lsb. */
static void three(const uint32_t *line, int lsb, int64_t v[3]) {
    for (int i = 0; i < 3; i++) {
        v[i] = 0;
        for (int b = 0; b < 24; b++) {
            int at = lsb + 24 * i + b;
            v[i] += (int64_t)(line[at / 32] >> at % 32 & 1) * (b < 23 ? 1 << b : -(1 << b));
        }
    }
}

struct sph_facet_leaf sph_naive_facet_read(const uint32_t *line) {
    struct sph_facet_leaf f = {.kind = (int)(line[7] >> 30),
                               .id = line[6] >> 24 | (line[7] & 0xffff) << 8,
                               .before = line[7] >> 16 & 63,
                               .after = line[7] >> 23 & 63};
    for (int i = 0; i < 3; i++)
        three(line, 72 * i, f.v[i]);
    return f;
}
