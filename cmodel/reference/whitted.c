/* whitted.c - see whitted.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/whitted.h"

#include <math.h>

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double share(double k) {
    return fmin(fmax(k, 0), 1);
}

static double left(const struct sph_material *m, double kr, double kt) {
    return m->sum.on ? 1 : 1 - kr - kt;
}

struct sph_ref_shares sph_ref_shares_of(const struct sph_material *m, int follow, int reflect,
                                        int refract) {
    double mirror = share(m->sum.on ? m->sum.kr : m->ks);
    struct sph_ref_shares s = {.kr = follow && reflect ? mirror : 0};
    if (m->sum.on) {
        s.ka = m->sum.ka, s.kd = m->kd, s.ks = m->ks;
        s.kt = follow && refract ? share(m->trans) : 0;
    } else { /* (1 - ks) * colour = kd * rgb */
        s.ka = s.kd = mirror < 1 ? fmin(1, m->kd / (1 - mirror)) : m->kd;
    }
    s.own = left(m, s.kr, s.kt);
    return s;
}

void sph_ref_reflect_all(struct sph_ref_shares *s, const struct sph_material *m, int whole) {
    s->kr = whole ? 1 : fmin(1, s->kr + s->kt);
    s->kt = 0;
    s->own = left(m, s->kr, s->kt);
}

int sph_ref_refract(const double dir[3], const double normal[3], double ratio, double out[3]) {
    double cosine = -dot(dir, normal), rest = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(rest >= 0)) return 0;
    for (int i = 0; i < 3; i++)
        out[i] = ratio * dir[i] + (ratio * cosine - sqrt(rest)) * normal[i];
    return 1;
}

double sph_ref_shine(const double normal[3], const double to_light[3], const double dir[3],
                     double shine) {
    double cosine = dot(normal, to_light), back[3];
    for (int i = 0; i < 3; i++)
        back[i] = to_light[i] - 2 * cosine * normal[i]; /* mirrored light, turned round */
    double c = dot(back, dir);
    return c > 0 ? pow(c, shine) : 0;
}
