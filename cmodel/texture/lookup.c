/* lookup.c - see lookup.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/lookup.h"

#include <stddef.h>

#include "texture/texel.h"
#include "texture/lod.h"

enum { WORDS_MASK = (1 << 20) - 1 };
static const uint32_t white = 0xffffffff;

/* What the fetches of one lookup share. */
struct job {
    const struct sph_machine *m;
    uint32_t map, line; /* of the mapping record, of the image header */
    uint64_t begin;     /* texels fetched before */
    const uint32_t *image;
    int clamp[2];
    struct sph_st st;
    uint32_t lod;
    struct sph_texture_work *work;
};

/* A line of memory; NULL and BAD_NODE behind its end. */
static const uint32_t *line_in(const struct sph_machine *m, uint64_t line,
                               struct sph_texture_work *work) {
    if (line < (uint32_t)m->regs[SPH_REG_MEM_LINES]) return sph_line(m, line);
    work->errors |= 1u << SPH_ERROR_BAD_NODE;
    return NULL;
}

/* The first texel line of a level. */
static uint64_t level_line(const struct job *j, uint32_t level) {
    uint32_t first = 0;
    if (level)
        first = sph_field(j->image, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * ((int)level - 1),
                          SPH_IMAGE_FIRST_BITS);
    return (uint64_t)j->line + 1 + first;
}

static uint32_t fetch(const struct job *j, uint32_t level, uint32_t width, uint32_t x, uint32_t y) {
    uint32_t word = sph_texel_word(width, x, y);
    uint64_t line = level_line(j, level) + word / SPH_LINE_WORDS;
    uint32_t address = (uint32_t)(line * SPH_LINE_WORDS + word % SPH_LINE_WORDS);
    int first = j->work->texels++ == j->begin;
    j->work->words = (j->work->words + address) & WORDS_MASK;
    if (j->work->fetch)
        j->work->fetch(j->work->user, &(struct sph_texel){j->line, width, level, x, y, address,
                                                          j->map, first, j->lod});
    const uint32_t *at = line_in(j->m, line, j->work);
    return at ? at[word % SPH_LINE_WORDS] : white;
}

/* Both axes of a level; returns its width. */
static uint32_t axes(const struct job *j, uint32_t level, struct sph_axis axis[2]) {
    uint32_t w = sph_field(j->image, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS) + 1;
    uint32_t h = sph_field(j->image, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS) + 1;
    w = sph_level_size(w, (int)level);
    h = sph_level_size(h, (int)level);
    axis[0] = sph_axis_at(j->st.at[0], w, j->clamp[0]);
    axis[1] = sph_axis_at(j->st.at[1], h, j->clamp[1]);
    return w;
}

static void bilinear(const struct job *j, uint32_t level, uint32_t out[4]) {
    struct sph_axis axis[2];
    uint32_t w = axes(j, level, axis), texel[4];
    for (int i = 0; i < 4; i++)
        texel[i] = fetch(j, level, w, axis[0].texel[i & 1], axis[1].texel[i >> 1]);
    sph_filter_bilinear(texel, axis[0].weight, axis[1].weight, out);
}

static uint32_t filtered(const struct job *j, int filter, uint32_t lod) {
    uint32_t near[4], far[4] = {0}, level = 0, weight = 0;
    if (filter == SPH_FILTER_NEAREST) {
        struct sph_axis axis[2];
        uint32_t w = axes(j, 0, axis);
        return fetch(j, 0, w, axis[0].nearest, axis[1].nearest);
    }
    if (filter == SPH_FILTER_LEVEL) level = (lod + 128) >> 8;
    if (filter == SPH_FILTER_BETWEEN) level = lod >> 8, weight = lod & 255;
    bilinear(j, level, near);
    if (weight) bilinear(j, level + 1, far); /* lod is at most the last level: weight 0 there */
    return sph_filter_levels(near, far, weight);
}

/* The nearest lod with fewer bits of fraction; the last level is a whole number and stays. */
static uint32_t coarser(uint32_t lod, int drop) {
    return (lod + (1u << drop >> 1)) >> drop << drop;
}

uint32_t sph_lookup(const struct sph_machine *m, uint32_t map, const struct sph_textured *where,
                    struct sph_texture_work *work) {
    const uint32_t *record = line_in(m, map, work);
    if (!record) return white;
    struct job j = {.m = m,
                    .map = map,
                    .begin = work->texels,
                    .line = sph_field(record, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS),
                    .clamp = {(int)sph_field(record, SPH_MAP_CLAMP_S_LSB, 1),
                              (int)sph_field(record, SPH_MAP_CLAMP_T_LSB, 1)},
                    .work = work};
    j.image = line_in(m, j.line, work);
    if (!j.image) return white;
    int levels = (int)sph_field(j.image, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS);
    if (levels < 1 || levels > SPH_TEXTURE_LEVELS) {
        work->errors |= 1u << SPH_ERROR_BAD_NODE;
        return white;
    }
    int32_t base = sph_field_signed(record, SPH_MAP_BASE_LSB, SPH_MAP_BASE_BITS);
    j.lod = coarser(sph_lod(where->path, base, levels), m->regs[SPH_REG_COARSE]);
    if (work->lod == SPH_LOD_NONE) work->lod = j.lod;
    j.st = sph_coords(record, where);
    return filtered(&j, m->regs[SPH_REG_TEX_FILTER], j.lod);
}
