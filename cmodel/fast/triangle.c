/* triangle.c - see triangle.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/triangle.h"

#include <string.h>

#include "prim/prim.h"

void sph_fast_triangle_read(const struct sph_profile *p, const uint32_t *record,
                            struct sph_fast_triangle *t) {
    int64_t e[2][3];
    memset(t, 0, sizeof *t);
    uint32_t kind = sph_record_kind(1, record);
    if (sph_prim_of(kind) != &sph_prim_triangle || sph_record_clear(kind, record)) return;
    struct sph_facet_leaf f = sph_triangle_read(p, record);
    t->known = 1, t->id = f.id, t->before = f.before, t->after = f.after;
    for (int i = 0; i < 3; i++) {
        e[0][i] = f.v[1][i] - f.v[0][i];
        e[1][i] = f.v[2][i] - f.v[0][i];
        t->v[i] = (int32_t)f.v[0][i];
        t->e1[i] = (int32_t)e[0][i];
        t->e2[i] = (int32_t)e[1][i];
    }
    sph_fast_cross(e[0], e[1], t->n);
}
