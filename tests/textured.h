/* textured.h - textures made in code: chains of one colour a level, scenes that show them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_TEXTURED_H
#define SPH_TEST_TEXTURED_H

#include "vectors.h"

#include <math.h>
#include <string.h>

#include "builder/build.h"
#include "render/render.h"
#include "texture/lookup.h"
#include "validate/validate.h"

/* Red of level l is 20 * l + 10, so that a picture tells the level; green and blue are 255. */
static inline uint32_t level_colour(int level) {
    return 0xffffff00u | (uint32_t)(20 * level + 10);
}

/* A chain whose texels the caller frees; random: noise instead of level_colour(). */
static inline struct sph_mip textured_mip(int width, int height, struct sph_rng *random) {
    struct sph_mip mip = {width, height, sph_mip_levels(width, height), 0, NULL};
    mip.texels = calloc(sph_mip_at(&mip, mip.levels) + 1, sizeof *mip.texels);
    assert_non_null(mip.texels);
    for (int l = 0; l < mip.levels; l++)
        for (size_t i = sph_mip_at(&mip, l); i < sph_mip_at(&mip, l + 1); i++)
            mip.texels[i] = random ? (uint32_t)sph_rng_next(random) : level_colour(l);
    return mip;
}

/* A scene without primitives, lit evenly: a pixel is albedo times texel. */
static inline struct sph_scene textured_scene(struct sph_material *white) {
    *white = (struct sph_material){{1, 1, 1}, 1, 0, 1, 0, 1, 1, {0}, 0};
    struct sph_scene s = {.name = "textured", .path = "textured.nff", .ambient = {1, 1, 1}};
    s.camera = (struct sph_camera){{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40, .width = 32, .height = 24};
    s.n_materials = 1;
    s.materials = white;
    return s;
}

static const struct sph_build_options textured_options = {.profile = SPH_STANDARD,
                                                          .tree = SPH_TREE_BALANCED,
                                                          .max_depth = 2,
                                                          .shadow = SPH_AUTO,
                                                          .reflect = SPH_AUTO,
                                                          .lights = SPH_AUTO,
                                                          .inside = SPH_AUTO,
                                                          .texture = SPH_AUTO,
                                                          .tex_filter = SPH_FILTER_BETWEEN};

/* Builds, or fails the test with build's message. */
static inline struct sph_machine textured_build(const struct sph_scene *scene,
                                                const struct sph_build_options *options,
                                                struct sph_build_report *report) {
    struct sph_machine m;
    struct sph_error err = {{0}};
    if (sph_build(scene, options, &m, report, &err) || sph_machine_validate(&m, &err))
        fail_msg("%s", err.text);
    if (!m.mem) abort();
    return m;
}

/* A mapping record of primitive id. */
static inline const uint32_t *textured_map(const struct sph_machine *m, uint32_t id) {
    const uint32_t *prim =
        m->mem + (size_t)((uint32_t)m->regs[SPH_REG_PRIM_BASE] + id) * SPH_LINE_WORDS;
    uint32_t line = sph_field(prim, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
    return line ? m->mem + (size_t)line * SPH_LINE_WORDS : NULL;
}

#endif
