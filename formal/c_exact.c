/* c_exact.c - the model's exact tests compute in integers, for all inputs of a profile
 * SPDX-License-Identifier: Apache-2.0
 *
 * clang puts a trap before each operation that might leave its type: a signed sum or product, a
 * shift, a division, an implicit conversion, an index. Inputs have as many bits as in a profile of
 * W. The proof is clang's own, which takes out a trap that it knows is never reached: of FUNCTION
 * none may be left. So each of these operations is that of the integers.
 */
#include "prim/facet.c"  // NOLINT(bugprone-suspicious-include): to be inlined
#include "prim/sphere.c" // NOLINT(bugprone-suspicious-include)

#ifndef W
#define W 24
#endif
#define WD (W + 1)

typedef _BitInt(W) coord; /* sW */
typedef _BitInt(WD) dir;  /* sWD */
typedef _BitInt(6) lift;  /* s(NG+2) */

#define PUT(to, from) (to)[0] = (from)[0], (to)[1] = (from)[1], (to)[2] = (from)[2]

static struct sph_ray ray_of(const coord org[3], const dir d[3], unsigned _BitInt(2 * WD) a,
                             int kind, struct sph_skip skip) {
    struct sph_ray ray = {.a = a, .kind = kind, .skip = skip};
    PUT(ray.org, org);
    PUT(ray.dir, d);
    return ray;
}

struct sph_leaf_result leaf(const coord org[3], const dir d[3], unsigned _BitInt(2 * WD) a,
                            int kind, struct sph_skip skip, int inside, const coord ctr[3],
                            unsigned _BitInt(W) rad, uint32_t id) {
    struct sph_ray ray = ray_of(org, d, a, kind, skip);
    struct sph_leaf of = {.rad = rad, .id = id};
    ray.inside = inside;
    PUT(of.ctr, ctr);
    return sph_leaf_test(&ray, &of);
}

static struct sph_facet_result facet(const coord org[3], const dir d[3], int kind,
                                     struct sph_skip skip, const lift l[3],
                                     struct sph_facet_leaf *of) {
    static const struct sph_profile p = {.w = W, .wd = WD, .ng = 4};
    struct sph_ray ray = ray_of(org, d, 0, kind, skip);
    PUT(ray.lift, l);
    return sph_facet_test(&p, &ray, of);
}

struct sph_facet_result triangle(const coord org[3], const dir d[3], int kind, struct sph_skip skip,
                                 const lift l[3], const coord v[3][3], struct sph_facet_leaf of) {
    of.kind = SPH_TRIANGLE;
    for (int i = 0; i < 3; i++)
        PUT(of.v[i], v[i]);
    return facet(org, d, kind, skip, l, &of);
}
