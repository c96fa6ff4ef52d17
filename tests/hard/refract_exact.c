/* refract_exact.c - see surface.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "surface.h"

/* v times the power of two that brings its length into 2^(bits-1) .. 2^bits; its square. */
static sph_i128 stretch(const int64_t v[3], int bits, sph_i128 out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = v[i];
    for (;;) {
        sph_i128 square = out[0] * out[0] + out[1] * out[1] + out[2] * out[2];
        if (square >> (2 * bits - 2)) return square;
        for (int i = 0; i < 3; i++)
            out[i] *= 2;
    }
}

/* floor(sqrt(x)) of x < 2^124. */
static sph_i128 root_of(sph_i128 x) {
    sph_i128 root = (sph_i128)sqrtl((long double)x);
    while (root * root > x)
        root--;
    while ((root + 1) * (root + 1) <= x)
        root++;
    return root;
}

int exact_refract(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                  uint32_t from, uint32_t to, int64_t out[3]) {
    sph_i128 d[3], n[3], v[3], dn = 0, sine = 0;
    sph_i128 a = stretch(dir, p->wd, d), nn = stretch(normal, p->wd, n);
    for (int i = 0; i < 3; i++) {
        sph_i128 c = d[(i + 1) % 3] * n[(i + 2) % 3] - d[(i + 2) % 3] * n[(i + 1) % 3];
        sine += c * c;
        dn += d[i] * n[i];
    }
    sph_i128 x = a * nn * to * to - sine * from * from;
    if (x < 0) return 0;
    int cut = p->wd - p->w + 12;
    sph_i128 root = root_of(x / ((sph_i128)1 << 2 * cut)) * ((sph_i128)1 << cut);
    for (int i = 0; i < 3; i++)
        v[i] = from * nn * d[i] - (from * dn + root) * n[i];
    exact_normalise(v, p->wd, out);
    return 1;
}
