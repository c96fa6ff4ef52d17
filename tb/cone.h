/* cone.h - cone records for benches, and what they mean
 * SPDX-License-Identifier: Apache-2.0
 *
 * Ball is a sphere seen from the eye: f = k*a + b^2 and b = oc.dir at any pixel, in wide integers
 * and without differences. Cone is a record of machine.def: made of a Ball, or of any bits.
 */
#ifndef SPH_TB_CONE_H
#define SPH_TB_CONE_H

#include "bench.h"

extern "C" {
#include "machine/layout.h"
}

namespace bench {

struct Ball {
    i128 oc[3], k;      /* sW+1 each; rad^2 - oc.oc */
    i128 dir[3], pitch; /* sWD, of pixel 0, 0; a step */

    i128 at(int i, int x, int y) const {
        return dir[i] + (i == 0 ? x * pitch : i == 1 ? -y * pitch : 0);
    }
    i128 b(int x, int y) const {
        return oc[0] * at(0, x, y) + oc[1] * at(1, x, y) + oc[2] * at(2, x, y);
    }
    i128 f(int x, int y) const {
        i128 a = 0;
        for (int i = 0; i < 3; i++)
            a += at(i, x, y) * at(i, x, y);
        return k * a + b(x, y) * b(x, y);
    }
};

struct Cone {
    u128 f, fx, fy, fxx, fxy, fyy;
    uint64_t b, bx, by;
    bool inside;

    static Cone any(Random &random, int f_bits, int b_bits) {
        Cone c;
        for (u128 *p : {&c.f, &c.fx, &c.fy, &c.fxx, &c.fxy, &c.fyy})
            *p = (u128)sign(random.mixed(random.percent(50) ? f_bits : f_bits / 2), f_bits);
        for (uint64_t *p : {&c.b, &c.bx, &c.by})
            *p = (uint64_t)sign(random.mixed(random.percent(50) ? b_bits : b_bits / 2), b_bits);
        c.inside = random.percent(20);
        return c;
    }
    static Cone of(const Ball &s) {
        Cone c;
        i128 f = s.f(0, 0), right = s.f(1, 0), down = s.f(0, 1);
        c.f = (u128)f;
        c.fx = (u128)(right - f);
        c.fy = (u128)(down - f);
        c.fxx = (u128)(s.f(2, 0) - 2 * right + f);
        c.fyy = (u128)(s.f(0, 2) - 2 * down + f);
        c.fxy = (u128)(s.f(1, 1) - right - down + f);
        c.b = (uint64_t)s.b(0, 0);
        c.bx = (uint64_t)(s.b(1, 0) - s.b(0, 0));
        c.by = (uint64_t)(s.b(0, 1) - s.b(0, 0));
        c.inside = s.k > 0;
        return c;
    }
    /* The contract's formula, word for word. */
    i128 f_at(int x, int y, int f_bits) const {
        u128 ux = (u128)x, uy = (u128)y;
        return sign(f + ux * fx + ux * (ux - 1) / 2 * fxx + uy * fy + uy * (uy - 1) / 2 * fyy +
                        ux * uy * fxy,
                    f_bits);
    }
    i128 b_at(int x, int y, int b_bits) const {
        return sign((u128)(b + (uint64_t)x * bx + (uint64_t)y * by), b_bits);
    }
    bool hit(int x, int y, int f_bits, int b_bits) const {
        return f_at(x, y, f_bits) > 0 && (b_at(x, y, b_bits) > 0 || inside);
    }
    void store(uint32_t *words) const { /* 4 lines of 8 */
        auto put = [words](int lsb, u128 x, int bits) {
            for (int i = 0; i < bits; i += 32)
                words[(lsb + i) / 32] = (uint32_t)(x >> i);
        };
        put(SPH_CONE_F_LSB, f, 128), put(SPH_CONE_FX_LSB, fx, 128);
        put(SPH_CONE_FY_LSB, fy, 128), put(SPH_CONE_FXX_LSB, fxx, 128);
        put(SPH_CONE_FXY_LSB, fxy, 128), put(SPH_CONE_FYY_LSB, fyy, 128);
        put(SPH_CONE_B_LSB, b, 64), put(SPH_CONE_BX_LSB, bx, 64), put(SPH_CONE_BY_LSB, by, 64);
        put(SPH_CONE_INSIDE_LSB, inside, 32), put(SPH_CONE_INSIDE_LSB + 32, 0, 32);
    }
};

/* A sphere whose outline crosses a frame of `side` pixels more often than not: the frame takes up
 * much of the range of directions, so that balls beside and behind the eye show both branches. */
inline Ball ball(Random &random, int w, int wd, int side) {
    Ball s;
    i128 top = ((i128)1 << (wd - 1)) - 1, reach = (i128)1 << w, d2 = 0;
    s.pitch = random.percent(10) ? 1 : 2 * top / side;
    s.dir[0] = -s.pitch * (side / 2) - (i128)random.below(2);
    s.dir[1] = s.pitch * (side / 2) - (i128)random.below(2);
    s.dir[2] = -1 - (i128)random.log_bits(wd - 1) % top;
    for (i128 &c : s.oc) {
        c = random.percent(25) ? random.smixed(w + 1) : random.log_sbits(w + 1);
        if (random.percent(5)) c = random.percent(50) ? reach - 1 : -reach;
        d2 += c * c;
    }
    i128 rad = 1 + (i128)random.log_bits(w), d = 0;
    if (random.percent(70)) { /* some part of its distance, or just around it */
        for (int bit = w + 1; bit >= 0; bit--)
            if ((d + ((i128)1 << bit)) * (d + ((i128)1 << bit)) <= d2) d += (i128)1 << bit;
        rad = random.percent(20) ? d + (i128)random.below(3) : d * (i128)random.below(21) / 16;
    }
    rad = rad >= reach ? reach - 1 : rad;
    s.k = rad * rad - d2;
    return s;
}

} // namespace bench

#endif
