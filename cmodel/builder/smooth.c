/* smooth.c - see builder/smooth.h, docs/design/shading.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/smooth.h"

#include <stdlib.h>
#include <string.h>

#include "builder/emit.h"
#include "scene/vector.h"
#include "shade/surface.h"
#include "scene/record.h"

enum {
    MANTISSA = SPH_SMOOTH_M_XX_BITS - 1,
    E_MAX = (1 << SPH_SMOOTH_E_BITS) - 1,
    LIMIT = 1 << (SPH_SMOOTH_N_X_BITS - 1),
    B_STEP = SPH_SMOOTH_B_Y_LSB - SPH_SMOOTH_B_X_LSB
};
static const double one = 1 << SPH_SMOOTH_FRACTION, own_cosine = 1 - 0x1p-20;

int sph_smooth_bends(const struct sph_facet *f) {
    if (!f->smooth) return 0;
    struct sph_vec own =
        sph_vec_cross(sph_vec_sub(f->v[1], f->v[0]), sph_vec_sub(f->v[2], f->v[0]));
    double least = 1, most = -1, length = sph_vec_length(own);
    for (int k = 0; k < 3; k++) {
        double cosine = sph_vec_dot(own, f->n[k]) / length / sph_vec_length(f->n[k]);
        least = fmin(least, cosine), most = fmax(most, cosine);
    }
    return !(least >= own_cosine || most <= -own_cosine);
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* The point that all is counted from: the middle of the corners, or of their box if a corner is
 * farther from it than the differences have bits. */
static void base_of(const struct sph_profile *p, const int32_t v[3][3], int32_t base[3]) {
    int32_t reach = (1 << (p->w - 1)) - 1;
    for (int i = 0; i < 3; i++) {
        int64_t sum = (int64_t)v[0][i] + v[1][i] + v[2][i], lo = v[0][i], hi = v[0][i];
        for (int k = 1; k < 3; k++)
            lo = v[k][i] < lo ? v[k][i] : lo, hi = v[k][i] > hi ? v[k][i] : hi;
        base[i] = (int32_t)floor((double)sum / 3 + 0.5);
        if (hi - base[i] >= reach || base[i] - lo >= reach) base[i] = (int32_t)((lo + hi) >> 1);
    }
}

/* Unit normals on the side of the triangle's own. */
static void on_side(const int32_t own[3], const double n[3][3], double out[3][3]) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double length = sqrt(dot(n[k], n[k]));
        for (int i = 0; i < 3; i++) {
            out[k][i] = n[k][i] / length;
            sum += out[k][i] * own[i];
        }
    }
    for (int k = 0; k < 3 && sum < 0; k++)
        for (int i = 0; i < 3; i++)
            out[k][i] = -out[k][i];
}

int sph_smooth_put(const struct sph_profile *p, const int32_t v[3][3], const int32_t own[3],
                   const double given[3][3], uint32_t *record) {
    double n[3][3], e1[3], e2[3], up[3], along[2][3], slope[3][3], most = 0;
    double unit = one / (1 << p->ng); /* of a coordinate with guard bits */
    int32_t base[3];
    on_side(own, given, n);
    base_of(p, v, base);
    for (int i = 0; i < 3; i++) {
        e1[i] = (double)v[1][i] - v[0][i];
        e2[i] = (double)v[2][i] - v[0][i];
    }
    cross(e1, e2, up);
    cross(e2, up, along[0]);
    cross(up, e1, along[1]);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            slope[i][k] = ((n[1][i] - n[0][i]) * along[0][k] + (n[2][i] - n[0][i]) * along[1][k]) /
                          dot(up, up);
            most = fmax(most, fabs(slope[i][k]) * unit);
        }
    int e = most > 0 ? MANTISSA - 1 - ilogb(most) : E_MAX;
    if (most > 0 && lround(ldexp(most, e)) >= 1 << MANTISSA) e--; /* rounds up to one bit more */
    if (e > E_MAX) e = E_MAX;
    if (e < 0) return 0;
    memset(record, 0, SPH_LINE_WORDS * sizeof *record);
    for (int i = 0; i < 3; i++) {
        double at = n[0][i];
        for (int k = 0; k < 3; k++) {
            at += slope[i][k] * (base[k] - v[0][k]);
            sph_field_set(record, SPH_SMOOTH_M_XX_LSB + SPH_SMOOTH_M_STEP * (3 * i + k),
                          SPH_SMOOTH_M_XX_BITS, (uint32_t)lround(ldexp(slope[i][k] * unit, e)));
        }
        if (!(fabs(at) * one < LIMIT - 1)) return 0;
        sph_field_set(record, SPH_SMOOTH_N_X_LSB + (SPH_SMOOTH_N_Y_LSB - SPH_SMOOTH_N_X_LSB) * i,
                      SPH_SMOOTH_N_X_BITS, (uint32_t)lround(at * one));
        sph_field_set(record, SPH_SMOOTH_B_X_LSB + B_STEP * i, SPH_SMOOTH_B_X_BITS,
                      (uint32_t)base[i]);
    }
    sph_field_set(record, SPH_SMOOTH_E_LSB, SPH_SMOOTH_E_BITS, (uint32_t)e);
    return 1;
}

/* Room for n lines more, of zeros: that of the first, or 0. */
static uint32_t append(struct sph_machine *m, uint64_t n) {
    uint64_t lines = m->lines + n;
    uint32_t first = m->lines, *mem = NULL;
    if (!(lines >> SPH_NODE_BASE_BITS)) mem = realloc(m->mem, lines * SPH_LINE_WORDS * sizeof *mem);
    if (!mem) return 0;
    memset(mem + (size_t)first * SPH_LINE_WORDS, 0, n * SPH_LINE_WORDS * sizeof *mem);
    m->mem = mem;
    m->lines = (uint32_t)lines;
    m->regs[SPH_REG_MEM_LINES] = (int32_t)lines;
    return first;
}

int sph_emit_smooth(const struct sph_scene *scene, const struct sph_grid *grid,
                    const struct sph_plants *plants, struct sph_machine *m,
                    struct sph_build_report *report, struct sph_error *err) {
    const struct sph_facets *facets = plants->facets;
    uint32_t n = 0, flat = 0, first_flat = 0;
    if (!sph_machine_effect(m, SPH_EFFECT_SMOOTH)) return 0;
    m->regs[SPH_REG_SMOOTH_BASE] = (int32_t)m->lines;
    for (uint32_t i = 0; i < facets->n; i++)
        n += (uint32_t)sph_smooth_bends(&scene->facets[facets->list[i].scene]);
    if (!n) return 0;
    uint32_t base = append(m, n), next = 0;
    if (!base) return sph_fail(err, "%s: out of memory or addresses for normals", scene->path);
    for (uint32_t i = 0; i < facets->n; i++) {
        const struct sph_grid_facet *f = &facets->list[i];
        const struct sph_facet *from = &scene->facets[f->scene];
        double normal[3][3];
        if (!sph_smooth_bends(from)) continue;
        for (int k = 0; k < 3; k++)
            sph_vec_turn(grid->rotation, from->n[k], normal[k]);
        if (!sph_smooth_put(plants->profile, (const int32_t(*)[3])f->v, f->normal,
                            (const double(*)[3])normal, sph_line(m, base + next))) {
            if (!flat++) first_flat = f->scene;
            continue;
        }
        sph_field_set(sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + plants->n_spheres + i),
                      SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS, ++next);
    }
    m->lines -= n - next; /* what was kept for those that stay flat */
    m->regs[SPH_REG_MEM_LINES] = (int32_t)m->lines;
    char first[SPH_PLACE];
    if (flat)
        sph_note(report->warning, sizeof report->warning,
                 "%s: %u of %u triangles with normals are too small for them and stay flat, this "
                 "one first\n",
                 sph_record_place(first, scene->path, scene->facets[first_flat].line, "triangle",
                                  first_flat),
                 flat, n);
    return 0;
}
