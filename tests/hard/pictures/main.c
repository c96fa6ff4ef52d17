/* main.c - hard-pictures: close-ups of what floats get wrong, beside the golden model
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: hard-pictures SCENES PICTURES      folders; prints the table of
 * docs/results/hard_cases.md
 *
 * Each picture has four fields: two ways of float32, ours, and the wrong pixels of the first one.
 * Exit code: 0 if ours shows the right sphere in every pixel, 1 if not, 2 for files.
 */
#include <math.h>
#include <stdlib.h>

#include "../exact.h"
#include "../hard.h"
#include "builder/build.h"
#include "image/image.h"
#include "machine/machine.h"
#include "pixel/background.h"
#include "prim/sphere.h"
#include "reference/floats.h"
#include "render/render.h"

/* ---- frames of a machine's spheres: exactly, and in floating point ---- */
/* All take the quantised scene out of the machine: its grid points are the numbers that the floats
 * start from, without error. Surfaces are matt; there are no mirror rays. */

struct draw_scene {
    const struct sph_machine *m;
    uint32_t n;
    struct sph_leaf *spheres;
};

struct draw_pixel {
    uint32_t id; /* sphere seen, SPH_ID_NONE: background */
    uint8_t rgb[3];
};

/* A way to draw: one of SPH_F32_TEXTBOOK to SPH_F64_TEXTBOOK, every step rounded to its type; of
 * a shadow ray what lies nearer than epsilon, in grid units, does not count. */
struct draw_way {
    int formula;
    double epsilon;
};

/* Takes the spheres of a machine without facets; the caller frees spheres. Ends the program if
 * memory does not do. */
struct draw_scene draw_scene(const struct sph_machine *m);

struct draw_pixel draw_float(const struct draw_scene *s, struct draw_way way, int x, int y);

/* The sphere by exact integers (exact.h), the rest in long double; no ray hits the sphere that it
 * leaves. */
struct draw_pixel draw_exact(const struct draw_scene *s, int x, int y);

/* ---- draw ---- */

struct draw_scene draw_scene(const struct sph_machine *m) {
    struct draw_scene s = {.m = m, .n = (uint32_t)m->regs[SPH_REG_N_PRIMS]};
    s.spheres = malloc((s.n + !s.n) * sizeof *s.spheres);
    if (!s.spheres) {
        perror("draw_scene");
        exit(2);
    }
    for (uint32_t i = 0; i < s.n; i++) {
        const uint32_t *line =
            m->mem + (size_t)SPH_LINE_WORDS * ((uint32_t)m->regs[SPH_REG_PRIM_BASE] + i);
        s.spheres[i] = sph_sphere_read(line, sph_machine_profile(m)->w);
    }
    return s;
}

/* The primary ray, in integers. */
static struct sph_ray primary(const struct draw_scene *s, int x, int y) {
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    for (int i = 0; i < 3; i++)
        ray.org[i] = s->m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(s->m, x, y, ray.dir);
    return ray;
}

/* Colour of the background, or of a surface that the lights of `shines` reach. */
static struct draw_pixel shade(const struct draw_scene *s, uint32_t id, const double at[3],
                               const double normal[3], uint32_t shines) {
    const int32_t *r = s->m->regs;
    struct draw_pixel p = {.id = id};
    double sum[3];
    for (int i = 0; i < 3; i++) {
        sum[i] = r[SPH_REG_AMBIENT_R + i] / 32768.0;
        p.rgb[i] = (uint8_t)(r[SPH_REG_BG_COLOUR] >> (8 * i) & 255);
    }
    if (id == SPH_ID_NONE) return p;
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        const int32_t *lamp = r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
        double dot = 0, nn = 0, ll = 0;
        for (int i = 0; i < 3; i++) {
            double to = lamp[i] - at[i];
            dot += to * normal[i];
            nn += normal[i] * normal[i];
            ll += to * to;
        }
        if (!(dot > 0) || !(shines >> l & 1)) continue;
        for (int i = 0; i < 3; i++)
            sum[i] += dot / sqrt(nn * ll) * lamp[3 + i] / 32768.0;
    }
    const uint32_t *line =
        s->m->mem + (size_t)SPH_LINE_WORDS * ((uint32_t)r[SPH_REG_PRIM_BASE] + id);
    for (int i = 0; i < 3; i++) {
        double albedo = sph_field(line, SPH_PRIM_RED_LSB + 8 * i, 8);
        p.rgb[i] = (uint8_t)(fmin(albedo * sum[i], 255) + 0.5);
    }
    return p;
}

/* ---- floating point ---- */

/* x as the formula's type has it. A sum, product or quotient of two floats, or a root, taken in
 * double and rounded again is that of float. */
static double rounded(int formula, double x) {
    return formula == SPH_F64_TEXTBOOK ? x : (double)(float)x;
}

/* Whether anything lies between a point and a light. */
static int hidden(const struct draw_scene *s, struct draw_way way, const double at[3],
                  const int32_t lamp[3]) {
    double dir[3], length2 = 0;
    for (int i = 0; i < 3; i++) {
        dir[i] = rounded(way.formula, lamp[i] - at[i]);
        length2 = rounded(way.formula, length2 + rounded(way.formula, dir[i] * dir[i]));
    }
    double length = rounded(way.formula, sqrt(length2));
    double least = rounded(way.formula, rounded(way.formula, way.epsilon) / length);
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        double ctr[3] = {(double)ball->ctr[0], (double)ball->ctr[1], (double)ball->ctr[2]};
        if (sph_float_between(sph_float_roots(way.formula, at, dir, ctr, (double)ball->rad), least,
                              1)
                .hit)
            return 1;
    }
    return 0;
}

struct draw_pixel draw_float(const struct draw_scene *s, struct draw_way way, int x, int y) {
    struct sph_ray ray = primary(s, x, y);
    struct sph_floats best = {0, 0, INFINITY};
    double org[3], dir[3], at[3] = {0}, normal[3] = {0};
    uint32_t id = SPH_ID_NONE, shines = ~0u;
    const int32_t *r = s->m->regs;
    for (int i = 0; i < 3; i++) {
        org[i] = (double)ray.org[i];
        dir[i] = (double)ray.dir[i];
    }
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        double ctr[3] = {(double)ball->ctr[0], (double)ball->ctr[1], (double)ball->ctr[2]};
        struct sph_floats hit = sph_float_between(
            sph_float_roots(way.formula, org, dir, ctr, (double)ball->rad), 0, best.t);
        if (!hit.hit) continue;
        best = hit;
        id = i;
    }
    if (id == SPH_ID_NONE) return shade(s, id, at, normal, 0);
    for (int i = 0; i < 3; i++) {
        at[i] = rounded(way.formula, org[i] + rounded(way.formula, best.t * dir[i]));
        normal[i] = rounded(way.formula, at[i] - (double)s->spheres[id].ctr[i]);
        if (best.far) normal[i] = -normal[i];
    }
    for (int l = 0; sph_machine_effect(s->m, SPH_EFFECT_SHADOW) && l < r[SPH_REG_N_LIGHTS]; l++)
        if (hidden(s, way, at, r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE)) shines &= ~(1u << l);
    return shade(s, id, at, normal, shines);
}

/* ---- exactly ---- */

/* Whether another sphere than `own` lies between a point outside of it and a light. */
static int hidden_exact(const struct draw_scene *s, uint32_t own, const long double at[3],
                        const int32_t lamp[3]) {
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_leaf *ball = &s->spheres[i];
        long double a = 0, b = 0, c = -(long double)ball->rad * (long double)ball->rad;
        if (i == own) continue;
        for (int j = 0; j < 3; j++) {
            long double oc = (long double)ball->ctr[j] - at[j], d = lamp[j] - at[j];
            a += d * d;
            b += oc * d;
            c += oc * oc;
        }
        long double disc = b * b - a * c;
        if (!(disc > 0)) continue;
        long double root = sqrtl(disc), near = b - root, far = b + root;
        if ((near > 0 && near < a) || (far > 0 && far < a)) return 1;
    }
    return 0;
}

struct draw_pixel draw_exact(const struct draw_scene *s, int x, int y) {
    struct sph_ray ray = primary(s, x, y);
    struct exact best = {0};
    long double point[3];
    double at[3] = {0}, normal[3] = {0};
    uint32_t id = SPH_ID_NONE, shines = ~0u;
    const int32_t *r = s->m->regs;
    for (uint32_t i = 0; i < s->n; i++) {
        struct exact e = exact_leaf(&ray, &s->spheres[i]);
        if (!e.hit || (id != SPH_ID_NONE && exact_order(&e, &best) >= 0)) continue;
        best = e;
        id = i;
    }
    if (id == SPH_ID_NONE) return shade(s, id, at, normal, 0);
    for (int i = 0; i < 3; i++) {
        point[i] = (long double)ray.org[i] + exact_t(&best) * (long double)ray.dir[i];
        at[i] = (double)point[i];
        normal[i] = (double)(point[i] - (long double)s->spheres[id].ctr[i]);
        if (best.far) normal[i] = -normal[i];
    }
    for (int l = 0; sph_machine_effect(s->m, SPH_EFFECT_SHADOW) && l < r[SPH_REG_N_LIGHTS]; l++)
        if (hidden_exact(s, id, point, r + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE))
            shines &= ~(1u << l);
    return shade(s, id, at, normal, shines);
}

enum { W = 100, H = 75, FIELDS = 4, SCALE = 2, GAP = 4, FAR_OFF = 8 };

/* What is counted. epsilon in units of the scene: the usual one, or none. */
static const struct {
    const char *name;
    int formula;
    double epsilon;
} ways[] = {
    {"float32 textbook", SPH_F32_TEXTBOOK, 1e-3}, {"without epsilon", SPH_F32_TEXTBOOK, 0},
    {"float32 paper", SPH_F32_PAPER, 1e-3},       {"float32 Gems", SPH_F32_GEMS, 1e-3},
    {"float64 textbook", SPH_F64_TEXTBOOK, 1e-3},
};
enum { WAYS = sizeof ways / sizeof *ways, TEXTBOOK = 0, NO_EPSILON, PAPER, GEMS };

static const struct {
    const char *name;
    int profile, shadow, first, second; /* ways of the first two fields */
} pictures[] = {
    {"far", SPH_REFERENCE, 0, TEXTBOOK, GEMS},
    {"horizon", SPH_REFERENCE, 0, GEMS, TEXTBOOK},
    {"gap", SPH_REFERENCE, 0, TEXTBOOK, PAPER},
    {"lens", SPH_REFERENCE, 0, TEXTBOOK, PAPER},
    {"shadow", SPH_REFERENCE, 1, NO_EPSILON, TEXTBOOK},
};
enum { PICTURES = sizeof pictures / sizeof *pictures };

struct count {
    int sphere, colour; /* another sphere; the right one, but a channel is off by more than 8 */
};

static void die(const struct sph_error *err) {
    fprintf(stderr, "hard-pictures: %s\n", err->text);
    exit(2);
}

/* Machine and golden model's frame of a scene. */
static struct sph_frame build_and_render(const char *path, int profile, int shadow,
                                         struct sph_machine *m) {
    struct sph_scene scene;
    struct sph_error err = {{0}};
    struct sph_read_options read = {0};
    struct sph_build_report report;
    struct sph_build_options o = {.profile = profile,
                                  .tree = SPH_TREE_BALANCED,
                                  .width = W,
                                  .height = H,
                                  .shadow = shadow ? SPH_ON : SPH_OFF,
                                  .reflect = SPH_OFF,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO};
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    struct sph_counters counters = {0};
    struct sph_frame frame;
    if (sph_scene_read(path, &read, &scene, &err) || sph_build(&scene, &o, m, &report, &err))
        die(&err);
    sph_scene_free(&scene);
    int errors = sph_render(m, &how, &frame, &counters, &err);
    if (errors > 0) sph_fail(&err, "%s: error bits %x", path, (unsigned)errors);
    if (errors) die(&err);
    return frame;
}

static int wrong(struct draw_pixel a, struct draw_pixel exact, struct count *c) {
    int off = 0;
    for (int i = 0; i < 3; i++)
        off |= abs(a.rgb[i] - exact.rgb[i]) > FAR_OFF;
    c->sphere += a.id != exact.id;
    c->colour += a.id == exact.id && off;
    return a.id != exact.id || off;
}

static uint32_t word(struct draw_pixel p) {
    return (uint32_t)p.rgb[0] | (uint32_t)p.rgb[1] << 8 | (uint32_t)p.rgb[2] << 16;
}

/* A pixel of a field, enlarged. */
static void put(struct sph_frame *sheet, int field, int x, int y, uint32_t colour) {
    for (int i = 0; i < SCALE * SCALE; i++) {
        int px = field * (W * SCALE + GAP) + x * SCALE + i % SCALE, py = y * SCALE + i / SCALE;
        sheet->pixels[py * sheet->width + px].colour[0] = colour;
    }
}

/* The exact colour, dark, and red where the pixel is wrong. */
static uint32_t marked(struct draw_pixel exact, int bad) {
    for (int i = 0; i < 3; i++)
        exact.rgb[i] = (uint8_t)(exact.rgb[i] / 3);
    if (bad) exact = (struct draw_pixel){0, {255, 32, 32}};
    return word(exact);
}

/* One picture: its file, its line of the table. Returns pixels in which ours shows another sphere.
 */
static int picture(int n, const char *scenes, const char *to) {
    char path[4096];
    struct sph_machine m;
    struct sph_error err = {{0}};
    struct count counts[WAYS] = {0}, ours = {0};
    snprintf(path, sizeof path, "%s/%s.nff", scenes, pictures[n].name);
    struct sph_frame frame = build_and_render(path, pictures[n].profile, pictures[n].shadow, &m);
    struct draw_scene s = draw_scene(&m);
    struct sph_frame sheet = {FIELDS * (W * SCALE + GAP) - GAP, H * SCALE, NULL};
    sheet.pixels = calloc((size_t)sheet.width * (size_t)sheet.height, sizeof *sheet.pixels);
    if (!sheet.pixels) die(&(struct sph_error){"no memory"});
    for (int i = 0; i < sheet.width * sheet.height; i++)
        sheet.pixels[i].colour[0] = 0xffffff;

    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const struct sph_pixel *p = &frame.pixels[y * W + x];
            struct draw_pixel exact = draw_exact(&s, x, y), drawn[WAYS], model = {.id = p->id};
            int bad[WAYS];
            for (int i = 0; i < 3; i++)
                model.rgb[i] = (uint8_t)(p->colour[0] >> 8 * i & 255);
            wrong(model, exact, &ours);
            for (int w = 0; w < WAYS; w++) {
                struct draw_way way = {ways[w].formula, ldexp(ways[w].epsilon, -m.grid_log2)};
                drawn[w] = draw_float(&s, way, x, y);
                bad[w] = wrong(drawn[w], exact, &counts[w]);
            }
            put(&sheet, 0, x, y, word(drawn[pictures[n].first]));
            put(&sheet, 1, x, y, word(drawn[pictures[n].second]));
            put(&sheet, 2, x, y, word(model));
            put(&sheet, 3, x, y, marked(exact, bad[pictures[n].first]));
        }
    snprintf(path, sizeof path, "%s/hard_%s.png", to, pictures[n].name);
    if (sph_image_write(path, &sheet, 0, &err)) die(&err);
    printf("| %s | %s |", pictures[n].name, sph_profiles[pictures[n].profile].name);
    for (int w = 0; w < WAYS; w++)
        if (w == NO_EPSILON && !pictures[n].shadow)
            printf(" |");
        else
            printf(" %d / %d |", counts[w].sphere, counts[w].colour);
    printf(" %d / %d |\n", ours.sphere, ours.colour);
    free(sheet.pixels);
    free(s.spheres);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    return ours.sphere;
}

int main(int argc, char **argv) {
    int bad = 0;
    if (argc != 3) {
        fprintf(stderr, "usage: hard-pictures SCENES PICTURES\n");
        return 2;
    }
    printf("| picture | profile |");
    for (int w = 0; w < WAYS; w++)
        printf(" %s |", ways[w].name);
    printf(" ours |\n|---|---|");
    for (int w = 0; w <= WAYS; w++)
        printf("---|");
    printf("\n");
    for (int n = 0; n < PICTURES; n++)
        bad += picture(n, argv[1], argv[2]);
    return bad ? 1 : 0;
}
