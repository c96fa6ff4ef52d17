/* gen.c - see gen.h; the table of families
 * SPDX-License-Identifier: Apache-2.0
 */
#include "gen.h"

#include <math.h>

const struct hard_family hard_families[HARD_FAMILIES] = {
    {"random", "radii of every size, three of four rays aimed", gen_random, HARD_SPHERES},
    {"graze0", "exact tangents from integer frames: disc = 0", gen_graze0, HARD_SPHERES},
    {"graze1", "tangents with radius, centre or direction one off; Pell pairs", gen_graze1,
     HARD_SPHERES},
    {"tiny_far", "radius 1 to 3 at the far end of the grid", gen_tiny_far, HARD_SPHERES},
    {"huge_near", "radius of half the grid or more, 1 to 64 units away", gen_huge_near,
     HARD_SPHERES},
    {"surf_out", "origin on a rounded hit point, outward, with and without its own id",
     gen_surf_out, HARD_SPHERES},
    {"surf_in", "the same, inward", gen_surf_in, HARD_SPHERES},
    {"inside", "origin in the sphere", gen_inside, HARD_SPHERES},
    {"axis", "one or two components of the direction 0, or very short directions", gen_axis,
     HARD_SPHERES},
    {"corner", "bit patterns: ends of every range, powers of two, few ones", gen_corner,
     HARD_SPHERES},
    {"rad0", "radius 0, aimed at", gen_rad0, HARD_SPHERES},
    {"dir0", "direction 0", gen_dir0, HARD_SPHERES},
    {"pair", "two spheres whose surfaces pass one point of the ray, exactly or within a unit",
     gen_pair, HARD_SPHERES},
    {"concentric", "two spheres with one centre, radii equal or few units apart", gen_concentric,
     HARD_SPHERES},
    {"shadow", "lights on, just in and just out of a surface", gen_shadows, HARD_SPHERES},
    {"own", "rays that leave their own sphere, from either side", gen_own, HARD_SPHERES},
    {"root", "discriminants that are squares, one more, one less", gen_root, HARD_SPHERES},
    {"quotient", "a a power of two or greatest, t a whole number or nearly", gen_quotient,
     HARD_SPHERES},
    {"surface", "points at the grid's ends, normals of length 0 and 1, mirror rays at 90 degrees",
     gen_surface, HARD_SPHERES},
    {"filter", "spheres and origins where the narrow filter rounds worst", gen_filter,
     HARD_SPHERES},
    {"nested", "up to three refractions on, in a ball of glass with another in it", gen_nested,
     HARD_SPHERES},
    {"edge", "two triangles of one edge, a point of it aimed at exactly, or one off", gen_edge,
     HARD_FACETS},
    {"vertex", "two triangles of a fan, their corner aimed at; groups", gen_vertex, HARD_FACETS},
    {"sliver", "triangles a unit or two wide, or without area", gen_sliver, HARD_FACETS},
    {"flat", "two triangles of one plane, over one another; rays in it", gen_flat, HARD_FACETS},
    {"skim", "along a triangle, from a unit beside it; half of them to a light", gen_skim,
     HARD_FACETS},
    {"plane", "a plane nearly along the ray, met beyond the grid; faces of the grid", gen_plane,
     HARD_FACETS},
    {"planes", "two planes through a point of the ray, or a unit apart", gen_planes, HARD_FACETS},
    {"critical", "directions, normals and indices where X is 0, or one off", gen_critical,
     HARD_REFRACTION},
    {"seam", "normals at an image's seam, poles and quarter turns", gen_seam, HARD_AROUND},
    {"texel", "edges and middles of texels, images of every size, weights of filters", gen_texel,
     HARD_TEXELS},
    {"level", "path lengths where a logarithm rounds, at levels and between", gen_level,
     HARD_LEVELS},
    {"clip", "planes of a BIH ahead, behind and at the origin", gen_clip, HARD_CLIPS},
    {"walk", "two spheres in a BIH, touching, cut or in one another", gen_walk, HARD_WALKS},
    {"unit", "vectors where the table of inverse roots changes its line", gen_unit_vector,
     HARD_UNITS},
    {"coplane", "a triangle in a plane, or a unit beside it, a point of both aimed at", gen_coplane,
     HARD_FACETS},
    {"pixel", "a common edge of two triangles that runs through centres of pixels", gen_pixel,
     HARD_FACETS},
    {"ridge", "a common edge seen head-on, or along one of its two triangles", gen_ridge,
     HARD_FACETS},
    {"meet", "a sphere and a triangle or plane through one point of the ray, or a unit apart",
     gen_meet, HARD_TIES},
    {"eye", "origin on or in a sphere, on a triangle or plane, or on both", gen_eye, HARD_TIES},
    {"glass", "in a ball of glass, tangent to another one in it, or one off", gen_glass,
     HARD_SPHERES},
};

static uint64_t mixed(uint64_t seed, uint64_t value) {
    struct sph_rng rng = {seed ^ value * 0xd1342543de82ef95u};
    return sph_rng_next(&rng);
}

void hard_make(uint64_t seed, int family, int profile, uint64_t number, struct hard_case *c) {
    uint64_t place = (uint64_t)family << 8 | (uint64_t)profile;
    struct sph_rng rng = {mixed(mixed(seed, place), number)};
    gen_start(c);
    c->of = hard_families[family].of;
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
