/* naive.c - a pixel from ray to colours, see naive.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. V (background), VI.B (blend), VI.C (light, shadow), VI.D; Aroxa 2014, Listing
 * 3.1: colour + kr * mirrored + kt * transmitted, followed as it is written, by recursion.
 */
#include "naive/naive.h"

#include <gmp.h>

#include "naive/hit.h"
#include "naive/math.h"
#include "naive/texture.h"

/* ---- background separation by definition; see naive.h ---- */

/* x as the two's complement number that `bits` bits hold of it. */
static void wrap(mpz_t x, unsigned bits) {
    mpz_fdiv_r_2exp(x, x, bits);
    if (mpz_tstbit(x, bits - 1)) {
        mpz_t all;
        mpz_init(all);
        mpz_setbit(all, bits);
        mpz_sub(x, x, all);
        mpz_clear(all);
    }
}

/* x += factor * (the number in `bits` bits of line `from`, lowest bit lsb). */
static void add(mpz_t x, int64_t factor, const uint32_t *from, int lsb, int bits) {
    mpz_t term;
    mpz_init(term);
    mpz_import(term, (size_t)bits / 32, -1, sizeof *from, 0, 0, from + lsb / 32);
    wrap(term, (unsigned)bits);
    mpz_mul_si(term, term, factor);
    mpz_add(x, x, term);
    mpz_clear(term);
}

static int in_cone(const struct sph_machine *m, const uint32_t *cone, int64_t x, int64_t y) {
    const struct sph_profile *p = sph_machine_profile(m);
    mpz_t f, b;
    mpz_inits(f, b, NULL);
    add(f, 1, cone, SPH_CONE_F_LSB, SPH_CONE_F_BITS);
    add(f, x, cone, SPH_CONE_FX_LSB, SPH_CONE_FX_BITS);
    add(f, y, cone, SPH_CONE_FY_LSB, SPH_CONE_FY_BITS);
    add(f, x * (x - 1) / 2, cone, SPH_CONE_FXX_LSB, SPH_CONE_FXX_BITS);
    add(f, y * (y - 1) / 2, cone, SPH_CONE_FYY_LSB, SPH_CONE_FYY_BITS);
    add(f, x * y, cone, SPH_CONE_FXY_LSB, SPH_CONE_FXY_BITS);
    add(b, 1, cone, SPH_CONE_B_LSB, SPH_CONE_B_BITS);
    add(b, x, cone, SPH_CONE_BX_LSB, SPH_CONE_BX_BITS);
    add(b, y, cone, SPH_CONE_BY_LSB, SPH_CONE_BY_BITS);
    wrap(f, (unsigned)(2 * p->w + 2 * p->wd + 4));
    wrap(b, (unsigned)(p->w + p->wd + 4));
    int inside = cone[SPH_CONE_INSIDE_LSB / 32] & 1;
    int in = mpz_sgn(f) > 0 && (inside || mpz_sgn(b) > 0);
    mpz_clears(f, b, NULL);
    return in;
}

int sph_naive_background(const struct sph_machine *m, int x, int y) {
    const int32_t *r = m->regs;
    size_t base = (uint32_t)r[SPH_REG_BG_BASE], lines = (uint32_t)r[SPH_REG_MEM_LINES];
    size_t rows = (size_t)r[SPH_REG_WIN_Y1], cones = (size_t)r[SPH_REG_BG_COUNT];
    if (r[SPH_REG_BG_MODE] == 1) {
        int across = r[SPH_REG_RECT_X0] <= x && x < r[SPH_REG_RECT_X1];
        return !(across && r[SPH_REG_RECT_Y0] <= y && y < r[SPH_REG_RECT_Y1]);
    }
    if (r[SPH_REG_BG_MODE] == 2 && base + rows / 8 + (rows % 8 > 0) <= lines) {
        uint32_t span = m->mem[base * SPH_LINE_WORDS + (size_t)y];
        return x < (int)(span & 0xffff) || x >= (int)(span >> 16);
    }
    if (r[SPH_REG_BG_MODE] == 3 && base + 4 * cones <= lines) {
        for (size_t i = 0; i < cones; i++)
            if (in_cone(m, m->mem + (base + 4 * i) * SPH_LINE_WORDS, x, y)) return 0;
        return 1;
    }
    return 0;
}

static int64_t min(int64_t a, int64_t b) {
    return a < b ? a : b;
}

static int on(const struct sph_machine *m, int effect) {
    return m->regs[SPH_REG_EFFECTS] & 1 << effect ? 1 : 0;
}

/* Whitted's sum; else the material blends. */
static int sums(const struct sph_machine *m, const struct sph_naive_prim *prim) {
    return on(m, SPH_EFFECT_SUM) && prim->sum;
}

/* All lights that the point faces and sees, and their highlights, each u2.15. */
static void light(const struct sph_machine *m, const struct sph_ray *from,
                  const struct sph_naive_found *f, const struct sph_naive_point *s, int64_t matt[3],
                  int64_t gloss[3]) {
    const struct sph_profile *p = sph_machine_profile(m);
    int64_t along[3];
    sph_naive_unit(from->dir, p->wd, along);
    for (int l = 0; l < m->regs[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = &m->regs[SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l];
        struct sph_ray ray = {.kind = SPH_SHADOW,
                              .skip = {f->prim.sphere.id, f->how.far},
                              .inside = on(m, SPH_EFFECT_INSIDE)};
        int64_t to[3], cosine = 0;
        for (int i = 0; i < 3; i++) {
            ray.org[i] = s->at[i];
            ray.lift[i] = s->at[i] * (1 << p->ng) - s->guarded[i];
            ray.dir[i] = lamp[i] - sph_naive_round64(s->at[i], lamp[3] / 65536);
        }
        sph_naive_unit(ray.dir, p->wd, to);
        for (int i = 0; i < 3; i++)
            cosine += to[i] * s->unit[i];
        cosine = min(sph_naive_round64(cosine, 17), 32768);
        if (cosine <= 0) continue;
        if (on(m, SPH_EFFECT_SHADOW) && sph_naive_trace(m, &ray).how.hit) continue;
        int64_t shine = f->prim.ks ? sph_naive_specular(s->unit, to, along, f->prim.power) : 0;
        for (int i = 0; i < 3; i++) {
            matt[i] += sph_naive_round64(cosine * (lamp[3 + i] % 65536), 15);
            gloss[i] += sph_naive_round64(shine * (lamp[3 + i] % 65536), 15);
        }
    }
}

/* byte * light as u8.8, limited to 255. */
static int64_t lit(int64_t byte, int64_t light) {
    return min(sph_naive_round64(byte * min(light, 131071), 7), 255 * 256);
}

/* texel: what the surface's own colour is multiplied by. */
static void shade(const struct sph_machine *m, const struct sph_ray *ray,
                  const struct sph_naive_found *f, const struct sph_naive_point *s, uint32_t texel,
                  int64_t colour[3]) {
    const struct sph_naive_prim *prim = &f->prim;
    int64_t matt[3] = {0}, gloss[3] = {0};
    light(m, ray, f, s, matt, gloss);
    for (int i = 0; i < 3; i++) {
        int64_t ambient = m->regs[SPH_REG_AMBIENT_R + i];
        int64_t rgb = (2 * prim->rgb[i] * (texel >> 8 * i & 255) + 255) / 510; /* to nearest */
        if (!sums(m, prim)) {
            colour[i] = lit(rgb, ambient + matt[i]);
            continue;
        }
        int64_t both = sph_naive_round64(prim->ka * ambient, 8) +
                       sph_naive_round64(prim->kd * min(matt[i], 131071), 8);
        int64_t shine = on(m, SPH_EFFECT_SPECULAR) ? lit(prim->ks, gloss[i]) : 0;
        colour[i] = min(lit(rgb, both) + shine, 255 * 256);
    }
}

/* A ray that leaves a point in the mirror direction of the ray that came. */
static struct sph_ray mirror_ray(const struct sph_machine *m, const struct sph_ray *ray,
                                 const struct sph_naive_found *f, const struct sph_naive_point *s) {
    struct sph_ray next = {.kind = SPH_REFLECTED,
                           .skip = {f->prim.sphere.id, f->how.far},
                           .inside = on(m, SPH_EFFECT_INSIDE)};
    for (int i = 0; i < 3; i++)
        next.org[i] = s->at[i];
    int64_t once[3], behind = 0;
    sph_naive_mirror(ray->dir, s->normal, sph_machine_profile(m)->wd, next.dir);
    for (int i = 0; i < 3; i++)
        once[i] = next.dir[i], behind += once[i] * s->side[i];
    if (s->bent && behind < 0)
        sph_naive_mirror(once, s->side, sph_machine_profile(m)->wd, next.dir);
    return next;
}

/* 1 if the point that the tree's first hit shows is known to lie in another sphere. */
static int buried(const struct sph_machine *m, const struct sph_ray *ray) {
    struct sph_naive_found f = sph_naive_first(m, ray, (uint32_t)m->regs[SPH_REG_ROOT]);
    if (!f.how.hit) return 0;
    struct sph_naive_point s = sph_naive_point_of(m, ray, &f);
    struct sph_ray next = mirror_ray(m, ray, &f, &s);
    return sph_naive_within(m, &next, f.prim.sphere.id);
}

/* What is gathered for a pixel: the three frames, u8.8 a channel, limited when they are read, and
 * the frame's word of textures. */
struct frames {
    int64_t sum[SPH_FRAMES][3];
    uint32_t texture;
};

/* Adds all that a ray with this weight sees, f being what it hits, path what lies behind it. */
static void follow(const struct sph_machine *m, const struct sph_ray *ray,
                   const struct sph_naive_found *f, int64_t weight, int depth,
                   struct sph_naive_path path, struct frames *frames) {
    const struct sph_profile *p = sph_machine_profile(m);
    const struct sph_naive_prim *prim = &f->prim;
    struct sph_naive_point s = {{0}, {0}, {0}, {0}, {0}, 0, {0}};
    struct sph_ray bent = {.kind = SPH_REFRACTED, .inside = 1};
    int64_t colour[3], kr = 0, kt = 0;
    if (f->how.hit) {
        s = sph_naive_point_of(m, ray, f);
        sph_naive_path_add(m, ray, f->how.key, &path);
        shade(m, ray, f, &s, sph_naive_texel(m, f, &s, path.length, &frames->texture), colour);
        if (depth < m->regs[SPH_REG_MAX_DEPTH]) {
            kr = on(m, SPH_EFFECT_REFLECT) ? prim->kr : 0;
            kt = on(m, SPH_EFFECT_REFRACT) ? prim->kt : 0;
            int64_t least = 256 * (int64_t)m->regs[SPH_REG_LEAST_WEIGHT]; /* u1.16 */
            if (sph_naive_round64(weight * kr, 8) < least) kr = 0;
            if (sph_naive_round64(weight * kt, 8) < least) kt = 0;
        }
    } else {
        for (int i = 0; i < 3; i++)
            colour[i] = 256 * (int64_t)(m->regs[SPH_REG_BG_COLOUR] >> (8 * i) & 255);
    }
    if (kt) {
        uint32_t sides[2] = {1000, prim->index}; /* outside, inside */
        bent.skip = (struct sph_skip){prim->sphere.id, !f->how.far};
        for (int i = 0; i < 3; i++)
            bent.org[i] = s.behind[i];
        if (!sph_naive_refract(p, ray->dir, s.normal, sides[f->how.far], sides[!f->how.far],
                               bent.dir)) {
            kr = min(kr + kt, 256);
            kt = 0;
        }
    }
    int64_t left = f->how.hit && sums(m, prim) ? 256 : 256 - min(256, kr + kt);
    int64_t own = sph_naive_round64(weight * left, 8);
    for (int i = 0; i < 3; i++) {
        int64_t whole = sph_naive_round64(weight * colour[i], 16);
        if (depth == 0) frames->sum[0][i] += whole;
        if (depth == 0) frames->sum[1][i] += sph_naive_round64(own * colour[i], 16);
        if (depth == 1) frames->sum[1][i] += whole;
        frames->sum[2][i] += sph_naive_round64(own * colour[i], 16);
    }
    struct sph_ray mirror = {0};
    if (kr) mirror = mirror_ray(m, ray, f, &s);
    for (int i = 0; i < 2; i++) {
        int64_t k = i ? kt : kr;
        if (!k) continue;
        struct sph_naive_found next = sph_naive_trace(m, i ? &bent : &mirror);
        path.bend = prim->bend;
        if (i && prim->bend) path.bend = f->how.far ? (prim->bend + 4) % 64 : 0;
        follow(m, i ? &bent : &mirror, &next, sph_naive_round64(weight * k, 8), depth + 1, path,
               frames);
    }
}

/* Of the primary ray. Turned: in units of 2^-(32-WD), halves are in the first one; rounded down. */
static void direction(const struct sph_machine *m, int x, int y, int64_t dir[3]) {
    static const int right[3] = {1, 0, 0}, down[3] = {0, -1, 0};
    const int32_t *r = m->regs;
    int turned = on(m, SPH_EFFECT_TURNED);
    int64_t unit = turned ? (int64_t)1 << (32 - m->profile.wd) : 1;
    for (int i = 0; i < 3; i++) {
        int64_t across = turned ? r[SPH_REG_ACROSS_X + i] : right[i] * (int64_t)r[SPH_REG_PITCH];
        int64_t below = turned ? r[SPH_REG_DOWN_X + i] : down[i] * (int64_t)r[SPH_REG_PITCH];
        int64_t at = r[SPH_REG_DIR_X0 + i] + x * across + y * below;
        dir[i] = at / unit - (at % unit < 0);
    }
}

struct sph_pixel sph_naive_pixel(const struct sph_machine *m, int x, int y) {
    const int32_t *r = m->regs;
    struct sph_pixel pixel = {.id = SPH_ID_NONE, .texture = SPH_NO_TEXTURE};
    struct frames frames = {.texture = SPH_NO_TEXTURE};
    struct sph_naive_found f = {0};
    struct sph_ray ray = {.org = {r[SPH_REG_EYE_X], r[SPH_REG_EYE_Y], r[SPH_REG_EYE_Z]},
                          .kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = on(m, SPH_EFFECT_INSIDE)};
    direction(m, x, y, ray.dir);
    int first = on(m, SPH_EFFECT_FIRST) && !(on(m, SPH_EFFECT_INTERPENETRATE) && buried(m, &ray));
    if (!sph_naive_background(m, x, y))
        f = first ? sph_naive_first(m, &ray, (uint32_t)r[SPH_REG_ROOT]) : sph_naive_trace(m, &ray);
    if (f.how.hit) pixel.id = f.prim.sphere.id, pixel.key = f.how.key;
    follow(m, &ray, &f, 65536, 0, (struct sph_naive_path){0, 0, 0}, &frames);
    pixel.texture = frames.texture;
    for (int frame = 0; frame < SPH_FRAMES; frame++)
        for (int i = 0; i < 3; i++) {
            int64_t byte = sph_naive_round64(min(frames.sum[frame][i], 65535), 8);
            pixel.colour[frame] |= (uint32_t)min(byte, 255) << (8 * i);
        }
    return pixel;
}

int sph_naive_strayed(const struct sph_machine *m) {
    static const int regs[] = {SPH_REG_EYE_X,    SPH_REG_EYE_Y,    SPH_REG_EYE_Z,  SPH_REG_DIR_X0,
                               SPH_REG_DIR_Y0,   SPH_REG_DIR_Z,    SPH_REG_PITCH,  SPH_REG_ACROSS_X,
                               SPH_REG_ACROSS_Y, SPH_REG_ACROSS_Z, SPH_REG_DOWN_X, SPH_REG_DOWN_Y,
                               SPH_REG_DOWN_Z};
    const int n = sizeof regs / sizeof *regs;
    uint32_t ones[32] = {0};
    int strayed = 0;
    for (int i = 0; i < n; i++) {
        int turned = on(m, SPH_EFFECT_TURNED) && regs[i] != SPH_REG_PITCH;
        int bits = i < 3 ? m->profile.w : turned || i > 6 ? 32 : m->profile.wd;
        for (int b = 0; b < bits; b++)
            ones[(b + 11 * (n - 1 - i)) % 32] += (uint32_t)m->regs[regs[i]] / (1u << b) % 2;
    }
    for (int b = 0; b < 32; b++)
        strayed |= ones[b] % 2 != (uint32_t)m->regs[SPH_REG_ONE_CAMERA] / (1u << b) % 2;
    return on(m, SPH_EFFECT_CAMERA) && strayed;
}
