/* named_refract.c - named cases 62 to 69 and 79: refracted rays where they begin, end and turn
 * back
 * SPDX-License-Identifier: Apache-2.0
 */
#include "named.h"

#include <string.h>

#include "naive/math.h"
#include "shade/refract.h"
#include "trace/setup.h"

enum { ANY, THROUGH, REFLECTED };

/* A direction, a normal and two indices in all three turns of the axes; model against naive model
 * and against what is expected. out: of the first turn. */
static void bend(struct named *n, const int64_t d[3], const int64_t normal[3], uint32_t from,
                 uint32_t to, int expected, int64_t out[3]) {
    for (int axis = 0; axis < 3; axis++) {
        struct hard_item item = {.what = HARD_REFRACT, .from = from, .to = to};
        struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}};
        struct sph_surface s = {.nn = 0};
        int64_t got[3] = {0}, same[3] = {0};
        for (int i = 0; i < 3; i++) {
            int j = (i + axis) % 3;
            item.dir[j] = ray.dir[j] = d[i];
            item.normal[j] = s.normal[j] = normal[i];
            s.nn += (uint64_t)(normal[i] * normal[i]);
        }
        n->vectors++;
        if (n->list) {
            hard_list_add(n->list, item);
            continue;
        }
        sph_ray_setup(n->p, &ray);
        s.unit = sph_unit(s.normal, s.nn, n->p->wd);
        int went = sph_refract(n->p, &ray, &s, from, to, got);
        int goes = sph_naive_refract(n->p, ray.dir, s.normal, from, to, same);
        require(n, went == goes && !memcmp(got, same, sizeof got), "not as the naive model bends");
        require(n, expected == ANY || went == (expected == THROUGH),
                went ? "through" : "reflected");
        for (int i = 0; i < 3 && !axis; i++)
            out[i] = got[i];
    }
}

/* sine = to/from exactly: 4/5 of 1000/1250, 3/5 of 600/1000. */
void named_critical(struct named *n) {
    int64_t out[3];
    for (int64_t k = 1; 5 * k < n->most; k = 3 * k + 1)
        for (int flip = -1; flip <= 1; flip += 2) {
            const int64_t normal[3] = {0, 0, flip * (n->half - 3)};
            for (int64_t off = -1; off <= 1; off++) { /* one unit steeper, there, one flatter */
                int expected = off > 0 ? REFLECTED : THROUGH;
                bend(n, V3(4 * k + off, 0, -3 * k * flip), normal, 1250, 1000, expected, out);
                if (!off && !n->list)
                    require(n, out[0] > 0 && !out[1] && !out[2], "not along the surface");
                bend(n, V3(3 * k + off, 0, -4 * k * flip), normal, 1000, 600, expected, out);
            }
            bend(n, V3(4 * k, 0, -3 * k * flip), normal, 1251, 1000, REFLECTED, out);
            bend(n, V3(4 * k, 0, -3 * k * flip), normal, 1249, 1000, THROUGH, out);
        }
}

/* B = 0. */
void named_refract_along(struct named *n) {
    struct sph_rng rng = {63};
    int64_t out[3];
    for (int i = 0; i < 60; i++) {
        int64_t u[3], v[3], w[3];
        gen_frame(&rng, 1ll << (n->p->wd / 2 - 2), u, v, w);
        bend(n, u, v, 1000, 1001, THROUGH, out);
        bend(n, u, v, 1000, 4000, THROUGH, out);
        bend(n, u, v, 1001, 1000, REFLECTED, out);
        bend(n, u, v, 4000, 1000, REFLECTED, out);
        bend(n, u, v, 1000, 1000, THROUGH, out); /* X = 0: along the surface, straight on */
        for (int j = 0; j < 3 && !n->list; j++)
            require(n, (out[j] > 0) == (u[j] > 0), "does not go straight on");
    }
}

/* B > 0, the normal turned away by rounding: to the other side all the same. */
void named_refract_away(struct named *n) {
    int64_t out[3];
    for (int64_t k = 1; k < n->half / 4; k = 5 * k + 1) {
        const int64_t normal[3] = {0, k, n->half};
        bend(n, V3(n->half / 2, 0, 1), normal, 1000, 1500, THROUGH, out);
        if (!n->list) require(n, out[2] * n->half + out[1] * k < 0, "on the ray's side");
        bend(n, V3(0, k, 1), normal, 1000, 4000, THROUGH, out);
        if (!n->list) require(n, out[2] * n->half + out[1] * k < 0, "on the ray's side");
        bend(n, V3(n->half / 2, 0, 1), normal, 1500, 1000, REFLECTED, out);
    }
}

/* Along the normal nothing bends; the shortest vectors too. */
void named_refract_head_on(struct named *n) {
    static const uint32_t index[] = {250, 950, 999, 1000, 1001, 1500, 4000};
    int64_t out[3], end = 1ll << (n->p->wd - 2);
    for (int i = 0; i < 7; i++)
        for (int64_t k = 1; k <= n->most; k = 4 * k + 1)
            for (int64_t m = 1; m <= n->most; m = 30 * m + 7) {
                bend(n, V3(0, 0, -k), V3(0, 0, m), 1000, index[i], THROUGH, out);
                if (!n->list)
                    require(n, !out[0] && !out[1] && out[2] <= -end, "bent though it is head on");
                bend(n, V3(0, 0, k), V3(0, 0, -m), index[i], 1000, THROUGH, out);
                if (!n->list)
                    require(n, !out[0] && !out[1] && out[2] >= end, "bent though it is head on");
                bend(n, V3(-k, k, 0), V3(1, -1, 0), 1000, index[i], THROUGH, out);
                if (!n->list)
                    require(n, out[0] + out[1] <= 1 && out[0] + out[1] >= -1 && !out[2], "bent");
                bend(n, V3(0, -1, 0), V3(-1, 0, 0), 1000, index[i], ANY, out);
            }
}

/* Least and greatest components and indices: X in 4WD+25 bits, T in 3WD+13. */
void named_refract_ends(struct named *n) {
    static const uint32_t sides[][2] = {{1000, 250}, {1000, 4000}, {250, 1000}, {4000, 1000}};
    int64_t ends[3] = {-n->most - 1, 0, n->most}, out[3];
    for (int i = 0; i < 27; i++)
        for (int j = 0; j < 27; j++)
            for (int k = 0; k < 4; k++) {
                if (i == 13 || j == 13) continue;
                const int64_t d[3] = {ends[i % 3], ends[i / 3 % 3], ends[i / 9]};
                const int64_t normal[3] = {ends[j % 3], ends[j / 3 % 3], ends[j / 9]};
                bend(n, d, normal, sides[k][0], sides[k][1], ANY, out);
            }
}

/* Neither side is air: sine = to/from exactly, 4/5 of 1250/1000 scaled, 3/5, 5/13; one index. */
void named_glass_in_glass(struct named *n) {
    static const uint32_t pairs[][2] = {{1500, 1200}, {2000, 1200}, {2600, 1000}, {1001, 1001}};
    static const int64_t sines[][3] = {{4, 3, 5}, {3, 4, 5}, {5, 12, 13}, {1, 1, 2}};
    int64_t out[3];
    for (int i = 0; i < 4; i++)
        for (int64_t k = 1; sines[i][2] * k < n->most; k = 3 * k + 1)
            for (int64_t off = -1; off <= 1; off++) {
                const int64_t d[3] = {sines[i][0] * k + off, 0, -sines[i][1] * k};
                const int64_t normal[3] = {0, 0, n->half - 5};
                int expected = off > 0 && i < 3 ? REFLECTED : THROUGH;
                bend(n, d, normal, pairs[i][0], pairs[i][1], expected, out);
                bend(n, d, normal, pairs[i][1], pairs[i][0], THROUGH, out); /* back again */
                if (i == 3 && !n->list)
                    require(n,
                            out[0] * sines[i][1] * k + out[2] * d[0] <= n->most &&
                                out[0] * sines[i][1] * k + out[2] * d[0] >= -n->most,
                            "bent between equals");
            }
}

/* A ray that hits the sphere of *c, and the refracted ray after it. 0: no hit, or reflected. */
static int enter(struct named *n, struct hard_case *c, uint32_t index, struct sph_ray *next) {
    struct sph_surface s;
    uint64_t roots = 0;
    sph_ray_setup(n->p, &c->ray);
    struct sph_leaf_result r = sph_leaf_test(&c->ray, &c->sphere[0]);
    if (!r.hit) return 0;
    struct sph_hit hit = {sph_leaf_key(&r, &roots), c->sphere[0].id, r.far != 0, 0};
    sph_surface_at(n->p, &c->ray, &hit, &c->sphere[0], &s);
    *next = (struct sph_ray){.kind = SPH_REFRACTED, .skip = {hit.id, !hit.far}, .inside = 1};
    for (int i = 0; i < 3; i++)
        next->org[i] = s.point[i];
    if (!sph_refract(n->p, &c->ray, &s, hit.far ? index : 1000, hit.far ? 1000 : index, next->dir))
        return 0;
    sph_ray_setup(n->p, next);
    return 1;
}

/* Grazing entries: rounding may put the point outside and turn the ray outwards. */
void named_refract_graze(struct named *n) {
    struct sph_rng rng = {67};
    int entered = 0, exits = 0;
    for (int i = 0; i < 3000 && !n->list; i++) {
        int64_t rad = vec_pick(&rng, 1, i % 3 ? n->half / 2 : 40), off = vec_pick(&rng, 0, 2);
        struct hard_case c = vector(V3(-n->half, rad - off, vec_pick(&rng, -2, 2)),
                                    V3(n->most, vec_pick(&rng, -3, 3), vec_pick(&rng, -3, 3)),
                                    V3(vec_pick(&rng, -5, 5), 0, 0), rad);
        struct sph_ray next;
        uint32_t index = i & 1 ? 1001 : (uint32_t)vec_pick(&rng, 1000, 4000);
        n->vectors++;
        if (!enter(n, &c, index, &next)) continue;
        entered++;
        struct sph_leaf_result r = sph_leaf_test(&next, &c.sphere[0]);
        require(n, r.hit && r.far, "a ray in the sphere does not leave it");
        exits += r.exit;
        c.ray = next;
        if (!enter(n, &c, index, &next)) continue; /* reflected inside */
        r = sph_leaf_test(&next, &c.sphere[0]);
        require(n, !r.hit, "a ray that has left hits the sphere again");
    }
    require(n, entered > 100 && exits > 3, "%d entered, %d left at once", entered, exits);
}

/* From the centre: the normal is -dir, the ray goes straight on and leaves. */
void named_refract_centre(struct named *n) {
    for (int64_t k = 1; k < n->half / 4 && !n->list; k = 3 * k + 1) {
        struct hard_case c = vector(V3(0, 0, 0), V3(k, 2 * k, -k), V3(k, 2 * k, -k), 1);
        struct sph_surface s;
        int64_t out[3];
        sph_ray_setup(n->p, &c.ray);
        struct sph_hit hit = {(uint64_t)(6 * k * k), c.sphere[0].id, 0, 0};
        sph_surface_at(n->p, &c.ray, &hit, &c.sphere[0], &s);
        n->vectors++;
        require(n, sph_refract(n->p, &c.ray, &s, 1000, 1500, out), "reflected head on");
        require(n,
                out[0] > 0 && out[1] / 2 - out[0] <= 1 && out[0] - out[1] / 2 <= 1 &&
                    out[0] + out[2] <= 1 && out[0] + out[2] >= -1,
                "does not go straight on");
    }
}

/* Nearly the same index on both sides, nearly along the surface: X is a difference of numbers that
 * agree in most bits, and its sign is still exact. */
void named_refract_cancel(struct named *n) {
    struct sph_rng rng = {69};
    int64_t out[3];
    int through = 0, reflected = 0;
    for (int i = 0; i < 400; i++) {
        uint32_t from = (uint32_t)vec_pick(&rng, 1001, 1020);
        int64_t b = vec_pick(&rng, 1, n->half / 4) / (1 + i % 7) + 1;
        const int64_t d[3] = {n->half - vec_pick(&rng, 0, 9), vec_pick(&rng, -3, 3), -b};
        const int64_t normal[3] = {vec_pick(&rng, -3, 3), vec_pick(&rng, -3, 3), n->half - i};
        bend(n, d, normal, from, 1000, ANY, out);
        double sine = (double)d[0] / __builtin_sqrt((double)(d[0] * d[0] + b * b));
        through += sine * from<1000, reflected += sine * from> 1000;
    }
    require(n, through > 20 && reflected > 20, "%d through, %d reflected", through, reflected);
}
