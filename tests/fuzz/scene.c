/* scene.c - what must be true of every scene that is read, and of what is built of it; see fuzz.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "trial/choose.h"
#include "render/render.h"
#include "fuzz.h"
#include "naive/naive.h"
#include "validate/validate.h"

/* The frame, primitives of a scene that is drawn, and pixels for the naive model: most inputs take
 * some milliseconds. A scene of more primitives than MANY is built once in 16 times. */
enum { WIDTH = 8, HEIGHT = 5, MANY = 400, FEW = 40, NAIVE = 2, IMAGE = 8 };

static char *text_of(const struct sph_scene *scene, size_t *size) {
    struct sph_error err = {""};
    char *text = NULL;
    FILE *to = open_memstream(&text, size);
    int bad = !to || sph_scene_write(scene, to, &err);
    if (to) fclose(to);
    if (!bad) return text;
    fuzz_message(&err, scene->path, 0);
    free(text);
    return NULL;
}

/* Written, read and written, it is the same text. */
static void round_trip(const struct sph_scene *scene) {
    size_t size, again_size;
    char *text = text_of(scene, &size);
    struct sph_scene back;
    struct sph_error err = {""};
    if (!text) return; /* refused by name */
    if (sph_scene_parse(text, size, scene->path, &(struct sph_read_options){0}, &back, &err))
        fuzz_fail("is not read as it was written: %s\n%s", err.text, text);
    char *again = text_of(&back, &again_size);
    if (!again || size != again_size || memcmp(text, again, size))
        fuzz_fail("is written anew as another:\n%s----\n%s", text, again);
    sph_scene_free(&back);
    free(text);
    free(again);
}

/* Images that nobody has to read: colours and alpha follow from the place. */
static struct sph_mip *images_of(const struct sph_scene *scene) {
    struct sph_mip *mips = calloc(scene->n_textures + 1ull, sizeof *mips);
    for (uint32_t i = 0; mips && i < scene->n_textures; i++) {
        struct sph_mip *m = &mips[i];
        m->width = 1 + (int)(strlen(scene->textures[i].path) * 5 % IMAGE);
        m->height = IMAGE;
        m->levels = sph_mip_levels(m->width, m->height);
        size_t n = sph_mip_at(m, m->levels);
        m->texels = malloc(n * sizeof *m->texels);
        for (size_t t = 0; m->texels && t < n; t++)
            m->texels[t] = (uint32_t)(t * 0x9e3779b1u);
    }
    return mips;
}

static void free_images(struct sph_mip *mips, uint32_t n) {
    for (uint32_t i = 0; mips && i < n; i++)
        free(mips[i].texels);
    free(mips);
}

static struct sph_build_options options_of(uint64_t choice) {
    static const int trees[] = {SPH_TREE_REINSERTED, SPH_TREE_BALANCED, SPH_TREE_PAPER,
                                SPH_TREE_BIH,        SPH_TREE_BOX4,     SPH_TREE_AUTO};
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    o.tree = trees[choice % 6];
    o.profile = (int)(choice >> 8 & 3);
    o.background = (int)(choice >> 10 & 3);
    o.max_depth = (int)(choice >> 12 & 3);
    o.width = WIDTH;
    o.height = HEIGHT;
    o.max_prims = choice >> 14 & 1;
    o.bg_levels = o.background == SPH_BG_EXACT ? (int)(choice >> 15 & 1) : 0;
    o.tex_filter = choice >> 16 & 1 ? SPH_FILTER_BETWEEN : (int)(choice >> 17 & 1);
    return o;
}

static struct sph_frame drawn(const struct sph_machine *m, int how, struct sph_counters *counters,
                              int *errors) {
    struct sph_render_options o = {.traverse = how, .threads = 1};
    struct sph_frame frame = {0};
    struct sph_error err = {""};
    memset(counters, 0, sizeof *counters);
    *errors = sph_render(m, &o, &frame, counters, &err);
    if (*errors < 0) fuzz_fail("not drawn: %s", err.text);
    return frame;
}

void fuzz_draw(const struct sph_machine *m) {
    struct sph_counters a, b;
    int errors, fast_errors;
    struct sph_frame tree = drawn(m, SPH_TRAVERSE_TREE, &a, &errors);
    struct sph_frame fast = drawn(m, SPH_TRAVERSE_FAST, &b, &fast_errors);
    if (errors != fast_errors) fuzz_fail("errors %x, fast %x", errors, fast_errors);
    if (sph_frame_hash(&tree) != sph_frame_hash(&fast)) fuzz_fail("fast draws another frame");
    if (memcmp(&a, &b, sizeof a)) fuzz_fail("fast counts otherwise");
    sph_frame_free(&tree);
    sph_frame_free(&fast);
}

/* What brute force and the naive model see is what the tree lets see. */
static void compare(const struct sph_machine *m, uint64_t choice) {
    struct sph_counters counters;
    int errors, brute_errors;
    fuzz_draw(m);
    struct sph_frame tree = drawn(m, SPH_TRAVERSE_TREE, &counters, &errors);
    struct sph_frame brute = drawn(m, SPH_TRAVERSE_BRUTE, &counters, &brute_errors);
    if (errors | brute_errors) fuzz_fail("errors %x, brute force %x", errors, brute_errors);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const struct sph_pixel *p = &tree.pixels[i], *q = &brute.pixels[i];
        if (p->id != q->id || p->key != q->key || memcmp(p->colour, q->colour, sizeof p->colour))
            fuzz_fail("pixel %d, %d: primitive %u, brute force %u", i % WIDTH, i / WIDTH, p->id,
                      q->id);
    }
    for (int k = 0; k < NAIVE && choice >> 20 & 1; k++) {
        int i = (int)((choice >> (24 + 8 * k) & 255) % (WIDTH * HEIGHT));
        struct sph_pixel n = sph_naive_pixel(m, i % WIDTH, i / WIDTH);
        const struct sph_pixel *p = &tree.pixels[i];
        int seen = !sph_machine_effect(m, SPH_EFFECT_TEXTURE); /* it knows no images */
        if (p->id != n.id || p->key != n.key ||
            (seen && memcmp(p->colour, n.colour, sizeof p->colour)))
            fuzz_fail("pixel %d, %d: primitive %u, naive model %u", i % WIDTH, i / WIDTH, p->id,
                      n.id);
    }
    sph_frame_free(&tree);
    sph_frame_free(&brute);
}

/* The machine's file is the machine. */
static void through_file(const struct sph_machine *m) {
    struct sph_machine back;
    struct sph_error err = {""};
    if (sph_machine_write(m, "m.sph", &err) || sph_machine_read("m.sph", &back, &err))
        fuzz_fail("its file: %s", err.text);
    if (memcmp(m->regs, back.regs, sizeof m->regs) || m->lines != back.lines ||
        memcmp(m->mem, back.mem, sizeof *m->mem * SPH_LINE_WORDS * m->lines))
        fuzz_fail("its file holds another machine");
    sph_machine_free(&back);
    fuzz_no_rest();
}

void fuzz_scene(const struct sph_scene *scene, uint64_t choice) {
    struct sph_error err = {""};
    uint64_t n = (uint64_t)scene->n_spheres + scene->n_facets;
    if (!scene->aff || !scene->read.timed) round_trip(scene);
    /* one scene of four is built: that takes most of the time */
    if (choice >> 50 & (n > MANY ? 15 : 3)) return;
    struct sph_build_options o = options_of(choice);
    const struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};
    struct sph_profile_choice profile;
    struct sph_mip *mips = images_of(scene);
    o.mips = mips;
    struct sph_machine m;
    static struct sph_build_report report;
    if (sph_build_kept(scene, &o, (int)(choice >> 18 & 1), &bound, &profile, &m, &report, &err)) {
        fuzz_message(&err, scene->path, 1);
    } else {
        if (sph_machine_validate(&m, &err)) fuzz_fail("built, but not valid: %s", err.text);
        if (choice >> 21 & 1) through_file(&m);
        if (n <= FEW) compare(&m, choice);
        sph_machine_free(&m);
    }
    free_images(mips, scene->n_textures);
}
