/* texture.c - see builder/texture/texture.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Behind all that was there: mapping records, then images, each a header and its texel lines.
 */
#include "builder/texture/texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/prim/build.h"
#include "builder/texture/map.h"
#include "common/fnv.h"

/* ---- spread ---- */

uint32_t sph_bend_of(int64_t radius) {
    return (uint32_t)(SPH_BEND_ONE + lround(2 * log2((double)radius)));
}

/* Whether rays leave what has this material. */
static int leaves(const struct sph_machine *m, const struct sph_material *material) {
    return (sph_machine_effect(m, SPH_EFFECT_REFLECT) && sph_material_kr(material)) ||
           (sph_machine_effect(m, SPH_EFFECT_REFRACT) && sph_material_kt(material));
}

/* Bends of the spheres that rays leave, if `put`; how many, which of the scene is the first, and
 * how many of them rays of the frame meet. */
static uint32_t bends(const struct sph_scene *scene, const struct sph_plants *plants,
                      const struct sph_build_options *o, struct sph_machine *m, int put,
                      uint32_t *first, uint32_t *met) {
    uint32_t n = *met = 0;
    for (uint32_t id = 0; id < plants->n_spheres; id++) {
        struct sph_grid_prim prim =
            sph_grid_prim_of(plants->balls, plants->n_spheres, plants->facets, id);
        if (!leaves(m, &scene->materials[sph_grid_appearance(scene, &prim).material])) continue;
        if (!n++) *first = prim.index;
        *met += !sph_is_unmet(scene, o, &prim);
        if (put)
            sph_field_set(sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id), SPH_PRIM_BEND_LSB,
                          SPH_PRIM_BEND_BITS, sph_bend_of(prim.ball->r));
    }
    return n;
}

void sph_emit_spread(const struct sph_scene *scene, const struct sph_plants *plants,
                     const struct sph_build_options *options, struct sph_machine *machine,
                     struct sph_build_report *report) {
    struct sph_effect_report *entry = &report->effects[SPH_REPORT_SPREAD];
    int textured = sph_machine_effect(machine, SPH_EFFECT_TEXTURE);
    uint32_t first = 0, met, n = bends(scene, plants, options, machine, 0, &first, &met);
    entry->called = textured && n;
    if (!textured)
        sph_note(entry->why, sizeof entry->why, "no image is shown");
    else if (!n)
        sph_note(entry->why, sizeof entry->why, "no ray leaves a sphere");
    else
        sph_note(entry->why, sizeof entry->why, "rays leave %u spheres, the first is %s", n,
                 sph_sphere_place(scene, first).text);
    if (entry->called && !met) sph_leave_out(entry, "no ray of this frame meets one");
    sph_settle(entry, options->spread);
    if (entry->on && !textured) sph_drop(entry, "it needs texture, and no image is shown");
    if (entry->on < entry->called)
        sph_note(report->warning, sizeof report->warning, "%s: spread off: %s\n", scene->path,
                 entry->why);
    if (!entry->on) return;
    bends(scene, plants, options, machine, 1, &first, &met);
    machine->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_SPREAD;
}

/* What grows while primitives are looked at. */
struct emit {
    struct sph_texture_job job;
    const struct sph_plants *plants;
    const struct sph_mip *mips;
    struct sph_machine *m;
    uint32_t first;  /* line of the first record */
    uint32_t *maps;  /* records, SPH_LINE_WORDS words each; image: texture + 1 for now */
    uint32_t n_maps; /* different ones */
    uint32_t *table; /* open hash table of records, index + 1 */
    uint32_t slots;
    uint32_t *line; /* of a texture's image header, 0: not in memory yet */
};

/* Line of a record equal to the one just written behind all others. */
static uint32_t record_line(struct emit *e) {
    const uint32_t *map = e->maps + (size_t)e->n_maps * SPH_LINE_WORDS;
    uint64_t hash = SPH_FNV_START;
    for (int i = 0; i < SPH_LINE_WORDS; i++)
        hash = sph_fnv(hash, map[i], 4);
    uint32_t at = (uint32_t)(hash >> 16) % e->slots;
    for (; e->table[at]; at = (at + 1) % e->slots) {
        const uint32_t *other = e->maps + (size_t)(e->table[at] - 1) * SPH_LINE_WORDS;
        if (!memcmp(map, other, SPH_LINE_WORDS * sizeof *map)) return e->first + e->table[at] - 1;
    }
    e->table[at] = ++e->n_maps;
    return e->first + e->n_maps - 1;
}

static struct sph_grid_prim prim_of(const struct sph_plants *p, uint32_t id) {
    return sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
}

/* Writes the record of a primitive behind the others. */
static int put_map(struct emit *e, const struct sph_grid_prim *prim, uint32_t texture,
                   uint32_t *map, struct sph_error *err) {
    const struct sph_scene *scene = e->job.scene;
    const struct sph_texture *t = &scene->textures[texture - 1];
    const struct sph_mip *mip = &e->mips[texture - 1];
    sph_field_set(map, SPH_MAP_CLAMP_S_LSB, 1, (uint32_t)t->wrap[0]);
    sph_field_set(map, SPH_MAP_CLAMP_T_LSB, 1, (uint32_t)t->wrap[1]);
    sph_field_set(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, texture);
    e->job.id = prim->facet ? scene->n_spheres + prim->index : prim->index;
    return sph_prim_build_of(prim->kind)->map(&e->job, prim, mip, map, err);
}

/* Lines of an image, header and levels. */
static uint32_t image_lines(const struct sph_mip *mip) {
    uint32_t lines = 1;
    for (int l = 0; l < mip->levels; l++)
        lines += sph_level_lines(sph_level_size((uint32_t)mip->width, l),
                                 sph_level_size((uint32_t)mip->height, l));
    return lines;
}

/* Writes header and texels from line `at` on. */
static void put_image(struct sph_machine *m, uint32_t at, const struct sph_mip *mip) {
    uint32_t *head = sph_line(m, at), first = 0;
    sph_field_set(head, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS, (uint32_t)mip->width - 1);
    sph_field_set(head, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS, (uint32_t)mip->height - 1);
    sph_field_set(head, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS, (uint32_t)mip->levels);
    for (int l = 0; l < mip->levels; l++) {
        uint32_t w = sph_level_size((uint32_t)mip->width, l);
        uint32_t h = sph_level_size((uint32_t)mip->height, l);
        const uint32_t *texel = mip->texels + sph_mip_at(mip, l);
        uint32_t *to = sph_line(m, at + 1 + first);
        if (l)
            sph_field_set(head, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * (l - 1),
                          SPH_IMAGE_FIRST_BITS, first);
        for (uint32_t y = 0; y < h; y++)
            for (uint32_t x = 0; x < w; x++)
                to[sph_texel_word(w, x, y)] = *texel++;
        first += sph_level_lines(w, h);
    }
}

/* Gives every image in use its place: lines of memory needed in all. */
static uint64_t place_images(struct emit *e) {
    uint64_t at = (uint64_t)e->first + e->n_maps;
    for (uint32_t i = 0; i < e->n_maps; i++) {
        uint32_t t =
            sph_field(e->maps + (size_t)i * SPH_LINE_WORDS, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS) -
            1;
        for (uint32_t other = 0; other < e->job.scene->n_textures && !e->line[t]; other++)
            if (e->line[other] && e->mips[other].texels == e->mips[t].texels)
                e->line[t] = e->line[other];
        if (e->line[t] || at >> SPH_NODE_BASE_BITS) continue;
        e->line[t] = (uint32_t)at;
        at += image_lines(&e->mips[t]);
    }
    return at;
}

/* Records and images into memory, which grows. */
static int put_all(struct emit *e, struct sph_error *err) {
    uint64_t lines = place_images(e);
    struct sph_machine *m = e->m;
    uint32_t *mem =
        lines >> SPH_NODE_BASE_BITS ? NULL : realloc(m->mem, lines * SPH_LINE_WORDS * sizeof *mem);
    if (!mem)
        return sph_fail(err, "%s: out of memory or addresses for its textures", e->job.scene->path);
    memset(mem + (size_t)e->first * SPH_LINE_WORDS, 0,
           (lines - e->first) * SPH_LINE_WORDS * sizeof *mem);
    m->mem = mem;
    m->lines = (uint32_t)lines;
    m->regs[SPH_REG_MEM_LINES] = (int32_t)lines;
    for (uint32_t i = 0; i < e->n_maps; i++) {
        uint32_t *map = sph_line(m, e->first + i);
        memcpy(map, e->maps + (size_t)i * SPH_LINE_WORDS, SPH_LINE_WORDS * sizeof *map);
        uint32_t t = sph_field(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS) - 1;
        sph_field_set(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, e->line[t]);
        put_image(m, e->line[t], &e->mips[t]);
    }
    return 0;
}

/* The work of sph_emit_textures() on memory that the caller frees. */
static int emit(struct emit *e, uint32_t n, struct sph_error *err) {
    for (uint32_t id = 0; id < n; id++) {
        struct sph_grid_prim prim = prim_of(e->plants, id);
        uint32_t texture = sph_grid_appearance(e->job.scene, &prim).texture;
        if (!texture) continue;
        uint32_t *map = e->maps + (size_t)e->n_maps * SPH_LINE_WORDS;
        memset(map, 0, SPH_LINE_WORDS * sizeof *map);
        if (put_map(e, &prim, texture, map, err)) return -1;
        sph_field_set(sph_line(e->m, (uint32_t)e->m->regs[SPH_REG_PRIM_BASE] + id),
                      SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS, record_line(e));
    }
    return put_all(e, err);
}

/* What the report says of the effect. */
static void report_textures(const struct emit *e, uint32_t used, struct sph_effect_report *entry) {
    uint32_t images = 0, lines = e->m->lines - e->first - e->n_maps;
    for (uint32_t t = 0; t < e->job.scene->n_textures; t++) {
        uint32_t seen = !e->line[t];
        for (uint32_t other = 0; other < t; other++)
            seen |= e->line[other] == e->line[t];
        images += !seen;
    }
    entry->on = 1;
    sph_note(entry->why, sizeof entry->why,
             "%u primitives with an image, %u mappings, %u images in %u lines", used, e->n_maps,
             images, lines);
}

/* Allocates what emit() works on, and frees it. */
static int run(struct emit *e, uint32_t n, uint32_t used, struct sph_effect_report *entry,
               struct sph_error *err) {
    e->slots = 2 * used;
    e->maps = calloc((size_t)used * SPH_LINE_WORDS, sizeof *e->maps);
    e->table = calloc(e->slots, sizeof *e->table);
    e->line = calloc(e->job.scene->n_textures, sizeof *e->line);
    int rc = e->maps && e->table && e->line
                 ? emit(e, n, err)
                 : sph_fail(err, "%s: out of memory for %u mappings", e->job.scene->path, used);
    if (!rc) report_textures(e, used, entry);
    free(e->maps);
    free(e->table);
    free(e->line);
    return rc;
}

int sph_emit_textures(const struct sph_scene *scene, const struct sph_grid *grid,
                      const struct sph_plants *plants, const struct sph_build_options *options,
                      struct sph_machine *machine, struct sph_build_report *report,
                      struct sph_error *err) {
    const int32_t *r = machine->regs;
    struct sph_effect_report *entry = &report->effects[SPH_REPORT_TEXTURE];
    uint32_t n = scene->n_spheres + plants->facets->n, used = 0, met = 0, line = 0;
    for (uint32_t id = 0; id < n; id++) {
        struct sph_grid_prim prim = prim_of(plants, id);
        struct sph_grid_appearance look = sph_grid_appearance(scene, &prim);
        if (!look.texture) continue;
        if (!used++) line = look.line;
        met += !sph_is_unmet(scene, options, &prim);
    }
    entry->called = used > 0;
    if (used && !met && options->texture != SPH_OFF) {
        sph_note(entry->why, sizeof entry->why, "%u primitives have an image, the first is %s",
                 used, sph_place_of(scene, line, "number", 0).text);
        sph_leave_out(entry, "no ray of this frame meets one");
        return 0;
    }
    if (!used) sph_note(entry->why, sizeof entry->why, "no primitive has an image");
    if (used && options->texture == SPH_OFF) {
        sph_note(entry->why, sizeof entry->why, "off as asked: %u primitives have an image", used);
        sph_note(report->warning, sizeof report->warning,
                 "%s: texture off: %u primitives have an "
                 "image\n",
                 scene->path, used);
    }
    if (!used || options->texture == SPH_OFF) return 0;
    if (!options->mips)
        return sph_fail(err, "%s:%u: the images of the scene were not read", scene->path,
                        scene->textures[0].line);
    struct emit e = {
        .plants = plants, .mips = options->mips, .m = machine, .first = machine->lines};
    struct sph_texture_bases own = {0}, *bases = options->bases ? options->bases : &own;
    /* The camera's own rays: those of a turned grid are rounded another way for each place. */
    struct sph_texture_view view = {-(double)plants->rays->z / plants->rays->pitch,
                                    (double)r[SPH_REG_FRAME_W] * r[SPH_REG_FRAME_H], grid->step,
                                    options->lod_literal};
    sph_bases_frame(bases, scene, &view);
    e.job = (struct sph_texture_job){scene, grid, sph_build_profile(options), bases, 0};
    if (run(&e, n, used, entry, err)) return -1;
    report->bases_computed = bases->computed;
    report->bases_kept = bases->kept;
    report->bases_flops = bases->flops;
    machine->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_TEXTURE;
    machine->regs[SPH_REG_TEX_FILTER] = options->tex_filter;
    machine->regs[SPH_REG_COARSE] = options->coarse;
    return 0;
}
