/* gen.c - see gen.h; the table of families
 * SPDX-License-Identifier: Apache-2.0
 */
#include "gen.h"

#include <math.h>

const struct hard_family hard_families[HARD_FAMILIES] = {
    {"random", "radii of every size, three of four rays aimed", gen_random},
    {"graze0", "exact tangents from integer frames: disc = 0", gen_graze0},
    {"graze1", "tangents with radius, centre or direction one off; Pell pairs", gen_graze1},
    {"tiny_far", "radius 1 to 3 at the far end of the grid", gen_tiny_far},
    {"huge_near", "radius of half the grid or more, 1 to 64 units away", gen_huge_near},
    {"surf_out", "origin on a rounded hit point, outward, with and without its own id",
     gen_surf_out},
    {"surf_in", "the same, inward", gen_surf_in},
    {"inside", "origin in the sphere", gen_inside},
    {"axis", "one or two components of the direction 0, or very short directions", gen_axis},
    {"corner", "bit patterns: ends of every range, powers of two, few ones", gen_corner},
    {"rad0", "radius 0, aimed at", gen_rad0},
    {"dir0", "direction 0", gen_dir0},
    {"pair", "two spheres whose surfaces pass one point of the ray, exactly or within a unit",
     gen_pair},
    {"concentric", "two spheres with one centre, radii equal or few units apart", gen_concentric},
    {"shadow", "lights on, just in and just out of a surface", gen_shadows},
    {"own", "rays that leave their own sphere, from either side", gen_own},
    {"root", "discriminants that are squares, one more, one less", gen_root},
    {"quotient", "a a power of two or greatest, t a whole number or nearly", gen_quotient},
    {"surface", "points at the grid's ends, normals of length 0 and 1, mirror rays at 90 degrees",
     gen_surface},
    {"filter", "spheres and origins where the narrow filter rounds worst", gen_filter},
};

static uint64_t mixed(uint64_t seed, uint64_t value) {
    struct sph_rng rng = {seed ^ value * 0xd1342543de82ef95u};
    return sph_rng_next(&rng);
}

void hard_make(uint64_t seed, int family, int profile, uint64_t number, struct hard_case *c) {
    uint64_t place = (uint64_t)family << 8 | (uint64_t)profile;
    struct sph_rng rng = {mixed(mixed(seed, place), number)};
    gen_start(c);
    hard_families[family].make(&rng, &sph_profiles[profile], c);
    c->ray.inside = number % 8 != 7;
}

void gen_start(struct hard_case *c) {
    *c = (struct hard_case){.n = 1};
    c->ray.kind = SPH_PRIMARY;
    c->ray.inside = 1;
    c->ray.skip.id = SPH_ID_NONE;
    c->sphere[0].id = HARD_ID;
    c->sphere[1].id = HARD_OTHER;
}

void gen_point(struct sph_rng *rng, const struct sph_profile *p, int64_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = vec_pick(rng, -gen_half(p), gen_half(p) - 1);
}

void gen_aim(struct sph_rng *rng, const struct sph_profile *p, const double to[3], int least,
             struct hard_case *c) {
    int bits = gen_one_in(rng, 4) ? (int)vec_pick(rng, least, p->wd - 1) : p->wd - 1;
    double longest = 0, most = (double)((1ll << bits) - 1), v[3];
    for (int i = 0; i < 3; i++) {
        v[i] = to[i] - (double)c->ray.org[i];
        longest = fmax(longest, fabs(v[i]));
    }
    if (longest == 0) v[0] = longest = 1;
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] = (int64_t)rint(v[i] / longest * most);
}

int gen_shadow(const struct sph_profile *p, const int64_t light[3], struct hard_case *c) {
    c->ray.kind = SPH_SHADOW;
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] = light[i] - c->ray.org[i];
    return gen_on_grid(p, light);
}

int64_t gen_frame(struct sph_rng *rng, int64_t most, int64_t u[3], int64_t v[3], int64_t w[3]) {
    int64_t q[4], norm = 0;
    while (!norm)
        for (int i = 0; i < 4; i++) {
            q[i] = vec_pick(rng, -most, most);
            norm += q[i] * q[i];
        }
    int64_t aa = q[0] * q[0], bb = q[1] * q[1], cc = q[2] * q[2], dd = q[3] * q[3];
    int64_t m[3][3] = {
        {aa + bb - cc - dd, 2 * (q[1] * q[2] + q[0] * q[3]), 2 * (q[1] * q[3] - q[0] * q[2])},
        {2 * (q[1] * q[2] - q[0] * q[3]), aa - bb + cc - dd, 2 * (q[2] * q[3] + q[0] * q[1])},
        {2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]), aa - bb - cc + dd}};
    int turn = (int)vec_pick(rng, 0, 2); /* so that short axes come in every direction */
    for (int i = 0; i < 3; i++) {
        u[i] = m[0][(i + turn) % 3];
        v[i] = m[1][(i + turn) % 3];
        w[i] = m[2][(i + turn) % 3];
    }
    return norm;
}

void gen_unit(struct sph_rng *rng, double v[3]) {
    double length2 = 0;
    while (length2 < 0.01 || length2 > 1) {
        length2 = 0;
        for (int i = 0; i < 3; i++) {
            v[i] = sph_rng_range(rng, -1, 1);
            length2 += v[i] * v[i];
        }
    }
    for (int i = 0; i < 3; i++)
        v[i] /= sqrt(length2);
}
