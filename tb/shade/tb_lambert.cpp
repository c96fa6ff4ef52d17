/* tb_lambert.cpp - rt_lambert against sph_lambert()
 * SPDX-License-Identifier: Apache-2.0
 */
#include "Vrt_lambert.h"
#include "bench.h"

extern "C" {
#include "shade/colour.h"
}

namespace {

constexpr uint64_t LATENCY = 5, INTERVAL = 2;

struct Vector {
    int32_t normal[3], light[3]; /* s1.16 */
    uint64_t tag, taken;
};

constexpr int32_t ONE = 65536, MAX = 131071, MIN = -131072;
const Vector corners[] = {
    {{0, 0, 0}, {0, 0, 0}, 0, 0},                         /* no normal, no light */
    {{ONE, 0, 0}, {ONE, 0, 0}, 0, 0},                     /* straight at the light: 32768 */
    {{0, -ONE, 0}, {0, -ONE, 0}, 0, 0},                   /* the same, negative */
    {{0, 0, ONE}, {0, 0, -ONE}, 0, 0},                    /* facing away: 0 */
    {{ONE, 0, 0}, {0, ONE, 0}, 0, 0},                     /* grazing: 0 */
    {{ONE, 0, 0}, {0, 0, 0}, 0, 0},                       /* light at the point */
    {{0, 0, 1}, {0, 0, ONE}, 0, 0},                       /* 2^16: rounds up to 1 */
    {{0, 1, 0}, {0, ONE - 1, 0}, 0, 0},                   /* 2^16-1: rounds down to 0 */
    {{-1, 0, 0}, {ONE, 0, 0}, 0, 0},                      /* -2^16: rounds up to 0 */
    {{-1, 0, 0}, {ONE + 1, 0, 0}, 0, 0},                  /* -2^16-1: rounds to -1, limited to 0 */
    {{ONE, 1, 0}, {ONE, ONE, 0}, 0, 0},                   /* rounds up past 1: limited */
    {{ONE, -1, 0}, {ONE, ONE, 0}, 0, 0},                  /* 2^32-2^16: rounds up to 1 */
    {{ONE, -1, 0}, {ONE, ONE + 1, 0}, 0, 0},              /* just below: 32767 */
    {{37838, 37837, 37837}, {37838, 37838, 37838}, 0, 0}, /* a diagonal, rounded unit vectors */
    {{MAX, MAX, MAX}, {MAX, MAX, MAX}, 0, 0},             /* largest dot product below 2^36 */
    {{MIN, MIN, MIN}, {MIN, MIN, MIN}, 0, 0},             /* largest of all */
    {{MIN, MIN, MIN}, {MAX, MAX, MAX}, 0, 0},             /* smallest of all */
};

/* A rounded unit vector as rt_unit makes it. */
void unit(bench::Random &random, int32_t out[3]) {
    int64_t v[3];
    for (int i = 0; i < 3; i++)
        v[i] = random.smixed(17);
    struct sph_unit u = sph_unit(v, (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), 17);
    for (int i = 0; i < 3; i++)
        out[i] = u.u[i];
}

Vector make(bench::Random &random) {
    Vector v{};
    if (random.percent(25)) { /* any words */
        for (int i = 0; i < 3; i++) {
            v.normal[i] = (int32_t)random.smixed(18);
            v.light[i] = (int32_t)random.smixed(18);
        }
        return v;
    }
    unit(random, v.normal);
    unit(random, v.light);
    if (random.percent(30)) /* nearly parallel: around the upper limit */
        for (int i = 0; i < 3; i++)
            v.light[i] = v.normal[i] + (int32_t)random.between(-2, 2);
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_lambert> b("tb_lambert", argc, argv);
    auto send = [&](const Vector &v) {
        b.set(b.dut.in_normal_x_i, 18, v.normal[0]);
        b.set(b.dut.in_normal_y_i, 18, v.normal[1]);
        b.set(b.dut.in_normal_z_i, 18, v.normal[2]);
        b.set(b.dut.in_light_x_i, 18, v.light[0]);
        b.set(b.dut.in_light_y_i, 18, v.light[1]);
        b.set(b.dut.in_light_z_i, 18, v.light[2]);
    };
    auto check = [&](const Vector &e) {
        struct sph_unit normal = {{e.normal[0], e.normal[1], e.normal[2]}, 0, 0};
        struct sph_unit light = {{e.light[0], e.light[1], e.light[2]}, 0, 0};
        b.expect("out_cosine_o", b.get(b.dut.out_cosine_o), sph_lambert(&normal, &light), 16);
        for (int i = 0; i < 3 && b.bad(); i++) {
            b.show("in_normal_i", e.normal[i], 18);
            b.show("in_light_i", e.light[i], 18);
        }
    };
    b.stream(corners, make, TAG, LATENCY, INTERVAL, send, check);
    return b.finish();
}
