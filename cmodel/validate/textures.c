/* textures.c - see textures.h; lines are drawn in machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/textures.h"

#include <stddef.h>

#include "texture/mip.h"

/* First line behind primitive records and the table of facets. */
static uint32_t first_line(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    uint32_t n = (uint32_t)r[SPH_REG_N_PRIMS], end = (uint32_t)r[SPH_REG_PRIM_BASE] + n;
    if (sph_machine_effect(m, SPH_EFFECT_FACETS))
        end = (uint32_t)r[SPH_REG_FACET_BASE] + n - (uint32_t)r[SPH_REG_N_SPHERES];
    return end;
}

static int check_image(const struct sph_machine *m, uint32_t line, struct sph_error *err) {
    const uint32_t *head = sph_line(m, line);
    struct sph_mip mip = {.width = (int)sph_field(head, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS) + 1,
                          .height = (int)sph_field(head, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS) + 1,
                          .levels =
                              (int)sph_field(head, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS)};
    uint32_t end = 0;
    if (mip.width > SPH_TEXTURE_SIDE || mip.height > SPH_TEXTURE_SIDE)
        return sph_fail(err, "line %u: image of %d x %d texels", line, mip.width, mip.height);
    if (mip.levels != sph_mip_levels(mip.width, mip.height))
        return sph_fail(err, "line %u: image of %d x %d texels has %d levels", line, mip.width,
                        mip.height, mip.levels);
    for (int l = 0; l < mip.levels; l++) {
        uint32_t first = 0;
        if (l)
            first = sph_field(head, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * (l - 1),
                              SPH_IMAGE_FIRST_BITS);
        if (first != end)
            return sph_fail(err, "line %u: level %d starts at line %u of the image, not %u", line,
                            l, first, end);
        end += sph_level_lines(sph_level_size((uint32_t)mip.width, l),
                               sph_level_size((uint32_t)mip.height, l));
    }
    if ((uint64_t)line + 1 + end > m->lines)
        return sph_fail(err, "line %u: image of %u lines, memory has %u in all", line, end,
                        m->lines);
    return 0;
}

static int check_map(const struct sph_machine *m, uint32_t line, struct sph_error *err) {
    const uint32_t *map = sph_line(m, line);
    uint32_t kind = sph_field(map, SPH_MAP_KIND_LSB, SPH_MAP_KIND_BITS);
    uint32_t image = sph_field(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
    if (kind > 1) return sph_fail(err, "line %u: mapping of kind %u", line, kind);
    if (image < first_line(m) || image >= m->lines)
        return sph_fail(err, "line %u: image at line %u, not in %u..%u", line, image, first_line(m),
                        m->lines - 1);
    return check_image(m, image, err);
}

int sph_validate_textures(const struct sph_machine *m, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], first = first_line(m), last = 0;
    for (uint32_t id = 0; id < n; id++) {
        const uint32_t *prim = sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id);
        uint32_t map = sph_field(prim, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
        if (!map || map == last) continue;
        if (map < first || map >= m->lines)
            return sph_fail(err, "primitive %u: mapping at line %u, not in %u..%u", id, map, first,
                            m->lines - 1);
        if (check_map(m, map, err)) return -1;
        last = map;
    }
    return 0;
}
