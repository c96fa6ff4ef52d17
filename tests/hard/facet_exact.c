/* facet_exact.c - see facet_exact.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * With A_j = v_j - org the line lies on one side of each edge as the volume of dir, A_k, A_l has
 * its sign; the plane is met at the volume of A_0, A_1, A_2 over the sum of the three. A ray to a
 * light comes from before the plane if that volume has its sign from all corners of a cube.
 */
#include "facet_exact.h"

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
