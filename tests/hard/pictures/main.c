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

#include "builder/build.h"
#include "draw.h"
#include "image/image.h"
#include "render/render.h"

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
