/* test_facet_mesh.c - no ray slips between triangles that share an edge or a corner
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every mesh of its kind on a small lattice, every direction, the origin at 0. The triangles have
 * their corners in every order: nothing depends on how a mesh is wound.
 */
#include "vectors.h"

#include "prim/facet.h"

typedef int64_t point[3];

static const struct sph_profile small = {"small", 4, 4, 4, 0, 4, 0};

/* Number n of the side^3 lattice points around 0. */
static void lattice(uint64_t n, int64_t side, point p) {
    for (int i = 0; i < 3; i++, n /= (uint64_t)side)
        p[i] = (int64_t)(n % (uint64_t)side) - side / 2;
}

static int64_t volume(const point a, const point b, const point c) {
    int64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += a[i] * (b[j] * c[k] - b[k] * c[j]);
    }
    return sum;
}

/* The key with which the ray hits the triangle, corners in order number `order` (0..5); 0: miss. */
static uint64_t key(const point dir, const point a, const point b, const point c, int order) {
    struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}};
    struct sph_facet_leaf f = {.kind = SPH_TRIANGLE, .id = 7};
    const int64_t *corner[3] = {a, b, c};
    uint64_t divisions = 0;
    for (int i = 0; i < 3; i++) {
        const int64_t *from = corner[order < 3 ? (i + order) % 3 : (5 - i + order) % 3];
        for (int j = 0; j < 3; j++)
            f.v[i][j] = from[j];
        ray.dir[i] = dir[i];
        ray.a += (uint64_t)(dir[i] * dir[i]);
    }
    struct sph_facet_result r = sph_facet_test(&small, &ray, &f);
    return r.hit ? sph_facet_key(&ray, &r, &divisions) : 0;
}

/* Closed tetrahedra around the origin: every ray hits a side, through an edge or a corner too; two
 * sides that it hits there have the same key. */
static void tetrahedra(void **state) {
    (void)state;
    uint64_t solids = 0, rays = 0, shared = 0;
    for (uint64_t n = 0; n < 27ull * 27 * 27 * 27; n += VEC_SHARE) {
        point v[4];
        for (int i = 0; i < 4; i++) {
            uint64_t at = n;
            for (int k = 0; k < i; k++)
                at /= 27;
            lattice(at % 27, 3, v[i]);
        }
        int64_t s = volume(v[0], v[1], v[2]); /* 0 strictly inside: four volumes of one sign */
        if (s <= 0 || volume(v[0], v[3], v[1]) <= 0 || volume(v[1], v[3], v[2]) <= 0 ||
            volume(v[2], v[3], v[0]) <= 0)
            continue;
        solids++;
        for (uint64_t d = 0; d < 125; d++, rays++) {
            point dir;
            uint64_t first = 0, hits = 0;
            lattice(d, 5, dir);
            if (!dir[0] && !dir[1] && !dir[2]) continue;
            for (int i = 0; i < 4; i++) {
                uint64_t k = key(dir, v[i], v[(i + 1) % 4], v[(i + 2) % 4],
                                 (int)((n + d + (uint64_t)i * 5) % 6));
                if (k) hits++;
                if (k && first) assert_true(k == first);
                if (k) first = k;
            }
            shared += hits > 1;
            if (!hits)
                fail_msg("slips: (%ld %ld %ld) (%ld %ld %ld) (%ld %ld %ld) (%ld %ld %ld) dir (%ld "
                         "%ld %ld)",
                         v[0][0], v[0][1], v[0][2], v[1][0], v[1][1], v[1][2], v[2][0], v[2][1],
                         v[2][2], v[3][0], v[3][1], v[3][2], dir[0], dir[1], dir[2]);
        }
    }
    printf("# %lu tetrahedra, %lu rays from inside, %lu through an edge or a corner\n", solids,
           rays, shared);
    assert_true(solids > 100 / VEC_SHARE && shared > rays / 10);
}

/* N.v of a triangle */
static int64_t height(const point a, const point b, const point c, const point v) {
    point e1, e2;
    for (int i = 0; i < 3; i++)
        e1[i] = b[i] - a[i], e2[i] = c[i] - a[i];
    return volume(e1, e2, v);
}

/* From within closed tetrahedra to lights outside: only that side lets light through whose plane
 * comes into the cube around the origin before it was rounded. ng is 0, a lattice's step 16. */
static void lights(void **state) {
    (void)state;
    uint64_t rays = 0, passed = 0, reached = 0;
    for (uint64_t n = 0; n < 27ull * 27 * 27 * 27; n += VEC_SHARE) {
        point v[4];
        for (uint64_t i = 0, at = n; i < 4; i++, at /= 27) {
            lattice(at % 27, 3, v[i]);
            for (int j = 0; j < 3; j++)
                v[i][j] *= 16;
        }
        if (volume(v[0], v[1], v[2]) <= 0 || volume(v[0], v[3], v[1]) <= 0 ||
            volume(v[1], v[3], v[2]) <= 0 || volume(v[2], v[3], v[0]) <= 0)
            continue;
        for (uint64_t d = 0; d < 125; d++, rays++) {
            point dir;
            int any = 0, lit = 1;
            lattice(d, 5, dir);
            if (!dir[0] && !dir[1] && !dir[2]) continue;
            for (int i = 0; i < 4; i++) {
                struct sph_ray ray = {.kind = SPH_SHADOW, .skip = {SPH_ID_NONE, 0}};
                struct sph_facet_leaf f = {.kind = SPH_TRIANGLE, .id = 7};
                const int64_t *a = v[i], *b = v[(i + 1) % 4], *c = v[(i + 2) % 4];
                int cube = 0; /* its corners before the plane */
                for (int j = 0; j < 3; j++) {
                    ray.dir[j] = 64 * dir[j];
                    ray.lift[j] = (int64_t)((n + d) / (j == 0 ? 1 : j == 1 ? 3 : 9) % 3) - 1;
                    f.v[0][j] = a[j], f.v[1][j] = b[j], f.v[2][j] = c[j];
                }
                for (int k = 0; k < 8; k++) {
                    point way;
                    for (int j = 0; j < 3; j++)
                        way[j] = a[j] + ray.lift[j] + (k >> j & 1 ? 1 : -1);
                    int64_t up = height(a, b, c, dir), to = height(a, b, c, way);
                    cube += up > 0 ? to > 0 : to < 0;
                }
                int hit = sph_facet_test(&small, &ray, &f).hit;
                int met = key(dir, a, b, c, 0) != 0;
                assert_int_equal(hit, met && cube == 8);
                reached += met && !hit;
                any |= met;
                lit &= !hit;
            }
            assert_true(any);
            passed += (uint64_t)lit;
        }
    }
    printf("# %lu rays to lights, %lu sides too near, %lu rays through\n", rays, reached, passed);
    assert_true(rays > 1000 / VEC_SHARE && reached && passed < rays / 2);
}

/* Tents: a fan of four triangles over the square of +-2, corners and apex at any height: every ray
 * along z through a point of the square hits it. Points are quarters, so the apex is one. */
static void tents(void **state) {
    (void)state;
    uint64_t rays = 0, shared = 0;
    for (uint64_t n = 0; n < 9ull * 81 * 3; n += VEC_SHARE) {
        uint64_t h = n / 9;
        point rim[4], apex = {(int64_t)(n % 3) - 1, (int64_t)(n / 3 % 3) - 1, 5};
        for (int i = 0; i < 4; i++, h /= 3) {
            rim[i][0] = i == 0 || i == 3 ? 2 : -2;
            rim[i][1] = i < 2 ? 2 : -2;
            rim[i][2] = (int64_t)(h % 3) + 4;
        }
        apex[2] += (int64_t)h % 3 - 1;
        for (int x = -8; x <= 8; x++)
            for (int y = -8; y <= 8; y++, rays++) {
                uint64_t hits = 0;
                point dir = {0, 0, 1};
                for (int i = 0; i < 4; i++) {
                    point a, b, c;
                    for (int j = 0; j < 3; j++) {
                        a[j] = 4 * rim[i][j] - (j == 0 ? x : j == 1 ? y : 0);
                        b[j] = 4 * rim[(i + 1) % 4][j] - (j == 0 ? x : j == 1 ? y : 0);
                        c[j] = 4 * apex[j] - (j == 0 ? x : j == 1 ? y : 0);
                    }
                    hits += key(dir, a, b, c, (int)((n + (uint64_t)i) % 6)) != 0;
                }
                shared += hits > 1;
                if (!hits) fail_msg("slips through tent %lu at %d, %d", n, x, y);
            }
    }
    printf("# %lu rays onto tents, %lu onto an edge or a corner\n", rays, shared);
    assert_true(shared > rays / 20);
}

/* Two triangles pqr and qps that share the edge pq, with p, q in front of the origin: seen along
 * the ray a quadrangle p s q r. Where the ray is inside all its four outer edges, one is hit. */
static void quadrangles(void **state) {
    (void)state;
    uint64_t rays = 0, on_edge = 0, edge_on = 0;
    for (uint64_t n = 0; n < 27ull * 27 * 27 * 27; n += VEC_SHARE) {
        point p, q, r, s;
        lattice(n % 27, 3, p);
        lattice(n / 27 % 27, 3, q);
        lattice(n / 729 % 27, 3, r);
        lattice(n / 19683, 3, s);
        p[2] += 3, q[2] += 3, r[2] += 3, s[2] += 3; /* ahead of rays with z > 0 */
        for (uint64_t d = 0; d < 9; d++) {
            point dir = {(int64_t)(d % 3) - 1, (int64_t)(d / 3) - 1, 3};
            int64_t sides[4] = {volume(dir, p, s), volume(dir, s, q), volume(dir, q, r),
                                volume(dir, r, p)};
            if (sides[0] <= 0 || sides[1] <= 0 || sides[2] <= 0 || sides[3] <= 0) continue;
            int order = (int)((n + d) % 6);
            uint64_t one = key(dir, p, q, r, order), two = key(dir, q, p, s, (order * 5 + 1) % 6);
            rays++;
            on_edge += volume(dir, p, q) == 0;
            edge_on += volume(dir, p, q) + sides[2] + sides[3] == 0;
            if ((!one && !two) || (one && two && one != two))
                fail_msg("p (%ld %ld %ld) q (%ld %ld %ld) r (%ld %ld %ld) s (%ld %ld %ld) dir "
                         "(%ld %ld %ld): keys %lu, %lu",
                         p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2], s[0], s[1], s[2],
                         dir[0], dir[1], dir[2], one, two);
        }
    }
    printf("# %lu rays inside two triangles, %lu through their edge, %lu beside a triangle that is "
           "seen as a line\n",
           rays, on_edge, edge_on);
    assert_true(rays > 1000 / VEC_SHARE && on_edge > 100 / VEC_SHARE && edge_on > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tetrahedra),
        cmocka_unit_test(lights),
        cmocka_unit_test(tents),
        cmocka_unit_test(quadrangles),
    };
    return cmocka_run_group_tests_name("facet_mesh", tests, NULL, NULL);
}
