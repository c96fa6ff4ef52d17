/* test_smooth.c - interpolated normals: against barycentric ones in double precision and the naive
 * model, the rule of mirrors, and records that are refused
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_smooth [seed]
 */
#include "build_scene.h"

#include "builder/smooth.h"
#include "render/render.h"
#include "naive/naive.h"
#include "shade/surface.h"
#include "validate/validate.h"

enum { WIDTH = 32, HEIGHT = 18 };
static const struct sph_render_options plain = {0};

static int64_t whole(int64_t lo, int64_t hi) {
    return lo + (int64_t)(uniform() * (double)(hi - lo + 1));
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* A triangle of any size within the grid, its normal, and normals up to `wild` away from it. */
static int triangle(const struct sph_profile *p, double wild, int32_t v[3][3], int32_t own[3],
                    double n[3][3]) {
    int64_t half = (1ll << (p->w - 1)) - 1;
    double size = exp2(uniform() * p->w) / 2;
    double e1[3], e2[3];
    for (int i = 0; i < 3; i++) {
        int64_t base = whole(-half, half);
        for (int k = 0; k < 3; k++) {
            int64_t to = base + (int64_t)between(-size, size);
            v[k][i] = (int32_t)(to > half ? half : to < -half - 1 ? -half - 1 : to);
        }
        e1[i] = v[1][i] - (double)v[0][i], e2[i] = v[2][i] - (double)v[0][i];
    }
    double up[3];
    for (int i = 0; i < 3; i++)
        up[i] = e1[(i + 1) % 3] * e2[(i + 2) % 3] - e1[(i + 2) % 3] * e2[(i + 1) % 3];
    if (!(dot(up, up) > 0)) return 0;
    unit(up);
    for (int i = 0; i < 3; i++)
        own[i] = (int32_t)lround(up[i] * ((1 << 23) - 1));
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            n[k][i] = up[i] + between(-wild, wild);
        unit(n[k]);
    }
    return 1;
}

/* At points of the triangle with guard bits each component is that of the normal between the
 * corners' up to half a unit for n, one for the sum, and half a unit of 2^-e for each distance. */
static void test_between(void **unused) {
    double worst = 0;
    int kept = 0, flat = 0;
    (void)unused;
    for (int run = 0; run < 20000; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        int32_t v[3][3], own[3];
        double n[3][3];
        uint32_t record[SPH_LINE_WORDS];
        if (!triangle(p, run % 7 ? 0.3 : 1, v, own, n)) continue;
        if (!sph_smooth_put(p, (const int32_t(*)[3])v, own, (const double(*)[3])n, record)) {
            flat++;
            continue;
        }
        kept++;
        double part[3] = {uniform(), uniform(), 0}, e1[3], e2[3], from[3], up[3];
        if (part[0] + part[1] > 1) part[0] = 1 - part[0], part[1] = 1 - part[1];
        if (run % 5 == 0) part[0] = run % 2, part[1] = 0;
        part[2] = 1 - part[0] - part[1];
        int64_t guarded[3], got[3];
        int e = (int)sph_field(record, SPH_SMOOTH_E_LSB, SPH_SMOOTH_E_BITS);
        double far = 0, sum = 0;
        for (int i = 0; i < 3; i++) {
            double at = part[0] * v[0][i] + part[1] * v[1][i] + part[2] * v[2][i];
            guarded[i] = lround(ldexp(at, p->ng));
            e1[i] = v[1][i] - (double)v[0][i], e2[i] = v[2][i] - (double)v[0][i];
            from[i] = ldexp((double)guarded[i], -p->ng) - v[0][i];
            far += fabs((double)guarded[i] -
                        ldexp(sph_field_signed(record, SPH_SMOOTH_B_X_LSB + 24 * i, 24), p->ng));
        }
        for (int i = 0; i < 3; i++)
            up[i] = e1[(i + 1) % 3] * e2[(i + 2) % 3] - e1[(i + 2) % 3] * e2[(i + 1) % 3];
        double nn = dot(up, up), c1[3], c2[3];
        for (int i = 0; i < 3; i++) { /* parts of the point that the machine has */
            int j = (i + 1) % 3, k = (i + 2) % 3;
            c1[i] = (from[j] * e2[k] - from[k] * e2[j]);
            c2[i] = (e1[j] * from[k] - e1[k] * from[j]);
        }
        double x = dot(c1, up) / nn, y = dot(c2, up) / nn;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                sum += n[k][i] * own[i];
        sph_smooth_normal(p, record, guarded, got);
        for (int i = 0; i < 3; i++) {
            double want = (1 - x - y) * n[0][i] + x * n[1][i] + y * n[2][i];
            if (sum < 0) want = -want;
            double off = fabs((double)got[i] - ldexp(want, 15));
            double most = 0.5 + 0.5 + 0.5 * far * exp2(-e) + 1e-3;
            if (off > most)
                fail_msg("run %d: off by %g units of 2^-15, at most %g", run, off, most);
            worst = fmax(worst, off);
        }
    }
    printf("# %d triangles, %d too small; a component is off by %.2f units of 2^-15 at most\n",
           kept, flat, worst);
    assert_true(kept > 5000 && flat > 10);
}

/* What is mirrored at the interpolated normal stays if it is in front of the facet; what is not is
 * mirrored once more, and is in front but for its rounding. */
static void test_mirror(void **unused) {
    int turned = 0;
    (void)unused;
    for (int run = 0; run < 20000; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        struct sph_ray ray = {.kind = SPH_PRIMARY};
        struct sph_surface s = {.flat = 1};
        int64_t facet[3], normal[3], out[3], once[3], in = 0, front = 0, room = 0;
        for (int i = 0; i < 3; i++) {
            ray.dir[i] = whole(-(1ll << (p->wd - 2)), 1ll << (p->wd - 2));
            facet[i] = whole(-(1 << 22), 1 << 22);
            normal[i] = facet[i] / 256 + whole(-20000, 20000);
        }
        sph_surface_turn(p, &ray, 0, facet, &s);
        for (int i = 0; i < 3; i++)
            in += s.side[i] * ray.dir[i];
        if (in >= 0) continue;
        sph_surface_bend(p, 0, normal, &s);
        sph_reflect(p, ray.dir, &s, once);
        sph_mirror(p, ray.dir, &s, out);
        int64_t before = 0;
        for (int i = 0; i < 3; i++) {
            before += once[i] * s.side[i];
            front += out[i] * s.side[i];
            room += llabs(s.side[i]);
        }
        assert_true(s.bent);
        if (before >= 0) {
            assert_memory_equal(out, once, sizeof out);
            continue;
        }
        turned++;
        assert_true(front >= -room);
    }
    for (int i = 0; i < SPH_PROFILES; i++) { /* along the facet: in front of it */
        const struct sph_profile *p = &sph_profiles[i];
        const int64_t down[3] = {0, 0, -1000}, along[3] = {3000, 0, 3000};
        struct sph_surface s = {.bent = 1, .nn = 18000000, .side = {0, 0, 7000}};
        int64_t out[3], once[3];
        memcpy(s.normal, along, sizeof along);
        sph_reflect(p, down, &s, once);
        sph_mirror(p, down, &s, out);
        assert_int_equal(once[2], 0);
        assert_memory_equal(out, once, sizeof out);
    }
    printf("# %d were mirrored once more\n", turned);
    assert_true(turned > 1000);
}

/* Triangles in the unit cube, with normals as wild as they may be, that mirror and refract. */
static struct sph_scene wild(void) {
    struct sph_scene s = bare();
    soup(&s, 12, 0.7);
    for (uint32_t i = 0; i < s.n_facets; i++) {
        struct sph_facet *f = &facet_list[i];
        struct sph_vec a = f->v[0], b = f->v[1], c = f->v[2];
        struct sph_vec e = at(b.x - a.x, b.y - a.y, b.z - a.z);
        struct sph_vec g = at(c.x - a.x, c.y - a.y, c.z - a.z);
        double size = 0.3 * sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
        f->smooth = i % 4 != 0;
        for (int k = 0; k < 3; k++)
            f->n[k] = near_to(
                at(e.y * g.z - e.z * g.y, e.z * g.x - e.x * g.z, e.x * g.y - e.y * g.x), size);
    }
    return s;
}

/* Frames of the model and of the naive one are equal, and differ from those of flat triangles. */
static void test_naive(void **unused) {
    int bends = 0;
    (void)unused;
    for (int run = 0; run < 8; run++) {
        struct sph_scene s = wild();
        struct sph_build_options o = standard, off;
        struct sph_build_report report;
        struct sph_frame frame, flat;
        struct sph_counters c = {{0}};
        struct sph_material *look = s.materials;
        o.profile = run % SPH_PROFILES;
        o.width = WIDTH, o.height = HEIGHT;
        o.max_depth = 3;
        o.smooth = o.refract = SPH_AUTO;
        *look = (struct sph_material){.rgb = {1, 0.8, 0.6}, .kd = 0.5, .ks = 0.5, .ior = 1.5};
        if (run & 4) {
            look->trans = 0.6;
            look->sum.on = 1, look->sum.kr = 0.3, look->sum.ka = 1;
            look->ks = 0.4, look->shine = 9;
            o.specular = SPH_AUTO;
        }
        struct sph_machine m = built(&s, o, &report);
        struct sph_error err = {{0}};
        if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
        assert_int_equal(report.effects[SPH_REPORT_SMOOTH].on, 1);
        assert_int_equal(sph_render(&m, &plain, &frame, &c, NULL), 0);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            struct sph_pixel naive = sph_naive_pixel(&m, i % WIDTH, i / WIDTH);
            if (memcmp(naive.colour, frame.pixels[i].colour, sizeof naive.colour) != 0 ||
                naive.id != frame.pixels[i].id)
                fail_msg("run %d: pixel %d,%d differs", run, i % WIDTH, i / WIDTH);
        }
        sph_machine_free(&m);
        off = o;
        off.smooth = SPH_OFF;
        m = built(&s, off, &report);
        assert_int_equal(sph_render(&m, &plain, &flat, &c, NULL), 0);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            bends += flat.pixels[i].colour[0] != frame.pixels[i].colour[0];
        sph_frame_free(&frame);
        sph_frame_free(&flat);
        sph_machine_free(&m);
    }
    printf("# %d pixels are not those of flat triangles\n", bends);
    assert_true(bends > 200);
}

static struct sph_machine m;

static void refused(uint32_t *line, int lsb, int width, uint32_t value, const char *part) {
    uint32_t before[SPH_LINE_WORDS];
    struct sph_error err = {{0}};
    memcpy(before, line, sizeof before);
    sph_field_set(line, lsb, width, value);
    if (!sph_machine_validate(&m, &err)) fail_msg("not refused: %s", part);
    if (!strstr(err.text, part)) fail_msg("message '%s' lacks '%s'", err.text, part);
    memcpy(line, before, sizeof before);
}

/* Wrong records are refused; one behind the end of memory is an error, and the triangle flat. */
static void test_wrong(void **unused) {
    struct sph_scene s = wild();
    struct sph_build_options o = standard;
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_frame frame;
    struct sph_counters c = {{0}};
    (void)unused;
    o.smooth = SPH_AUTO;
    o.width = WIDTH, o.height = HEIGHT;
    m = built(&s, o, &report);
    uint32_t *prim = sph_line(&m, (uint32_t)m.regs[SPH_REG_PRIM_BASE]);
    uint32_t *record = sph_line(&m, (uint32_t)m.regs[SPH_REG_SMOOTH_BASE]);
    for (int id = 0; id < 12; id++)
        refused(prim + (size_t)8 * (size_t)id, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS, 4000,
                "its normals are record 3999, behind the end of memory");
    refused(record, SPH_SMOOTH_B_X_LSB, 24, 1 << 15, "start at no point of the grid");
    refused(record, 255, 1, 1, "bits of its normals that must be 0 are not");
    for (int id = 0; id < 12; id++)
        sph_field_set(prim + (size_t)8 * (size_t)id, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS,
                      4000);
    assert_int_equal(sph_render(&m, &plain, &frame, &c, NULL), 1 << SPH_ERROR_BAD_NODE);
    sph_frame_free(&frame);
    m.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_SMOOTH);
    m.regs[SPH_REG_SMOOTH_BASE] = 0;
    if (!sph_machine_validate(&m, &err) || !strstr(err.text, "a facet with a radius"))
        fail_msg("%s", err.text);
    sph_machine_free(&m);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_between),
                                       cmocka_unit_test(test_mirror), cmocka_unit_test(test_naive),
                                       cmocka_unit_test(test_wrong)};
    seed(argc, argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
